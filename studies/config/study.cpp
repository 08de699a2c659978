#include "studies/config/study.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "studies/config/execution_error.hpp"
#include "studies/config/study_data.hpp"

namespace unbruised::studies {
namespace {

void apply_column(Scenario& scenario, const VaryColumn& column, std::size_t index) {
  const KeySpec& spec = *column.address.spec;
  if (spec.field == nullptr) return;
  const FieldRef field = spec.field(scenario, column.address.index);
  if (column.input.is_text) {
    assign(spec, field, column.words[index], column.address.elements);
  } else {
    assign_number(field, column.input.numbers[index], column.address.elements);
  }
}

}  // namespace

Scenario StudyData::scenario(std::size_t id) const {
  Scenario scenario = bases[base_of(id)];
  for (std::size_t c = 0; c < plan.columns.size(); ++c) {
    apply_column(scenario, plan.columns[c], plan.index(id, c));
  }
  return scenario;
}

std::size_t StudyData::base_of(std::size_t scenario) const {
  std::size_t product = 0, gripper = 0, grippers = 1;
  for (std::size_t c = 0; c < plan.columns.size(); ++c) {
    const std::string& key = plan.columns[c].input.key;
    if (key == "product.use") product = plan.index(scenario, c);
    if (key != "gripper.use") continue;
    gripper = plan.index(scenario, c);
    grippers = plan.columns[c].input.count();
  }
  return product * grippers + gripper;
}

std::uint64_t pareto_search_count(std::uint64_t objectives, std::uint64_t points, std::uint64_t starts) {
  return objectives * std::max(kAnchorStarts, starts) + (objectives + points) * starts;
}

Study::Study(std::shared_ptr<const StudyData> data) : data_(std::move(data)) {}
const std::string& Study::name() const { return data_->settings.name; }
StudyKind Study::kind() const { return data_->settings.kind; }
std::uint64_t Study::seed() const { return data_->settings.seed; }
const std::string& Study::description() const { return data_->settings.description; }
const WindowSettings& Study::window() const { return data_->settings.window; }
std::size_t Study::scenario_count() const { return data_->plan.scenario_count; }
const std::vector<InputColumn>& Study::inputs() const { return data_->inputs; }
const std::string& Study::resolved_toml() const { return data_->resolved; }
const ContactSteps& Study::fewest_contact_steps() const { return data_->fewest_contact_steps; }
bool Study::is_time_step_chosen() const { return data_->is_time_step_chosen; }
const std::vector<std::string>& Study::warnings() const { return data_->warnings; }
Scenario Study::scenario(std::size_t id) const { return data_->scenario(id); }

const std::vector<SearchVariable>& Study::variables() const { return data_->variables; }
const std::vector<RandomVariable>& Study::randoms() const { return data_->randoms; }
const std::vector<RankCorrelation>& Study::correlations() const { return data_->correlations; }
const std::vector<StrategyCandidate>& Study::candidates() const { return data_->candidates; }
const SearchSettings& Study::search() const { return data_->search; }
const SamplingSettings& Study::sampling() const { return data_->sampling; }
const CompareSettings& Study::compare() const { return data_->compare; }
const CalibrateSettings& Study::calibrate() const { return data_->calibrate; }
const SensitivitySettings& Study::sensitivity() const { return data_->sensitivity; }

Scenario Study::with_values(Scenario base, std::span<const std::string> keys, std::span<const double> values) {
  for (std::size_t k = 0; k < keys.size(); ++k) apply_named(base, keys[k], values[k]);
  StrategyParameters& strategy = base.strategy;
  strategy.contact_force_N = std::min(strategy.contact_force_N, strategy.grip_force_N);
  return base;
}

Scenario Study::scenario_with(std::span<const std::string> keys, std::span<const double> values) const {
  return with_values(data_->bases.front(), keys, values);
}

std::optional<double> Study::base_value(const std::string& key) const {
  const KeyAddress address = find_key(key);
  Scenario base = data_->bases.front();
  if (address.spec == nullptr || !has_field(*address.spec, base, address.index)) return std::nullopt;
  return number_at(address.spec->field(base, address.index), address.elements);
}

std::size_t Study::input_index(std::size_t scenario, std::size_t column) const {
  return data_->plan.index(scenario, column);
}

double Study::input_number(std::size_t scenario, std::size_t column) const {
  const InputColumn& input = data_->inputs[column];
  return input.is_text ? std::numeric_limits<double>::quiet_NaN() : input.numbers[input_index(scenario, column)];
}

std::string Study::input_text(std::size_t scenario, std::size_t column) const {
  const InputColumn& input = data_->inputs[column];
  const std::size_t index = input_index(scenario, column);
  return input.is_text ? input.texts[index] : spelled(input.numbers[index]);
}

}  // namespace unbruised::studies

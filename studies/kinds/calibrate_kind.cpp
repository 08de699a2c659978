#include "studies/kinds/calibrate_kind.hpp"

#include <utility>
#include <variant>

#include "studies/findings/calibration_tables.hpp"
#include "studies/kinds/curve_fit.hpp"
#include "studies/kinds/curve_rounds.hpp"

namespace unbruised::studies {
namespace {

std::vector<std::string> fitted_keys(const Study& study) {
  std::vector<std::string> keys;
  for (const SearchVariable& key : study.variables()) keys.push_back(key.key);
  return keys;
}

}  // namespace

KindAnswer run_calibrate(const KindInput& input) {
  const Study& study = input.study;
  const CalibrateSettings& settings = study.calibrate();
  input.journal.total_may_grow();
  CurveRounds rounds(input);
  std::vector<std::optional<SpecimenFit>> fits(settings.curves.size());
  rounds.run(fits.size(), [&](std::size_t i) {
    fits[i] = fit_specimen(study.variables(), settings, settings.curves[i],
                           [&](const std::vector<std::vector<double>>& points) { return rounds.ask(i, points); });
  });
  KindAnswer answer;
  answer.lane_use = rounds.lane_use();
  answer.interrupted = rounds.is_stopped();
  if (answer.interrupted) return answer;
  std::vector<SpecimenFit> all;
  for (std::optional<SpecimenFit>& fit : fits) all.push_back(*std::move(fit));
  Calibration found = calibration_of(study, all);
  answer.found = std::move(found.tables);
  answer.warnings = std::move(found.warnings);
  answer.product = std::move(found.product_toml);
  return answer;
}

std::size_t curves_at_most(const Study& study) {
  return study.calibrate().curves.size() *
         fit_scenarios_at_most(study.variables().size(), study.calibrate().budget);
}

std::vector<ColumnInfo> fitted_columns(const Study& study) {
  std::vector<ColumnInfo> columns;
  for (const SearchVariable& key : study.variables()) columns.push_back({key.key, key.units, "fitted key"});
  return columns;
}

std::optional<Scenario> scenario_of_fit(const Study& study, const ScenarioRow& row) {
  std::vector<double> values;
  for (const InputValue& input : row.inputs) {
    if (!std::holds_alternative<double>(input)) return std::nullopt;
    values.push_back(std::get<double>(input));
  }
  if (values.size() != study.variables().size()) return std::nullopt;
  return study.scenario_with(fitted_keys(study), values);
}

ScenarioSet first_of_fits(const Study& study) {
  ScenarioSet set;
  set.count = 1;
  set.columns = fitted_columns(study);
  set.scenario = [study](std::size_t) { return study.scenario(0); };
  set.inputs = [study](std::size_t) {
    std::vector<InputValue> inputs;
    for (const SearchVariable& key : study.variables()) inputs.emplace_back(*study.base_value(key.key));
    return inputs;
  };
  return set;
}

}  // namespace unbruised::studies

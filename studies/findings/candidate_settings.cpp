#include "studies/findings/candidate_settings.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "studies/config/schema.hpp"

namespace unbruised::studies {
namespace {

/// A key, and in which table of a list it stands.
struct Setting {
  const KeySpec& spec;
  int index = 0;  ///< 0 where it stands in no list
};

/// Nothing where a candidate's list is shorter.
std::optional<FieldRef> field_in(const Setting& setting, Scenario& scenario) {
  if (!has_field(setting.spec, scenario, setting.index)) return std::nullopt;
  return setting.spec.field(scenario, setting.index);
}

template <class Value>
bool all_equal(const std::vector<Value>& values) {
  return std::all_of(values.begin(), values.end(), [&](const Value& value) { return value == values.front(); });
}

std::vector<std::string> texts_of(const Setting& setting, std::vector<StrategyCandidate>& candidates) {
  std::vector<std::string> texts;
  for (StrategyCandidate& candidate : candidates) {
    const auto field = field_in(setting, candidate.scenario);
    texts.push_back(field ? spelled(setting.spec, *field) : "");
  }
  return texts;
}

std::vector<double> numbers_of(const Setting& setting, std::vector<StrategyCandidate>& candidates) {
  std::vector<double> numbers;
  for (StrategyCandidate& candidate : candidates) {
    const auto field = field_in(setting, candidate.scenario);
    numbers.push_back(field ? number_at(*field, {}).value_or(kAbsent) : kAbsent);
  }
  return numbers;
}

/// The keys of strategies; those in lists once for each table of the longest.
std::vector<Setting> settings_of(const std::vector<StrategyCandidate>& candidates) {
  std::vector<Setting> settings;
  for (const KeySpec& spec : key_table()) {
    if (!spec.path.starts_with("strategy.") || spec.field == nullptr) continue;
    const bool is_in_list = spec.path.find("[]") != std::string_view::npos;
    std::size_t count = is_in_list ? 0 : 1;
    for (const StrategyCandidate& candidate : candidates) {
      count = std::max(count, scenario_list_size(candidate.scenario, spec.path).value_or(0));
    }
    for (std::size_t i = 0; i < count; ++i) settings.push_back({spec, static_cast<int>(i)});
  }
  return settings;
}

std::string path_of(const Setting& setting) {
  std::string path(setting.spec.path);
  const std::size_t list = path.find("[]");
  if (list != std::string::npos) path.insert(list + 1, std::to_string(setting.index));
  return path;
}

}  // namespace

std::vector<ResultColumn> candidate_settings(const std::vector<StrategyCandidate>& given) {
  std::vector<StrategyCandidate> candidates = given;  // fields are reached through a scenario that may be changed
  std::vector<ResultColumn> columns;
  for (const Setting& setting : settings_of(candidates)) {
    std::vector<std::string> texts = texts_of(setting, candidates);
    if (all_equal(texts)) continue;
    const KeyType type = setting.spec.type;
    ResultColumn column{path_of(setting), "", "setting of the candidate", {}};
    if (type == KeyType::number || type == KeyType::optional_number) {
      const Unit* unit = unit_of(setting.spec.path);
      column.units = unit == nullptr ? "1" : std::string(unit->udunits);
      column.values = numbers_of(setting, candidates);
    } else {
      column.values = std::move(texts);
    }
    columns.push_back(std::move(column));
  }
  return columns;
}

}  // namespace unbruised::studies

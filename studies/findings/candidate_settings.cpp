#include "studies/findings/candidate_settings.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "studies/config/schema.hpp"

namespace unbruised::studies {
namespace {

FieldRef field_in(const KeySpec& spec, Scenario& scenario) {
  constexpr int kNoList = 0;
  return spec.field(scenario, kNoList);
}

template <class Value>
bool all_equal(const std::vector<Value>& values) {
  return std::all_of(values.begin(), values.end(), [&](const Value& value) { return value == values.front(); });
}

std::vector<std::string> texts_of(const KeySpec& spec, std::vector<StrategyCandidate>& candidates) {
  std::vector<std::string> texts;
  for (StrategyCandidate& candidate : candidates)
    texts.push_back(spelled(spec, field_in(spec, candidate.scenario)));
  return texts;
}

std::vector<double> numbers_of(const KeySpec& spec, std::vector<StrategyCandidate>& candidates) {
  std::vector<double> numbers;
  for (StrategyCandidate& candidate : candidates) {
    numbers.push_back(number_at(field_in(spec, candidate.scenario), {}).value_or(kAbsent));
  }
  return numbers;
}

}  // namespace

std::vector<ResultColumn> candidate_settings(const std::vector<StrategyCandidate>& given) {
  std::vector<StrategyCandidate> candidates = given;  // fields are reached through a scenario that may be changed
  std::vector<ResultColumn> columns;
  for (const KeySpec& spec : key_table()) {
    if (!spec.path.starts_with("strategy.") || spec.field == nullptr) continue;
    std::vector<std::string> texts = texts_of(spec, candidates);
    if (all_equal(texts)) continue;
    const bool is_number = spec.type == KeyType::number || spec.type == KeyType::optional_number;
    ResultColumn column{std::string(spec.path), "", "setting of the candidate", {}};
    if (is_number) {
      const Unit* unit = unit_of(spec.path);
      column.units = unit == nullptr ? "1" : std::string(unit->udunits);
      column.values = numbers_of(spec, candidates);
    } else {
      column.values = std::move(texts);
    }
    columns.push_back(std::move(column));
  }
  return columns;
}

}  // namespace unbruised::studies

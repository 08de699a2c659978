#include "studies/findings/grid_answer.hpp"

#include <cmath>
#include <map>
#include <utility>

#include "studies/findings/key_columns.hpp"

namespace unbruised::studies {
namespace {

/// What became of one strategy.
struct Tally {
  std::vector<InputValue> values;
  std::vector<std::uint64_t> scenarios;
  double held = 0.0;
  double count = 0.0;
  double cycle_time_s = kAbsent;  ///< the longest of those held
};

void count_row(Tally& tally, const ScenarioRow& row) {
  tally.count += 1.0;
  tally.scenarios.push_back(row.id);
  if (row.result.outcome != Outcome::held) return;
  tally.held += 1.0;
  tally.cycle_time_s = std::fmax(tally.cycle_time_s, row.result.metrics[Metric::cycle_time_s]);
}

const Tally* best_of(const std::vector<Tally>& tallies) {
  const Tally* best = nullptr;
  for (const Tally& tally : tallies) {
    if (tally.held < tally.count || std::isnan(tally.cycle_time_s)) continue;
    if (best == nullptr || tally.cycle_time_s < best->cycle_time_s) best = &tally;
  }
  return best;
}

ResultTable table_of(const std::vector<ColumnInfo>& keys, const std::vector<Tally>& tallies, const Tally* best) {
  ResultTable table{.name = "strategies", .row = "strategy_number", .columns = {}, .attributes = {}};
  for (std::size_t k = 0; k < keys.size(); ++k) {
    std::vector<InputValue> values;
    for (const Tally& tally : tallies) values.push_back(tally.values[k]);
    table.columns.push_back(key_column(keys[k], values));
  }
  std::vector<double> held;
  std::vector<double> count;
  std::vector<double> cycle_time_s;
  std::vector<double> is_best;
  for (const Tally& tally : tallies) {
    held.push_back(tally.held);
    count.push_back(tally.count);
    cycle_time_s.push_back(tally.cycle_time_s);
    is_best.push_back(&tally == best ? 1.0 : 0.0);
  }
  table.columns.push_back({"held", "1", "combinations held", std::move(held)});
  table.columns.push_back({"combinations", "1", "of the keys that are not chosen", std::move(count)});
  table.columns.push_back({"cycle_time_s", "s", "longest of those held", std::move(cycle_time_s)});
  table.columns.push_back({"best", "1", "1: shortest cycle of those held in all", std::move(is_best)});
  return table;
}

/// Has the key at `place` one value wherever the keys at `given` have the same ones?
bool follows(const StudyRows& rows, const std::vector<std::size_t>& given, std::size_t place) {
  if (given.empty()) return false;
  std::map<std::vector<InputValue>, InputValue> value_of;
  for (const ScenarioRow& row : rows) {
    const auto [found, is_new] = value_of.try_emplace(picked(row.inputs, given), row.inputs[place]);
    if (!is_new && found->second != row.inputs[place]) return false;
  }
  return true;
}

/// Moves what follows the given keys to them; returns what was moved.
std::vector<std::size_t> move_following(KeyPlaces& places, const StudyRows& rows) {
  std::vector<std::size_t> following;
  for (const std::size_t place : places.others) {
    if (follows(rows, places.given, place)) following.push_back(place);
  }
  for (const std::size_t place : following) {
    std::erase(places.others, place);
    places.given.push_back(place);
  }
  return following;
}

}  // namespace

GridAnswer grid_answer(const std::vector<ColumnInfo>& inputs, const StudyRows& rows) {
  KeyPlaces places = key_places(inputs);
  const std::vector<std::size_t> following = move_following(places, rows);
  std::vector<Tally> tallies;
  std::map<std::vector<InputValue>, std::size_t> place_of;
  for (const ScenarioRow& row : rows) {
    std::vector<InputValue> values = picked(row.inputs, places.others);
    const auto [found, is_new] = place_of.try_emplace(values, tallies.size());
    if (is_new) tallies.emplace_back().values = std::move(values);
    count_row(tallies[found->second], row);
  }
  GridAnswer answer;
  answer.following = picked(inputs, following);
  answer.keys = picked(inputs, places.others);
  const Tally* best = best_of(tallies);
  answer.table = table_of(answer.keys, tallies, best);
  answer.table.attributes.emplace_back("over", leaves_text(picked(inputs, places.given)));
  if (best == nullptr) return answer;
  answer.best = best->scenarios.front();
  answer.best_rows = best->scenarios;
  answer.best_values = best->values;
  return answer;
}

}  // namespace unbruised::studies

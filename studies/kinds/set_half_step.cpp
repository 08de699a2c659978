#include "studies/kinds/set_half_step.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <unordered_map>
#include <utility>

#include "studies/execution/batch_runner.hpp"
#include "studies/findings/balances.hpp"
#include "studies/findings/check_warnings.hpp"
#include "studies/findings/table_text.hpp"
#include "studies/findings/winner_check.hpp"
#include "studies/kinds/half_step.hpp"

namespace unbruised::studies {
namespace {

/// Results of scenarios 0 .. count - 1, which are recorded nowhere; nothing: interrupted.
std::optional<std::vector<ScenarioResult>> run_unrecorded(const KindInput& input, std::size_t count,
                                                          const std::function<Scenario(std::uint64_t)>& scenario) {
  Batch batch{.ids = {}, .scenario = scenario, .stop = input.stop};
  for (std::uint64_t id = 0; id < count; ++id) batch.ids.push_back(id);
  std::vector<ScenarioResult> results(count);
  if (count == 0) return results;
  const BatchReport done = run_batch(
      input.executor, batch, [&](std::uint64_t id, const ScenarioResult& result) { results[id] = result; });
  if (done.stopped) return std::nullopt;
  return results;
}

ForceRunner unrecorded_forces(const KindInput& input) {
  return [&input](const std::vector<ForceRequest>& requests) -> std::optional<std::vector<ScenarioRow>> {
    const auto results = run_unrecorded(input, requests.size(), [&](std::uint64_t i) {
      return window_scenario(input.study, requests[i].combination(), requests[i].grip_force_N, requests[i].step);
    });
    if (!results) return std::nullopt;
    std::vector<ScenarioRow> rows;
    for (std::size_t i = 0; i < requests.size(); ++i) {
      rows.push_back({.id = i, .result = (*results)[i], .inputs = {}});
    }
    return rows;
  };
}

/// The relative width of the widest bracket: a grid's ends are not known better.
double grid_tolerance(const WindowTable& window) {
  double widest = 1.0;
  for (const WindowRow& row : window.rows) {
    widest = std::fmax(widest, row.hold_bracket_high_N / row.hold_bracket_low_N);
    widest = std::fmax(widest, row.damage_bracket_high_N / row.damage_bracket_low_N);
  }
  return widest - 1.0;
}

/// Rows of which some have other results.
class ReplacedRows : public RowSource {
 public:
  /// @param results by the place of the row
  ReplacedRows(StudyRows rows, std::unordered_map<std::size_t, ScenarioResult> results)
      : rows_(std::move(rows)), results_(std::move(results)) {}

  [[nodiscard]] std::size_t size() const override { return rows_.size(); }

  [[nodiscard]] RowBlock block(std::size_t first) const override {
    const RowBlock block = rows_.block(first);
    const auto part = block.rows.first(std::min(block.rows.size(), kRowsAtATime));
    auto rows = std::make_shared<std::vector<ScenarioRow>>(part.begin(), part.end());
    for (std::size_t i = 0; i < rows->size(); ++i) {
      if (const auto found = results_.find(first + i); found != results_.end()) (*rows)[i].result = found->second;
    }
    return {*rows, rows};
  }

 private:
  const StudyRows rows_;
  const std::unordered_map<std::size_t, ScenarioResult> results_;
};

/// The rows with those of `ids` at half the time step whose impact the step does not resolve.
struct RowsAgain {
  StudyRows rows;
  std::size_t repeated = 0;
};

std::optional<RowsAgain> rows_again(const KindInput& input, const StudyRows& rows,
                                    const std::function<bool(std::uint64_t id)>& matters) {
  std::vector<std::pair<std::size_t, std::uint64_t>> places;  // and ids
  std::size_t place = 0;
  for (const ScenarioRow& row : rows) {
    if (impact_is_unresolved(row.result) && matters(row.id)) places.emplace_back(place, row.id);
    ++place;
  }
  const ScenarioSet set = scenario_set(input.study);
  const auto results = run_unrecorded(input, places.size(), [&](std::uint64_t k) {
    Scenario scenario = set.scenario(places[k].second);
    scenario.simulation.time_step_s *= 0.5;
    return scenario;
  });
  if (!results) return std::nullopt;
  std::unordered_map<std::size_t, ScenarioResult> by_place;
  for (std::size_t k = 0; k < places.size(); ++k) by_place.emplace(places[k].first, (*results)[k]);
  return RowsAgain{std::make_shared<const ReplacedRows>(rows, std::move(by_place)), places.size()};
}

void add_check(ResultTable table, KindAnswer& answer) {
  answer.found.push_back(std::move(table));
  answer.warnings = check_warnings(answer.found);
}

}  // namespace

std::optional<WindowAnswer> sweep_window_answer(const KindInput& input, const std::vector<ColumnInfo>& columns,
                                                const StudyRows& rows, StudyWindow& window,
                                                std::vector<std::string>& warnings) {
  const ForceRunner run = unrecorded_forces(input);
  auto answer = look_at_half_step(
      {.study = input.study,
       .ends = LookAt::impacts_only,
       .range = {.from_N = window.from_N, .to_N = window.to_N, .tolerance = grid_tolerance(window.table)},
       .run = run,
       .answer = [&] { return answer_of(input.study, window, columns, rows); }},
      window);
  if (answer) warnings = half_step_warnings(input.study, window, 0.0);
  return answer;
}

bool check_grid_winner(const KindInput& input, const GridAnswer& found, const StudyRows& rows,
                       KindAnswer& answer) {
  if (!found.best || varies_time_step(input.study)) return true;
  const auto again = rows_again(input, rows, [&](std::uint64_t id) {
    return std::binary_search(found.best_rows.begin(), found.best_rows.end(), id);
  });
  if (!again) return false;
  if (again->repeated > 0) add_check(grid_check(input.study, found, {rows, again->rows, again->repeated}), answer);
  return true;
}

bool check_compare_winner(const KindInput& input, const StudyRows& rows, KindAnswer& answer) {
  const ResultTable* comparison = find_table(answer.found, "comparison");
  if (comparison == nullptr || text_attribute(*comparison, "winner").empty()) return true;
  const auto again = rows_again(input, rows, [](std::uint64_t) { return true; });
  if (!again) return false;
  if (again->repeated > 0) {
    add_check(compare_check(input.study, answer.found, {rows, again->rows, again->repeated}), answer);
  }
  return true;
}

}  // namespace unbruised::studies

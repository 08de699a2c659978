#include "studies/kinds/window_run.hpp"

#include <utility>

#include "studies/scenarios/scenario_set.hpp"

namespace unbruised::studies {
namespace {

class WindowStudy {
 public:
  WindowStudy(const Study& study, const std::vector<ColumnInfo>& columns, const ForceRunner& run)
      : study_(study), columns_(columns), run_(run) {}

  std::optional<WindowRun> execute() {
    if (!search() || !look_again()) return std::nullopt;
    found_.warnings = half_step_warnings(study_, found_.window, study_.window().tolerance);
    return std::move(found_);
  }

 private:
  bool search() {
    auto ends =
        search_study_windows(study_, combinations_of(study_), [this](const std::vector<ForceRequest>& requests) {
          auto rows = run_(requests);
          if (rows) rows_.insert(rows_.end(), rows->begin(), rows->end());
          return rows;
        });
    if (!ends) return false;
    found_.window.table.inputs = scenario_set(study_).columns;
    found_.window.table.rows = *std::move(ends);
    for (std::size_t point = 0; point < found_.window.table.rows.size(); ++point) {
      found_.window.table.rows[point].inputs = grid_inputs(study_, point);
      found_.window.points.push_back(point);
    }
    return true;
  }

  /// At half the time step. Cycle times are those of the time step as written.
  bool look_again() {
    const WindowSettings& range = study_.window();
    auto answer =
        look_at_half_step({.study = study_,
                           .ends = LookAt::deciding_ends,
                           .range = {range.from_N, range.to_N, range.tolerance},
                           .run = run_,
                           .answer = [this] { return answer_of(study_, found_.window, columns_, rows_); }},
                          found_.window);
    if (answer) found_.answer = *std::move(answer);
    return answer.has_value();
  }

  const Study& study_;
  const std::vector<ColumnInfo>& columns_;
  const ForceRunner& run_;
  std::vector<ScenarioRow> rows_;  ///< of the search, in the order of asking
  WindowRun found_;
};

}  // namespace

std::vector<SearchedCombination> combinations_of(const Study& study) {
  return searched_combinations(factor_groups(scenario_set(study)));
}

WindowSearchSettings window_search_settings(const Study& study, std::vector<SearchedCombination> combinations) {
  const WindowSettings& range = study.window();
  return {.from_N = range.from_N,
          .to_N = range.to_N,
          .tolerance = range.tolerance,
          .combinations = std::move(combinations)};
}

std::optional<std::vector<WindowRow>> search_study_windows(const Study& study,
                                                           std::vector<SearchedCombination> combinations,
                                                           const ForceRunner& run) {
  const WindowSearchSettings settings = window_search_settings(study, std::move(combinations));
  WindowSearchResult result = search_windows(settings, [&](const std::vector<ForceRequest>& requests) {
    const auto rows = run(requests);
    return rows ? std::optional(samples_of(study, requests, *rows)) : std::nullopt;
  });
  if (result.interrupted) return std::nullopt;
  return std::move(result.rows);
}

std::optional<WindowRun> run_window_study(const Study& study, const std::vector<ColumnInfo>& columns,
                                          const ForceRunner& run) {
  return WindowStudy(study, columns, run).execute();
}

}  // namespace unbruised::studies

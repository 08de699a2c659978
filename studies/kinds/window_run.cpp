#include "studies/kinds/window_run.hpp"

#include <cstdint>
#include <utility>

#include "studies/scenarios/scenario_set.hpp"

namespace unbruised::studies {
namespace {

class WindowStudy {
 public:
  WindowStudy(const Study& study, const std::vector<std::size_t>& factor_group,
              const std::vector<ColumnInfo>& columns, const ForceRunner& run)
      : study_(study), factor_group_(factor_group), columns_(columns), run_(run) {}

  std::optional<WindowRun> execute() {
    if (!search() || !look_again()) return std::nullopt;
    found_.warnings = half_step_warnings(study_, found_.window, study_.window().tolerance);
    return std::move(found_);
  }

 private:
  bool search() {
    const WindowSettings& range = study_.window();
    const WindowSearchSettings settings{
        .from_N = range.from_N, .to_N = range.to_N, .tolerance = range.tolerance, .factor_group = factor_group_};
    const WindowSearchResult result = search_windows(settings, [this](const std::vector<ForceRequest>& requests) {
      const auto rows = run_(requests);
      if (rows) rows_.insert(rows_.end(), rows->begin(), rows->end());
      return rows ? std::optional(samples_of(study_, requests, *rows)) : std::nullopt;
    });
    if (result.interrupted) return false;
    next_id_ = result.evaluation_count;
    found_.window.table.inputs = scenario_set(study_).columns;
    found_.window.table.rows = result.rows;
    for (std::size_t point = 0; point < result.rows.size(); ++point) {
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
                           .range = {range.from_N, range.to_N, range.tolerance, next_id_},
                           .run = run_,
                           .answer = [this] { return answer_of(study_, found_.window, columns_, rows_); }},
                          found_.window);
    if (answer) found_.answer = *std::move(answer);
    return answer.has_value();
  }

  const Study& study_;
  const std::vector<std::size_t>& factor_group_;
  const std::vector<ColumnInfo>& columns_;
  const ForceRunner& run_;
  std::vector<ScenarioRow> rows_;  ///< of the search, in the order of asking
  std::uint64_t next_id_ = 0;
  WindowRun found_;
};

}  // namespace

std::optional<WindowRun> run_window_study(const Study& study, const std::vector<std::size_t>& factor_group,
                                          const std::vector<ColumnInfo>& columns, const ForceRunner& run) {
  return WindowStudy(study, factor_group, columns, run).execute();
}

}  // namespace unbruised::studies

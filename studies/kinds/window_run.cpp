#include "studies/kinds/window_run.hpp"

#include <cstdint>
#include <utility>

#include "studies/kinds/half_step.hpp"
#include "studies/scenarios/scenario_set.hpp"

namespace unbruised::studies {
namespace {

class WindowStudy {
 public:
  WindowStudy(const Study& study, const std::vector<std::size_t>& factor_group,
              const std::vector<ColumnInfo>& columns, const ForceRunner& run)
      : study_(study), factor_group_(factor_group), columns_(columns), run_(run) {}

  std::optional<WindowRun> execute() {
    if (!search() || !look_at_half_step()) return std::nullopt;
    found_.warnings = half_step_warnings(found_.window.table, study_.window().tolerance, time_steps());
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
      return rows ? std::optional(samples_of(requests, *rows)) : std::nullopt;
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

  /// Until the answer rests on no ends that were not looked at.
  bool look_at_half_step() {
    find_answer();
    if (varies_time_step(study_)) return true;
    for (auto ends = deciding_ends(found_.window.table, found_.answer); !ends.empty();
         ends = deciding_ends(found_.window.table, found_.answer)) {
      const EndSearchResult result = search_again(ends);
      if (result.interrupted) return false;
      next_id_ += result.evaluation_count;
      keep_half_step(found_.window.table, ends, result.safe_N);
      find_answer();
    }
    return true;
  }

  /// Cycle times are those of the time step as written.
  void find_answer() { found_.answer = answer_of(study_, found_.window, columns_, rows_); }

  EndSearchResult search_again(const std::vector<KnownEnd>& ends) {
    const WindowSettings& range = study_.window();
    const EndSearchSettings settings{
        .from_N = range.from_N, .to_N = range.to_N, .tolerance = range.tolerance, .first_id = next_id_};
    return search_ends(ends, settings,
                       [&](const std::vector<EndRequest>& asked) { return safe_sides(ends, asked); });
  }

  std::optional<std::vector<bool>> safe_sides(const std::vector<KnownEnd>& ends,
                                              const std::vector<EndRequest>& asked) {
    std::vector<ForceRequest> requests;
    for (const EndRequest& each : asked) {
      const std::size_t point = found_.window.points[ends[each.end].row];
      requests.push_back({each.id, point, each.grip_force_N, StepSize::half});
    }
    const auto rows = run_(requests);
    if (!rows) return std::nullopt;
    const std::vector<GripSample> samples = samples_of(requests, *rows);
    std::vector<bool> safe;
    for (std::size_t i = 0; i < asked.size(); ++i) safe.push_back(is_safe(samples[i], ends[asked[i].end].end));
    return safe;
  }

  [[nodiscard]] std::vector<GripSample> samples_of(const std::vector<ForceRequest>& requests,
                                                   const std::vector<ScenarioRow>& rows) const {
    std::vector<GripSample> samples;
    for (std::size_t i = 0; i < requests.size(); ++i) {
      const Scenario scenario = study_.scenario(requests[i].combination);
      samples.push_back(grip_sample(rows[i].result, scenario, requests[i].grip_force_N));
    }
    return samples;
  }

  [[nodiscard]] std::vector<double> time_steps() const {
    std::vector<double> steps;
    for (const std::size_t point : found_.window.points) {
      steps.push_back(study_.scenario(point).simulation.time_step_s);
    }
    return steps;
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

#include "studies/kinds/window_findings.hpp"

#include <map>
#include <utility>

#include "studies/goals/verdict.hpp"
#include "studies/scenarios/scenario_set.hpp"

namespace unbruised::studies {
namespace {

std::optional<std::size_t> column_of(const Study& study, const std::string& key) {
  for (std::size_t i = 0; i < study.inputs().size(); ++i) {
    if (study.inputs()[i].key == key) return i;
  }
  return std::nullopt;
}

template <class T>
std::vector<T> without(std::vector<T> values, std::size_t place) {
  values.erase(values.begin() + static_cast<std::ptrdiff_t>(place));
  return values;
}

}  // namespace

GripSample grip_sample(const ScenarioResult& result, const LimitParameters& limits, double grip_force_N) {
  return {.grip_force_N = grip_force_N,
          .holds = holds(result.metrics, result.outcome, limits),
          .undamaged = undamaged(result.metrics, result.outcome, limits),
          .peak_finger_force_N = result.metrics[Metric::peak_finger_force_N]};
}

std::optional<StudyWindow> window_of_sweep(const Study& study, const std::vector<ScenarioRow>& rows) {
  const std::optional<std::size_t> force_column = column_of(study, kGripForceKey);
  if (!force_column) return std::nullopt;
  // Points that agree in all other keys stand together, in the order of the study.
  std::map<std::vector<std::size_t>, std::vector<GripSample>> samples;
  std::map<std::vector<std::size_t>, std::uint64_t> a_point_of;
  for (const ScenarioRow& row : rows) {
    std::vector<std::size_t> others;
    for (std::size_t i = 0; i < study.inputs().size(); ++i) {
      if (i != *force_column) others.push_back(study.input_index(row.id, i));
    }
    const double force_N = study.input_number(row.id, *force_column);
    samples[others].push_back(grip_sample(row.result, study.scenario(row.id).limits, force_N));
    a_point_of.try_emplace(std::move(others), row.id);
  }
  StudyWindow window;
  window.table.inputs = without(scenario_set(study).columns, *force_column);
  for (auto& [others, group] : samples) {
    const std::uint64_t point = a_point_of.at(others);
    WindowRow row = read_grip_window(std::move(group));
    row.inputs = without(grid_inputs(study, point), *force_column);
    window.table.rows.push_back(std::move(row));
    window.points.push_back(point);
  }
  return window;
}

WindowAnswer answer_of(const Study& study, StudyWindow& window, const std::vector<ColumnInfo>& inputs,
                       const std::vector<ScenarioRow>& rows) {
  const SettingOfRow setting = [&](std::size_t row) {
    return force_setting(study.scenario(window.points[row]).gripper.value_or(GripperParameters{}));
  };
  add_set_points(window.table, setting);
  return window_answer(window.table, setting, inputs, rows);
}

}  // namespace unbruised::studies

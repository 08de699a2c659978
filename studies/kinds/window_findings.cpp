#include "studies/kinds/window_findings.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "studies/findings/balances.hpp"
#include "studies/findings/sizing.hpp"
#include "studies/goals/verdict.hpp"
#include "studies/scenarios/scenario_set.hpp"
#include "studies/text/key_names.hpp"

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

/// Does any combination know more than one force? A force that follows another key, e.g. one for each product,
/// asks nothing about windows.
bool has_two_forces(const std::map<std::vector<std::size_t>, std::vector<GripSample>>& samples) {
  return std::any_of(samples.begin(), samples.end(), [](const auto& combination) {
    const std::vector<GripSample>& group = combination.second;
    return std::any_of(group.begin(), group.end(), [&](const GripSample& sample) {
      return sample.grip_force_N != group.front().grip_force_N;
    });
  });
}

}  // namespace

GripSample grip_sample(const ScenarioResult& result, const Scenario& scenario, double grip_force_N) {
  return {.grip_force_N = grip_force_N,
          .holds = holds(result.metrics, result.outcome, scenario.limits),
          .undamaged = undamaged(result.metrics, result.outcome, scenario.limits),
          .peak_finger_force_N = result.metrics[Metric::peak_finger_force_N],
          .damage = damage_claim(scenario),
          .unresolved_impact = impact_is_unresolved(result)};
}

Scenario window_scenario(const Study& study, std::size_t point, double grip_force_N, StepSize step) {
  Scenario scenario = study.scenario(point);
  scenario.strategy.grip_force_N = grip_force_N;
  scenario.strategy.contact_force_N = std::min(scenario.strategy.contact_force_N, grip_force_N);
  if (step == StepSize::half) scenario.simulation.time_step_s *= 0.5;
  return scenario;
}

bool varies_time_step(const Study& study) { return column_of(study, kTimeStepKey).has_value(); }

void add_window_columns(const Study& study, std::vector<ColumnInfo>& columns) {
  if (!varies_time_step(study))
    columns.push_back({kTimeStepKey, "s", "time step; half of it where the ends were looked at again"});
  columns.push_back({kGripForceKey, "N", "drive force limit of each finger"});
}

std::vector<InputValue> window_inputs(const Study& study, const ForceRequest& request) {
  std::vector<InputValue> inputs = grid_inputs(study, request.combination());
  if (!varies_time_step(study)) {
    const Scenario scenario = window_scenario(study, request.combination(), request.grip_force_N, request.step);
    inputs.emplace_back(scenario.simulation.time_step_s);
  }
  inputs.emplace_back(request.grip_force_N);
  return inputs;
}

std::optional<Scenario> scenario_of_window_inputs(const Study& study, const std::vector<InputValue>& inputs) {
  if (inputs.empty() || !std::holds_alternative<double>(inputs.back())) return std::nullopt;
  ForceRequest request{.place = {}, .grip_force_N = std::get<double>(inputs.back())};
  for (std::size_t point = 0; point < study.scenario_count(); ++point) {
    request.place.generation = point;
    for (const StepSize step : {StepSize::as_written, StepSize::half}) {
      request.step = step;
      if (window_inputs(study, request) != inputs) continue;
      return window_scenario(study, point, request.grip_force_N, step);
    }
  }
  return std::nullopt;
}

std::optional<StudyWindow> window_of_sweep(const Study& study, const StudyRows& rows) {
  const std::optional<std::size_t> force_column = column_of(study, kGripForceKey);
  if (!force_column) return std::nullopt;
  // Points that agree in all other keys stand together, in the order of the study.
  StudyWindow window;
  std::map<std::vector<std::size_t>, std::vector<GripSample>> samples;
  std::map<std::vector<std::size_t>, std::uint64_t> a_point_of;
  for (const ScenarioRow& row : rows) {
    std::vector<std::size_t> others;
    for (std::size_t i = 0; i < study.inputs().size(); ++i) {
      if (i != *force_column) others.push_back(study.input_index(row.id, i));
    }
    const double force_N = study.input_number(row.id, *force_column);
    window.from_N = std::fmin(window.from_N, force_N);
    window.to_N = std::fmax(window.to_N, force_N);
    samples[others].push_back(grip_sample(row.result, study.scenario(row.id), force_N));
    a_point_of.try_emplace(std::move(others), row.id);
  }
  if (!has_two_forces(samples)) return std::nullopt;
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
                       const StudyRows& rows) {
  const SettingOfRow setting = [&](std::size_t row) {
    return force_setting(jaw_of(study.scenario(window.points[row])));
  };
  add_set_points(window.table, setting);
  return window_answer(window.table, setting, inputs, rows);
}

ResultTable sizing_of(const Study& study, const StudyWindow& window, const WindowAnswer& answer) {
  return sizing_table(answer, [&](std::size_t row) { return study.scenario(window.points[row]); });
}

}  // namespace unbruised::studies

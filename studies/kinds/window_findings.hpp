#pragma once

/// @file
/// Windows of a study and what follows from them: the window table of a sweep's grid, set-points, the answer.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/scenario/scenario.hpp"
#include "studies/config/study.hpp"
#include "studies/findings/grip_window.hpp"
#include "studies/findings/window_answer.hpp"
#include "studies/kinds/window_search.hpp"
#include "studies/results/rows.hpp"
#include "studies/text/key_names.hpp"

namespace unbruised::studies {

/// A window table with a point of the study's grid for each row.
struct StudyWindow {
  WindowTable table;
  std::vector<std::size_t> points;
  double from_N = kAbsent, to_N = kAbsent;  ///< of a sweep: the least and the greatest force of its grid
};

GripSample grip_sample(const ScenarioResult& result, const Scenario& scenario, double grip_force_N);

/// The scenario of a window study at a point of its grid, with this grip force; `contact_force_N` never exceeds
/// it.
Scenario window_scenario(const Study& study, std::size_t point, double grip_force_N,
                         StepSize step = StepSize::as_written);

/// Does the study vary the time step? Then nothing is repeated at half of it.
bool varies_time_step(const Study& study);

/// The columns of a window study behind those of its grid: the time step (where the grid has it not) and the grip
/// force; and the inputs of one evaluation, in the order of all columns.
void add_window_columns(const Study& study, std::vector<ColumnInfo>& columns);
std::vector<InputValue> window_inputs(const Study& study, const ForceRequest& request);
/// The scenario of such inputs; nothing when they are none of the study's.
std::optional<Scenario> scenario_of_window_inputs(const Study& study, const std::vector<InputValue>& inputs);

/// The window of a sweep over the grip force, read from its grid; nothing when the grip force is not varied.
std::optional<StudyWindow> window_of_sweep(const Study& study, const StudyRows& rows);

/// Fills the set-points of the table and says what the study answers. @param inputs, rows of all scenarios
WindowAnswer answer_of(const Study& study, StudyWindow& window, const std::vector<ColumnInfo>& inputs,
                       const StudyRows& rows);

/// The sizing sheet of these strategies.
ResultTable sizing_of(const Study& study, const StudyWindow& window, const WindowAnswer& answer);

}  // namespace unbruised::studies

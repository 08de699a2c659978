#pragma once

/// @file
/// The contact of a study that gets the fewest time steps, anywhere between the ends of what it varies; and the
/// time step that is chosen where a study gives none.

#include "studies/config/study.hpp"
#include "studies/config/study_data.hpp"

namespace unbruised::studies {

/// Over the ends of the grid, every candidate, the ends and the middle of what is searched or drawn, and of a
/// window's forces from the least to the (geometric) middle. A contact time rises or falls with a key, or turns
/// once, gently.
ContactSteps fewest_contact_steps(const StudyData& data);

/// Chosen steps lie between these: a longer one is not worth its coarser trace, a shorter one takes a study longer
/// than anybody would want without having asked for it.
inline constexpr double kLeastChosenStep_s = 1e-4;
inline constexpr double kLongestChosenStep_s = 1e-3;

/// Writes a time step into every scenario of the study.
void set_time_step(StudyData& data, double time_step_s);

/// Writes the step that gives its shortest contact `kStepsPerContact` steps,
/// rounded down to two digits and between kLeastChosenStep_s and kLongestChosenStep_s; one for the whole study, so
/// that factor groups stay shared.
void choose_time_step(StudyData& data);

}  // namespace unbruised::studies

#pragma once

/// @file
/// Does the answer of a window study depend on the time step? The ends that decide it are looked for again at half
/// of it.

#include <string>
#include <vector>

#include "studies/kinds/end_search.hpp"
#include "studies/kinds/window_findings.hpp"

namespace unbruised::studies {

/// The ends of the rows that set the common window of the best strategies (where none has a set-point: of the
/// first with a window) and were not looked at yet.
std::vector<KnownEnd> deciding_ends(const WindowTable& window, const WindowAnswer& answer);

/// Does a run lie on the safe side of an end?
bool is_safe(const GripSample& sample, WindowEnd end);

/// Writes what was found at half the time step into the table: infinite (F_hold) or zero (F_damage) where no force
/// of the range is on the safe side any more.
void keep_half_step(WindowTable& window, const std::vector<KnownEnd>& ends, const std::vector<double>& safe_N);

/// One sentence for each end that moves by more than the tolerance.
/// @param time_step_s as the study has it, of each row
std::vector<std::string> half_step_warnings(const WindowTable& window, double tolerance,
                                            const std::vector<double>& time_step_s);

}  // namespace unbruised::studies

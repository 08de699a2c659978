#pragma once

/// @file
/// How far the ends of a window move at half the time step.

#include <string>
#include <vector>

#include "studies/results/rows.hpp"

namespace unbruised::studies {

/// One end that was looked at again.
struct EndMove {
  const char* name = "F_hold";
  double as_found_N = 0.0;
  double half_step_N = 0.0;
  double relative = 0.0;  ///< half_step_N / as_found_N - 1
};

/// Of a row: none, one or both.
std::vector<EndMove> half_step_moves(const WindowRow& row);

/// "F_damage falls from 4.81 to 3.69 N (-23 %)", "F_hold stays at 1.27 N"
std::string move_text(const EndMove& move);

}  // namespace unbruised::studies

#pragma once

/// @file
/// The columns of the window table beside its inputs: one list for whoever writes, reads or shows them.

#include <array>
#include <string_view>

#include "studies/results/rows.hpp"

namespace unbruised::studies {

struct WindowNumber {
  const char* name;
  double WindowRow::*value;
  const char* units;
  const char* long_name;
};

struct WindowFlag {
  const char* name;
  bool WindowRow::*value;
  std::array<std::string_view, 2> words;  ///< of 0 and 1
  const char* long_name;
};

struct WindowText {
  const char* name;
  std::string WindowRow::*value;
  const char* long_name;
};

inline constexpr std::array<WindowNumber, 11> kWindowNumbers = {{
    {"hold_force_N", &WindowRow::hold_force_N, "N", "least grip force that neither drops nor slips"},
    {"damage_force_N", &WindowRow::damage_force_N, "N",
     "greatest of the holding forces that exceeds no damage limit"},
    {"margin", &WindowRow::margin, "1", "damage_force_N / hold_force_N - 1"},
    {"hold_bracket_low_N", &WindowRow::hold_bracket_low_N, "N", "greatest grip force known not to hold"},
    {"hold_bracket_high_N", &WindowRow::hold_bracket_high_N, "N", "least grip force known to hold"},
    {"damage_bracket_low_N", &WindowRow::damage_bracket_low_N, "N", "greatest grip force known not to damage"},
    {"damage_bracket_high_N", &WindowRow::damage_bracket_high_N, "N", "least grip force known to damage"},
    {"hold_force_half_step_N", &WindowRow::hold_force_half_step_N, "N", "hold_force_N at half the time step"},
    {"damage_force_half_step_N", &WindowRow::damage_force_half_step_N, "N",
     "damage_force_N at half the time step"},
    {"set_point_N", &WindowRow::set_point_N, "N", "grip force to set at this combination"},
    {"set_point_tolerance_N", &WindowRow::set_point_tolerance_N, "N",
     "the setting may be off by this either way; the gripper's accuracy is taken off already"},
}};

inline constexpr std::array<WindowFlag, 2> kWindowFlags = {{
    {"exists", &WindowRow::exists, {"no_window", "window"}, "is there a grip force that holds unharmed"},
    {"set_point_exists",
     &WindowRow::set_point_exists,
     {"no_set_point", "set_point"},
     "is there a force in the window that this gripper can set and keep"},
}};

inline constexpr std::array<WindowText, 3> kWindowTexts = {{
    {"note", &WindowRow::note, "remark on this window"},
    {"intervals", &WindowRow::intervals, "all grip forces that hold unharmed, in N"},
    {"set_point_note", &WindowRow::set_point_note, "the set-point, or why there is none"},
}};

}  // namespace unbruised::studies

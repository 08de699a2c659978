#pragma once

/// @file
/// Finds F_hold and F_damage of many combinations at once: every round asks for the forces of all combinations
/// together, so that lanes are full. Rounds depend on the answers alone, never on their order of arrival nor on
/// the machine.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "studies/findings/grip_window.hpp"
#include "studies/results/rows.hpp"

namespace unbruised::studies {

struct WindowSearchSettings {
  /// > 0
  double from_N = 0.1;
  /// > from_N
  double to_N = 10.0;
  /// > 0; a bracket is done when high <= low (1 + tolerance)
  double tolerance = 0.005;
  /// Factor group of each combination; its length is the number of combinations.
  std::vector<std::size_t> factor_group;
};

/// With which time step a run is made.
enum class StepSize { as_written, half };

/// A force to try. Ids count on from 0 by (round, combination, force).
struct ForceRequest {
  std::uint64_t id = 0;
  std::size_t combination = 0;
  double grip_force_N = 0.0;
  StepSize step = StepSize::as_written;
};

/// Answers in the order of the requests (`grip_force_N` is filled in by the search); nothing: interrupted.
using ForceEvaluator = std::function<std::optional<std::vector<GripSample>>(const std::vector<ForceRequest>&)>;

struct WindowSearchResult {
  std::vector<WindowRow> rows;  ///< one per combination, without inputs; empty when interrupted
  std::uint64_t evaluation_count = 0;
  int round_count = 0;
  bool interrupted = false;
};

/// Round 0 samples [from_N, to_N] log-evenly, ends included; each later one cuts every open bracket of every
/// combination (`deciding_brackets`) into k + 1 parts of equal ratio, k chosen so that each factor group asks
/// enough at once to fill lanes.
WindowSearchResult search_windows(const WindowSearchSettings& settings, const ForceEvaluator& evaluate);

}  // namespace unbruised::studies

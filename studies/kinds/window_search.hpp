#pragma once

/// @file
/// Finds F_hold and F_damage of many combinations at once: every round asks for the forces of all combinations
/// together, so that lanes are full. The forces of a combination depend on its own answers alone, never on other
/// combinations, the order of arrival, nor the machine: some of the combinations can be searched by others.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "studies/findings/grip_window.hpp"
#include "studies/results/rows.hpp"

namespace unbruised::studies {

/// A combination whose window is searched.
struct SearchedCombination {
  std::uint64_t number = 0;
  /// > 0; combinations of its factor group in the whole study, itself among them: they fill lanes together
  std::size_t group_size = 1;
};
/// All combinations of a study. @param factor_group of each
std::vector<SearchedCombination> searched_combinations(const std::vector<std::size_t>& factor_group);

struct WindowSearchSettings {
  /// > 0
  double from_N = 0.1;
  /// > from_N
  double to_N = 10.0;
  /// > 0; a bracket is done when high <= low (1 + tolerance)
  double tolerance = 0.005;
  std::vector<SearchedCombination> combinations;  ///< by ascending number
};

/// With which time step a run is made.
enum class StepSize { as_written, half };

/// A force to try.
struct ForceRequest {
  SearchPlace place;  ///< (round, combination, number of the force in both)
  double grip_force_N = 0.0;
  StepSize step = StepSize::as_written;

  [[nodiscard]] std::size_t combination() const { return place.generation; }
};

/// Rounds of one search, at most: bisection needs 30 for a ratio of 1e6 at a tolerance of 1e-3. What is asked
/// after it has rounds from here on.
inline constexpr std::uint64_t kWindowRoundsMost = 100;

/// Answers in the order of the requests (`grip_force_N` is filled in by the search); nothing: interrupted.
using ForceEvaluator = std::function<std::optional<std::vector<GripSample>>(const std::vector<ForceRequest>&)>;

struct WindowSearchResult {
  std::vector<WindowRow> rows;  ///< one per combination, without inputs; empty when interrupted
  std::uint64_t evaluation_count = 0;
  std::uint64_t round_count = 0;
  bool interrupted = false;
};

/// Round 0 samples [from_N, to_N] log-evenly, ends included; each later one cuts every open bracket of every
/// combination (`deciding_brackets`) into k + 1 parts of equal ratio, k chosen so that each factor group asks
/// enough at once to fill lanes when its combinations have as many open brackets each.
WindowSearchResult search_windows(const WindowSearchSettings& settings, const ForceEvaluator& evaluate);

}  // namespace unbruised::studies

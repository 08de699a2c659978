#pragma once

/// @file
/// Where an end of a known window lies under another condition (half the time step): asked at the known bracket
/// first, outwards only where it does not hold, then narrowed. Many ends are asked together.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "studies/results/rows.hpp"

namespace unbruised::studies {

enum class WindowEnd { hold, damage };

/// An end as it is known: the safe force next to it, and the unsafe one on its other side.
struct KnownEnd {
  std::size_t row = 0;  ///< of the window table
  WindowEnd end = WindowEnd::hold;
  /// > 0
  double safe_N = 0.0;
  /// NaN where the range that was searched ends before the window does
  double unsafe_N = kAbsent;
};

/// A force to try at an end.
struct EndRequest {
  std::size_t end = 0;  ///< index into the known ends
  double grip_force_N = 0.0;
};

/// Does the force lie on the safe side, in the order of the requests, those of one round? Nothing: interrupted.
using EndEvaluator = std::function<std::optional<std::vector<bool>>(const std::vector<EndRequest>&)>;

struct EndSearchSettings {
  /// > 0, < to_N: the range of the forces
  double from_N = 0.1;
  double to_N = 10.0;
  /// > 0; relative width at which the search stops
  double tolerance = 0.005;
};

struct EndSearchResult {
  /// The safe force next to each end; NaN where no force of the range is safe.
  std::vector<double> safe_N;
  std::uint64_t evaluation_count = 0;
  bool interrupted = false;
};

/// The rounds and their forces follow from the answers alone, ends and forces in their order.
EndSearchResult search_ends(const std::vector<KnownEnd>& ends, const EndSearchSettings& settings,
                            const EndEvaluator& evaluate);

}  // namespace unbruised::studies

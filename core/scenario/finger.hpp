#pragma once

/// @file
/// How fingers hold, and where more than two of them stand.

#include <array>
#include <optional>
#include <vector>

namespace unbruised {

/// What keeps the fingers pressed once the grip's force has risen.
enum class HoldMode {
  force,     ///< the drives go on pressing
  position,  ///< the fingers are locked where they are
};

/// One of a list of fingers. Exactly one of angle and direction is given.
struct FingerParameters {
  /// Of where it stands about the vertical, from x; it closes towards the middle.
  std::optional<double> angle_rad;
  /// Not zero; in which it closes, of any length.
  std::optional<std::array<double, 3>> direction;
  /// From the middle of the grip to the line on which its pad's middle moves.
  std::array<double, 3> offset_m{0.0, 0.0, 0.0};
};

}  // namespace unbruised

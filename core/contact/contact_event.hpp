#pragma once

/// @file
/// What the contact state register tells of its changes.

#include <array>
#include <cstdint>
#include <string_view>

namespace unbruised {

/// A change of one contact in the contact state register.
struct ContactEvent {
  enum class Kind : std::int8_t { make = 0, break_ = 1, stick = 2, slip = 3 };
  double time_s = 0.0;  ///< interpolated inside the step
  int node = 0;         ///< particle index
  int surface = 0;      ///< its number in `kSurfaces`
  Kind kind = Kind::make;
};

/// In the order of `ContactEvent::Kind`.
inline constexpr std::array<std::string_view, 4> kContactEventWords = {"make", "break", "stick", "slip"};

}  // namespace unbruised

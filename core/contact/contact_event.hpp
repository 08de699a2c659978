#pragma once

/// @file
/// What the contact state register tells of its changes.

#include <cstdint>

namespace unbruised {

/// A change of one contact in the contact state register.
struct ContactEvent {
  enum class Kind : std::int8_t { make = 0, break_ = 1, stick = 2, slip = 3 };
  double time_s = 0.0;  ///< interpolated inside the step
  int node = 0;         ///< particle index
  int surface = 0;      ///< 0 left pad, 1 right pad, 2 support
  Kind kind = Kind::make;
};

}  // namespace unbruised

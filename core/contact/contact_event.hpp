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
  int surface = 0;      ///< its number in the trace
  Kind kind = Kind::make;
  int contact = 0;  ///< number of the candidate: a particle, or a place that it carries, before one surface
  std::array<double, 3> place_m{};  ///< of the contact in the cell at that time
  std::array<double, 3> force_N{};  ///< on the product at that time
};

/// In the order of `ContactEvent::Kind`.
inline constexpr std::array<std::string_view, 4> kContactEventWords = {"make", "break", "stick", "slip"};

}  // namespace unbruised

#pragma once

/// @file
/// Rotations of one body as unit quaternions; those of all lanes at once are in lanes/lane_rotation.hpp.

#include <array>

namespace unbruised {

/// w + x i + y j + z k, of length 1.
struct Attitude {
  double w = 1.0;
  std::array<double, 3> axis{};  ///< times the sine of half the angle
};

/// Half a turn as a person writes it, rounded up.
inline constexpr double kHalfTurn_rad = 3.1416;

/// About the vector by its length.
Attitude attitude_of(const std::array<double, 3>& rotation_rad);
/// The shortest rotation from upright to there, about the vector by its length [rad]. Half a turn, also one of
/// kHalfTurn_rad, goes about the axis that the attitude has.
std::array<double, 3> rotation_to(const Attitude& attitude);

/// First `second`, then `first`.
Attitude operator*(const Attitude& first, const Attitude& second);
Attitude inverse(const Attitude& attitude);
/// A vector that has turned with it.
std::array<double, 3> turned(const Attitude& attitude, const std::array<double, 3>& vector);
/// The angle between two attitudes, at most pi [rad].
double angle_between_rad(const Attitude& a, const Attitude& b);

}  // namespace unbruised

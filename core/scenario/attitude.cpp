#include "core/scenario/attitude.hpp"

#include <algorithm>
#include <cmath>

#include "core/scenario/vectors.hpp"

namespace unbruised {
namespace {

/// w of half a turn is the cosine of 1.5708, -4e-6, where it is written with five digits: still no way round the
/// other side.
constexpr double kHalfTurnRoom = -1e-5;

}  // namespace

Attitude attitude_of(const std::array<double, 3>& rotation_rad) {
  const double angle = length(rotation_rad);
  if (!(angle > 0.0)) return {};
  Attitude attitude{std::cos(0.5 * angle), rotation_rad};
  for (double& component : attitude.axis) component *= std::sin(0.5 * angle) / angle;
  return attitude;
}

std::array<double, 3> rotation_to(const Attitude& attitude) {
  const double sine = length(attitude.axis);
  if (!(sine > 0.0)) return {};
  const double sign = attitude.w < kHalfTurnRoom ? -1.0 : 1.0;
  const double angle = 2.0 * std::atan2(sine, sign * attitude.w);
  std::array<double, 3> rotation = attitude.axis;
  for (double& component : rotation) component *= sign * angle / sine;
  return rotation;
}

Attitude operator*(const Attitude& first, const Attitude& second) {
  Attitude both{first.w * second.w, cross(first.axis, second.axis)};
  for (std::size_t i = 0; i < 3; ++i) {
    both.w -= first.axis[i] * second.axis[i];
    both.axis[i] += first.w * second.axis[i] + second.w * first.axis[i];
  }
  return both;
}

Attitude inverse(const Attitude& attitude) {
  return {attitude.w, {-attitude.axis[0], -attitude.axis[1], -attitude.axis[2]}};
}

std::array<double, 3> turned(const Attitude& attitude, const std::array<double, 3>& vector) {
  // x + 2 w (q x x) + 2 q x (q x x)
  const std::array<double, 3> once = cross(attitude.axis, vector), twice = cross(attitude.axis, once);
  std::array<double, 3> out = vector;
  for (std::size_t i = 0; i < 3; ++i) out[i] += 2.0 * (attitude.w * once[i] + twice[i]);
  return out;
}

double angle_between_rad(const Attitude& a, const Attitude& b) {
  const Attitude between = inverse(a) * b;
  return 2.0 * std::atan2(length(between.axis), std::abs(between.w));
}

}  // namespace unbruised

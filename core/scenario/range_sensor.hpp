#pragma once

/// @file
/// The range sensors of a gripper.

#include <array>
#include <optional>

namespace unbruised {

/// A range sensor in each finger: a ray from a place at its pad's face along the way that the finger closes. It
/// reads how far the ray comes before it meets the product.
struct RangeSensorParameters {
  /// > 0; what it reads where the ray meets nothing nearer. None: there are no range sensors.
  std::optional<double> maximum_m;
  /// From the middle of the pad's face to the ray, along y and z.
  std::array<double, 2> offset_m{0.0, 0.0};
  /// How far the ray starts behind the pad's face; < 0: in front of it, but not within the product at the start.
  double depth_m = 0.0;
  /// > 0, <= 1 / time_step_s; a sample is held until the next. None: it reads at all times.
  std::optional<double> rate_Hz;
  /// >= 0; it reads multiples of this; 0: any range
  double resolution_m = 0.0;
  /// >= 0, needs rate_Hz; standard deviation of a sample
  double noise_m = 0.0;
  /// >= 0; scenarios with the same seed have the same noise.
  int noise_seed = 1;
};

}  // namespace unbruised

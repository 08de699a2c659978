#pragma once

/// @file
/// How far the product has slipped past a pad, as a person would measure it: by way at the centre of what the pad
/// presses on, and by angle about it (docs/metrics.md).

#include <array>
#include <cmath>

#include "core/lanes/lane.hpp"

namespace unbruised {

/// Of one pad, all lanes at once.
class PadSlip {
 public:
  /// Lets a lane's slip begin from here.
  void forget(int lane);

  void begin_step();
  /// Takes in how far a contact's anchor moved in this step; it counts by its force. @param place_m along the
  /// pad's tangents @param force_N 0 in lanes where it is open
  void add_closed(const std::array<Lane, 2>& place_m, const Lane& force_N, const std::array<Lane, 2>& moved_m);
  /// Takes in the way of a particle that does not touch, in lanes where `open`.
  void add_open(const std::array<Lane, 2>& way_m, const Mask& open);
  /// The motion of the product that fits those of the anchors best; while nothing touches, the mean way of the
  /// particles before the pad. @param least_radius_m contacts nearer together than this show no angle
  void end_step(double least_radius_m, const Mask& running);

  [[nodiscard]] double way_m(int lane) const {
    return std::sqrt(way_[0][lane] * way_[0][lane] + way_[1][lane] * way_[1][lane]);
  }
  [[nodiscard]] double angle_rad(int lane) const { return std::abs(angle_[lane]); }

 private:
  std::array<Lane, 2> way_{Lane(0.0), Lane(0.0)};
  Lane angle_{0.0};
  // Sums over the contacts of the present step, each times its force.
  Lane force_{0.0}, square_{0.0}, turn_{0.0};
  std::array<Lane, 2> moved_{Lane(0.0), Lane(0.0)}, place_{Lane(0.0), Lane(0.0)};
  std::array<Lane, 2> open_way_{Lane(0.0), Lane(0.0)};
  Lane open_count_{0.0};
};

}  // namespace unbruised

#pragma once

/// @file
/// How the surface of a conveyor moves: at one speed, or from one speed to another.

#include <array>

#include "core/motion/profile.hpp"
#include "core/scenario/scenario.hpp"

namespace unbruised {

class Belt {
 public:
  /// At rest for ever.
  Belt() = default;
  explicit Belt(const ConveyorParameters& conveyor);

  /// Along its direction: at one speed until its speed begins to change, also before the start of the run.
  [[nodiscard]] MotionProfile::State at(double time_s) const;
  /// Horizontal unit vector.
  [[nodiscard]] const std::array<double, 2>& direction() const { return direction_; }

 private:
  std::array<double, 2> direction_{0.0, 1.0};
  double start_speed_m_s_ = 0.0, end_speed_m_s_ = 0.0;
  double acceleration_m_s2_ = 0.0;  ///< signed
  double start_s_ = 0.0, change_s_ = 0.0;
};

}  // namespace unbruised

#pragma once

/// @file
/// A product that begins turned.

#include <array>

#include <Eigen/Dense>

#include "core/body/body_model.hpp"
#include "core/body/body_state.hpp"

namespace unbruised {

/// About a vector by its length.
class Rotation {
 public:
  explicit Rotation(const std::array<double, 3>& vector_rad);

  [[nodiscard]] const std::array<double, 3>& vector_rad() const { return vector_rad_; }
  [[nodiscard]] std::array<double, 3> of(const std::array<double, 3>& vector) const { return times(R_, vector); }
  [[nodiscard]] std::array<double, 3> back(const std::array<double, 3>& vector) const {
    return times(R_.transpose(), vector);
  }

 private:
  static std::array<double, 3> times(const Eigen::Matrix3d& matrix, const std::array<double, 3>& vector);

  std::array<double, 3> vector_rad_;
  Eigen::Matrix3d R_;
};

/// Turns a whole state about the centre of mass at rest: places, velocities and accelerations.
void turn_state(const BodyModel& body, const Rotation& turn, BodyState& state);

}  // namespace unbruised

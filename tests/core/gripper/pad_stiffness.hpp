#pragma once

/// @file
/// How stiff a pad that is a body is at rest, pressed or sheared as a whole.

#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include "core/door/eigen.hpp"
#include "core/gripper/pad_body.hpp"

namespace unbruised::testing {

/// Force over way of a face that moves as a whole along `axis`, its other motions held or free: conjugate
/// gradients on the forces of its particles.
inline double stiffness_N_m(const PadBody& pad, std::size_t axis, bool held) {
  const auto n = static_cast<Eigen::Index>(pad.face.size());
  const auto is_given = [&](std::size_t i) { return held || i == axis; };
  const auto motion = [&](const Eigen::VectorXd& force_N) {
    std::vector<double> force(3 * pad.body.particle_count, 0.0);
    for (Eigen::Index k = 0; k < 3 * n; ++k) {
      force[static_cast<std::size_t>(3 * pad.face[static_cast<std::size_t>(k / 3)] + k % 3)] = force_N[k];
    }
    const std::vector<double> u = pad.body.statics->free_shape(force);
    Eigen::VectorXd moved = Eigen::VectorXd::Zero(3 * n);
    for (Eigen::Index k = 0; k < 3 * n; ++k) {
      if (!is_given(static_cast<std::size_t>(k % 3))) continue;
      moved[k] = u[static_cast<std::size_t>(3 * pad.face[static_cast<std::size_t>(k / 3)] + k % 3)];
    }
    return moved;
  };
  Eigen::VectorXd wanted = Eigen::VectorXd::Zero(3 * n);
  for (Eigen::Index k = static_cast<Eigen::Index>(axis); k < 3 * n; k += 3) wanted[k] = 1.0;
  Eigen::VectorXd force = Eigen::VectorXd::Zero(3 * n), left = wanted, along = left;
  double square = left.squaredNorm();
  const double enough = 1e-20 * square;
  for (int i = 0; i < 1000 && square > enough; ++i) {
    const Eigen::VectorXd moved = motion(along);
    const double step = square / along.dot(moved);
    force += step * along;
    left -= step * moved;
    const double next = left.squaredNorm();
    along = left + next / square * along;
    square = next;
  }
  EXPECT_LE(square, enough);
  return wanted.dot(force);
}

}  // namespace unbruised::testing

#pragma once

/// @file
/// A rigid body on a spring: up to six freedoms with constant mass, damping and stiffness, M q'' + C q' + K q = w,
/// q the twist of its origin against what it is fixed to, w the wrench about it. The plate on a sensor and the
/// gripper on a wrist are such mounts.

#include <array>
#include <optional>

#include "core/scenario/scenario.hpp"

namespace unbruised {

/// A wrench (force, torque) or a twist (displacement, rotation).
using Six = std::array<double, 6>;

struct Mount {
  SixBySix mass{}, damping{}, stiffness{};
  std::array<double, 3> origin_m{};  ///< from where its carrier's axes begin
  bool carries_pads = false, carries_support = false;
};

/// The mount of a scenario's sensor; nothing where it has none.
/// @param grip_m centre of the pads @param foot_m where the support's plane lies under the product's middle
std::optional<Mount> sensor_mount(const Scenario& scenario, const std::array<double, 3>& grip_m,
                                  const std::array<double, 3>& foot_m);

/// A x.
Six multiply(const SixBySix& A, const Six& x);
/// x of A x = b, A symmetric and positive definite.
Six solve(const SixBySix& A, const Six& b);
/// A^-1.
SixBySix inverse(const SixBySix& A);
/// A wrench about another point. @param to that point, from the one it is about
Six moved(const Six& wrench, const std::array<double, 3>& to);
/// Wrench of a force at a place.
Six wrench_of(const std::array<double, 3>& force_N, const std::array<double, 3>& place_m);
/// Sum of b and the multiple of a.
Six add(const Six& b, double factor, const Six& a);

}  // namespace unbruised

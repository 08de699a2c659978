#pragma once

/// @file
/// One step of a relaxing material, exact for an elongation u that is linear over it. Each branch remembers
/// q = int exp(-(t - s) / tau) u'(s) ds, so that the stress is that of g_inf u + sum g q, and over a time h
///   q(t + h) = exp(-h / tau) q + xi (u(t + h) - u),  xi = (tau / h) (1 - exp(-h / tau)).

#include <span>
#include <vector>

#include "core/integration/wilson_theta.hpp"
#include "core/scenario/relaxation.hpp"

namespace unbruised {

struct BranchStep {
  double share;                   ///< g
  double time_s;                  ///< tau
  double keep_theta, gain_theta;  ///< exp(-h / tau) and xi over theta dt
  double keep, gain;              ///< over dt
};

struct RelaxationStep {
  double long_term = 1.0;  ///< g_inf
  /// Stiffness at t + theta dt over the instantaneous one, g_inf + sum g xi: the same in every step.
  double stiffness_theta = 1.0;
  std::vector<BranchStep> branch;

  /// Does it flow without end?
  [[nodiscard]] bool flows() const { return !branch.empty() && long_term == 0.0; }
  /// Of the instantaneous stiffness, with which a body that has stood for long carries its load; one that flows
  /// has been laid down just now.
  [[nodiscard]] double rest_share() const { return flows() ? 1.0 : long_term; }
  /// sum g tau: viscosity of what flows, over the instantaneous stiffness [s].
  [[nodiscard]] double flow_time_s() const;
};

RelaxationStep relaxation_step(std::span<const RelaxationBranch> branches, const WilsonTheta& wilson);

}  // namespace unbruised

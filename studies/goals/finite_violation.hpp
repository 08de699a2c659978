#pragma once

#include <algorithm>
#include <cmath>

namespace unbruised::studies {

/// Stands for an infinite violation: solvers take no infinities, and nothing simulated comes near it.
inline constexpr double kWorstViolation = 1e6;

/// The violation as a number that a solver takes; NaN is the worst.
inline double finite_violation(double violation) {
  if (std::isnan(violation)) return kWorstViolation;
  return std::clamp(violation, -kWorstViolation, kWorstViolation);
}

}  // namespace unbruised::studies

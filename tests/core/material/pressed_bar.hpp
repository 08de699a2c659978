#pragma once

/// @file
/// A bar lying between two slippery pads that press on its ends, slowly: its stress is the same everywhere.

#include <cmath>
#include <vector>

#include "tests/core/simulation/scenes.hpp"

namespace unbruised::testing {

inline constexpr double kE_Pa = 1e6, kLength_m = 0.06, kWidth_m = 0.02;

/// Without a force yet.
inline Scenario pressed_bar() {
  Scenario scenario = small_box();
  LatticeParameters& product = lattice_of(scenario);
  product.size_m = {kLength_m, kWidth_m, kWidth_m};
  product.youngs_modulus_Pa = kE_Pa;
  product.poisson_ratio = 0.3;
  product.friction = 0.0;
  only_grip(scenario);
  scenario.cell.approach_gap_m = 1e-4;
  jaw_of(scenario).pad_size_m = {0.04, 0.04};
  jaw_of(scenario).drive_viscous_N_s_m = 100.0;
  scenario.strategy.approach_speed_m_s = 0.01;
  scenario.strategy.contact_force_N = 0.1;
  return scenario;
}

inline constexpr double kYield_Pa = 3e4, kTangent_Pa = 3e5;

/// The same, which yields and is pressed so hard.
inline Scenario yielding_bar(double largest_stress_Pa) {
  Scenario scenario = pressed_bar();
  LatticeParameters& product = lattice_of(scenario);
  product.yield_stress_Pa = kYield_Pa;
  product.tangent_modulus_Pa = kTangent_Pa;
  product.relaxation_time_s = 5e-3;
  jaw_of(scenario).pad_modulus_Pa = 1e8;
  scenario.strategy.grip_force_N = largest_stress_Pa * kWidth_m * kWidth_m;
  scenario.strategy.grip_ramp_s = 3.0;
  scenario.strategy.settle_s = 0.5;
  scenario.strategy.recover_s = 0.5;
  scenario.simulation.time_step_s = 2e-3;
  return scenario;
}

/// Compressive strain between the ends of the bar, over time.
inline std::vector<double> bar_strain(const Trace& trace) {
  const auto n = static_cast<std::size_t>(trace.particle_count);
  std::vector<double> strain(trace.time_s.size(), 0.0);
  for (std::size_t k = 0; k < strain.size(); ++k) {
    for (std::size_t p = 0; p < n; ++p) {
      const double x = trace.rest_position_m[3 * p];
      if (std::abs(x) < 0.5 * kLength_m - 1e-9) continue;
      // Nine particles at each end; the pads push them inwards.
      strain[k] -= std::copysign(1.0, x) * trace.displacement_m[3 * (n * k + p)] / 9.0 / kLength_m;
    }
  }
  return strain;
}

}  // namespace unbruised::testing

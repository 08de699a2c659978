#pragma once

/// @file
/// Slow grips of the ripe kiwi's flesh: as the shipped fruit between the shipped pads, and as a sphere between
/// stiff plates.

#include <cmath>
#include <vector>

#include "tests/core/simulation/scenes.hpp"

namespace unbruised::testing {

/// configs/products/kiwi_ripe.toml between pads of 0.4 MPa and 3 mm; approach and grip only.
inline Scenario kiwi_grip(double cell_size_m) {
  Scenario scenario;
  LatticeParameters kiwi;
  kiwi.shape = Shape::ellipsoid;
  kiwi.size_m = {0.050, 0.071, 0.050};
  kiwi.cell_size_m = cell_size_m;
  kiwi.mass_kg = 0.095;
  kiwi.youngs_modulus_Pa = 0.288e6;
  kiwi.poisson_ratio = 0.35;
  kiwi.yield_stress_Pa = 0.024e6;
  kiwi.tangent_modulus_Pa = 0.080e6;
  kiwi.loss_ratio = 0.2;
  kiwi.at_frequency_Hz = 50.0;
  kiwi.friction = 0.6;
  scenario.product = kiwi;
  scenario.gripper = ParallelJawParameters{};
  scenario.cell.approach_gap_m = 5e-4;
  scenario.strategy.approach_speed_m_s = 0.02;
  scenario.strategy.contact_force_N = 0.1;
  scenario.strategy.grip_ramp_s = 0.2;
  scenario.strategy.settle_s = 1.0;
  scenario.simulation.time_step_s = 2e-3;
  scenario.simulation.duration_s = 0.35;
  return scenario;
}

/// Floating, R = 25 mm, between plates more than fifty times as stiff as the sphere.
inline Scenario sphere_between_plates(double cell_size_m) {
  Scenario scenario = kiwi_grip(cell_size_m);
  lattice_of(scenario).size_m[1] = 0.050;
  jaw_of(scenario).pad_modulus_Pa = 5e6;
  scenario.cell.gravity_m_s2 = {0.0, 0.0, 0.0};
  scenario.cell.support = false;
  return scenario;
}

/// Grip forces from `low_N` to `high_N` in equal ratios, one per lane.
inline std::vector<ScenarioResult> run_grips(const Scenario& scenario, double low_N, double high_N) {
  std::vector<Scenario> scenarios(static_cast<std::size_t>(lane_count()), scenario);
  for (std::size_t i = 0; i < scenarios.size(); ++i) {
    scenarios[i].strategy.grip_force_N =
        low_N * std::pow(high_N / low_N, static_cast<double>(i) / static_cast<double>(scenarios.size() - 1));
  }
  return run_side_by_side(scenarios);
}

/// Largest finger force at which contact_yield_ratio_max passes 1, linear between neighbouring grips; NaN:
/// nowhere.
inline double yield_force_N(const Scenario& scenario, double low_N, double high_N) {
  const auto grips = run_grips(scenario, low_N, high_N);
  for (std::size_t i = 1; i < grips.size(); ++i) {
    const Metrics &before = grips[i - 1].metrics, &after = grips[i].metrics;
    const double low = before[Metric::contact_yield_ratio_max], high = after[Metric::contact_yield_ratio_max];
    if (low > 1.0 || high <= 1.0) continue;
    const double from = before[Metric::peak_finger_force_N], to = after[Metric::peak_finger_force_N];
    return from + (1.0 - low) / (high - low) * (to - from);
  }
  return std::nan("");
}

}  // namespace unbruised::testing

// Coulomb friction on the support: a block that slides stops where it should, and slides only where it should.

#include <cmath>

#include <gtest/gtest.h>

#include "tests/core/simulation/scenes.hpp"

namespace unbruised {
namespace {

using namespace testing;

constexpr double kFriction = 0.5;

/// A flat block, too low to tip over, lying on the support.
Scenario block() {
  Scenario scenario = small_box();
  scenario.gripper = NoGripper{};
  lattice_of(scenario).size_m = {0.06, 0.06, 0.02};
  lattice_of(scenario).cell_size_m = 0.01;
  lattice_of(scenario).youngs_modulus_Pa = 1e6;
  scenario.cell.support_friction = kFriction;
  scenario.simulation.time_step_s = 5e-4;
  return scenario;
}

/// Mean displacement of all particles along an axis, over time.
std::vector<double> mean_way(const Trace& trace, std::size_t axis) {
  const auto n = static_cast<std::size_t>(trace.particle_count);
  std::vector<double> way(trace.time_s.size(), 0.0);
  for (std::size_t k = 0; k < way.size(); ++k) {
    for (std::size_t p = 0; p < n; ++p) {
      way[k] += (trace.displacement_m[3 * (n * k + p) + axis] - trace.displacement_m[3 * p + axis]) /
                static_cast<double>(n);
    }
  }
  return way;
}

/// Every row: the support pushes, and its tangential force stays inside the cone.
void expect_inside_the_cone(const Trace& trace, double friction) {
  const auto x = column(trace, "support_force_N", 0), y = column(trace, "support_force_N", 1),
             z = column(trace, "support_force_N", 2);
  for (std::size_t k = 0; k < z.size(); ++k) {
    EXPECT_GE(z[k], 0.0);
    EXPECT_LE(std::hypot(x[k], y[k]), friction * z[k] * (1.0 + 1e-12)) << "row " << k;
  }
}

TEST(Friction, StopsASlidingBlockWhereCoulombSays) {
  for (const std::array<double, 2> direction :
       {std::array<double, 2>{1.0, 0.0}, std::array<double, 2>{0.6, 0.8}}) {
    const double speed = 0.6;
    const double stop_s = speed / (kFriction * kGravity);
    const double stop_m = 0.5 * speed * stop_s;
    Scenario scenario = block();
    lattice_of(scenario).initial_velocity_m_s = {direction[0] * speed, direction[1] * speed, 0.0};
    scenario.simulation.duration_s = 1.5 * stop_s;
    Trace trace;
    const ScenarioResult result = run(scenario, &trace);
    expect_inside_the_cone(trace, kFriction);
    const std::vector<double> x = mean_way(trace, 0), y = mean_way(trace, 1);
    std::vector<double> way;
    for (std::size_t k = 0; k < x.size(); ++k) way.push_back(std::hypot(x[k], y[k]));
    // The mass rocks on the layer while it slides; that moves the place by some hundredths of a millimetre.
    EXPECT_NEAR(way.back(), stop_m, 0.01 * stop_m);
    EXPECT_NEAR(std::atan2(y.back(), x.back()), std::atan2(direction[1], direction[0]), 2e-3);
    const auto first_at_rest = static_cast<std::size_t>(std::max_element(way.begin(), way.end()) - way.begin());
    EXPECT_NEAR(trace.time_s[first_at_rest], stop_s, 0.015 * stop_s);
    EXPECT_LT(result.metrics[Metric::impulse_balance_error], 1e-6);
    // Measured 6e-6; sliding is one of the terms, so an account that missed it would be off by most of the energy.
    EXPECT_NEAR(result.metrics[Metric::energy_balance_error], 0.0, 1e-4);
    std::cout << "[ measured ] way " << way.back() << " m of " << stop_m << ", time "
              << trace.time_s[first_at_rest] << " s of " << stop_s << ", energy error "
              << result.metrics[Metric::energy_balance_error] << "\n";
  }
}

/// Ways down a slope of `tangent` at 0, 0.02, 0.11 and 0.2 s. The weight along the slope comes on at once; until
/// the layer is sheared far enough to hold it, some milliseconds, the block gains 1-2 mm/s.
std::array<double, 4> ways_on_slope(double tangent) {
  const double angle = std::atan(tangent);
  Scenario scenario = block();
  scenario.cell.gravity_m_s2 = {kGravity * std::sin(angle), 0.0, -kGravity * std::cos(angle)};
  scenario.simulation.duration_s = 0.2;
  Trace trace;
  run(scenario, &trace);
  expect_inside_the_cone(trace, kFriction);
  const std::vector<double> way = mean_way(trace, 0);
  return {way.front(), way[40], way[220], way[400]};
}

TEST(Friction, ABlockOnASlopeSlidesExactlyWhenTheSlopeExceedsTheCoefficient) {
  for (double tangent : {0.3, 0.45, 0.49}) {
    const auto way = ways_on_slope(tangent);
    EXPECT_LT(way[3], 1e-4) << tangent;                     // the start
    EXPECT_LT(std::abs(way[3] - way[2]), 1e-7) << tangent;  // at rest, elastic ringing aside
    std::cout << "[ measured ] tan " << tangent << ": " << way[3] << " m, last 0.09 s " << way[3] - way[2]
              << " m\n";
  }
  for (double tangent : {0.51, 0.6, 0.8}) {
    const auto way = ways_on_slope(tangent);
    const double angle = std::atan(tangent);
    const double wanted = kGravity * (std::sin(angle) - kFriction * std::cos(angle));
    const double acceleration = (way[3] - 2.0 * way[2] + way[1]) / (0.09 * 0.09);
    EXPECT_NEAR(acceleration, wanted, 0.01 * wanted) << tangent;
    std::cout << "[ measured ] tan " << tangent << ": " << acceleration << " m/s2 of " << wanted << "\n";
  }
}

TEST(Friction, RestsWithoutCreepOnASlope) {
  const double angle = std::atan(0.25);  // half the coefficient
  Scenario scenario = block();
  scenario.cell.gravity_m_s2 = {kGravity * std::sin(angle), 0.0, -kGravity * std::cos(angle)};
  scenario.simulation.duration_s = 2.0;
  scenario.simulation.trace_interval_s = 0.5;
  Trace trace;
  run(scenario, &trace);
  const std::vector<double> way = mean_way(trace, 0);
  EXPECT_LT(std::abs(way.back() - way[way.size() - 2]) / 0.5, 1e-9) << "m/s";
}

TEST(Contact, NoFingerEverPullsAndNoneLeavesTheCone) {
  for (ProfileKind profile : {ProfileKind::trapezoid, ProfileKind::minimum_jerk}) {
    Scenario scenario = small_box();
    scenario.strategy.profile = profile;
    scenario.strategy.lift_acceleration_m_s2 = 5.0;
    scenario.strategy.grip_force_N = 0.12;  // slips at times
    Trace trace;
    run(scenario, &trace);
    const TraceSignal& fingers = signal(trace, "finger_force_N");
    double most = 0.0;
    for (std::size_t i = 0; i < fingers.values.size(); i += 3) {
      const double normal = (i / 3) % 2 == 0 ? fingers.values[i] : -fingers.values[i];
      EXPECT_GE(normal, 0.0);
      EXPECT_LE(std::hypot(fingers.values[i + 1], fingers.values[i + 2]), 0.5 * normal * (1.0 + 1e-12));
      most = std::max(most, normal);
    }
    EXPECT_GT(most, 0.1);
    expect_inside_the_cone(trace, scenario.cell.support_friction);
  }
}

}  // namespace
}  // namespace unbruised

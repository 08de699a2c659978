// A product between fingers that are locked in place: what the forces then follow.

#include <cmath>

#include <gtest/gtest.h>

#include "core/scenario/opening.hpp"
#include "core/surface/surfaces.hpp"
#include "tests/core/simulation/scenes.hpp"

namespace unbruised {
namespace {

using namespace testing;

Scenario held_by(HoldMode hold, Scenario scenario = small_box(), std::optional<double> stiffness_N_m = {}) {
  jaw_of(scenario).hold = hold;
  jaw_of(scenario).lock_stiffness_N_m = stiffness_N_m;
  return scenario;
}

/// Row of a trace at a time.
std::size_t row_at(const Scenario& scenario, double time_s) {
  return static_cast<std::size_t>(time_s / scenario.simulation.time_step_s);
}

/// A block that is gripped and moved along the grip axis, free of gravity: a trapezoid of 2 m/s2 for 0.2 s, 0.1 s
/// after the fingers are locked.
Scenario shaken_along_x() {
  Scenario scenario = small_box();
  only_grip(scenario);
  scenario.cell.transfer_m = {0.08, 0.0};
  scenario.strategy.profile = ProfileKind::trapezoid;
  scenario.strategy.transfer_acceleration_m_s2 = 2.0;
  scenario.strategy.settle_s = 0.5;
  scenario.strategy.hold_s = 0.1;
  scenario.strategy.grip_force_N = 0.5;
  lattice_of(scenario).relaxation_time_s = 1e-2;
  return scenario;
}

TEST(PositionHold, KeepsTheWaysFromTheLiftToTheRelease) {
  for (const FingerCoupling coupling : {FingerCoupling::centric, FingerCoupling::independent}) {
    Scenario scenario = held_by(HoldMode::position);
    jaw_of(scenario).coupling = coupling;
    Trace trace;
    const ScenarioResult result = run(scenario, &trace);
    EXPECT_EQ(result.outcome, Outcome::held) << result.cause;
    const double lift_s = result.metrics[Metric::lift_time_s];
    for (std::size_t f = 0; f < kJawFingers; ++f) {
      const auto way = column(trace, "finger_way_m", f), speed = column(trace, "finger_speed_m_s", f);
      const std::size_t first = row_at(scenario, lift_s) + 2;
      // The cycle ends with the fingers open: opening takes gap / release speed.
      const double release_s = result.metrics[Metric::cycle_time_s] - approach_gap_m(scenario) / 0.1;
      for (std::size_t k = first; k < row_at(scenario, release_s) - 1; ++k) {
        ASSERT_EQ(way[k], way[first]) << k;
        ASSERT_EQ(speed[k], 0.0) << k;
      }
      EXPECT_NE(way[first - 3], way[first]) << "until then the drives press";
      EXPECT_LT(way.back(), way[first] - approach_gap_m(scenario)) << "and in the end the fingers open";
    }
  }
}

TEST(PositionHold, IsForceHoldWhereTheProductIsElasticAndNothingMoves) {
  Scenario scene = small_box();
  only_grip(scene);
  scene.strategy.settle_s = 1.0;
  scene.strategy.hold_s = 0.5;
  const ScenarioResult by_force = run(held_by(HoldMode::force, scene));
  for (const std::optional<double> stiffness : {std::optional<double>(), std::optional<double>(1e5)}) {
    const ScenarioResult by_place = run(held_by(HoldMode::position, scene, stiffness));
    for (const Metric metric : {Metric::peak_finger_force_N, Metric::peak_pressure_Pa, Metric::compression_max_m,
                                Metric::cycle_time_s, Metric::first_contact_time_s}) {
      // What had not come to rest at the lift, a second after the ramp: 1e-6 of it.
      EXPECT_NEAR(by_place.metrics[metric], by_force.metrics[metric], 1e-6 * by_force.metrics[metric])
          << info_of(metric).name;
    }
  }
}

TEST(PositionHold, KeepsTheForceThatTheSqueezeOfAnElasticBlockNeeds) {
  // The block's stiffness from two grips that are held by force; locked at a third squeeze it gives the force of a
  // straight line, whatever the drives are told later.
  std::vector<double> squeeze, force;
  const auto grip = [&](HoldMode hold, double force_N) {
    Scenario scene = small_box();
    only_grip(scene);
    scene.strategy.settle_s = 1.0;
    scene.strategy.hold_s = 0.5;
    scene.strategy.grip_force_N = force_N;
    Trace trace;
    const ScenarioResult result = run(held_by(hold, scene), &trace);
    const std::size_t k = row_at(scene, result.metrics[Metric::lift_time_s] + 0.4);
    squeeze.push_back(column(trace, "finger_way_m", 0)[k] - approach_gap_m(scene));
    force.push_back(column(trace, "finger_force_N", 0)[k]);
  };
  grip(HoldMode::force, 0.2);
  grip(HoldMode::force, 0.4);
  grip(HoldMode::position, 0.3);
  const double stiffness_N_m = (force[1] - force[0]) / (squeeze[1] - squeeze[0]);
  EXPECT_NEAR(force[2], stiffness_N_m * squeeze[2], 1e-4 * force[2]) << "the layers are straight within 2e-5";
}

/// Change of a finger's force and way while the palm is accelerated along x.
struct Jerked {
  std::array<double, kJawFingers> force_N{}, way_m{};
};

Jerked jerked(const Scenario& scene) {
  Trace trace;
  const ScenarioResult result = run(scene, &trace);
  const std::size_t before = row_at(scene, result.metrics[Metric::lift_time_s] + 0.05), during = before + 230;
  Jerked change;
  for (std::size_t f = 0; f < kJawFingers; ++f) {
    const auto force = column(trace, "finger_force_N", 3 * f), way = column(trace, "finger_way_m", f);
    change.force_N[f] = std::abs(force[during]) - std::abs(force[before]);
    change.way_m[f] = way[during] - way[before];
  }
  return change;
}

TEST(PositionHold, SharesAJerkAlongTheGripAxisByStiffness) {
  // m a between two equal sides: one presses more by m a / 2, the other less. A finger with a lock of k gives way
  // under its own inertia too: (m / 2 + m_finger) a / k.
  const double a = 2.0, m = 0.008;
  for (const std::optional<double> stiffness :
       {std::optional<double>(), std::optional<double>(1e4), std::optional<double>(1e5)}) {
    Scenario scene = held_by(HoldMode::position, shaken_along_x(), stiffness);
    jaw_of(scene).coupling = FingerCoupling::independent;
    const Jerked change = jerked(scene);
    const double share_N = 0.5 * m * a;
    // What still rings of the jump of the acceleration 0.18 s later: exp(-18) of the product, exp(-6) of a finger
    // of 0.1 kg on the softer lock, whose damping ratio is 0.1.
    const double tolerance = stiffness ? 0.01 : 1e-4;
    EXPECT_NEAR(change.force_N[0], share_N, tolerance * share_N) << "the finger behind pushes";
    EXPECT_NEAR(change.force_N[1], -share_N, tolerance * share_N);
    const double way_m = stiffness ? (0.5 * m + jaw_of(scene).finger_mass_kg) * a / *stiffness : 0.0;
    EXPECT_NEAR(change.way_m[0], -way_m, tolerance * way_m + 1e-11);
    EXPECT_NEAR(change.way_m[1], way_m, tolerance * way_m + 1e-11);
  }
}

TEST(PositionHold, ClosesTheAccountOfEnergy) {
  for (const FingerCoupling coupling : {FingerCoupling::centric, FingerCoupling::independent}) {
    const Scenario scene = [&] {
      Scenario all = shaken_along_x();
      all.simulation.time_step_s = 5e-4;
      jaw_of(all).coupling = coupling;
      return all;
    }();
    const double by_force = run(held_by(HoldMode::force, scene)).metrics[Metric::energy_balance_error];
    for (const std::optional<double> stiffness : {std::optional<double>(), std::optional<double>(2e3),
                                                  std::optional<double>(1e4), std::optional<double>(1e6)}) {
      const double error =
          run(held_by(HoldMode::position, scene, stiffness)).metrics[Metric::energy_balance_error];
      EXPECT_LT(std::abs(error), 2e-3 + std::abs(by_force)) << stiffness.value_or(0.0);
      std::cout << "[ measured ] energy " << error << " at " << stiffness.value_or(0.0) << " N/m, by force "
                << by_force << "\n";
    }
  }
}

TEST(PositionHold, FollowsAProductThatFlows) {
  // Lifted hard, a block that yields under the pads gives way for good; held by force it keeps the force.
  const auto force_at_end = [](HoldMode hold) {
    Scenario scene = small_box();
    LatticeParameters& product = lattice_of(scene);
    product.cell_size_m = 0.005;
    product.yield_stress_Pa = 900.0;
    product.tangent_modulus_Pa = 5e3;
    scene.strategy.grip_force_N = 0.4;
    scene.strategy.lift_acceleration_m_s2 = 8.0;
    scene.strategy.hold_s = 0.2;
    scene.cell.lift_height_m = 0.05;
    Trace trace;
    const ScenarioResult result = run(held_by(hold, scene), &trace);
    EXPECT_GT(result.metrics[Metric::plastic_strain_max], 1e-3);
    const std::size_t k = row_at(scene, result.metrics[Metric::lift_time_s] + 0.35);
    return column(trace, "finger_force_N", 0)[k];
  };
  const double by_force = force_at_end(HoldMode::force), by_place = force_at_end(HoldMode::position);
  EXPECT_NEAR(by_force, 0.4, 1e-2 * 0.4);
  EXPECT_LT(by_place, 0.98 * 0.4);
  std::cout << "[ measured ] after the lift " << by_force << " N by force, " << by_place << " N by position\n";
}

TEST(PositionHold, StaysInAnEmergencyStop) {
  Scenario scenario = held_by(HoldMode::position);
  scenario.strategy.stop_time_s = 0.35;  // in the transfer
  Trace trace;
  const ScenarioResult result = run(scenario, &trace);
  const auto way = column(trace, "finger_way_m", 0);
  const std::size_t first = row_at(scenario, result.metrics[Metric::lift_time_s]) + 2;
  ASSERT_LT(first, way.size() - 100);
  for (std::size_t k = first; k < way.size(); ++k) ASSERT_EQ(way[k], way[first]) << k;
}

TEST(PositionHold, OfOneLaneLeavesItsNeighboursAlone) {
  std::vector<Scenario> scenes = {held_by(HoldMode::force), held_by(HoldMode::position),
                                  held_by(HoldMode::position, small_box(), 1e5), held_by(HoldMode::force)};
  jaw_of(scenes[3]).curve_speed_m_s = {0.0, 0.3, 0.5};
  jaw_of(scenes[3]).curve_force_N = {100.0, 60.0, 0.0};
  const auto together = run_side_by_side(scenes);
  for (std::size_t i = 0; i < scenes.size(); ++i) expect_same_bits(together[i], run(scenes[i]), std::to_string(i));
  // At rest a drive with a curve presses like one without, and so it does while its limit lies below the curve.
  EXPECT_NEAR(together[3].metrics[Metric::peak_finger_force_N], together[0].metrics[Metric::peak_finger_force_N],
              1e-9);
}

}  // namespace
}  // namespace unbruised

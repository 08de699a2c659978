// Pads that are bodies in whole cycles: against layers and closed forms, the accounts of energy and impulse, no
// creep, the same bits in any lane, and a product that turns.

#include <cmath>

#include <gtest/gtest.h>

#include "core/gripper/pad_lanes.hpp"
#include "core/scenario/pad_lattice.hpp"
#include "tests/core/gripper/pad_stiffness.hpp"
#include "tests/core/simulation/scenes.hpp"

namespace unbruised {
namespace {

using namespace testing;

/// Makes the pads bodies.
ParallelJawParameters& make_pads(Scenario& scenario, double side_m, double thickness_m, double cell_m,
                                 double modulus_Pa, double poisson_ratio) {
  ParallelJawParameters& jaw = jaw_of(scenario);
  jaw.pad.kind = PadKind::lattice;
  jaw.pad.cell_size_m = cell_m;
  jaw.pad_size_m = {side_m, side_m};
  jaw.pad_thickness_m = thickness_m;
  jaw.pad_modulus_Pa = modulus_Pa;
  jaw.pad_poisson_ratio = poisson_ratio;
  jaw.pad_relaxation_time_s = 1e-3;
  return jaw;
}

/// A cube of 2 cm and 8 g between silicone of 8 mm.
Scenario soft_grip() {
  Scenario scenario = small_box();
  make_pads(scenario, 0.02, 0.008, 0.004, 2e5, 0.45);
  return scenario;
}

TEST(LatticePads, ThatKeepTheirWidthPressAsLayersDo) {
  // Nu = 0 and pads as large as the face: E A / t, and a hundredth more for the skin.
  const double force_N = 2.0, modulus_Pa = 2e5, thickness_m = 0.004, side_m = 0.02;
  const double pressed_m = force_N * thickness_m / (modulus_Pa * side_m * side_m);
  std::array<double, 2> way_m{};
  for (const PadKind kind : {PadKind::layer, PadKind::lattice}) {
    Scenario scenario = small_box();
    lattice_of(scenario).poisson_ratio = 0.0;
    lattice_of(scenario).youngs_modulus_Pa = 1e6;
    ParallelJawParameters& jaw = make_pads(scenario, side_m, thickness_m, 0.002, modulus_Pa, 0.0);
    jaw.pad.kind = kind;
    if (kind == PadKind::layer) jaw.pad.cell_size_m.reset();
    only_grip(scenario);
    scenario.strategy.grip_force_N = force_N;
    scenario.strategy.hold_s = 0.3;
    scenario.strategy.recover_s = 0.0;
    const ScenarioResult result = run(scenario);
    ASSERT_EQ(result.outcome, Outcome::held) << result.cause;
    way_m[static_cast<std::size_t>(kind)] = 0.5 * result.metrics[Metric::compression_max_m];
  }
  EXPECT_NEAR((way_m[1] - way_m[0]) / pressed_m, 0.01, 0.01);
}

TEST(LatticePads, HoldWithoutCreepAtTwiceTheForceThatIsNeeded) {
  Scenario scenario = soft_grip();
  scenario.strategy.grip_force_N = 2.0 * 0.008 * kGravity / (2.0 * 0.5);
  scenario.strategy.hold_s = 1.5;
  const ScenarioResult result = run(scenario);
  EXPECT_EQ(result.outcome, Outcome::held) << result.cause;
  EXPECT_LT(result.metrics[Metric::hold_drift_m_s], 1e-6);
  EXPECT_LT(result.metrics[Metric::impulse_balance_error], 1e-9);
  std::cout << "[ measured ] drift " << 1e6 * result.metrics[Metric::hold_drift_m_s] << " um/s, slip "
            << 1e6 * result.metrics[Metric::slip_max_m] << " um\n";
}

TEST(LatticePads, SlipWhereFrictionSaysSo) {
  Scenario scenario = soft_grip();
  lattice_of(scenario).youngs_modulus_Pa = 1e6;
  scenario.strategy.contact_force_N = 0.01;
  scenario.cell.lift_height_m = 0.3;
  scenario.cell.place_height_m = 0.295;
  scenario.cell.transfer_m = {0.0, 0.0};
  scenario.strategy.profile = ProfileKind::minimum_jerk;
  scenario.strategy.lift_acceleration_m_s2 = 2.0;
  scenario.strategy.lower_acceleration_m_s2 = 0.2;
  scenario.strategy.speed_m_s = 10.0;
  scenario.strategy.settle_s = 0.4;
  scenario.strategy.recover_s = 0.0;
  scenario.limits.slip_m = 1e-4;
  const double wanted = 0.008 * (kGravity + 2.0) / (2.0 * 0.5);
  std::vector<Scenario> batch;
  for (int k = 0; k < lane_count(); ++k) {
    Scenario one = scenario;
    one.strategy.grip_force_N = wanted * (0.9 + 0.2 * k / (lane_count() - 1));
    batch.push_back(one);
  }
  const auto results = run_side_by_side(batch);
  double found = 0.0;
  for (std::size_t k = 0; k < results.size(); ++k) {
    if (results[k].outcome != Outcome::held) found = batch[k].strategy.grip_force_N;
  }
  EXPECT_NEAR(found / wanted, 1.0, 0.03);
  std::cout << "[ measured ] slips up to " << found / wanted << " of m (g + a) / (2 mu)\n";
}

TEST(LatticePads, AreShearedByTheWeightThatHangsOnThem) {
  // Firm and square, so that the faces of the pads stay plane: each carries half of the weight.
  Scenario scenario = small_box();
  lattice_of(scenario).youngs_modulus_Pa = 1e7;
  const double side_m = 0.02, modulus_Pa = 1e5, thickness_m = 0.008;
  make_pads(scenario, side_m, thickness_m, 0.004, modulus_Pa, 0.45);
  scenario.cell.transfer_m = {0.0, 0.0};
  scenario.strategy.grip_force_N = 1.0;
  scenario.strategy.hold_s = 0.5;
  Trace trace;
  const ScenarioResult result = run(scenario, &trace);
  ASSERT_EQ(result.outcome, Outcome::held) << result.cause;
  const std::vector<double> palm = column(trace, "palm_position_m", 2);
  std::size_t at = 0;  // the last moment of the hold
  for (std::size_t i = 0; i < palm.size(); ++i) {
    if (palm[i] == largest(palm)) at = i;
  }
  ASSERT_GT(at, 0U);
  const auto height = [&](std::size_t row) {
    double sum = 0.0;
    for (int p = 0; p < trace.particle_count; ++p) {
      sum += trace.displacement_m[3 * (row * static_cast<std::size_t>(trace.particle_count) +
                                       static_cast<std::size_t>(p)) +
                                  2];
    }
    return sum / trace.particle_count;
  };
  const double sag_m = palm[at] - (height(at) - height(0));
  std::string error;
  const auto pad = build_pad(jaw_of(scenario), WilsonTheta(1e-3, 1.4), error);
  ASSERT_TRUE(pad.has_value()) << error;
  const double skin = kPadSkin * modulus_Pa / thickness_m / 3.0 * side_m * side_m;
  const double expected_m = 0.5 * 0.008 * kGravity * (1.0 / stiffness_N_m(*pad, 2, true) + 1.0 / skin);
  EXPECT_NEAR(sag_m / expected_m, 1.0, 0.02);
  std::cout << "[ measured ] sags " << 1e6 * sag_m << " um, expected " << 1e6 * expected_m << " um\n";
}

/// Way of each finger in the grip, pressed and not moved.
double pressed_m(double product_cell_m, double pad_cell_m) {
  Scenario scenario = soft_grip();
  lattice_of(scenario).cell_size_m = product_cell_m;
  jaw_of(scenario).pad.cell_size_m = pad_cell_m;
  scenario.simulation.time_step_s = 2e-3;
  only_grip(scenario);
  scenario.strategy.grip_force_N = 1.0;
  scenario.strategy.recover_s = 0.0;
  return 0.5 * run(scenario).metrics[Metric::compression_max_m];
}

TEST(LatticePads, ConvergeWithEitherMesh) {
  const double base = pressed_m(0.005, 0.004);
  const double pad_2 = pressed_m(0.005, 0.00267), pad_3 = pressed_m(0.005, 0.002);
  EXPECT_LT(std::abs(pad_3 - pad_2), 0.6 * std::abs(pad_2 - base));
  EXPECT_LT(std::abs(pad_3 - pad_2), 0.02 * pad_3);
  const double coarse = pressed_m(0.01, 0.004), fine = pressed_m(0.0033, 0.004);
  EXPECT_LT(std::abs(fine - base), 0.6 * std::abs(base - coarse));
  EXPECT_LT(std::abs(fine - base), 0.02 * base);
  std::cout << "[ measured ] pad cells of 4, 2.67, 2 mm: " << 1e3 * base << ", " << 1e3 * pad_2 << ", "
            << 1e3 * pad_3 << " mm; product cells of 10, 5, 3.3 mm: " << 1e3 * coarse << ", " << 1e3 * base << ", "
            << 1e3 * fine << " mm\n";
}

TEST(LatticePads, CloseTheAccountOfEnergyTheBetterTheShorterTheStep) {
  double before = HUGE_VAL;
  for (const double dt : {2e-3, 1e-3, 5e-4}) {
    for (const FingerCoupling coupling : {FingerCoupling::centric, FingerCoupling::independent}) {
      Scenario scenario = soft_grip();
      jaw_of(scenario).coupling = coupling;
      scenario.simulation.time_step_s = dt;
      const ScenarioResult result = run(scenario);
      EXPECT_EQ(result.outcome, Outcome::held) << result.cause;
      EXPECT_LT(result.metrics[Metric::impulse_balance_error], 1e-9);
      const double error = std::abs(result.metrics[Metric::energy_balance_error]);
      std::cout << "[ measured ] dt " << 1e3 * dt << " ms: energy error "
                << result.metrics[Metric::energy_balance_error] << "\n";
      if (coupling == FingerCoupling::centric) {
        EXPECT_LT(error, before);
        before = error / 1.5;  // contacts come and go within steps
      }
    }
  }
}

TEST(LatticePads, HaveTheSameBitsInAnyLaneAndCompany) {
  std::vector<Scenario> batch(static_cast<std::size_t>(lane_count()), soft_grip());
  for (std::size_t k = 0; k < batch.size(); ++k) {
    batch[k].strategy.grip_force_N = 0.1 + 0.05 * static_cast<double>(k);
    batch[k].strategy.approach_speed_m_s = 0.03 + 0.002 * static_cast<double>(k);
    jaw_of(batch[k]).coupling = k % 2 == 0 ? FingerCoupling::centric : FingerCoupling::independent;
  }
  const auto together = run_side_by_side(batch);
  for (const std::size_t k : {std::size_t{0}, std::size_t{5}, batch.size() - 1}) {
    expect_same_bits(run(batch[k]), together[k], "lane " + std::to_string(k));
  }
}

TEST(LatticePads, AreCarriedByTheirFingers) {
  // A constant drive force accelerates finger and pad together.
  Scenario scenario = soft_grip();
  ParallelJawParameters& jaw = jaw_of(scenario);
  jaw.finger_mass_kg = 0.01;
  jaw.pad.density_kg_m3 = 3000.0;  // 9.6 g
  jaw.drive_viscous_N_s_m = 0.0;
  for (const FingerCoupling coupling : {FingerCoupling::centric, FingerCoupling::independent}) {
    jaw.coupling = coupling;
    const WilsonTheta w(1e-4, 1.4);
    std::string error;
    const auto pad = build_pad(jaw, w, error);
    ASSERT_TRUE(pad.has_value()) << error;
    GripperLanes gripper;
    PadLanes pads(*pad, w);
    for (int lane = 0; lane < lane_count(); ++lane) {
      gripper.load(lane, scenario, 0.0, 0.0);
      pads.load(lane, {0.0, 0.0, 0.0}, 0.02);
    }
    DriveCommand command;
    command.force_limit_N = Lane(0.5);
    command.set_speed_m_s = Lane(100.0);
    const Mask running(true);
    double mean = 0.0;
    constexpr int kSteps = 400;
    for (int step = 0; step < kSteps; ++step) {
      pads.begin_step(gripper, {}, running);
      gripper.begin_step(w, command, &pads.on_fingers());
      for (int f = 0; f < kJawFingers; ++f) {
        pads.advance(f, nullptr, gripper.way_at_theta(f, without_force()), running);
      }
      gripper.advance(w, without_force(), running);
      pads.book_step(gripper, running);
      if (step >= kSteps / 2) mean += gripper.acceleration(0)[3] / (kSteps / 2);
    }
    const double mass_kg = jaw.finger_mass_kg + pad_mass_kg(jaw);
    EXPECT_NEAR(mean, 0.5 / mass_kg, 0.01 * 0.5 / mass_kg);
    const double gained = pads.energy_J(3, gripper) + gripper.energy()[3] + pads.damped_J(3);
    EXPECT_NEAR(gained / gripper.work()[3], 1.0, 1e-2);
  }
}

TEST(LatticePads, HangAtRestOnFingersUnderGravity) {
  Scenario scenario = soft_grip();
  scenario.cell.gravity_m_s2 = {0.0, 0.0, -kGravity};
  const WilsonTheta w(1e-3, 1.4);
  std::string error;
  const auto pad = build_pad(jaw_of(scenario), w, error);
  ASSERT_TRUE(pad.has_value()) << error;
  GripperLanes gripper;
  PadLanes pads(*pad, w);
  gripper.load(0, scenario, 0.0, 0.0);
  pads.load(0, {0.0, 0.0, -kGravity}, 0.02);
  const std::size_t low = 3 * static_cast<std::size_t>(pad->face.front()) + 2;
  const double sag_m = pads.body(kLeftPad).u().at(low, 0);
  EXPECT_LT(sag_m, 0.0);
  LaneVector down;
  down[2] = Lane(-kGravity);
  for (int step = 0; step < 100; ++step) {
    pads.begin_step(gripper, {down, down}, Mask(true));
    gripper.begin_step(w, {}, &pads.on_fingers());
    for (int f = 0; f < kJawFingers; ++f) {
      pads.advance(f, nullptr, gripper.way_at_theta(f, without_force()), Mask(true));
    }
    gripper.advance(w, without_force(), Mask(true));
  }
  EXPECT_NEAR(pads.body(kLeftPad).u().at(low, 0) / sag_m, 1.0, 1e-6);
  EXPECT_LT(std::abs(gripper.way(kLeftPad)[0]), 1e-9);
}

TEST(LatticePads, TurnWithTheirPalm) {
  Scenario scenario = soft_grip();
  scenario.strategy.grip_force_N = 0.5;
  scenario.strategy.tilt_rad = {0.3, 0.3, 0.0};
  double before = HUGE_VAL;
  for (const double dt : {1e-3, 5e-4}) {
    scenario.simulation.time_step_s = dt;
    const ScenarioResult result = run(scenario);
    EXPECT_EQ(result.outcome, Outcome::held) << result.cause;
    EXPECT_LT(result.metrics[Metric::impulse_balance_error], 1e-9);
    const double error = std::abs(result.metrics[Metric::energy_balance_error]);
    EXPECT_LT(error, std::max(before, 1e-3));
    std::cout << "[ measured ] turned, dt " << 1e3 * dt << " ms: energy error " << error << "\n";
    before = error;
  }
}

}  // namespace
}  // namespace unbruised

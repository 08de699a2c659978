// What a patch of pressure resists when the product turns in the pads, against the closed forms of dry friction.

#include "core/scenario/product_frame.hpp"
#include "tests/core/frame/held_scenes.hpp"
#include "tests/core/frame/patch_friction.hpp"

namespace unbruised {
namespace {

using namespace testing;

constexpr double kFriction = 0.3;

/// Without gravity: pads that turn about their axis faster than friction can drag the product along, after next to
/// no lift.
Scenario wrenched(const std::array<double, 3>& size_m, double cell_size_m, double youngs_modulus_Pa,
                  double grip_force_N) {
  Scenario scenario = tilted_block({1.0, 0.0, 0.0}, grip_force_N, 5e-4);
  make_product(scenario, size_m, cell_size_m, 0.2, youngs_modulus_Pa).friction = kFriction;
  jaw_of(scenario).pad_relaxation_time_s = 1e-3;
  scenario.cell.gravity_m_s2 = {0.0, 0.0, 0.0};
  scenario.cell.support = false;
  scenario.cell.lift_height_m = 0.01;
  scenario.strategy.lift_acceleration_m_s2 = 2.0;  // a third of what friction holds
  scenario.strategy.tilt_speed_rad_s = 50.0;
  scenario.strategy.tilt_acceleration_rad_s2 = 700.0;
  scenario.limits.slip_rad = 0.2;
  scenario.simulation.duration_s = 0.5;  // to within the turn
  return scenario;
}

/// Torque of both pads about their axis over friction x normal force, while the product turns against them, [m].
double friction_lever_m(const Scenario& scenario) {
  Trace trace;
  const ScenarioResult result = run(scenario, &trace);
  EXPECT_LT(std::abs(result.metrics[Metric::angular_impulse_balance_error]), 1e-3);
  const std::vector<double> angle_rad = column(trace, "slip_rad");
  double torque = 0.0, force = 0.0;
  int rows = 0;
  for (std::size_t row = 1; row < trace.time_s.size(); ++row) {
    // While the pads run ahead: from the angle on at which all but the middle slides, and before they have turned
    // far on the face.
    if (!(angle_rad[row] > 0.02) || !(angle_rad[row] < 0.10) || !(angle_rad[row] > angle_rad[row - 1] + 1e-3))
      continue;
    const double* of_surface = signal(trace, "surface_torque_N_m").values.data() + 9 * row;
    const double* of_finger = signal(trace, "finger_force_N").values.data() + 6 * row;
    torque += of_surface[0] + of_surface[3];
    force += std::abs(of_finger[0]) + std::abs(of_finger[3]);
    ++rows;
  }
  EXPECT_GT(rows, 6);
  return torque / (kFriction * force);
}

// Uniform pressure: the mean distance from the middle, 2/3 R of a disc and (sqrt 2 + ln(1 + sqrt 2)) / 6 of the
// side of a square.
TEST(Torsion, OfAnEvenlyPressedPatchIsFrictionTimesTheMeanDistanceFromItsMiddle) {
  Scenario square = wrenched({0.01, 0.0375, 0.0375}, 0.00375, 2e7, 2.0);
  jaw_of(square).pad_size_m = {0.03, 0.03};
  EXPECT_NEAR(friction_lever_m(square) / (0.03 * (std::sqrt(2.0) + std::asinh(1.0)) / 6.0), 1.0, 0.03);
  Scenario disc = wrenched({0.01, 0.03, 0.03}, 0.003, 2e7, 2.0);
  lattice_of(disc).shape = Shape::cylinder;
  lattice_of(disc).axis = Axis::x;
  jaw_of(disc).pad_size_m = {0.04, 0.04};
  EXPECT_NEAR(friction_lever_m(disc) / (0.015 * 2.0 / 3.0), 1.0, 0.03);
}

// Hertz's pressure: 3 pi / 16 a.
TEST(Torsion, OfAHertzianPatchIsThreePiSixteenthsOfItsRadius) {
  constexpr double kRadius_m = 0.02, kPatch_m = 0.3 * kRadius_m, kModulus_Pa = 2e5;
  const double plane_Pa = kModulus_Pa / (1.0 - 0.25 * 0.25);
  const double force_N = 4.0 * plane_Pa * kPatch_m * kPatch_m * kPatch_m / (3.0 * kRadius_m);
  Scenario sphere = wrenched({0.04, 0.04, 0.04}, 0.002, kModulus_Pa, force_N);
  lattice_of(sphere).shape = Shape::sphere;
  jaw_of(sphere).pad_modulus_Pa = 1e7;
  jaw_of(sphere).pad_thickness_m = 1e-3;
  EXPECT_NEAR(friction_lever_m(sphere) / (3.0 * std::numbers::pi / 16.0 * kPatch_m), 1.0, 0.03);
}

/// A stiff block of 50 mm and 0.1 kg, lifted slowly and held by pads of 30 mm beside its middle.
Scenario beside_its_middle(double offset_m, double share_of_limit) {
  Scenario scenario = tilted_block({}, 1.0, 2e-3);
  LatticeParameters& block = make_product(scenario, {0.05, 0.05, 0.05}, 0.005, 0.1, 2e7);
  block.friction = 0.6;
  scenario.cell.grip_offset_m = offset_m;
  scenario.cell.lift_height_m = 0.05;
  scenario.strategy.profile = ProfileKind::minimum_jerk;
  scenario.strategy.lift_acceleration_m_s2 = 0.2;
  scenario.strategy.settle_s = 0.2;
  scenario.strategy.hold_s = 1.0;
  scenario.simulation.duration_s = 2.6;
  scenario.limits.slip_rad = 0.02;
  scenario.limits.slip_m = 5e-4;
  const double weight_N = 0.1 * (kGravity + scenario.strategy.lift_acceleration_m_s2);
  scenario.strategy.grip_force_N =
      share_of_limit * 0.5 * weight_N / 0.6 / share_at_arm(even_square(0.03), offset_m);
  return scenario;
}

// Each pad carries half of the weight at the arm e: force and moment on the limit surface of its patch.
TEST(Torsion, AProductGrippedBesideItsMiddleTurnsWhenAndOnlyWhenItsPatchesCannotCarryIt) {
  std::vector<Scenario> scenarios;
  std::vector<double> shares;
  for (const double offset_m : {0.005, 0.010}) {
    for (const double share : {0.9, 0.97, 1.03, 1.1}) {
      scenarios.push_back(beside_its_middle(offset_m, share));
      shares.push_back(share);
    }
  }
  std::vector<Trace> traces;
  const auto results = run_side_by_side(scenarios, &traces);
  for (std::size_t i = 0; i < results.size(); ++i) {
    SCOPED_TRACE(std::to_string(scenarios[i].cell.grip_offset_m) + " m, " + std::to_string(shares[i]));
    EXPECT_EQ(results[i].outcome, shares[i] > 1.0 ? Outcome::held : Outcome::slipped) << results[i].cause;
    double largest_rad = 0.0;
    const std::vector<double>& attitude = signal(traces[i], "attitude").values;
    for (std::size_t row = 0; row < traces[i].time_s.size(); ++row) {
      largest_rad = std::max(largest_rad, 2.0 * std::abs(std::atan2(attitude[4 * row + 1], attitude[4 * row])));
    }
    if (shares[i] > 1.0) {
      EXPECT_LT(largest_rad, 0.02);
    } else if (shares[i] < 0.95) {
      EXPECT_GT(largest_rad, 0.3) << "beyond what a product that stays upright could turn";
    }
    EXPECT_LT(std::abs(results[i].metrics[Metric::impulse_balance_error]), 1e-9);
  }
}

TEST(Torsion, OnlyAGripBesideTheMiddleIsFollowedByAFrame) {
  const auto frame_of = [](double offset_m, double height_m) {
    Scenario scenario = small_box();
    scenario.cell.grip_offset_m = offset_m;
    scenario.cell.grip_height_m = height_m;
    return product_frame(scenario);
  };
  EXPECT_EQ(frame_of(0.0, 0.0), ProductFrame::upright);
  EXPECT_EQ(frame_of(0.0009, -0.0009), ProductFrame::upright) << "less than a twentieth";
  EXPECT_EQ(frame_of(-0.0011, 0.0), ProductFrame::floating);
  EXPECT_EQ(frame_of(0.0, 0.0011), ProductFrame::floating);
}

}  // namespace
}  // namespace unbruised

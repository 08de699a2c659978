// A block that is lifted and turned in the grip, against statics and the closed forms of a turning gripper.

#include "core/scenario/product_frame.hpp"
#include "tests/core/frame/held_scenes.hpp"

namespace unbruised {
namespace {

using namespace testing;

constexpr double kStep_s = 2e-3, kMass_kg = 0.1, kForce_N = 4.0;

/// Sweeps end at a change of 1e-8 of the largest force.
constexpr double kSolved_N = 1e-7;

std::vector<Scenario> tilted_every_way() {
  std::vector<Scenario> all;
  for (const std::array<double, 3>& tilt : {std::array<double, 3>{kQuarter_rad, 0.0, 0.0},
                                            {0.0, kQuarter_rad, 0.0},
                                            {0.0, 0.0, kQuarter_rad},
                                            {0.0, 2.0 * kQuarter_rad, 0.0},
                                            {-2.0 * kQuarter_rad, 0.0, 0.0},
                                            {0.4, -0.6, 0.5}}) {
    Scenario scenario = tilted_block(tilt, kForce_N, kStep_s);
    scenario.simulation.duration_s = 2.3;
    all.push_back(scenario);
  }
  return all;
}

TEST(Tilt, CarriesTheProductAsStaticsSayWhicheverWayItIsTurned) {
  for (const Trace& trace : traces_of(tilted_every_way())) {
    const GripRow row = grip_row(trace, last_in_phase(trace, CyclePhase::hold));
    const Eigen::Vector3d weight_N(0.0, 0.0, -kMass_kg * kGravity);
    const Eigen::Vector3d along_palm_N = palm_attitude(row.rotation_rad).conjugate() * weight_N;
    SCOPED_TRACE(row.rotation_rad.transpose());
    EXPECT_LT((row.left_N + row.right_N + along_palm_N).norm(), 3.0 * kSolved_N);
    EXPECT_NEAR(row.mean_normal_N(), kForce_N, kSolved_N);
  }
}

TEST(Tilt, AcrossPressesOnePadWithHalfTheWeightMore) {
  Scenario scenario = tilted_block({0.0, kQuarter_rad, 0.0}, kForce_N, kStep_s);
  scenario.simulation.duration_s = 1.4;
  const Trace trace = traces_of({scenario}).front();
  const GripRow row = grip_row(trace, last_in_phase(trace, CyclePhase::hold));
  // 4 -+ m g / 2, in a prototype 3.50967 and 4.49033.
  EXPECT_NEAR(row.left_N.x(), 3.50967, 1e-5);
  EXPECT_NEAR(-row.right_N.x(), 4.49033, 1e-5);
}

TEST(Tilt, KeepsImpulseAndDoesNotCreep) {
  for (const ScenarioResult& result : run_side_by_side(tilted_every_way())) {
    EXPECT_EQ(result.outcome, Outcome::held) << result.cause;
    EXPECT_LT(result.metrics[Metric::impulse_balance_error], 1e-10);
    EXPECT_LT(result.metrics[Metric::hold_drift_m_s], 1e-9);
    // Beside the pads' edges the body is soft and presses little: there some picometres slide as it swings.
    EXPECT_LT(result.metrics[Metric::slip_max_m], 1e-10);
    // The approach and the lift leave as much of what is put in until then in an upright cycle too.
    EXPECT_LT(std::abs(result.metrics[Metric::energy_balance_error]), 2e-3);
  }
}

TEST(Tilt, ThatIsTakenBackLeavesTheGripAsItWas) {
  Scenario scenario = tilted_block({0.3, 1.2, -0.4}, kForce_N, kStep_s);
  scenario.strategy.settle_s = 0.2;
  const Trace trace = traces_of({scenario}).front();
  const std::vector<double> phase = column(trace, "phase");
  std::size_t level = 0;  // settled after the tilt is taken back, before the fingers open
  for (std::size_t i = 0; i < phase.size(); ++i) {
    if (phase[i] == static_cast<double>(CyclePhase::turn)) level = i;
  }
  const GripRow row = grip_row(trace, level);
  EXPECT_LT(row.rotation_rad.norm(), 1e-4);  // the last step of the way back
  EXPECT_NEAR(row.left_N.x(), kForce_N, 2e-3);
  EXPECT_NEAR(row.left_N.z() + row.right_N.z(), kMass_kg * kGravity, 2e-2);  // it still rings
}

TEST(Tilt, OfNextToNothingIsTheUprightCycle) {
  Scenario upright = tilted_block({0.0, 0.0, 0.0}, kForce_N, kStep_s);
  Scenario barely = tilted_block({1e-12, 0.0, 0.0}, kForce_N, kStep_s);
  // A turn takes its time, however small: 4e-7 s of it here.
  ASSERT_EQ(product_frame(upright), ProductFrame::upright);
  ASSERT_EQ(product_frame(barely), ProductFrame::floating);
  const ScenarioResult a = run(upright), b = run(barely);
  EXPECT_EQ(a.outcome, b.outcome);
  // The frame follows the product's own small tilt, and the law of the upright one is linear in it: what differs
  // are squares of angles of 1e-3, and events within a step.
  for (const Metric metric : {Metric::peak_finger_force_N, Metric::friction_margin_min, Metric::compression_max_m,
                              Metric::peak_sensor_force_N, Metric::grip_impulse_N_s, Metric::cycle_time_s}) {
    EXPECT_NEAR(b.metrics[metric], a.metrics[metric], 1e-4 * std::abs(a.metrics[metric]));
  }
}

TEST(Tilt, TakesFromTheGripWhatTheTurningFingersNeed) {
  // m w'' + c w' = D - S - m Omega^2 s in mid-turn: the drive at its limit presses by m Omega^2 s less; the
  // product leans with m g sin of the angle on one pad.
  Scenario scenario = tilted_block({0.0, kQuarter_rad, 0.0}, 2.0, 1e-3);
  scenario.strategy.tilt_acceleration_rad_s2 = 36.0;
  scenario.simulation.duration_s = 1.2;
  const Trace trace = traces_of({scenario}).front();
  std::size_t mid = 0;
  double nearest = 1.0;
  for (std::size_t i = 0; i < trace.time_s.size(); ++i) {
    const double off = std::abs(grip_row(trace, i).rotation_rad.y() - 0.5 * kQuarter_rad);
    if (off < nearest) {
      nearest = off;
      mid = i;
    }
  }
  const GripRow row = grip_row(trace, mid);
  const double spin =
      (grip_row(trace, mid + 1).rotation_rad.y() - grip_row(trace, mid - 1).rotation_rad.y()) / 2e-3;
  const std::vector<double> way = column(trace, "finger_way_m"), speed = column(trace, "finger_speed_m_s");
  const double gap_m = 0.002, reach_m = 0.025 + gap_m - way[mid];
  const double acceleration = (speed[mid + 1] - speed[mid - 1]) / 2e-3;
  const double expected = 2.0 - 0.1 * spin * spin * reach_m - 1.0 * speed[mid] - 0.1 * acceleration;
  EXPECT_GT(0.1 * spin * spin * reach_m, 0.03) << "the turn is too slow to show";
  EXPECT_NEAR(row.mean_normal_N(), expected, 1e-3);
  // The spin is largest there, and nothing is accelerated along the grip axis but by the sag of the product.
  EXPECT_NEAR(row.normal_difference_N(), kMass_kg * kGravity * std::sin(row.rotation_rad.y()), 2e-3);
}

TEST(Tilt, PivotsAProductThatIsHeldOffItsCentreWithTooLittleFriction) {
  // 0.1 kg held 15 mm off its centre weighs 0.015 N m about the grip axis once that is level: more than the
  // friction of two 30 mm pads of 2.2 N each, 2 x 0.3 x 2.2 N x 11.5 mm = 0.0152 N m less what carries the weight.
  Scenario scenario = tilted_block({kQuarter_rad, 0.0, 0.0}, 2.2, kStep_s);
  lattice_of(scenario).friction = 0.3;
  scenario.cell.grip_height_m = 0.015;
  Scenario upright = scenario;
  upright.strategy.tilt_rad = {1e-9, 0.0, 0.0};
  const std::vector<ScenarioResult> results = run_side_by_side({scenario, upright});
  EXPECT_EQ(results[0].outcome, Outcome::slipped) << results[0].cause;
  EXPECT_GT(results[0].metrics[Metric::slip_max_rad], 0.1);
  EXPECT_EQ(results[1].outcome, Outcome::held) << results[1].cause;
}

TEST(Tilt, IsTheSameWhateverIsTurnedBesideIt) {
  std::vector<Scenario> all = tilted_every_way();
  for (Scenario& scenario : all) scenario.simulation.duration_s = 0.9;
  const ScenarioResult lone = run(all[5]);
  expect_same_bits(lone, run_side_by_side(all)[5], "beside others");
}

}  // namespace
}  // namespace unbruised

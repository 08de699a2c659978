// A product that a gripper takes through waypoints: statics wherever it has been, what the turning costs, and how
// it is put down.

#include "tests/core/frame/held_scenes.hpp"

namespace unbruised {
namespace {

using namespace testing;

constexpr double kStep_s = 2e-3;
constexpr double kForce_N = 4.0;
constexpr double kMass_kg = 0.1;

using Vector = std::array<double, 3>;

/// Pads whose edges lie within cells of the block. Edges of 30 mm lie on those of cells, and which particles
/// beyond them have come to carry a trace on the way is remembered: 4e-8 N.
constexpr double kPad_m = 0.028;

/// The block of a tilt, which goes through these rotations instead and rests after the last.
Scenario through(const std::vector<Vector>& rotations_rad) {
  Scenario scenario = tilted_block({0.0, 0.0, 0.0}, kForce_N, kStep_s);
  for (const Vector& rotation_rad : rotations_rad)
    scenario.strategy.waypoint.push_back({.rotation_rad = rotation_rad});
  // Side by side run those that are put down upright as well.
  scenario.simulation.contact_set = ContactSet::whole_surface;
  return scenario;
}

/// The last step of the hold that does not look ahead to what comes then.
GripRow at_the_end_of_the_hold(const Trace& trace) {
  return grip_row(trace, last_in_phase(trace, CyclePhase::hold) - 1);
}

TEST(Waypoints, LeaveTheProductInTheGripAsStaticsSayWhicheverWayItCame) {
  // Each attitude by a tilt, and by a way round.
  const double q = kQuarter_rad;
  const std::vector<std::pair<Vector, std::vector<Vector>>> ways = {
      {{q, 0.0, 0.0}, {{0.0, 0.7, 0.0}, {q, 0.0, 0.0}}},
      {{0.0, q, 0.0}, {{0.3, 0.3, -0.8}, {0.0, q, 0.0}}},
      {{0.0, 0.0, q}, {{0.6, 0.0, 0.0}, {0.0, 0.0, q}}},
      {{2.0 * q, 0.0, 0.0}, {{0.0, 0.0, q}, {q, 0.0, 0.0}, {2.0 * q, 0.0, 0.0}}},
      {{0.0, 2.0 * q, 0.0}, {{0.0, 2.0 * q, 0.0}}},
      {{0.0, 0.0, 2.0 * q}, {{0.0, q, 0.0}, {0.0, 0.0, 2.0 * q}}}};
  std::vector<Scenario> tilted, taken;
  for (const auto& [tilt, rotations] : ways) {
    tilted.push_back(tilted_block(tilt, kForce_N, kStep_s));
    tilted.back().strategy.hold_s = 0.8;
    tilted.back().simulation.contact_set = ContactSet::whole_surface;
    tilted.back().simulation.duration_s = 2.0;
    jaw_of(tilted.back()).pad_size_m = {kPad_m, kPad_m};
    taken.push_back(through(rotations));
    jaw_of(taken.back()).pad_size_m = {kPad_m, kPad_m};
    taken.back().strategy.hold_s = 0.8;
    taken.back().simulation.duration_s = 3.0;
  }
  const std::vector<Trace> by_tilt = traces_of(tilted), by_way = traces_of(taken);
  for (std::size_t i = 0; i < ways.size(); ++i) {
    const GripRow a = at_the_end_of_the_hold(by_tilt[i]), b = at_the_end_of_the_hold(by_way[i]);
    SCOPED_TRACE(a.rotation_rad.transpose());
    const Eigen::Vector3d weight_N(0.0, 0.0, -kMass_kg * kGravity);
    EXPECT_LT((b.left_N + b.right_N + palm_attitude(b.rotation_rad).conjugate() * weight_N).norm(), 1e-9);
    EXPECT_LT((a.left_N - b.left_N).norm(), 1e-9);  // 7e-13 are left
    EXPECT_LT((a.right_N - b.right_N).norm(), 1e-9);
  }
}

/// Largest loss of the mean normal force against the drive's limit during the last of two turns.
double largest_loss_N(const Vector& first_rad, const Vector& second_rad) {
  Scenario scenario = through({first_rad, second_rad});
  scenario.strategy.waypoint[0].wait_s = 0.3;
  scenario.strategy.tilt_acceleration_rad_s2 = 36.0;
  scenario.simulation.duration_s = 2.0;
  const Trace trace = traces_of({scenario}).front();
  const std::size_t end = last_in_phase(trace, CyclePhase::turn);
  double largest = 0.0;
  for (std::size_t i = end - 240; i <= end; ++i)
    largest = std::max(largest, kForce_N - grip_row(trace, i).mean_normal_N());
  return largest;
}

TEST(Waypoints, TheTurningFingersPullByTheSpinAcrossThemNotAcrossTheRoom) {
  // A quarter about the vertical brings the grip axis along y. A turn about y is then one about the grip axis,
  // which pulls at no finger; one about x is across, m Omega^2 s = 0.1 x 5.87^2 x 0.024 N.
  const double q = kQuarter_rad;
  const auto after_quarter = [q](const Vector& turn_rad) {
    return rotation_to(attitude_of(turn_rad) * attitude_of({0.0, 0.0, q}));
  };
  EXPECT_LT(largest_loss_N({0.0, 0.0, q}, after_quarter({0.0, q, 0.0})), 0.01);
  EXPECT_NEAR(largest_loss_N({0.0, 0.0, q}, after_quarter({q, 0.0, 0.0})), 0.083, 0.01);
}

TEST(Waypoints, BalanceEnergyAndImpulseAboutAxesThatChange) {
  // The moment of the pads times the turn of each step, about whatever axis: the error falls with its square.
  Scenario scenario = through({{0.0, 1.4, 0.0}, {1.2, 0.0, 0.9}});
  scenario.strategy.waypoint[1].place_m = Vector{0.05, 0.1, 0.15};
  scenario.cell.grip_height_m = 0.01;
  scenario.simulation.duration_s = 2.4;
  const ScenarioResult result = run(scenario);
  EXPECT_EQ(result.outcome, Outcome::held) << result.cause;
  EXPECT_LT(std::abs(result.metrics[Metric::energy_balance_error]), 2e-3);
  EXPECT_LT(result.metrics[Metric::impulse_balance_error], 1e-10);
}

TEST(Waypoints, TheErrorOfTheEnergyFallsWithTheSquareOfTheStep) {
  // Through an axis that changes; all times are fixed, and the pads stand at the block.
  const auto error = [](double time_step_s) {
    Scenario scenario = through({{0.0, 1.0, 0.0}, {0.8, 0.0, 0.6}});
    scenario.cell.grip_height_m = 0.01;
    scenario.cell.approach_gap_m = 1e-5;
    scenario.strategy.ramp_from_start = true;
    scenario.simulation.time_step_s = time_step_s;
    scenario.simulation.duration_s = 1.4;
    return run(scenario).metrics[Metric::energy_balance_error];
  };
  const double coarse = error(4e-3), middle = error(2e-3), fine = error(1e-3);
  EXPECT_GT((coarse - middle) / (middle - fine), 3.0);
}

TEST(Waypoints, TurningAlonePressesNoDentDeeper) {
  Scenario scenario = through({{0.0, kQuarter_rad, 0.0}, {2.0 * kQuarter_rad, 0.0, 0.0}});
  LatticeParameters& block = lattice_of(scenario);
  block.youngs_modulus_Pa = 4e4;
  block.yield_stress_Pa = 3e3;
  block.tangent_modulus_Pa = 1e4;
  jaw_of(scenario).pad_size_m = {0.06, 0.06};
  scenario.cell.gravity_m_s2 = {0.0, 0.0, 0.0};
  scenario.strategy.grip_force_N = 9.0;
  scenario.simulation.duration_s = 2.5;
  const Trace trace = traces_of({scenario}).front();
  const std::vector<double> strain = column(trace, "plastic_strain_max");
  const double gripped = strain[last_in_phase(trace, CyclePhase::lift)];
  EXPECT_GT(gripped, 1e-3);
  EXPECT_NEAR(strain[last_in_phase(trace, CyclePhase::hold) - 1], gripped, 1e-12);
}

TEST(Waypoints, PutTheProductDownAsItWasTurned) {
  // About the vertical, so that it stands on the face that it stood on.
  for (const double turn_rad : {kQuarter_rad, -2.0 * kQuarter_rad, 0.5}) {
    Scenario scenario = through({{0.0, 0.0, turn_rad}});
    scenario.cell.grip_offset_m = 0.005;
    scenario.cell.transfer_m = {0.1, 0.05};
    scenario.cell.place_height_m = 0.02;
    scenario.strategy.recover_s = 0.5;
    Trace trace;
    const ScenarioResult result = run(scenario, &trace);
    SCOPED_TRACE(turn_rad);
    EXPECT_EQ(result.outcome, Outcome::held) << result.cause;
    EXPECT_LT(result.metrics[Metric::place_attitude_rad],
              2e-3);  // the grip's own lean, and what the release leaves
    EXPECT_LT(result.metrics[Metric::place_error_m], 1e-4);
    const SpinRow body = last_row(trace, points_of(scenario));
    EXPECT_NEAR(signal(trace, "support_force_N").values.rbegin()[0], kMass_kg * kGravity, 1e-3);
    EXPECT_NEAR(body.center_motion_m.z(), 0.02, 1e-4);
  }
}

TEST(Waypoints, PutTheProductDownOnAnotherFace) {
  Scenario scenario = through({{kQuarter_rad, 0.0, 0.0}});
  lattice_of(scenario).size_m = {0.05, 0.06, 0.04};
  scenario.cell.transfer_m = {0.0, 0.1};
  scenario.strategy.recover_s = 1.0;
  Trace trace;
  const ScenarioResult result = run(scenario, &trace);
  EXPECT_EQ(result.outcome, Outcome::held) << result.cause;
  EXPECT_LT(result.metrics[Metric::place_attitude_rad], 3e-4);
  EXPECT_LT(result.metrics[Metric::place_error_m], 1e-4);
  EXPECT_LT(result.metrics[Metric::impulse_balance_error], 1e-10);
  EXPECT_NEAR(signal(trace, "support_force_N").values.rbegin()[0], kMass_kg * kGravity, 1e-4);
  // From half of 40 mm to half of 60; the block and the layers give way by some micrometres.
  EXPECT_NEAR(last_row(trace, points_of(scenario)).center_motion_m.z(), 0.01, 5e-5);
}

/// The block is picked from a belt that runs across the grip axis.
Scenario from_a_belt() {
  Scenario scenario = through({{kQuarter_rad, 0.0, 0.0}, {2.0 * kQuarter_rad, 0.0, 0.0}});
  scenario.cell.conveyor.speed_m_s = 0.2;
  scenario.cell.place_height_m = 0.01;
  scenario.cell.transfer_m = {0.05, 0.8};
  scenario.strategy.pick = PickKind::tracking;
  scenario.strategy.waypoint.front().place_m = Vector{0.0, 0.7, 0.12};
  scenario.strategy.recover_s = 1.0;
  return scenario;
}

TEST(Waypoints, BeginOverTheFirstOfThemAfterAPickFromABelt) {
  Trace trace;
  const ScenarioResult result = run(from_a_belt(), &trace);
  EXPECT_EQ(result.outcome, Outcome::held) << result.cause;
  EXPECT_LT(result.metrics[Metric::pick_error_m], 1e-4);
  EXPECT_LT(result.metrics[Metric::place_error_m], 1e-4);
  EXPECT_LT(result.metrics[Metric::place_attitude_rad], 1e-3);
  EXPECT_LT(result.metrics[Metric::impulse_balance_error], 1e-9);
  EXPECT_NEAR(signal(trace, "support_force_N").values.rbegin()[0], kMass_kg * kGravity, 1e-3);
  // Place and velocity of the palm are continuous from belt to rest, and it turns at rest over the first waypoint.
  const std::vector<double> y_m = column(trace, "palm_position_m", 1),
                            turn_rad = column(trace, "palm_rotation_rad", 0);
  const double most_m_s2 = 2.0 * 2.0;  // of both parts of the way off the belt
  for (std::size_t i = 2; i < y_m.size(); ++i) {
    EXPECT_LT(std::abs(y_m[i] - 2.0 * y_m[i - 1] + y_m[i - 2]), 1.1 * most_m_s2 * kStep_s * kStep_s)
        << trace.time_s[i];
  }
  const auto turning = std::find_if(turn_rad.begin(), turn_rad.end(), [](double angle) { return angle > 1e-6; });
  EXPECT_NEAR(y_m[static_cast<std::size_t>(turning - turn_rad.begin())], 0.7, 1e-9);
}

TEST(Waypoints, AreTheSameWhateverIsTurnedBesideThem) {
  std::vector<Scenario> all = {through({{0.3, 0.0, 0.0}}), through({{0.0, 0.6, 0.0}, {0.5, 0.0, 0.4}}),
                               through({{0.0, 0.0, 1.0}})};
  for (Scenario& scenario : all) scenario.simulation.duration_s = 1.2;
  expect_same_bits(run(all[1]), run_side_by_side(all)[1], "beside others");
}

}  // namespace
}  // namespace unbruised

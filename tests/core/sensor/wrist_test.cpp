// A gripper on a wrist sensor: what it reads of weight, inertia and the product, upright and turned.

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/scenario/attitude.hpp"
#include "tests/core/simulation/scenes.hpp"

namespace unbruised {
namespace {

using namespace testing;

constexpr double kGripper_kg = 1.0;

/// The small box in a gripper of 1 kg, its sensor 0.1 m above the pads.
Scenario measured_box() {
  Scenario scenario = small_box();
  scenario.sensor.at = SensorMount::wrist;
  scenario.sensor.position_m = {0.0, 0.0, 0.1};
  scenario.sensor.center_of_mass_m = {0.0, 0.0, -0.04};
  scenario.sensor.mass_kg = kGripper_kg;
  scenario.sensor.element_stiffness_N_m = 1e6;
  scenario.sensor.element_radius_m = 0.03;
  return scenario;
}

double box_kg() { return 0.008; }

/// Row of a trace at a time.
std::size_t row_at(const Trace& trace, double time_s) {
  const auto at = std::lower_bound(trace.time_s.begin(), trace.time_s.end(), time_s);
  return static_cast<std::size_t>(at - trace.time_s.begin());
}

TEST(Wrist, ChangesAlmostNothingForTheProduct) {
  Scenario scenario = measured_box();
  const ScenarioResult with = run(scenario);
  scenario.sensor.at = SensorMount::none;
  const ScenarioResult without = run(scenario);
  EXPECT_EQ(with.outcome, Outcome::held) << with.cause;
  // 4 N/um against pads and a box of some N/mm.
  for (const Metric metric : {Metric::peak_finger_force_N, Metric::compression_max_m, Metric::friction_margin_min,
                              Metric::cycle_time_s}) {
    EXPECT_NEAR(with.metrics[metric], without.metrics[metric], 0.01 * without.metrics[metric])
        << info_of(metric).name;
  }
  EXPECT_LT(std::abs(with.metrics[Metric::energy_balance_error]), 0.01);
  EXPECT_LT(with.metrics[Metric::impulse_balance_error], 1e-9);
}

// In the compensated reading gripper and path are gone: what the fingers do to the product is left.
TEST(Wrist, CompensatedReadsWhatTheFingersDo) {
  Trace trace;
  run(measured_box(), &trace);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::vector<double> read = column(trace, "sensor_wrench_compensated", axis);
    const std::vector<double> left = column(trace, "finger_force_N", axis);
    const std::vector<double> right = column(trace, "finger_force_N", 3 + axis);
    double most = 0.0, size = 0.0;
    for (std::size_t i = 0; i < read.size(); ++i) {
      most = std::max(most, std::abs(read[i] - left[i] - right[i]));
      size = std::max(size, std::abs(left[i]));
    }
    EXPECT_LT(most, 1e-9 * std::max(size, box_kg() * kGravity)) << axis;  // rounding
  }
}

TEST(Wrist, WeighsTheProductInTheAir) {
  Scenario scenario = measured_box();
  scenario.strategy.hold_s = 0.3;
  Trace trace;
  const ScenarioResult result = run(scenario, &trace);
  const double lifted_s = result.metrics[Metric::lift_time_s] + 0.5;
  const std::vector<double> raw = column(trace, "sensor_wrench", 2);
  EXPECT_NEAR(raw[row_at(trace, lifted_s)], box_kg() * kGravity, 0.01 * box_kg() * kGravity);
  EXPECT_NEAR(raw[0], 0.0, 1e-9);
  scenario.sensor.tare = SensorTare::none;
  run(scenario, &trace);
  EXPECT_NEAR(column(trace, "sensor_wrench", 2)[0], kGripper_kg * kGravity, 1e-9);
}

// m_gripper a of the lift's minimum jerk: the raw reading shows it, the compensated one does not.
TEST(Wrist, RawReadsTheInertiaOfTheGripper) {
  Trace trace;
  const ScenarioResult result = run(measured_box(), &trace);
  const std::vector<double> raw = column(trace, "sensor_wrench", 2);
  const double top_N = *std::max_element(raw.begin(), raw.end());
  EXPECT_NEAR(top_N, kGripper_kg * 2.0 + box_kg() * (kGravity + 2.0), 0.02 * 2.0);  // a ring of the sensor's mode
  EXPECT_GE(result.metrics[Metric::peak_sensor_force_N], top_N);
}

// Turned by 90 degrees about the grip axis, gravity lies along the palm's y.
TEST(Wrist, ReadsInTheAxesOfAPalmThatTurns) {
  Scenario scenario = measured_box();
  scenario.sensor.tare = SensorTare::none;
  scenario.cell.lift_height_m = 0.1;
  scenario.strategy.tilt_rad = {M_PI / 2.0, 0.0, 0.0};
  scenario.strategy.hold_s = 0.4;
  scenario.strategy.grip_force_N = 0.6;
  Trace trace;
  const ScenarioResult result = run(scenario, &trace);
  EXPECT_EQ(result.outcome, Outcome::held) << result.cause;
  const std::vector<double> turn = column(trace, "palm_rotation_rad", 0);
  std::size_t row = 0;
  for (std::size_t i = 0; i < turn.size(); ++i) {
    if (turn[i] > M_PI / 2.0 - 1e-9) row = i;  // the last of the hold
  }
  ASSERT_GT(row, 0U);
  const double weight_N = (kGripper_kg + box_kg()) * kGravity;
  // z of the cell is -y... y' = z turned by 90 degrees about x: the palm's y points up.
  EXPECT_NEAR(column(trace, "sensor_wrench", 1)[row], weight_N, 1e-3 * weight_N);
  EXPECT_NEAR(column(trace, "sensor_wrench", 2)[row], 0.0, 1e-3 * weight_N);
  EXPECT_NEAR(column(trace, "sensor_wrench_compensated", 1)[row], box_kg() * kGravity, 0.02 * box_kg() * kGravity);
  // The gripper's weight acts 0.04 m, the box's 0.1 m below the origin.
  const double lever_N_m = 0.04 * kGripper_kg * kGravity + 0.1 * box_kg() * kGravity;
  EXPECT_NEAR(column(trace, "sensor_wrench", 3)[row], lever_N_m, 2e-3 * lever_N_m);
}

// Beside lanes with and without a sensor each has the bits that it has alone.
TEST(Wrist, LanesKeepTheirBits) {
  std::vector<Scenario> scenarios(3, measured_box());
  scenarios[1].sensor.at = SensorMount::none;
  scenarios[2].sensor.at = SensorMount::support;
  scenarios[2].sensor.rate_Hz = 500.0;
  scenarios[2].sensor.noise_N = 0.01;
  const std::vector<ScenarioResult> together = run_side_by_side(scenarios);
  for (std::size_t i = 0; i < scenarios.size(); ++i) {
    expect_same_bits(together[i], run(scenarios[i]), "lane " + std::to_string(i));
  }
}

// A plate under the product at the start carries its weight, and nothing when it is lifted.
TEST(Wrist, APlateUnderTheProductWeighsIt) {
  Scenario scenario = measured_box();
  scenario.sensor = {};
  scenario.sensor.at = SensorMount::support;
  scenario.sensor.position_m = {0.0, 0.0, -0.02};
  Trace trace;
  const ScenarioResult result = run(scenario, &trace);
  EXPECT_EQ(result.outcome, Outcome::held) << result.cause;
  const std::vector<double> weight = column(trace, "sensor_wrench", 2);
  EXPECT_NEAR(weight[0], box_kg() * kGravity, 1e-6);
  EXPECT_NEAR(weight[row_at(trace, result.metrics[Metric::lift_time_s] + 0.3)], 0.0, 1e-4);
  EXPECT_NEAR(weight.back(), box_kg() * kGravity, 1e-3);
  EXPECT_LT(std::abs(result.metrics[Metric::energy_balance_error]), 0.01);
}

}  // namespace
}  // namespace unbruised

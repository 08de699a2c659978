// Slip is the way that a person would measure between pad and product.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/core/simulation/scenes.hpp"

namespace unbruised {
namespace {

using namespace testing;

TEST(Slip, IsTheWayOfThePadAlongAProductThatStays) {
  // A slippery post stands on the floor while the pads are lifted along it: contacts at the pads' edges open and
  // close, and each knows only its own part of the way.
  const ScenarioResult result = run(standing_post(0.0));
  EXPECT_EQ(result.outcome, Outcome::slipped) << result.cause;
  // The springs of the pads take some 10 um of it; the mean travel of closed contacts saturated at 26 mm.
  EXPECT_NEAR(result.metrics[Metric::slip_max_m], 0.04, 1e-4);
}

TEST(Slip, DoesNotDependOnHowFineTheFaceIs) {
  // 2 mu F = 0.12 N carries 8 g at rest (0.08 N), not at 10 m/s2 (0.16 N): it slips while the lift speeds up, and
  // sticks again.
  std::vector<double> slip;
  for (const double cell : {0.01, 0.005}) {
    Scenario scenario = small_box();
    lattice_of(scenario).cell_size_m = cell;
    lattice_of(scenario).youngs_modulus_Pa = 1e6;
    scenario.strategy.grip_force_N = 0.12;
    scenario.strategy.lift_acceleration_m_s2 = 10.0;
    scenario.strategy.hold_s = 0.1;
    scenario.cell.transfer_m = {0.0, 0.0};
    scenario.strategy.release_height_m = 0.008;  // it hangs lower than it stood
    scenario.simulation.duration_s = 0.45;       // and would land harder than a millisecond resolves
    scenario.limits.slip_m = 0.1;
    const ScenarioResult result = run(scenario);
    EXPECT_EQ(result.outcome, Outcome::held) << result.cause;
    slip.push_back(result.metrics[Metric::slip_max_m]);
  }
  EXPECT_GT(slip[0], 1e-3);
  EXPECT_NEAR(slip[1], slip[0], 0.03 * slip[0]) << "of what the faces deform";
}

/// A block of 4 cm that pads of 1 cm hold 12 mm beside its middle: it turns about the grip axis by its weight.
Scenario swinging_block() {
  Scenario scenario = small_box();
  make_product(scenario, {0.04, 0.04, 0.04}, 0.01, 0.064, 1e6).friction = 0.5;
  jaw_of(scenario).pad_size_m = {0.01, 0.01};
  scenario.cell.grip_offset_m = 0.012;
  scenario.strategy.grip_force_N = 1.2;
  scenario.strategy.hold_s = 0.5;
  scenario.limits.slip_m = 0.1;
  scenario.simulation.max_strain = 1.0;
  return scenario;
}

TEST(Slip, OfAProductThatTurnsInTheGripIsAnAngle) {
  Trace trace;
  const ScenarioResult result = run(swinging_block(), &trace);
  EXPECT_TRUE(result.metrics[Metric::slip_max_rad] > 0.1) << result.metrics[Metric::slip_max_rad];
  // The line from the lowest to the highest particle of its middle, in the plane across the grip axis.
  std::size_t low = 0, high = 0;
  for (std::size_t i = 0; i + 2 < trace.rest_position_m.size(); i += 3) {
    const auto z = [&](std::size_t at) { return trace.rest_position_m[at + 2]; };
    if (z(i) < z(low)) low = i;
    if (z(i) > z(high)) high = i;
  }
  const auto top = freedom(trace, trace.displacement_m, high + 1),
             bottom = freedom(trace, trace.displacement_m, low + 1);
  const auto angle = column(trace, "slip_rad", 0);
  const double height_m = trace.rest_position_m[high + 2] - trace.rest_position_m[low + 2];
  const auto turned_rad = [&](std::size_t row) {
    return std::abs(std::asin((top[row] - bottom[row]) / height_m));
  };
  // The layers have sheared as far as they do by the time it slides as a whole.
  const auto row_past = [&](double least_rad) {
    const auto past = std::find_if(angle.begin(), angle.end(), [&](double a) { return a > least_rad; });
    EXPECT_NE(past, angle.end());
    return static_cast<std::size_t>(past - angle.begin());
  };
  const std::size_t from = row_past(0.03), to = row_past(0.12);
  const double slipped_rad = angle[to] - angle[from];
  EXPECT_NEAR(slipped_rad, turned_rad(to) - turned_rad(from), 0.03 * slipped_rad) << "of the block's own twist";
}

TEST(Slip, OfABlockThatIsHeldInItsMiddleHasNoAngle) {
  Scenario scenario = swinging_block();
  scenario.cell.grip_offset_m = 0.0;
  const ScenarioResult result = run(scenario);
  EXPECT_EQ(result.outcome, Outcome::held) << result.cause;
  EXPECT_LT(result.metrics[Metric::slip_max_rad], 1e-4);
}

}  // namespace
}  // namespace unbruised

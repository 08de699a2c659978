// Whole cycles between shaped pads: balances, friction along a face, turning palms, lanes side by side.

#include <cmath>

#include <gtest/gtest.h>

#include "tests/core/contact/shaped_pad_scenes.hpp"

namespace unbruised {
namespace {

using namespace testing;

/// Of m g T: what the static start is solved to.
constexpr double kImpulse = 1e-9;

/// A small fruit that is lifted, carried and put down.
Scenario small_fruit() {
  Scenario s = small_box();
  make_product(s, {0.04, 0.04, 0.05}, 0.008, 0.04, 5e5).shape = Shape::ellipsoid;
  lattice_of(s).friction = 0.5;
  jaw_of(s).pad_size_m = {0.025, 0.03};
  jaw_of(s).pad_relaxation_time_s = 1e-3;
  s.strategy.grip_force_N = 1.0;
  s.simulation.time_step_s = 5e-4;
  return s;
}

struct NamedPad {
  const char* name;
  PadParameters pad;
};

std::vector<NamedPad> shapes() {
  std::vector<NamedPad> all;
  PadParameters pad;
  pad.shape = PadShape::cylinder;
  pad.radius_m = 0.03;
  all.push_back({"convex", pad});
  pad.radius_m = -0.022;
  all.push_back({"cradle", pad});
  pad.shape = PadShape::sphere;
  pad.radius_m = 0.03;
  all.push_back({"sphere", pad});
  pad = {};
  pad.shape = PadShape::v_groove;
  pad.half_angle_rad = 1.2;
  all.push_back({"groove", pad});
  return all;
}

TEST(ShapedPadCycles, ImpulseClosesToRoundOffAndEnergyWithTheStep) {
  for (const NamedPad& named : shapes()) {
    Scenario s = small_fruit();
    pad_of(s) = named.pad;
    const ScenarioResult result = run(s);
    EXPECT_EQ(result.outcome, Outcome::held) << named.name << ": " << result.cause;
    EXPECT_LT(result.metrics[Metric::impulse_balance_error], kImpulse) << named.name;
    EXPECT_NEAR(result.metrics[Metric::energy_balance_error], 0.0, 0.02) << named.name;
    std::cout << "[ measured ] " << named.name << ": energy " << result.metrics[Metric::energy_balance_error]
              << ", impulse " << result.metrics[Metric::impulse_balance_error] << ", slip "
              << result.metrics[Metric::slip_max_m] << "\n";
  }
}

TEST(ShapedPadCycles, BalancesCloseWhereTheProductSlidesOverTheFace) {
  for (const NamedPad& named : shapes()) {
    Scenario s = small_fruit();
    pad_of(s) = named.pad;
    lattice_of(s).friction = 0.15;
    s.cell.grip_offset_m = 0.003;  // it is pushed along the slope
    const ScenarioResult result = run(s);
    EXPECT_LT(result.metrics[Metric::impulse_balance_error], kImpulse) << named.name;
    EXPECT_NEAR(result.metrics[Metric::energy_balance_error], 0.0, 0.03) << named.name;
    std::cout << "[ measured ] sliding, " << named.name << ": energy "
              << result.metrics[Metric::energy_balance_error] << ", outcome " << static_cast<int>(result.outcome)
              << " " << result.cause << "\n";
  }
}

TEST(ShapedPadCycles, LanesOfOtherShapesDoNotMatter) {
  std::vector<Scenario> scenarios;
  for (const NamedPad& named : shapes()) {
    scenarios.push_back(small_fruit());
    pad_of(scenarios.back()) = named.pad;
  }
  const std::vector<ScenarioResult> together = run_side_by_side(scenarios);
  expect_same_bits(run(scenarios[1]), together[1], "cradle");
}

TEST(ShapedPadCycles, APalmThatTurnsTakesTheFaceAlong) {
  // Half a turn about x and back; the same cycle with a floating frame that does not turn is the upright one.
  Scenario s = small_fruit();
  pad_of(s) = shapes()[1].pad;
  s.strategy.grip_force_N = 2.0;
  const ScenarioResult upright = run(s);
  s.strategy.tilt_rad = {0.6, 0.0, 0.0};
  const ScenarioResult tilted = run(s);
  EXPECT_EQ(tilted.outcome, Outcome::held) << tilted.cause;
  EXPECT_LT(tilted.metrics[Metric::impulse_balance_error], 1e-9);
  EXPECT_LT(tilted.metrics[Metric::angular_impulse_balance_error], 1e-6);
  EXPECT_NEAR(tilted.metrics[Metric::energy_balance_error], 0.0, 0.02);
  EXPECT_NEAR(tilted.metrics[Metric::compression_max_m], upright.metrics[Metric::compression_max_m],
              0.02 * upright.metrics[Metric::compression_max_m]);
}

}  // namespace
}  // namespace unbruised

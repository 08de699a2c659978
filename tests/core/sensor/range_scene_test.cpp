// Range sensors in a running simulation: fingers that move, lanes, the trace.

#include <cmath>

#include "tests/core/simulation/scenes.hpp"

namespace unbruised {
namespace {

using testing::column;

/// The small cube between independent or centric fingers, rays off the axis.
Scenario sensing_box() {
  Scenario scenario = testing::small_box();
  RangeSensorParameters& range = jaw_of(scenario).range;
  range.maximum_m = 0.03;
  range.depth_m = 0.004;
  range.offset_m = {0.006, -0.005};
  return scenario;
}

TEST(RangeScene, ReadsTheWayThatIsLeftAndTheDepthWhereThePadsTouch) {
  Trace trace;
  const ScenarioResult result = testing::run(sensing_box(), &trace);
  ASSERT_EQ(result.outcome, Outcome::held) << result.cause;
  ASSERT_EQ(testing::signal(trace, "range_m").extents, std::vector<int>{2});
  for (std::size_t f = 0; f < 2; ++f) {
    const std::vector<double> range = column(trace, "range_m", f), way = column(trace, "finger_way_m", f);
    // Gap and depth; the cube bulges by nu rho g h / E x 1 cm = 5 um at most as it stands on its mat.
    EXPECT_NEAR(range.front(), 0.006, 5e-6);
    for (std::size_t i = 0; i < range.size(); ++i) {
      if (trace.time_s[i] > result.metrics[Metric::first_contact_time_s] - 1e-3) break;
      EXPECT_NEAR(range[i], range.front() - way[i], 1e-9) << trace.time_s[i];  // it is at rest
    }
    // Held: the pad's layer is pressed in by force / (E / thickness x area) = 0.3 / (0.4e6 / 3e-3 x 4e-4) = 5.6 um
    // on a face that stays flat within as much again.
    const auto at = static_cast<std::size_t>(std::lround(result.metrics[Metric::lift_time_s] / 1e-3));
    EXPECT_NEAR(range[at], 0.004, 2e-5);
    EXPECT_LT(range[at], 0.004);
  }
}

TEST(RangeScene, GoesWithAProductThatIsCarried) {
  Trace trace;
  const ScenarioResult result = testing::run(sensing_box(), &trace);
  const std::vector<double> range = column(trace, "range_m");
  const auto held = [&](double time_s) { return range[static_cast<std::size_t>(std::lround(time_s / 1e-3))]; };
  const double lift_s = result.metrics[Metric::lift_time_s];
  // 2 cm up and 5 cm across in the grip: the same place of the face.
  EXPECT_NEAR(held(lift_s + 0.3), held(lift_s), 1e-5);
}

TEST(RangeScene, ReadsNothingOnceTheProductIsOutOfReach) {
  Scenario scenario = sensing_box();
  jaw_of(scenario).range.maximum_m = 0.005;
  Trace trace;
  testing::run(scenario, &trace);
  EXPECT_EQ(column(trace, "range_m").front(), 0.005);
}

TEST(RangeScene, HasTheSameBitsInEveryLane) {
  Scenario scenario = sensing_box();
  scenario.strategy.guard = GuardKind::range;
  scenario.strategy.guard_range_m = 0.0055;
  jaw_of(scenario).range.rate_Hz = 700.0;
  jaw_of(scenario).range.noise_m = 1e-4;
  Scenario other = sensing_box();
  jaw_of(other).range.noise_seed = 5;
  Trace alone;
  const ScenarioResult single = testing::run(scenario, &alone);
  std::vector<Scenario> all(static_cast<std::size_t>(lane_count()), other);
  for (const std::size_t lane : {std::size_t{0}, std::size_t{3}, all.size() - 1}) all[lane] = scenario;
  std::vector<Trace> traces;
  const std::vector<ScenarioResult> results = testing::run_side_by_side(all, &traces);
  for (const std::size_t lane : {std::size_t{0}, std::size_t{3}, all.size() - 1}) {
    testing::expect_same_bits(results[lane], single, "lane " + std::to_string(lane));
    EXPECT_EQ(column(traces[lane], "range_m", 1), column(alone, "range_m", 1));
  }
}

TEST(RangeScene, SensorsThatNobodyObeysChangeNothing) {
  testing::expect_same_bits(testing::run(sensing_box()), testing::run(testing::small_box()), "with sensors");
}

}  // namespace
}  // namespace unbruised

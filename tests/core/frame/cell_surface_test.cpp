// Surfaces that the cell lists: planes and rectangles, at rest and moving.

#include "tests/core/frame/rolling_scenes.hpp"

namespace unbruised {
namespace {

using namespace testing;

constexpr double kWeight_N = 0.1 * kGravity;

/// A ball of 60 mm that begins with its lowest place on z = 0, over nothing.
Scenario ball() {
  Scenario scenario = roller(Shape::sphere, 0.0);
  scenario.cell.support = false;
  scenario.simulation.contact_set = ContactSet::automatic;
  return scenario;
}

CellSurfaceParameters surface(const std::array<double, 3>& center_m, const std::array<double, 3>& normal) {
  CellSurfaceParameters given;
  given.center_m = center_m;
  given.normal = normal;
  given.modulus_Pa = 2e5;
  given.relaxation_time_s = 0.02;
  return given;
}

/// Of the centre of mass at the end of a trace.
Eigen::Vector3d acceleration_m_s2(const Trace& trace, const Points& points) {
  const std::size_t n = points.X.size(), row = trace.time_s.size() - 1;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double total = 0.0;
  for (std::size_t p = 0; p < n; ++p) {
    total += points.mass_kg[p];
    sum +=
        points.mass_kg[p] * Eigen::Map<const Eigen::Vector3d>(trace.acceleration_m_s2.data() + 3 * (n * row + p));
  }
  return sum / total;
}

// Two smooth planes that lean by 45 degrees carry a ball with m g / sqrt 2 each: its patches are alike and it
// rests where both give way alike.
TEST(CellSurface, TwoSlopesCarryABallBetweenThem) {
  Scenario scenario = ball();
  const double to_plane = 0.03 * std::sqrt(2.0);  // of the ball's centre, at z = 0.03, above their common line
  for (const double side : {-1.0, 1.0}) {
    scenario.cell.surface.push_back(surface({0.0, 0.0, 0.03 - to_plane}, {side, 0.0, 1.0}));
    scenario.cell.surface.back().friction = 0.0;
  }
  scenario.simulation.duration_s = 1.0;
  Trace trace;
  const ScenarioResult result = run(scenario, &trace);
  const Points points = points_of(scenario);
  EXPECT_EQ(result.outcome, Outcome::held) << result.cause;
  EXPECT_NEAR(acceleration_m_s2(trace, points).norm(), 0.0, 1e-3);
  EXPECT_NEAR(last_center(trace, points).motion_m.x(), 0.0, 1e-9);
  // Winkler's layer under a sphere of radius R: N = pi R k d^2, and the centre sinks by sqrt 2 d; the ball, E = 2
  // MPa, gives way by a tenth of that beside it.
  const double depth_m = std::sqrt(kWeight_N / std::sqrt(2.0) / (std::numbers::pi * 0.03 * 2e5 / 0.005));
  EXPECT_NEAR(last_center(trace, points).motion_m.z(), -std::sqrt(2.0) * depth_m, 0.15 * depth_m);
  EXPECT_EQ(signal(trace, "contact_count").extents.front(), 5);
}

// On a plane of its own a product rests as on the support, wherever that plane stands and whatever it is called.
TEST(CellSurface, CarriesLikeTheSupport) {
  Scenario on_support = ball();
  on_support.cell.support = true;
  std::get<LatticeParameters>(on_support.product).initial_height_m = 1e-3;
  lay_support(on_support.cell, 4e7, 0.5);
  on_support.cell.support_relaxation_time_s = 0.02;
  Scenario on_surface = ball();
  on_surface.cell.surface = {surface({0.4, -0.2, -1e-3}, {0.0, 0.0, 3.0})};
  Trace first, second;
  const ScenarioResult a = run(on_support, &first), b = run(on_surface, &second);
  // The same fall of 1 mm, to another floor: equal but for rounding.
  EXPECT_NEAR(a.metrics[Metric::energy_input_J], b.metrics[Metric::energy_input_J], 1e-12);
  EXPECT_NEAR(last_center(first, points_of(on_support)).motion_m.z() - 1e-3,
              last_center(second, points_of(on_surface)).motion_m.z(), 1e-10);
}

/// Nothing holds the product.
void expect_free_fall(Scenario scenario) {
  scenario.simulation.duration_s = 0.1;
  Trace trace;
  run(scenario, &trace);
  EXPECT_NEAR(last_center(trace, points_of(scenario)).motion_m.z(), -0.5 * kGravity * 0.01, 1e-5);
}

TEST(CellSurface, IsTouchedOnItsRectangleOnly) {
  Scenario scenario = ball();
  scenario.cell.surface = {surface({0.1, 0.0, 0.0}, {0.0, 0.0, 1.0})};
  scenario.cell.surface.front().size_m = {0.1, 0.1};  // from x = 0.05 on
  expect_free_fall(scenario);
}

// Of a plane above the ball that faces upwards, the ball is behind.
TEST(CellSurface, IsNotTouchedFromBehind) {
  Scenario scenario = ball();
  scenario.cell.surface = {surface({0.0, 0.0, 0.2}, {0.0, 0.0, 1.0})};
  expect_free_fall(scenario);
}

// A ball that falls beside a wall cuts into its rim: that is said, not guessed.
TEST(CellSurface, SaysWhereARimIsMet) {
  Scenario scenario = ball();
  scenario.cell.surface = {surface({0.025, 0.0, -0.1}, {-1.0, 0.0, 0.0})};
  scenario.cell.surface.front().size_m = {0.2, 0.15};  // up to z = -0.025
  scenario.simulation.duration_s = 0.2;
  const ScenarioResult result = run(scenario);
  EXPECT_EQ(result.outcome, Outcome::out_of_range);
  EXPECT_NE(result.cause.find("rim"), std::string::npos) << result.cause;
}

// A box on a rough plate goes where the plate goes; its energy closes with the plate's work.
TEST(CellSurface, CarriesAProductAlongItsPath) {
  Scenario scenario = turned_box({0.06, 0.05, 0.04}, {});
  scenario.cell.support = false;
  CellSurfaceParameters plate = surface({0.0, 0.0, 0.0}, {0.0, 0.0, 1.0});
  plate.friction = 1.0;
  plate.path_time_s = {0.3, 0.6};
  plate.path_m = {{0.0, 0.0, 0.0}, {0.05, -0.02, 0.03}};
  scenario.cell.surface = {plate};
  scenario.simulation.duration_s = 1.0;
  Trace trace;
  const ScenarioResult result = run(scenario, &trace);
  const Eigen::Vector3d motion_m = last_center(trace, points_of(scenario)).motion_m;
  // Places at the rim, which carry little, slip by some um on the way.
  EXPECT_NEAR(motion_m.x(), 0.05, 5e-6);
  EXPECT_NEAR(motion_m.y(), -0.02, 5e-6);
  EXPECT_NEAR(motion_m.z(), 0.03, 2e-4);  // the layer gives way
  EXPECT_LT(std::abs(result.metrics[Metric::energy_balance_error]), 0.02);
  EXPECT_LT(std::abs(result.metrics[Metric::impulse_balance_error]), 1e-10);
}

// A ball that rolls along the floor comes to a wall and goes back: the listed wall and the support act together.
TEST(CellSurface, AWallTurnsARollingBallBack) {
  Scenario scenario = ball();
  scenario.cell.support = true;
  lay_support(scenario.cell, 4e7, 0.4);
  std::get<LatticeParameters>(scenario.product).initial_velocity_m_s = {0.4, 0.0, 0.0};
  scenario.cell.surface = {surface({0.09, 0.0, 0.05}, {-1.0, 0.0, 0.0})};
  scenario.cell.surface.front().size_m = {0.2, 0.2};
  scenario.cell.surface.front().relaxation_time_s = 0.0;
  scenario.simulation.duration_s = 0.6;
  Trace trace;
  const ScenarioResult result = run(scenario, &trace);
  const Center end = last_center(trace, points_of(scenario));
  EXPECT_LT(end.velocity_m_s.x(), -0.02);
  EXPECT_LT(end.motion_m.x(), 0.06);
  EXPECT_LT(std::abs(result.metrics[Metric::impulse_balance_error]), 1e-10);
}

}  // namespace
}  // namespace unbruised

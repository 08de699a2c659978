// Products that roll, tip and come to rest on other faces: contact with the whole surface.

#include "core/simulation/model_parts.hpp"
#include "tests/core/frame/rolling_scenes.hpp"

namespace unbruised {
namespace {

using namespace testing;

// Rolling, an inertia J resists as J / R^2 of mass: 2/5 of a sphere, 1/2 of a cylinder. The issue asks for 2 % at
// five cells across; measured 0.1 to 0.3 %.
TEST(WholeSurface, RollsDownASlopeAsClosedFormsSay) {
  constexpr double kSlope = 0.1;
  for (const auto& [shape, share] : {std::pair{Shape::sphere, 5.0 / 7.0}, std::pair{Shape::cylinder, 2.0 / 3.0}}) {
    const Scenario scenario = roller(shape, kSlope);
    Trace trace;
    const ScenarioResult result = run(scenario, &trace);
    EXPECT_EQ(result.outcome, Outcome::held) << result.cause;
    const Points points = points_of(scenario);
    const double duration_s = *scenario.simulation.duration_s;
    const double way_m = 0.5 * share * kGravity * std::sin(kSlope) * duration_s * duration_s;
    EXPECT_NEAR(last_center(trace, points).motion_m.x() / way_m, 1.0, 0.02);
    EXPECT_LT(std::abs(result.metrics[Metric::impulse_balance_error]), 1e-10);
    EXPECT_LT(std::abs(result.metrics[Metric::energy_balance_error]), 0.01);
  }
}

// Coulomb: sliding ends where the rim's speed has come up with the centre's, at v / (1 + J / (m R^2)).
TEST(WholeSurface, SlidesUntilItRolls) {
  Scenario scenario = roller(Shape::sphere, 0.0);
  std::get<LatticeParameters>(scenario.product).initial_velocity_m_s = {0.3, 0.0, 0.0};
  scenario.cell.support_friction = 0.4;
  Trace trace;
  run(scenario, &trace);
  // The rim lies deeper by what the layer gives way, 1.3 % of the radius here.
  EXPECT_NEAR(last_center(trace, points_of(scenario)).velocity_m_s.x(), 0.3 * 5.0 / 7.0, 0.02 * 0.3);
}

// The prototype's sphere, pushed at 0.3 m/s: it slides, and then rolls at v0 q / (1 + q), q = m R^2 / J. Without
// the arms of its places from their particles it rolls with 6 % less at 0.8 s: their force acts beside the true
// surface.
TEST(WholeSurface, RollsOnAtTheSpeedAtWhichItBeganTo) {
  Scenario scenario = roller(Shape::sphere, 0.0);
  LatticeParameters& ball = lattice_of(scenario);
  ball.size_m = {0.05, 0.05, 0.05};
  ball.cell_size_m = 0.00625;
  ball.mass_kg.reset();
  ball.density_kg_m3 = 900.0;
  ball.poisson_ratio = 0.3;
  ball.friction = 0.4;
  ball.relaxation_time_s = 1e-6;
  ball.initial_velocity_m_s = {0.3, 0.0, 0.0};
  lay_support(scenario.cell, 2e8, 0.4);
  scenario.simulation.time_step_s = 1e-3;
  scenario.simulation.trace_interval_s = 1e-2;
  std::array<double, 2> speed_m_s{};
  for (std::size_t i = 0; i < 2; ++i) {
    scenario.simulation.duration_s = i == 0 ? 0.2 : 0.8;
    Trace trace;
    EXPECT_LT(run(scenario, &trace).metrics[Metric::impulse_balance_error], 1e-10);
    speed_m_s[i] = last_center(trace, points_of(scenario)).velocity_m_s.x();
  }
  // 0.2092 m/s of the prototype have the inertia of its particles; ours have that of the sphere.
  EXPECT_NEAR(speed_m_s[0], 0.3 * 5.0 / 7.0, 0.02 * speed_m_s[0]);
  EXPECT_NEAR(speed_m_s[1], speed_m_s[0], 0.01 * speed_m_s[0]);
}

// Balanced on an edge its centre of mass stands above it: atan(20 / 30) for this box. 1 % of the angle to either
// side it falls back or over.
TEST(WholeSurface, TipsWhereItsCentrePassesTheEdge) {
  const double balance_rad = std::atan(2.0 / 3.0);
  std::vector<Scenario> boxes;
  for (const double share : {0.99, 1.01}) {
    boxes.push_back(turned_box({0.04, 0.04, 0.06}, {0.0, share * balance_rad, 0.0}));
    std::get<LatticeParameters>(boxes.back().product).youngs_modulus_Pa = 2e6;
    lay_support(boxes.back().cell, 4e7, 1.5);
    boxes.back().simulation.duration_s = 1.2;
    boxes.back().simulation.trace_interval_s = 0.1;
  }
  const std::vector<Trace> traces = traces_of(boxes);
  const Points points = points_of(boxes.front());
  const Eigen::Quaterniond over(Eigen::AngleAxisd(0.5 * std::numbers::pi, Eigen::Vector3d::UnitY()));
  // Both rest by then, flat but for the sag of their feet.
  EXPECT_LT(last_row(traces[0], points).attitude.angularDistance(Eigen::Quaterniond::Identity()), 1e-3);
  EXPECT_LT(last_row(traces[1], points).attitude.angularDistance(over), 1e-3);
}

/// Height at the end of a trace of the centre of mass above where it is in a body at rest on z = 0.
double last_height_m(const Scenario& scenario, const Trace& trace) {
  return build(scenario)->parts().body.center_of_mass_m[2] + last_center(trace, points_of(scenario)).motion_m.z();
}

/// Height of the centre of mass of a box that stands on its support, by statics.
double standing_m(const std::array<double, 3>& size_m) {
  Scenario scenario = turned_box(size_m, {});
  scenario.simulation.contact_set = ContactSet::whole_surface;
  scenario.simulation.duration_s = 0.01;
  return last_height_m(scenario, traces_of({scenario}).front());
}

struct Fall {
  std::array<double, 3> rotation_rad, spin_rad_s;
  double height_m;
  std::array<double, 3> stands;  ///< extents in the end, the last one upwards
  Eigen::Vector3d up;            ///< in the end, in the axes of the box
};

// frames.md, section 7: on another face, on an edge, on a corner with spin. It rests with its weight, upright, and
// as high as statics say of a box that stands so.
TEST(WholeSurface, LandsOnAnotherFaceAndRests) {
  const double weight_N = 0.06 * 0.05 * 0.04 * 1000.0 * kGravity, quarter = 0.5 * std::numbers::pi;
  const std::vector<Fall> falls = {
      {{0.0, quarter, 0.0}, {}, 1e-3, {0.04, 0.05, 0.06}, -Eigen::Vector3d::UnitX()},
      {{0.0, quarter + 0.35, 0.0}, {}, 1e-3, {0.04, 0.05, 0.06}, -Eigen::Vector3d::UnitX()},
      {{0.6, 0.5, 0.3}, {2.0, -1.0, 3.0}, 5e-3, {0.06, 0.05, 0.04}, Eigen::Vector3d::UnitZ()}};
  std::vector<Scenario> boxes;
  for (const Fall& fall : falls) {
    boxes.push_back(turned_box({0.06, 0.05, 0.04}, fall.rotation_rad));
    auto& box = std::get<LatticeParameters>(boxes.back().product);
    box.initial_spin_rad_s = fall.spin_rad_s;
    box.initial_height_m = fall.height_m;
    boxes.back().simulation.duration_s = 1.5;
    boxes.back().simulation.trace_interval_s = 0.1;
  }
  std::vector<Trace> traces;
  const std::vector<ScenarioResult> results = run_side_by_side(boxes, &traces);
  const Points points = points_of(boxes.front());
  for (std::size_t i = 0; i < falls.size(); ++i) {
    EXPECT_NEAR(last_support_N(traces[i]).z(), weight_N, 1e-6);
    const Eigen::Vector3d up = last_row(traces[i], points).attitude.conjugate() * Eigen::Vector3d::UnitZ();
    EXPECT_NEAR((up - falls[i].up).norm(), 0.0, 1e-4);
    // Friction holds the foot, which statics let spread by Poisson's ratio: 3 um of 60 um of sag.
    EXPECT_NEAR(last_height_m(boxes[i], traces[i]), standing_m(falls[i].stands), 4e-6);
    EXPECT_LT(std::abs(results[i].metrics[Metric::impulse_balance_error]), 1e-10);
  }
  // 29.9415 of the prototype, whose places stand at the particles; 1.1 um of 60 um of sag are left.
  EXPECT_NEAR(1e3 * last_height_m(boxes[0], traces[0]), 29.9415, 1.5e-3);
}

// Between its poles a ball of six sides has nothing to roll on.
TEST(WholeSurface, SaysWhereSixSidesAreTooFew) {
  Scenario scenario = roller(Shape::sphere, 0.0);
  auto& ball = std::get<LatticeParameters>(scenario.product);
  scenario.simulation.contact_set = ContactSet::six_sides;
  scenario.simulation.duration_s = 0.2;
  EXPECT_EQ(run(scenario).outcome, Outcome::held);
  ball.initial_rotation_rad = {-0.6755, 0.6755, 0.0};  // down with a corner of the cube around it
  const ScenarioResult result = run(scenario);
  EXPECT_EQ(result.outcome, Outcome::out_of_range);
  EXPECT_NE(result.cause.find("six sides"), std::string::npos) << result.cause;
}

// A contact of some milliseconds loses energy to the step; the loss falls with it.
TEST(WholeSurface, LosesLessEnergyAtShorterSteps) {
  double before = 1.0;
  for (const double step_s : {1e-3, 5e-4, 2.5e-4}) {
    Scenario scenario = turned_box({0.06, 0.05, 0.04}, {0.0, 0.5 * std::numbers::pi, 0.0});
    std::get<LatticeParameters>(scenario.product).initial_height_m = 1e-3;
    scenario.simulation.time_step_s = step_s;
    scenario.simulation.duration_s = 0.2;
    const double error = run(scenario).metrics[Metric::energy_balance_error];
    EXPECT_LT(std::abs(error), 0.75 * before) << step_s;
    before = std::abs(error);
  }
}

// The same bits whatever runs beside it.
TEST(WholeSurface, DoesNotKnowItsNeighbours) {
  Scenario alone = turned_box({0.06, 0.05, 0.04}, {0.6, 0.5, 0.3});
  alone.simulation.duration_s = 0.1;
  Scenario other = alone;
  std::get<LatticeParameters>(other.product).initial_rotation_rad = {0.0, 0.2, 0.0};
  other.simulation.duration_s = 0.15;
  const ScenarioResult single = run(alone);
  const std::vector<ScenarioResult> together = run_side_by_side({other, alone, other});
  expect_same_bits(single, together[1], "between two others");
}

}  // namespace
}  // namespace unbruised

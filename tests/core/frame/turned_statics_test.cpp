// A product at rest in a turned grip, against the statics of one whose weight is turned.

#include "core/lanes/lane.hpp"
#include "tests/core/frame/held_scenes.hpp"

namespace unbruised {
namespace {

using namespace testing;

constexpr double kStep_s = 2e-3;

/// Where the particles are in the axes of the palm, from the centre of the pads.
Eigen::Matrix3Xd places_in_grip_m(const Trace& trace, const Points& points, std::size_t row) {
  const SpinRow body = spin_row(trace, points, row);
  const Eigen::Map<const Eigen::Vector3d> palm(signal(trace, "palm_position_m").values.data() + 3 * row);
  const Eigen::Quaterniond back = palm_attitude(grip_row(trace, row).rotation_rad).conjugate();
  Eigen::Matrix3Xd places(3, static_cast<Eigen::Index>(points.X.size()));
  for (std::size_t p = 0; p < points.X.size(); ++p) {
    const auto at = static_cast<Eigen::Index>(p);
    places.col(at) = back * (body.center_motion_m - palm + body.attitude * (points.X[p] + body.u.col(at)));
  }
  return places;
}

/// The turns that bring "down" in the axes of the palm to the faces, edges and corners of a cube.
std::vector<std::array<double, 3>> turns_to_26_ways() {
  std::vector<std::array<double, 3>> turns;
  for (int i = 0; i < 27; ++i) {
    if (i == 13) continue;
    const Eigen::Vector3d way(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
    const Eigen::AngleAxisd turn(Eigen::Quaterniond::FromTwoVectors(way.normalized(), -Eigen::Vector3d::UnitZ()));
    const Eigen::Vector3d vector = turn.angle() * turn.axis();
    turns.push_back({vector.x(), vector.y(), vector.z()});
  }
  return turns;
}

/// What rest in the grip looks like, turned one way.
struct Rest {
  Eigen::Vector3d down;  ///< in the axes of the palm
  Eigen::Matrix3Xd places_m;
};

std::vector<Rest> rests_after(const std::vector<std::array<double, 3>>& turns) {
  std::vector<Rest> rests;
  for (std::size_t from = 0; from < turns.size(); from += kLanes) {
    std::vector<Scenario> batch;
    for (std::size_t i = from; i < std::min(turns.size(), from + kLanes); ++i) {
      std::array<double, 3> turn = turns[i];
      turn[0] += 1e-12;  // next to none is a turn too
      batch.push_back(tilted_block(turn, 4.0, kStep_s));
      batch.back().strategy.hold_s = 0.8;
      batch.back().simulation.duration_s = 1.7;
      batch.back().simulation.trace_interval_s = 0.02;
    }
    const Points points = points_of(batch.front());
    for (const Trace& trace : traces_of(batch)) {
      const std::size_t row = last_in_phase(trace, CyclePhase::hold);
      rests.push_back({palm_attitude(grip_row(trace, row).rotation_rad).conjugate() * -Eigen::Vector3d::UnitZ(),
                       places_in_grip_m(trace, points, row)});
    }
  }
  return rests;
}

/// The ways of the particles of a cube turned by a quarter about the grip axis, each that of the particle which
/// stands there then.
Eigen::Matrix3Xd turned_about_the_grip_axis(const Eigen::Matrix3Xd& way_m, const Points& points) {
  const Eigen::AngleAxisd quarter(kQuarter_rad, Eigen::Vector3d::UnitX());
  Eigen::Matrix3Xd out = way_m;
  for (std::size_t p = 0; p < points.X.size(); ++p) {
    const Eigen::Vector3d there = quarter * points.X[p];
    for (std::size_t to = 0; to < points.X.size(); ++to) {
      if ((points.X[to] - there).norm() > 1e-6) continue;
      out.col(static_cast<Eigen::Index>(to)) = quarter * way_m.col(static_cast<Eigen::Index>(p));
    }
  }
  return out;
}

TEST(TurnedStatics, TwentySixWaysGiveTheShapeThatTheTurnedWeightGives) {
  const std::vector<Rest> rests = rests_after(turns_to_26_ways());
  const auto towards = [&](const Eigen::Vector3d& way) -> const Eigen::Matrix3Xd& {
    return std::find_if(rests.begin(), rests.end(),
                        [&](const Rest& rest) { return (rest.down - way).norm() < 1e-6; })
        ->places_m;
  };
  // Next to nothing slips, so the places are linear in the weight: all follow from those along the axes.
  std::array<Eigen::Matrix3Xd, 3> sag;
  const Eigen::Matrix3Xd weightless =
      0.5 * (towards(Eigen::Vector3d::UnitZ()) + towards(-Eigen::Vector3d::UnitZ()));
  for (int axis = 0; axis < 3; ++axis)
    sag[static_cast<std::size_t>(axis)] = towards(Eigen::Vector3d::Unit(axis)) - weightless;
  const double sag_m = sag[2].cwiseAbs().maxCoeff();
  EXPECT_GT(sag_m, 5e-5);
  for (const Rest& rest : rests) {
    const Eigen::Matrix3Xd expected =
        weightless + rest.down.x() * sag[0] + rest.down.y() * sag[1] + rest.down.z() * sag[2];
    SCOPED_TRACE(rest.down.transpose());
    // 3e-4 of the sag are the squares of the small turns in the grip.
    EXPECT_LT((rest.places_m - expected).cwiseAbs().maxCoeff(), 1e-3 * sag_m);
  }
  // What weight along y does to a cube is what weight along -z does, turned by a quarter. The places themselves
  // are not: the pads hold the cube as it stood when they closed.
  const Points points = points_of(tilted_block({1e-12, 0.0, 0.0}, 4.0, kStep_s));
  const Eigen::Matrix3Xd difference = turned_about_the_grip_axis(-sag[2], points) - sag[1];
  EXPECT_LT(difference.cwiseAbs().maxCoeff(), 5e-3 * sag_m);  // 2.4e-3 are left of that shape
}

TEST(TurnedStatics, DoesNotCreepAtTwiceTheLeastForce) {
  std::vector<Scenario> scenarios;
  for (const std::array<double, 3>& tilt : {std::array<double, 3>{kQuarter_rad, 0.0, 0.0},
                                            {0.0, kQuarter_rad, 0.0},
                                            {0.0, 0.0, kQuarter_rad},
                                            {2.0 * kQuarter_rad, 0.0, 0.0},
                                            {0.0, 2.0 * kQuarter_rad, 0.0},
                                            {0.0, 0.0, 2.0 * kQuarter_rad}}) {
    // m g / (2 mu) is the least.
    Scenario& scenario = scenarios.emplace_back(tilted_block(tilt, 0.1 * kGravity, kStep_s));
    scenario.strategy.hold_s = 2.0;
    scenario.simulation.duration_s = 3.2;
  }
  for (const ScenarioResult& result : run_side_by_side(scenarios)) {
    EXPECT_EQ(result.outcome, Outcome::held) << result.cause;
    EXPECT_LT(result.metrics[Metric::hold_drift_m_s], 1e-12);  // 1e-6 would be creep; it stands to rounding
  }
}

TEST(TurnedStatics, HardGripsAndLongStepsComeToRest) {
  // dt^2 F d / J is 3 and 13: angular momentum is not given back, and half of beta in each step does not ring.
  for (const double time_step_s : {5e-3, 1e-2}) {
    for (const double turn : {1e-6, 1.0}) {
      Scenario scenario = tilted_block({0.9 * turn, 1.0 * turn, 0.7 * turn}, 100.0, time_step_s);
      lattice_of(scenario).youngs_modulus_Pa = 2e7;
      scenario.cell.grip_height_m = 0.01;
      scenario.strategy.grip_ramp_s = 0.3;  // which such steps resolve
      scenario.strategy.hold_s = 1.0;
      scenario.simulation.duration_s = 2.0;  // before the turn is taken back
      Trace trace;
      const ScenarioResult result = run(scenario, &trace);
      EXPECT_EQ(result.outcome, Outcome::held) << result.cause;
      const std::size_t n = 3 * static_cast<std::size_t>(trace.particle_count);
      const Eigen::Map<const Eigen::VectorXd> velocity(
          trace.velocity_m_s.data() + n * last_in_phase(trace, CyclePhase::hold), static_cast<Eigen::Index>(n));
      EXPECT_LT(velocity.cwiseAbs().maxCoeff(), 1e-3) << time_step_s << " s, " << turn;
    }
  }
}

}  // namespace
}  // namespace unbruised

#include "core/simulation/replay_recorder.hpp"

#include <cmath>

#include "core/scenario/attitude.hpp"
#include "core/scenario/vectors.hpp"
#include "tests/core/simulation/scenes.hpp"

namespace unbruised {
namespace {

using Vector = std::array<double, 3>;

constexpr double kInterval_s = 0.02;

struct Seen {
  ScenarioResult result;
  Replay replay;
  Trace trace;
};

/// In a lane of its own choice, so that nothing may hang on the number of a lane.
Seen see(const Scenario& scenario, int lane = 0) {
  Seen seen;
  LaneSimulation simulation(testing::build(scenario));
  simulation.load(lane, scenario);
  simulation.record(lane, {&seen.trace, &seen.replay, kInterval_s});
  while (simulation.busy(lane)) simulation.step();
  seen.result = simulation.finished().front().result;
  return seen;
}

Vector part(const std::vector<double>& values, std::size_t row) {
  return {values[3 * row], values[3 * row + 1], values[3 * row + 2]};
}

/// Where a vertex stands in a frame.
Vector place_of(const Replay& replay, std::size_t frame, std::size_t vertex) {
  const auto& q = replay.attitude;
  const Attitude attitude{q[4 * frame], {q[4 * frame + 1], q[4 * frame + 2], q[4 * frame + 3]}};
  Vector there = replay.vertex_m[vertex];
  const std::size_t at = 3 * (frame * replay.vertex_m.size() + vertex);
  for (std::size_t i = 0; i < 3; ++i) there[i] += static_cast<double>(replay.deformation_m[at + i]);
  there = turned(attitude, there);
  for (std::size_t i = 0; i < 3; ++i) there[i] += replay.product_m[3 * frame + i];
  return there;
}

/// The row of the trace that a frame shows.
std::size_t row_of(const Seen& seen, std::size_t frame) {
  const auto& times = seen.trace.time_s;
  const auto at = std::find(times.begin(), times.end(), seen.replay.time_s[frame]);
  EXPECT_NE(at, times.end()) << "a frame stands between two steps";
  return static_cast<std::size_t>(at - times.begin());
}

/// The corners of a box are particles: they have to be where the trace has them.
void expect_corners_where_particles_are(const Seen& seen, double tolerance_m) {
  const Replay& replay = seen.replay;
  const auto particles = static_cast<std::size_t>(seen.trace.particle_count);
  std::size_t compared = 0;
  for (std::size_t v = 0; v < replay.vertex_m.size(); ++v) {
    for (std::size_t p = 0; p < particles; ++p) {
      Vector off = part(seen.trace.rest_position_m, p);
      for (std::size_t i = 0; i < 3; ++i) off[i] -= place_of(replay, 0, v)[i];
      if (length(off) > 2e-5) continue;  // at the start it is pressed together by its weight only
      ++compared;
      for (std::size_t frame = 0; frame < replay.frame_count(); frame += 3) {
        const Vector seen_m = place_of(replay, frame, v);
        for (std::size_t i = 0; i < 3; ++i) {
          const std::size_t freedom = 3 * p + i;
          const double place_m = seen.trace.rest_position_m[freedom] +
                                 seen.trace.displacement_m[row_of(seen, frame) * 3 * particles + freedom];
          EXPECT_NEAR(seen_m[i], place_m, tolerance_m);
        }
      }
    }
  }
  EXPECT_GE(compared, 8U) << "a box has eight corners";
}

Scenario squeezed_box() {
  Scenario scenario = testing::small_box();
  LatticeParameters& product = testing::lattice_of(scenario);
  product.yield_stress_Pa = 800.0;
  product.tangent_modulus_Pa = 5e4;
  return scenario;
}

TEST(ReplayRecorder, PutsTheSurfaceWhereTheParticlesAre) {
  // Deformations are kept in single precision: 1e-7 of a millimetre or less.
  expect_corners_where_particles_are(see(testing::small_box()), 1e-9);
}

TEST(ReplayRecorder, DoesSoForAProductThatTurns) {
  Scenario scenario = testing::small_box();
  scenario.strategy.tilt_rad = {0.0, 0.4, 0.0};
  const Seen seen = see(scenario);
  double turned_rad = 0.0;
  for (std::size_t frame = 0; frame < seen.replay.frame_count(); ++frame) {
    turned_rad = std::max(turned_rad, 2.0 * std::acos(std::min(1.0, std::abs(seen.replay.attitude[4 * frame]))));
  }
  EXPECT_NEAR(turned_rad, 0.4, 0.02);
  expect_corners_where_particles_are(seen, 1e-9);
}

TEST(ReplayRecorder, ShowsTheForcesOfTheTrace) {
  const Seen seen = see(testing::small_box());
  const TraceSignal& force = testing::signal(seen.trace, "surface_force_N");
  for (std::size_t frame = 0; frame < seen.replay.frame_count(); ++frame) {
    for (std::size_t i = 0; i < 9; ++i) {
      EXPECT_EQ(seen.replay.force_N[9 * frame + i], force.values[9 * row_of(seen, frame) + i]);
    }
  }
}

TEST(ReplayRecorder, ReadsAtTheWristWhatTheFingersCarry) {
  const Seen seen = see(testing::small_box());
  const double weight_N = 1000.0 * 0.02 * 0.02 * 0.02 * testing::kGravity;
  double lifted_N = 0.0;
  for (std::size_t frame = 0; frame < seen.replay.frame_count(); ++frame) {
    double support_N = seen.replay.force_N[9 * frame + 8];
    if (support_N == 0.0) lifted_N = seen.replay.wrist_wrench[6 * frame + 2];
    const double fingers_N = seen.replay.force_N[9 * frame + 2] + seen.replay.force_N[9 * frame + 5];
    EXPECT_NEAR(seen.replay.wrist_wrench[6 * frame + 2], -fingers_N, 1e-12);
  }
  EXPECT_LT(lifted_N, -0.5 * weight_N) << "the product hangs on the wrist";
}

TEST(ReplayRecorder, KeepsTheStrainThatDecidesAndTheShapeThatStays) {
  const Seen seen = see(squeezed_box());
  const Replay& replay = seen.replay;
  const double strain = seen.result.metrics[Metric::plastic_strain_max];
  ASSERT_GT(strain, 0.0);
  const float most = *std::max_element(replay.plastic_strain.begin(), replay.plastic_strain.end());
  // Cells are averaged around a place; a patch shows all of its own. Frames may miss its very peak.
  EXPECT_GT(static_cast<double>(most), 0.3 * strain);
  EXPECT_LE(static_cast<double>(most), strain * (1.0 + 1e-6));
  double set_m = 0.0;
  for (std::size_t v = 0; v < replay.vertex_m.size(); ++v)
    set_m = std::max(set_m, length(part(replay.permanent_m, v)));
  EXPECT_LE(set_m, seen.result.metrics[Metric::permanent_set_max_m] * (1.0 + 1e-9));
}

TEST(ReplayRecorder, ShowsPressureOnlyWhereSomethingTouches) {
  const Seen seen = see(testing::small_box());
  const Replay& replay = seen.replay;
  const std::size_t vertices = replay.vertex_m.size();
  for (std::size_t frame = 0; frame < replay.frame_count(); ++frame) {
    double pressed_N = 0.0;
    for (std::size_t s = 0; s < 3; ++s) pressed_N += std::abs(replay.force_N[9 * frame + 3 * s + (s < 2 ? 0 : 2)]);
    float most = 0.0F;
    for (std::size_t v = 0; v < vertices; ++v) most = std::max(most, replay.pressure_Pa[frame * vertices + v]);
    EXPECT_EQ(most > 0.0F, pressed_N > 0.0) << "frame " << frame;
  }
}

TEST(ReplayRecorder, MakesTheSameFramesInEveryLaneAndChangesNoMetric) {
  const Seen one = see(squeezed_box(), 0), other = see(squeezed_box(), lane_count() - 1);
  EXPECT_EQ(one.replay.deformation_m, other.replay.deformation_m);
  EXPECT_EQ(one.replay.plastic_strain, other.replay.plastic_strain);
  EXPECT_EQ(one.replay.force_place_m, other.replay.force_place_m);
  testing::expect_same_bits(one.result, testing::run(squeezed_box()), "with and without a replay");
}

TEST(ReplayRecorder, EndsWithTheLastStep) {
  const Seen seen = see(testing::small_box());
  EXPECT_EQ(seen.replay.time_s.front(), 0.0);
  EXPECT_EQ(seen.replay.time_s.back(), seen.trace.time_s.back());
  for (std::size_t frame = 1; frame + 1 < seen.replay.frame_count(); ++frame) {
    EXPECT_NEAR(seen.replay.time_s[frame], kInterval_s * static_cast<double>(frame),
                seen.trace.time_s[1] - seen.trace.time_s[0] - 1e-6);
  }
}

TEST(ReplayRecorder, ShowsTheParticlesAndSpringsOfANetwork) {
  Scenario scenario = testing::small_box();
  NetworkParameters network;
  network.particle.resize(2);
  network.particle[0].fixed = {true, true, true};
  network.particle[1].position_m = {0.1, 0.0, 0.0};
  network.particle[1].mass_kg = 0.1;
  network.particle[1].initial_velocity_m_s = {0.01, 0.0, 0.0};
  network.spring.resize(1);
  network.spring[0].between = {0, 1};
  network.spring[0].stiffness_N_m = 10.0;
  scenario.product = network;
  scenario.gripper = NoGripper{};
  scenario.cell.support = false;
  scenario.cell.gravity_m_s2 = {0.0, 0.0, 0.0};
  scenario.simulation.duration_s = 0.2;
  const Seen seen = see(scenario);
  EXPECT_EQ(seen.replay.vertex_m.size(), 2U);
  EXPECT_TRUE(seen.replay.triangle.empty());
  ASSERT_EQ(seen.replay.line.size(), 1U);
  const std::size_t last = seen.replay.frame_count() - 1;
  EXPECT_NEAR(place_of(seen.replay, last, 1)[0], 0.1 + seen.trace.displacement_m[6 * row_of(seen, last) + 3],
              1e-9);
}

}  // namespace
}  // namespace unbruised

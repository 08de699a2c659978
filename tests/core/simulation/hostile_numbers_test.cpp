// Numbers that no product has: each is refused by `validate`, or ends as a named outcome, and the lanes beside it
// keep their bits.

#include <cmath>
#include <functional>
#include <limits>

#include <gtest/gtest.h>

#include "tests/core/simulation/scenes.hpp"

namespace unbruised {
namespace {

using namespace testing;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

using Setter = std::function<void(Scenario&, double)>;

std::vector<Setter> lattice_numbers() {
  return {
      [](Scenario& s, double x) { lattice_of(s).size_m[1] = x; },
      [](Scenario& s, double x) { lattice_of(s).cell_size_m = x; },
      [](Scenario& s, double x) { lattice_of(s).density_kg_m3 = x; },
      [](Scenario& s, double x) { lattice_of(s).youngs_modulus_Pa = x; },
      [](Scenario& s, double x) { lattice_of(s).poisson_ratio = x; },
      [](Scenario& s, double x) { lattice_of(s).relaxation_time_s = x; },
      [](Scenario& s, double x) { lattice_of(s).friction = x; },
      [](Scenario& s, double x) { lattice_of(s).initial_velocity_m_s[2] = x; },
      [](Scenario& s, double x) { s.gripper->finger_mass_kg = x; },
      [](Scenario& s, double x) { s.gripper->pad_size_m[0] = x; },
      [](Scenario& s, double x) { s.gripper->pad_modulus_Pa = x; },
      [](Scenario& s, double x) { s.gripper->drive_gain_N_s_m = x; },
      [](Scenario& s, double x) { s.gripper->max_force_N = x; },
      [](Scenario& s, double x) { s.cell.gravity_m_s2[2] = x; },
      [](Scenario& s, double x) { s.cell.support_friction = x; },
      [](Scenario& s, double x) { s.cell.approach_gap_m = x; },
      [](Scenario& s, double x) { s.cell.grip_height_m = x; },
      [](Scenario& s, double x) { s.cell.transfer_m[1] = x; },
      [](Scenario& s, double x) { s.cell.place_height_m = x; },
      [](Scenario& s, double x) { s.strategy.approach_speed_m_s = x; },
      [](Scenario& s, double x) { s.strategy.grip_force_N = x; },
      [](Scenario& s, double x) { s.strategy.contact_force_N = x; },
      [](Scenario& s, double x) { s.strategy.lift_acceleration_m_s2 = x; },
      [](Scenario& s, double x) { s.strategy.hold_s = x; },
      [](Scenario& s, double x) { s.limits.slip_m = x; },
      [](Scenario& s, double x) { s.limits.finger_force_N = x; },
      [](Scenario& s, double x) { s.simulation.time_step_s = x; },
      [](Scenario& s, double x) { s.simulation.theta = x; },
      [](Scenario& s, double x) { s.simulation.max_strain = x; },
      [](Scenario& s, double x) { s.simulation.trace_interval_s = x; },
  };
}

std::vector<Setter> network_numbers() {
  return {
      [](Scenario& s, double x) { network_of(s).particle[1].mass_kg = x; },
      [](Scenario& s, double x) { network_of(s).particle[1].position_m[0] = x; },
      [](Scenario& s, double x) { network_of(s).particle[1].initial_displacement_m[0] = x; },
      [](Scenario& s, double x) { network_of(s).particle[1].initial_velocity_m_s[0] = x; },
      [](Scenario& s, double x) { network_of(s).spring[0].stiffness_N_m = x; },
      [](Scenario& s, double x) { network_of(s).spring[0].damping_N_s_m = x; },
      [](Scenario& s, double x) { network_of(s).spring[0].rest_length_m = x; },
      [](Scenario& s, double x) { network_of(s).spring[0].yield_force_N = x; },
      [](Scenario& s, double x) { network_of(s).load[0].time_s[1] = x; },
      [](Scenario& s, double x) { network_of(s).load[0].force_N[0][0] = x; },
  };
}

Scenario loaded_oscillator() {
  Scenario scenario = oscillator(2.0, 100.0, 0.01, 20);
  network_of(scenario).load = {{1, {0.0, 1.0}, {{1.0, 0.0, 0.0}, {1.0, 0.0, 0.0}}}};
  return scenario;
}

TEST(HostileNumbers, TheScenesThemselvesAreSound) {
  EXPECT_TRUE(validate(small_box()).empty());
  EXPECT_TRUE(validate(loaded_oscillator()).empty());
}

TEST(HostileNumbers, NanAndInfinityAreRefusedInEveryField) {
  for (const double bad : {kNan, kInfinity, -kInfinity}) {
    std::size_t at = 0;
    for (const Setter& set : lattice_numbers()) {
      Scenario scenario = small_box();
      set(scenario, bad);
      EXPECT_FALSE(validate(scenario).empty()) << "lattice number " << at << " = " << bad;
      ++at;
    }
    at = 0;
    for (const Setter& set : network_numbers()) {
      Scenario scenario = loaded_oscillator();
      set(scenario, bad);
      EXPECT_FALSE(validate(scenario).empty()) << "network number " << at << " = " << bad;
      ++at;
    }
  }
}

TEST(HostileNumbers, ZeroMassAndASpringOfNoLengthAreRefused) {
  Scenario massless = loaded_oscillator();
  network_of(massless).particle[1].mass_kg = 0.0;
  EXPECT_FALSE(validate(massless).empty());
  Scenario point = loaded_oscillator();
  network_of(point).particle[1].position_m = network_of(point).particle[0].position_m;
  EXPECT_FALSE(validate(point).empty());
  Scenario itself = loaded_oscillator();
  network_of(itself).spring[0].between = {1, 1};
  EXPECT_FALSE(validate(itself).empty());
  Scenario weightless = small_box();
  lattice_of(weightless).density_kg_m3 = 0.0;
  EXPECT_FALSE(validate(weightless).empty());
  Scenario nobody = loaded_oscillator();
  network_of(nobody).load[0].particle = 7;
  EXPECT_FALSE(validate(nobody).empty());
}

/// Runs it if it can be run: a model that cannot be factored says why.
void expect_named_end(const Scenario& scenario, const std::string& what) {
  if (!validate(scenario).empty()) return;
  std::string error;
  const auto model = Model::build(scenario, error);
  if (model == nullptr) {
    EXPECT_FALSE(error.empty()) << what;
    return;
  }
  const ScenarioResult result = simulate(model, scenario, nullptr);
  EXPECT_NE(result.outcome, Outcome::not_run) << what;
  if (result.outcome == Outcome::diverged || result.outcome == Outcome::out_of_range) {
    EXPECT_FALSE(result.cause.empty()) << what;
  }
  for (const double value : result.metrics.values()) EXPECT_FALSE(std::isinf(value)) << what;
}

TEST(HostileNumbers, AStiffnessThatHoldsNothingEndsWithAName) {
  Scenario loose = loaded_oscillator();
  network_of(loose).spring[0].stiffness_N_m = 0.0;  // the mass is free: K is singular, K + a0 M is not
  expect_named_end(loose, "no stiffness");
  Scenario apart = loaded_oscillator();
  network_of(apart).spring.clear();
  expect_named_end(apart, "no springs");
  Scenario plastic = loaded_oscillator();
  network_of(plastic).spring[0].yield_force_N = 1e-300;
  network_of(plastic).spring[0].hardening_ratio = 0.0;
  expect_named_end(plastic, "perfectly plastic");
  Scenario wall = loaded_oscillator();
  network_of(wall).particle[1].fixed = {true, true, true};
  expect_named_end(wall, "nothing can move");
}

TEST(HostileNumbers, ExtremesOfEveryFieldEndWithAName) {
  std::size_t at = 0;
  for (const Setter& set : network_numbers()) {
    for (const double extreme : {1e-300, 1e-30, 1e30, 1e300, -1e300}) {
      Scenario scenario = loaded_oscillator();
      set(scenario, extreme);
      expect_named_end(scenario, "network number " + std::to_string(at) + " = " + std::to_string(extreme));
    }
    ++at;
  }
}

/// Extremes of what may differ inside a batch: they share the factor of the sound scenario.
std::vector<Scenario> violent_neighbours() {
  std::vector<Scenario> all;
  const auto add = [&](const std::function<void(Scenario&)>& change) {
    Scenario scenario = small_box();
    scenario.simulation.max_rotation_rad = 1e300;
    scenario.simulation.max_strain = 1e300;
    change(scenario);
    all.push_back(scenario);
  };
  add([](Scenario& s) { lattice_of(s).initial_velocity_m_s = {0.0, 1e200, 1e200}; });
  add([](Scenario& s) { s.cell.gravity_m_s2 = {0.0, 1e308, -1e308}; });
  add([](Scenario& s) { s.cell.gravity_m_s2 = {0.0, 0.0, -1e5}; });
  add([](Scenario& s) { lattice_of(s).friction = 1e6; });
  add([](Scenario& s) { s.gripper->drive_gain_N_s_m = 1e12; });
  add([](Scenario& s) { s.gripper->finger_mass_kg = 1e-12; });
  add([](Scenario& s) { s.strategy.lift_acceleration_m_s2 = 1e6; });
  add([](Scenario& s) {
    s.gripper->max_force_N = 1e6;
    s.strategy.grip_force_N = 1e6;
  });
  return all;
}

TEST(HostileNumbers, ViolentLanesLeaveASoundOneItsBits) {
  const Scenario sound = small_box();
  const auto model = build(sound);
  ASSERT_NE(model, nullptr);
  const ScenarioResult alone = simulate(model, sound, nullptr);
  ASSERT_EQ(alone.outcome, Outcome::held) << alone.cause;
  const std::vector<Scenario> violent = violent_neighbours();
  LaneSimulation simulation(model);
  for (int lane = 0; lane < lane_count(); ++lane) {
    const Scenario& neighbour = violent[static_cast<std::size_t>(lane) % violent.size()];
    ASSERT_EQ(factor_key(neighbour), factor_key(sound)) << lane;
    simulation.load(lane, lane == 3 ? sound : neighbour);
  }
  int ended = 0;
  int diverged = 0;
  while (simulation.busy_count() > 0) {
    simulation.step();
    for (const auto& finished : simulation.finished()) {
      ++ended;
      if (finished.lane == 3) expect_same_bits(finished.result, alone, "among violent neighbours");
      if (finished.result.outcome != Outcome::diverged) continue;
      ++diverged;
      EXPECT_FALSE(finished.result.cause.empty()) << finished.lane;
    }
  }
  EXPECT_EQ(ended, lane_count());
  EXPECT_GE(diverged, 4);
}

}  // namespace
}  // namespace unbruised

// Numbers that no product has: each is refused by `validate`, or ends as a named outcome, and the lanes beside it
// keep their bits.

#include <cmath>
#include <functional>
#include <limits>

#include <gtest/gtest.h>

#include "tests/core/scenario/scenarios.hpp"
#include "tests/core/simulation/scenes.hpp"

namespace unbruised {
namespace {

using namespace testing;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The n-th number of all fields.
struct Numbered {
  std::string name;
  std::size_t n;
};

/// Calls `visit` with each number of the scenario, in the order of the table; ints are left out.
void for_each(Scenario& scenario, const std::function<void(const std::string&, NumberSlot)>& visit) {
  for (const NumberField& field : number_fields()) {
    field.each(scenario, [&](const NumberPlace& place, NumberSlot slot) {
      if (!std::holds_alternative<int*>(slot)) visit(path_of(field.path, place), slot);
    });
  }
}

std::vector<Numbered> numbers_of(Scenario scenario) {
  std::vector<Numbered> all;
  for_each(scenario, [&](const std::string& name, NumberSlot) { all.push_back({name, all.size()}); });
  return all;
}

Scenario with(Scenario scenario, const Numbered& number, double value) {
  std::size_t n = 0;
  for_each(scenario, [&](const std::string&, NumberSlot slot) {
    if (n++ == number.n) set(slot, value);
  });
  return scenario;
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
  for (const Scenario& sound : {small_box(), loaded_oscillator()}) {
    const std::vector<Numbered> all = numbers_of(sound);
    EXPECT_GE(all.size(), 50U);
    for (const Numbered& number : all) {
      for (const double bad : {kNan, kInfinity, -kInfinity}) {
        EXPECT_FALSE(validate(with(sound, number, bad)).empty()) << number.name << " = " << bad;
      }
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

TEST(HostileNumbers, AMassThatNoSpringHoldsCanBeBuiltBesideSpringsThatYieldBetweenWalls) {
  // Found by random configs: K has no elastic mode, so the shift of the static factor was 0 and the factor
  // singular.
  Scenario scenario = loaded_oscillator();
  NetworkParameters& network = network_of(scenario);
  network.spring[0].yield_force_N = 1.0;
  network.particle[1].fixed = {true, true, true};
  NetworkParticle free;
  free.position_m = {3.0, 0.0, 0.0};
  free.mass_kg = 0.5;
  network.particle.push_back(free);
  ASSERT_TRUE(validate(scenario).empty());
  std::string error;
  EXPECT_NE(Model::build(scenario, error), nullptr) << error;
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
  const Scenario sound = loaded_oscillator();
  for (const Numbered& number : numbers_of(sound)) {
    if (!number.name.starts_with("product.")) continue;  // a run of 1e300 s or of 1e300 steps has no end
    for (const double extreme : {1e-300, 1e-30, 1e30, 1e300, -1e300}) {
      expect_named_end(with(sound, number, extreme), number.name + " = " + std::to_string(extreme));
    }
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
  add([](Scenario& s) { jaw_of(s).drive_gain_N_s_m = 1e12; });
  add([](Scenario& s) { jaw_of(s).finger_mass_kg = 1e-12; });
  add([](Scenario& s) { s.strategy.lift_acceleration_m_s2 = 1e6; });
  add([](Scenario& s) {
    jaw_of(s).max_force_N = 1e6;
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

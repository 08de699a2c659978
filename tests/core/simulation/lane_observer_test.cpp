// Who is added to the list of a lane's observers sees the start, every step and the end, and changes nothing.

#include "core/simulation/lane_observer.hpp"

#include <limits>
#include <stdexcept>

#include "tests/core/simulation/scenes.hpp"

namespace unbruised {
namespace {

using testing::column;

/// What an observer was shown.
struct Seen {
  int starts = 0, ends = 0;
  std::vector<double> time_s, force_x_N, center_acceleration_z_m_s2;
  double last_time_s = -1.0;
};

class Spy final : public LaneObserver {
 public:
  /// @param enough_steps after which it wants no more
  explicit Spy(Seen& seen, std::int64_t enough_steps = std::numeric_limits<std::int64_t>::max())
      : seen_(seen), enough_steps_(enough_steps) {}
  void start(const LaneStep& loaded) override {
    ++seen_.starts;
    note(loaded);
  }
  bool observe(const LaneStep& step) override {
    EXPECT_EQ(step.start_s, seen_.time_s.back());
    EXPECT_EQ(static_cast<std::size_t>(step.count), seen_.time_s.size());
    note(step);
    return step.count < enough_steps_;
  }
  void end(const LaneStep& last) override {
    ++seen_.ends;
    seen_.last_time_s = last.time_s;
  }

 private:
  void note(const LaneStep& step) {
    seen_.time_s.push_back(step.time_s);
    seen_.force_x_N.push_back(step.view.contact.surface_force(kLeftPad, step.lane)[0]);
    seen_.center_acceleration_z_m_s2.push_back(step.seen.center_acceleration_m_s2[2]);
  }
  Seen& seen_;
  std::int64_t enough_steps_;
};

/// Runs a scenario in lane 2 under the observers.
ScenarioResult run_watched(const Scenario& scenario, std::vector<std::unique_ptr<LaneObserver>> observers,
                           Trace* trace = nullptr) {
  LaneSimulation simulation(testing::build(scenario));
  simulation.load(2, scenario);
  for (auto& observer : observers) simulation.watch(2, std::move(observer));
  if (trace != nullptr) simulation.record(2, trace);
  while (simulation.busy(2)) simulation.step();
  return simulation.finished().front().result;
}

std::vector<std::unique_ptr<LaneObserver>> one(std::unique_ptr<LaneObserver> observer) {
  std::vector<std::unique_ptr<LaneObserver>> list;
  list.push_back(std::move(observer));
  return list;
}

TEST(LaneObserver, SeesTheStartEveryStepAndTheEndAsTheTraceDoes) {
  const Scenario scenario = testing::small_box();
  Seen seen;
  Trace trace;
  const ScenarioResult watched = run_watched(scenario, one(std::make_unique<Spy>(seen)), &trace);
  EXPECT_EQ(seen.starts, 1);
  EXPECT_EQ(seen.ends, 1);
  EXPECT_EQ(seen.time_s, trace.time_s);
  EXPECT_EQ(seen.force_x_N, column(trace, "finger_force_N", 0));
  EXPECT_EQ(seen.last_time_s, trace.time_s.back());
  testing::expect_same_bits(watched, testing::run(scenario), "with and without observers");
}

TEST(LaneObserver, IsShownTheStateThatTheScenarioStartsFrom) {
  // Pulled off its support from the first moment on, in a lane that another scenario left at rest.
  Scenario rests = testing::small_box();
  rests.gripper = NoGripper{};
  rests.simulation.duration_s = 2e-3;
  Scenario falls = rests;
  falls.cell.gravity_m_s2 = {0.0, 0.0, testing::kGravity};
  LaneSimulation simulation(testing::build(rests));
  simulation.load(0, rests);
  while (simulation.busy(0)) simulation.step();
  simulation.load(0, falls);
  Seen seen;
  simulation.watch(0, std::make_unique<Spy>(seen));
  // Rounding of the mean over the particles.
  EXPECT_NEAR(seen.center_acceleration_z_m_s2.front(), testing::kGravity, 1e-12);
}

TEST(LaneObserver, EndsTheRunWhenItHasSeenEnough) {
  Seen seen;
  const ScenarioResult result = run_watched(testing::small_box(), one(std::make_unique<Spy>(seen, 7)));
  EXPECT_EQ(seen.time_s.size(), 8U);
  EXPECT_EQ(seen.ends, 1);
  EXPECT_EQ(result.metrics[Metric::step_count], 7.0);
}

TEST(LaneObserver, JoinsAtTheStartOrNotAtAll) {
  Seen seen;
  const Scenario scenario = testing::small_box();
  LaneSimulation simulation(testing::build(scenario));
  EXPECT_THROW(simulation.watch(0, std::make_unique<Spy>(seen)), std::logic_error);
  simulation.load(0, scenario);
  simulation.step();
  EXPECT_THROW(simulation.watch(0, std::make_unique<Spy>(seen)), std::logic_error);
  EXPECT_EQ(seen.starts, 0);
}

}  // namespace
}  // namespace unbruised

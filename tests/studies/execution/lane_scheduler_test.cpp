/// @file
/// What only the scheduler does: work that grows while it runs. Fixed sets are tested in batch_runner_test.cpp.

#include "studies/execution/lane_scheduler.hpp"

#include <atomic>
#include <latch>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "tests/studies/execution/fake_simulator.hpp"

namespace unbruised::studies {
namespace {

using testing::FakeSimulator;
using testing::kFakeLanes;

/// Three groups, runs of 1 to 7 steps.
Scenario scenario_of(std::uint64_t id) {
  Scenario scenario;
  std::get<LatticeParameters>(scenario.product).youngs_modulus_Pa = 1e6 + static_cast<double>(id % 3);
  scenario.strategy.grip_force_N = 1.0 + static_cast<double>(id);
  scenario.simulation.duration_s = static_cast<double>(1 + (id * 5) % 7);
  return scenario;
}

WorkOrder growing(ResultSink sink) {
  return {.scenario = scenario_of, .sink = std::move(sink), .stop = nullptr, .supply = Supply::growing};
}

TEST(LaneScheduler, DeliversWhatIsAddedFromManyThreadsWhileItWorks) {
  for (const int threads : {1, 3}) {
    const FakeSimulator simulator;
    std::set<std::uint64_t> delivered;
    LaneScheduler scheduler(simulator, growing([&](std::uint64_t id, const ScenarioResult&) {
                              EXPECT_TRUE(delivered.insert(id).second);
                            }),
                            threads);
    std::vector<std::jthread> askers;
    std::atomic<int> asking = 4;
    for (std::uint64_t asker = 0; asker < 4; ++asker) {
      askers.emplace_back([&, asker] {
        for (std::uint64_t i = 0; i < 25; ++i) scheduler.add(std::vector<std::uint64_t>{100 * asker + i});
        if (--asking == 0) scheduler.close();
      });
    }
    const WorkReport done = scheduler.run();
    EXPECT_EQ(delivered.size(), 100U);
    EXPECT_EQ(done.delivered, 100U);
    EXPECT_EQ(done.group_count, 3U);
  }
}

/// A search asks for one more only when it has its answer, so that each group runs empty again and again.
TEST(LaneScheduler, KeepsModelsForTheQuestionsThatFollow) {
  const FakeSimulator simulator;
  LaneScheduler* itself = nullptr;
  std::uint64_t next = 3;
  LaneScheduler scheduler(simulator, growing([&](std::uint64_t, const ScenarioResult&) {
                            if (next == 60) return itself->close();
                            itself->add(std::vector<std::uint64_t>{next++});
                          }),
                          1);
  itself = &scheduler;
  scheduler.add(std::vector<std::uint64_t>{0});
  scheduler.run();
  EXPECT_EQ(simulator.record.models_built, 3);
}

TEST(LaneScheduler, FillsTheLanesOfOneThreadBeforeItUsesAnother) {
  const FakeSimulator simulator;
  LaneScheduler scheduler(simulator, growing([](std::uint64_t, const ScenarioResult&) {}), 2);
  std::vector<std::uint64_t> one_group;
  for (std::uint64_t i = 0; i < kFakeLanes; ++i) one_group.push_back(3 * i);
  scheduler.add(one_group);
  scheduler.close();
  scheduler.run();
  EXPECT_EQ(simulator.record.most_lanes_busy, kFakeLanes);
  EXPECT_EQ(simulator.record.lane_simulations, 1);
}

TEST(LaneScheduler, LendsAThreadThatNobodyHasWorkForToOneThatHas) {
  for (const int threads : {1, 2, 5}) {
    const FakeSimulator simulator;
    LaneScheduler scheduler(simulator, growing([](std::uint64_t, const ScenarioResult&) {}), threads);
    scheduler.add(std::vector<std::uint64_t>{0});
    scheduler.close();
    scheduler.run();
    EXPECT_EQ(simulator.record.steps_on_two_threads, threads > 1 ? simulator.record.steps.load() : 0) << threads;
  }
}

TEST(LaneScheduler, IsNotEndedByAnEmptyQueueButByClosing) {
  const FakeSimulator simulator;
  std::latch first_done(1);
  std::size_t delivered = 0;
  LaneScheduler scheduler(simulator, growing([&](std::uint64_t, const ScenarioResult&) {
                            if (++delivered == 1) first_done.count_down();
                          }),
                          2);
  scheduler.add(std::vector<std::uint64_t>{1});
  std::jthread later([&] {
    first_done.wait();
    scheduler.add(std::vector<std::uint64_t>{2});
    scheduler.close();
  });
  EXPECT_EQ(scheduler.run().delivered, 2U);
}

TEST(LaneScheduler, EndsWhenAbortedThoughNobodyClosedIt) {
  const FakeSimulator simulator;
  LaneScheduler* itself = nullptr;
  LaneScheduler scheduler(simulator, growing([&](std::uint64_t id, const ScenarioResult&) {
                            if (id == 6) itself->abort();
                          }),
                          1);
  itself = &scheduler;
  std::vector<std::uint64_t> ids;
  for (std::uint64_t id = 0; id < 300; ++id) ids.push_back(id);
  scheduler.add(ids);
  EXPECT_LT(scheduler.run().delivered, 300U);
}

TEST(LaneScheduler, ThrowsWhatTheSinkThrew) {
  const FakeSimulator simulator;
  LaneScheduler scheduler(
      simulator, growing([](std::uint64_t, const ScenarioResult&) { throw std::runtime_error("disk full"); }), 2);
  scheduler.add(std::vector<std::uint64_t>{0, 1, 2});
  EXPECT_THROW(scheduler.run(), std::runtime_error);
}

}  // namespace
}  // namespace unbruised::studies

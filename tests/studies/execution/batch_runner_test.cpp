#include "studies/execution/batch_runner.hpp"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <map>
#include <mutex>
#include <stdexcept>
#include <thread>

#include <gtest/gtest.h>

#include "studies/execution/lane_executor.hpp"
#include "studies/results/digest.hpp"
#include "tests/studies/execution/fake_simulator.hpp"

namespace unbruised::studies {
namespace {

using testing::batch_of;
using testing::fake_result;
using testing::FakeSimulator;
using testing::kFakeLanes;
using testing::scenario_of;

struct BatchRun {
  std::map<std::uint64_t, ScenarioResult> results;
  BatchReport report;
};

BatchRun run(const FakeSimulator& simulator, const Batch& batch, int threads) {
  BatchRun outcome;
  outcome.report =
      run_batch(LaneExecutor(simulator, threads), batch, [&](std::uint64_t id, const ScenarioResult& r) {
        EXPECT_TRUE(outcome.results.emplace(id, r).second) << "scenario " << id << " was delivered twice";
      });
  return outcome;
}

TEST(BatchRunner, GivesEachIdItsOwnResultWhateverTheThreadsAndGroups) {
  for (const std::uint64_t groups : {1U, 3U, 40U}) {
    for (const int threads : {1, 2, 4}) {
      const FakeSimulator simulator;
      const BatchRun done = run(simulator, batch_of(200, groups), threads);
      ASSERT_EQ(done.results.size(), 200U) << groups << " groups, " << threads << " threads";
      for (const auto& [id, result] : done.results) {
        ASSERT_EQ(result_digest(result), result_digest(fake_result(scenario_of(id, groups))))
            << "scenario " << id << ", " << groups << " groups, " << threads << " threads";
      }
      EXPECT_FALSE(done.report.stopped);
      EXPECT_EQ(done.report.group_count, groups);
    }
  }
}

TEST(BatchRunner, BuildsEachModelOnceAndKeepsFewAlive) {
  for (const int threads : {1, 2, 4}) {
    const FakeSimulator simulator;
    run(simulator, batch_of(300, 50), threads);
    EXPECT_EQ(simulator.record.models_built, 50);
    EXPECT_LE(simulator.record.most_models_alive, threads + 1);
    EXPECT_EQ(simulator.record.models_alive, 0);
  }
}

TEST(BatchRunner, KeepsLanesFullWhileThereAreScenarios) {
  const FakeSimulator simulator;
  const Batch batch = batch_of(400, 1);
  run(simulator, batch, 1);
  double lane_steps = 0.0;
  for (const std::uint64_t id : batch.ids) lane_steps += scenario_of(id, 1).simulation.duration_s.value();
  // Lanes are empty only at the end, for at most the longest run.
  EXPECT_LE(static_cast<double>(simulator.record.steps), lane_steps / kFakeLanes + 7.0);
  EXPECT_EQ(simulator.record.lane_simulations, 1);
}

TEST(BatchRunner, SharesAFewScenariosFairlyAtTheStart) {
  const FakeSimulator simulator;
  run(simulator, batch_of(4, 1), 4);
  // Four scenarios on four threads: nobody may take more than its share before the others have had theirs.
  EXPECT_LT(simulator.record.most_lanes_busy, 4);
}

TEST(BatchRunner, TurnsAModelThatCannotBeBuiltIntoRows) {
  FakeSimulator simulator;
  simulator.faults.no_model_of_modulus_Pa = 1e6 + 1.0;
  const BatchRun done = run(simulator, batch_of(30, 3), 2);
  ASSERT_EQ(done.results.size(), 30U);
  for (const auto& [id, result] : done.results) {
    EXPECT_EQ(result.outcome, id % 3 == 1 ? Outcome::diverged : Outcome::held) << id;
    EXPECT_EQ(result.cause, id % 3 == 1 ? "the matrix cannot be factored" : "") << id;
  }
}

TEST(BatchRunner, GivesOnlyTheScenarioThatThrowsARowWithTheCause) {
  for (const int threads : {1, 3}) {
    FakeSimulator simulator;
    simulator.faults.throws_in_step_at_N = 1.0 + 17.0;
    simulator.faults.throws_in_load_at_N = 1.0 + 23.0;
    const BatchRun done = run(simulator, batch_of(60, 1), threads);
    ASSERT_EQ(done.results.size(), 60U);
    for (const auto& [id, result] : done.results) {
      if (id == 17 || id == 23) {
        EXPECT_EQ(result.outcome, Outcome::diverged);
        EXPECT_EQ(result.cause, id == 17 ? "out of memory" : "internal error: cannot load this");
      } else {
        EXPECT_EQ(result_digest(result), result_digest(fake_result(scenario_of(id, 1)))) << id;
      }
    }
  }
}

TEST(BatchRunner, TurnsLackOfMemoryForLanesIntoRows) {
  FakeSimulator simulator;
  simulator.faults.no_lanes = true;
  const BatchRun done = run(simulator, batch_of(30, 2), 3);
  ASSERT_EQ(done.results.size(), 30U);
  for (const auto& [id, result] : done.results) EXPECT_EQ(result.cause, "out of memory") << id;
}

TEST(BatchRunner, StopsHandingOutScenarios) {
  const FakeSimulator simulator;
  std::atomic<bool> stop = false;
  std::size_t delivered = 0;
  Batch batch = batch_of(5000, 5);
  batch.stop = &stop;
  const BatchReport report = run_batch(LaneExecutor(simulator, 2), batch,
                                       [&](std::uint64_t, const ScenarioResult&) { stop = ++delivered >= 10; });
  EXPECT_TRUE(report.stopped);
  EXPECT_EQ(report.delivered, delivered);
  EXPECT_GE(delivered, 10U);
  // What had arrived when the flag was set, and what ends in the step that the two threads are in.
  EXPECT_LE(delivered, 10U + kResultsWaitingMost + 2U * kFakeLanes);
}

TEST(BatchRunner, GoesOnWithTheOtherScenariosWhileAResultIsWritten) {
  constexpr std::uint64_t kCount = 200;
  for (const int threads : {1, 2}) {
    const FakeSimulator simulator;
    Batch batch = batch_of(kCount, 3);
    // Each scenario is asked for once to find its group and once to be run.
    std::mutex mutex;
    std::condition_variable asked_for;
    std::uint64_t asked = 0;
    batch.scenario = [&](std::uint64_t id) {
      {
        const std::lock_guard lock(mutex);
        ++asked;
      }
      asked_for.notify_all();
      return scenario_of(id, 3);
    };
    bool all_begun = false;
    std::size_t delivered = 0;
    run_batch(LaneExecutor(simulator, threads), batch, [&](std::uint64_t, const ScenarioResult&) {
      if (delivered++ > 0) return;
      // A disk that hangs until all others have begun; the deadline only ends a test that has failed.
      std::unique_lock lock(mutex);
      all_begun = asked_for.wait_for(lock, std::chrono::seconds(20), [&] { return asked >= 2 * kCount; });
    });
    EXPECT_TRUE(all_begun) << threads << " threads waited for the sink";
    EXPECT_EQ(delivered, kCount);
  }
}

TEST(BatchRunner, LetsOnlySoManyResultsWaitForASlowSink) {
  const FakeSimulator simulator;
  constexpr std::uint64_t kCount = 3 * kResultsWaitingMost;
  std::atomic<std::size_t> arrived = 0;
  std::size_t written = 0;
  std::size_t most_waiting = 0;
  Batch batch = batch_of(kCount, 1);
  batch.scenario = [&](std::uint64_t id) {
    ++arrived;  // a bound from above: asked for twice each, the first time all at once
    return scenario_of(id, 1);
  };
  const BatchReport report =
      run_batch(LaneExecutor(simulator, 2), batch, [&](std::uint64_t, const ScenarioResult&) {
        while (written == 0 && arrived < kCount + kResultsWaitingMost) std::this_thread::yield();
        for (int i = 0; written == 0 && i < 1000; ++i) std::this_thread::yield();  // room for one too many to come
        most_waiting = std::max<std::size_t>(most_waiting, arrived - kCount - written);
        ++written;
      });
  EXPECT_EQ(report.delivered, kCount);
  EXPECT_EQ(written, kCount);
  EXPECT_LE(most_waiting, kResultsWaitingMost + 4U * kFakeLanes);
}

TEST(BatchRunner, EndsAlsoWhereTheSinkFailsWhileManyResultsWait) {
  const FakeSimulator simulator;
  std::atomic<bool> is_full = false;
  Batch batch = batch_of(3 * kResultsWaitingMost, 1);
  std::atomic<std::uint64_t> asked = 0;
  batch.scenario = [&](std::uint64_t id) {
    // All ids once to find their groups, then as many as may wait.
    if (++asked > 4 * kResultsWaitingMost) is_full = true;
    return scenario_of(id, 1);
  };
  EXPECT_THROW(run_batch(LaneExecutor(simulator, 2), batch,
                         [&](std::uint64_t, const ScenarioResult&) {
                           while (!is_full) std::this_thread::yield();
                           throw std::runtime_error("disk full");
                         }),
               std::runtime_error);
}

TEST(BatchRunner, PassesAnExceptionOfTheSinkOn) {
  const FakeSimulator simulator;
  const ResultSink full_disk = [](std::uint64_t id, const ScenarioResult&) {
    if (id == 40) throw std::runtime_error("disk full");
  };
  EXPECT_THROW(run_batch(LaneExecutor(simulator, 2), batch_of(500, 3), full_disk), std::runtime_error);
}

TEST(BatchRunner, RunsNothingOfAnEmptyBatch) {
  const FakeSimulator simulator;
  const BatchRun done = run(simulator, batch_of(0, 1), 2);
  EXPECT_EQ(done.report.delivered, 0U);
  EXPECT_FALSE(done.report.stopped);
}

}  // namespace
}  // namespace unbruised::studies

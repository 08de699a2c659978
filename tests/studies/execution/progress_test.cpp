#include "studies/execution/progress.hpp"

#include <map>

#include <gtest/gtest.h>

#include "studies/execution/batch_runner.hpp"
#include "studies/execution/counted_simulator.hpp"
#include "studies/execution/lane_executor.hpp"
#include "studies/results/digest.hpp"
#include "tests/studies/execution/fake_simulator.hpp"

namespace unbruised::studies {
namespace {

TEST(Progress, SaysRateTimeLeftAndOutcomes) {
  ProgressState state{.done = 60, .total = 1100, .done_at_start = 20, .seconds = 10.0};
  state.outcomes.of[0] = 30;
  state.outcomes.of[3] = 10;
  EXPECT_EQ(
      progress_text(state),
      "60 of 1,100 scenarios (20 of an earlier run), 4 per second, about 4 min 20 s left; held 30, damaged 10");
  EXPECT_TRUE(progress_bar(state).starts_with("[#-------------------] 60 of")) << progress_bar(state);
  EXPECT_EQ(progress_text({}), "0 of 0 scenarios");
}

TEST(Progress, KnowsTheTimeLeftBeforeAnyScenarioHasEnded) {
  ProgressState state{.total = 32};
  EXPECT_EQ(seconds_left(state), std::nullopt);
  state.plan = {.scenarios = 32.0, .steps_each = 1000.0, .seconds_per_step = 1e-3};
  EXPECT_DOUBLE_EQ(seconds_left(state).value(), 32.0);  // the plan's guess: 32 x 1000 x 1e-3 s
  state.steps = 4000.0;
  state.seconds = 8.0;  // twice as slow as guessed: 28000 steps are left at 500 per second
  EXPECT_DOUBLE_EQ(seconds_left(state).value(), 56.0);
  EXPECT_EQ(progress_text(state), "0 of 32 scenarios, about 56 s left");
}

TEST(Progress, WeighsWhatEndedScenariosTookAgainstWhatWasExpected) {
  ProgressState state{.done = 32, .total = 64, .seconds = 10.0, .steps = 16000.0, .steps_of_done = 16000.0};
  state.plan = {.scenarios = 64.0, .steps_each = 1000.0};
  // (32 x 1000 + 16000) / 64 = 750 steps for each of the 32 left, at 1600 steps per second.
  EXPECT_DOUBLE_EQ(seconds_left(state).value(), 15.0);
  state.done = state.total;
  EXPECT_DOUBLE_EQ(seconds_left(state).value(), 0.0);
}

TEST(Progress, SaysOfASearchWhatItTakesAtMost) {
  ProgressState state{.done = 10, .total = 16, .total_is_final = false, .seconds = 10.0};
  EXPECT_EQ(progress_text(state), "10 scenarios, 1 per second");
  state.plan = {.scenarios = 640.0, .steps_each = 100.0, .may_end_sooner = true};
  state.steps = state.steps_of_done = 1000.0;
  EXPECT_EQ(progress_text(state), "10 of at most 640 scenarios, 1 per second, at most 10 min 30 s left");
  state.plan.may_end_sooner = false;
  EXPECT_TRUE(progress_text(state).starts_with("10 of about 640")) << progress_text(state);
}

TEST(Progress, PrintsPlainLinesOffATerminalAndNothingWhenQuiet) {
  EXPECT_EQ(progress_style(-1, Verbosity::usual), ProgressStyle::lines);
  EXPECT_EQ(progress_style(-1, Verbosity::quiet), ProgressStyle::none);
  std::string printed;
  {
    Progress progress(
        ProgressStyle::lines, [&](std::string_view text) { printed += text; }, std::chrono::milliseconds(5));
    progress.expect(10, 4);
    progress.count(Outcome::held, 7.0);
    std::this_thread::sleep_for(std::chrono::milliseconds(60));
  }
  EXPECT_NE(printed.find("5 of 10"), std::string::npos) << printed;
  EXPECT_EQ(printed.find('\r'), std::string::npos);
}

/// Eight scenarios of one factor key with 1 to 7 steps.
Batch batch() {
  Batch batch{.ids = {0, 1, 2, 3, 4, 5, 6, 7}, .scenario = [](std::uint64_t id) {
                Scenario scenario;
                scenario.strategy.grip_force_N = 1.0 + static_cast<double>(id);
                scenario.simulation.duration_s = static_cast<double>(1 + (id * 5) % 7);
                return scenario;
              }};
  return batch;
}

// A default in between would take from every study what the simulator asks for.
TEST(CountedSimulator, IsTheSimulatorInAllElse) {
  const Simulator& core = core_simulator();
  Progress progress(ProgressStyle::none, [](std::string_view) {});
  const CountedSimulator counting(core, progress);
  EXPECT_EQ(counting.lane_count(), core.lane_count());
  EXPECT_EQ(counting.place_count(), core.place_count());
  EXPECT_GT(core.place_count(), core.lane_count());
  Scenario scenario;
  scenario.simulation.duration_s = 2.5;
  EXPECT_EQ(counting.duration_s(scenario), 2.5);
  EXPECT_EQ(counting.factor_key(scenario), core.factor_key(scenario));
}

TEST(CountedSimulator, CountsEveryStepOfEveryScenarioAndChangesNoResult) {
  const testing::FakeSimulator fake;
  std::map<std::uint64_t, std::uint64_t> plain;
  std::map<std::uint64_t, std::uint64_t> counted;
  run_batch(LaneExecutor(fake, 2), batch(),
            [&](std::uint64_t id, const ScenarioResult& result) { plain[id] = result_digest(result); });
  Progress progress(ProgressStyle::none, [](std::string_view) {});
  const CountedSimulator counting(fake, progress);
  const BatchReport report =
      run_batch(LaneExecutor(counting, 2), batch(),
                [&](std::uint64_t id, const ScenarioResult& result) { counted[id] = result_digest(result); });
  EXPECT_EQ(plain, counted);
  EXPECT_EQ(progress.steps(), report.lane_use.busy_lane_steps);
  EXPECT_EQ(progress.steps(), 29U);  // 1 + 6 + 4 + 2 + 7 + 5 + 3 + 1
}

}  // namespace
}  // namespace unbruised::studies

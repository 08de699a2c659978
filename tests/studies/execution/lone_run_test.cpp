#include "studies/execution/lone_run.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "studies/execution/lane_executor.hpp"
#include "studies/results/digest.hpp"
#include "tests/studies/execution/fake_simulator.hpp"

namespace unbruised::studies {
namespace {

using testing::fake_result;
using testing::FakeSimulator;

Scenario scenario() {
  Scenario one;
  one.strategy.grip_force_N = 6.0;
  one.simulation.duration_s = 5.0;
  return one;
}

TEST(LoneRun, GivesTheResultAndTheTrace) {
  const FakeSimulator simulator;
  Trace trace;
  const auto result = run_alone(simulator, scenario(), &trace, nullptr);
  ASSERT_TRUE(result.has_value());
  EXPECT_EQ(result_digest(*result), result_digest(fake_result(scenario())));
  EXPECT_EQ(trace.time_s.size(), 1U);
  Trace of_executor;
  const auto same = LaneExecutor(simulator, 1).run_traced(scenario(), of_executor, nullptr);
  EXPECT_EQ(result_digest(same.value()), result_digest(*result));
  EXPECT_EQ(of_executor.time_s, trace.time_s);
}

TEST(LoneRun, GivesNothingWhenStopped) {
  const FakeSimulator simulator;
  const std::atomic<bool> stop = true;
  EXPECT_FALSE(run_alone(simulator, scenario(), nullptr, &stop).has_value());
}

TEST(LoneRun, TurnsWhatCannotBeRunIntoARowWithTheCause) {
  FakeSimulator simulator;
  simulator.faults.no_model_of_modulus_Pa = std::get<LatticeParameters>(scenario().product).youngs_modulus_Pa;
  const auto without_model = run_alone(simulator, scenario(), nullptr, nullptr);
  EXPECT_EQ(without_model.value().outcome, Outcome::diverged);
  EXPECT_EQ(without_model->cause, "the matrix cannot be factored");
  FakeSimulator thrower;
  thrower.faults.throws_in_load_at_N = scenario().strategy.grip_force_N;
  EXPECT_EQ(run_alone(thrower, scenario(), nullptr, nullptr).value().cause, "internal error: cannot load this");
}

TEST(LoneRun, TellsExceptionsInWords) {
  const auto words_of = [](const auto& thrown) {
    try {
      throw thrown;
    } catch (...) {
      return current_exception_text();
    }
  };
  EXPECT_EQ(words_of(std::bad_alloc()), "out of memory");
  EXPECT_EQ(words_of(std::runtime_error("why")), "internal error: why");
  EXPECT_EQ(words_of(7), "internal error of unknown kind");
}

}  // namespace
}  // namespace unbruised::studies

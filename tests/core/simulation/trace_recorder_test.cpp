#include "core/simulation/trace_recorder.hpp"

#include <cmath>
#include <string>

#include "tests/core/simulation/scenes.hpp"

namespace unbruised {
namespace {

using testing::column;
using testing::largest;

/// Gripped beyond first yield, softly enough to be carried to the end.
Scenario squeezed_box() {
  Scenario scenario = testing::small_box();
  LatticeParameters& product = testing::lattice_of(scenario);
  product.yield_stress_Pa = 800.0;
  product.tangent_modulus_Pa = 5e4;
  scenario.limits.contact_yield_ratio = 0.5;
  scenario.strategy.hold_s = 0.05;
  return scenario;
}

TEST(TraceRecorder, ShowsEveryQuantityThatDecidesUpToItsMetric) {
  Trace trace;
  const ScenarioResult result = testing::run(squeezed_box(), &trace);
  ASSERT_EQ(result.outcome, Outcome::damaged) << result.cause;
  // Every step is kept, so the peaks are the same numbers.
  const auto largest_of_fingers = [&](const char* name) {
    return std::max(largest(column(trace, name, 0)), largest(column(trace, name, 1)));
  };
  EXPECT_EQ(largest_of_fingers("contact_yield_ratio"), result.metrics[Metric::contact_yield_ratio_max]);
  EXPECT_GT(largest_of_fingers("contact_yield_ratio"), 0.5);
  EXPECT_EQ(largest(column(trace, "patch_pressure_Pa")), result.metrics[Metric::peak_pressure_Pa]);
  EXPECT_EQ(largest(column(trace, "plastic_strain_max")), result.metrics[Metric::plastic_strain_max]);
  EXPECT_EQ(largest(column(trace, "absorbed_energy_J")), result.metrics[Metric::absorbed_energy_J]);
  EXPECT_GE(largest_of_fingers("slip_m"), result.metrics[Metric::slip_max_m]);  // the trace also sees the release
}

TEST(TraceRecorder, BeginsWithTheForcesOfTheProductAtRest) {
  Scenario scenario = testing::small_box();
  scenario.gripper = NoGripper{};
  scenario.simulation.duration_s = 0.02;
  Trace trace;
  testing::run(scenario, &trace);
  const double weight_N = -1000.0 * 0.02 * 0.02 * 0.02 * scenario.cell.gravity_m_s2[2];
  // Statics are solved to 1e-10 of the weight; the first step finds the same state again.
  EXPECT_NEAR(column(trace, "support_force_N", 2).front(), weight_N, 1e-9 * weight_N);
  EXPECT_NEAR(column(trace, "support_force_N", 2)[1], weight_N, 1e-6 * weight_N);
  EXPECT_GT(column(trace, "contact_count", 2).front(), 0.0);
}

TEST(TraceRecorder, HasNoYieldRatioWhereNothingYields) {
  Trace trace;
  testing::run(testing::small_box(), &trace);
  for (const TraceSignal& signal : trace.signals) EXPECT_NE(signal.name, "contact_yield_ratio");
}

TEST(TraceRecorder, NamesThePhaseOfEveryRow) {
  Trace trace;
  const ScenarioResult result = testing::run(squeezed_box(), &trace);
  const std::vector<double> phase = column(trace, "phase");
  ASSERT_EQ(phase.size(), trace.time_s.size());
  EXPECT_EQ(phase.front(), static_cast<double>(CyclePhase::approach));
  EXPECT_EQ(phase.back(), static_cast<double>(CyclePhase::recover));
  for (std::size_t i = 1; i < phase.size(); ++i) {
    EXPECT_TRUE(phase[i] == phase[i - 1] || phase[i] == phase[i - 1] + 1.0) << trace.time_s[i];
  }
  const auto start_of = [&](CyclePhase wanted) {
    const auto at = std::find(phase.begin(), phase.end(), static_cast<double>(wanted));
    return trace.time_s[static_cast<std::size_t>(at - phase.begin())];
  };
  const double step_s = trace.time_s[1] - trace.time_s[0];  // rows stand one step apart
  EXPECT_NEAR(start_of(CyclePhase::grip), result.metrics[Metric::first_contact_time_s], step_s);
  EXPECT_NEAR(start_of(CyclePhase::lift), result.metrics[Metric::lift_time_s], step_s);
  EXPECT_NEAR(start_of(CyclePhase::recover), result.metrics[Metric::cycle_time_s], step_s);
  EXPECT_EQ(
      testing::signal(trace, "phase").long_name,
      "phase of the cycle: 0 approach, 1 grip, 2 lift, 3 hold, 4 transfer, 5 lower, 6 release, 7 recover, 8 stop, "
      "9 turn");
}

}  // namespace
}  // namespace unbruised

#include "studies/findings/balances.hpp"

#include <gtest/gtest.h>

namespace unbruised::studies {
namespace {

ScenarioRow row_of(std::uint64_t id, Outcome outcome, double energy_error, double impulse_error) {
  ScenarioRow row{.id = id, .result = {}, .inputs = {}};
  row.result.outcome = outcome;
  row.result.metrics[Metric::energy_balance_error] = energy_error;
  row.result.metrics[Metric::impulse_balance_error] = impulse_error;
  return row;
}

TEST(Balances, TheWorstIsTheLargestBySizeWithSignScenarioAndOutcome) {
  // A signed maximum would print the mildest: -0.0005.
  const std::vector<ScenarioRow> rows = {row_of(0, Outcome::held, -0.0005, -3e-9),
                                         row_of(1, Outcome::dropped, -0.152, 1e-9),
                                         row_of(2, Outcome::held, -0.011, 2e-9)};
  EXPECT_EQ(balance_line(rows),
            "worst balances: impulse_balance_error -3e-09 (scenario 0, held); energy_balance_error -0.152 "
            "(scenario 1, dropped), of those held -0.011 (scenario 2, held)");
  EXPECT_EQ(balance_doubt(rows), "") << "no row is out of range";
  EXPECT_EQ(balance_line({}), "");
}

TEST(Balances, ARowWithEnergyFromNowhereIsAWarning) {
  const std::vector<ScenarioRow> rows = {row_of(0, Outcome::out_of_range, -0.06, 0.0),
                                         row_of(1, Outcome::out_of_range, 0.07, 0.0),
                                         row_of(2, Outcome::held, kEnergyErrorMost, 0.0)};
  EXPECT_EQ(
      balance_doubt(rows),
      "in 2 scenarios more than 5 % of the energy put in is unaccounted for (worst: "
      "energy_balance_error +0.07 (scenario 1, out_of_range)), so forces and damage there are not to be trusted "
      "and the outcome is out_of_range; try a smaller simulation.time_step_s");
}

TEST(Balances, AnImpactThatTheStepDoesNotResolveIsAWarning) {
  std::vector<ScenarioRow> rows = {row_of(0, Outcome::held, 0.0, 0.0), row_of(1, Outcome::held, 0.0, 0.0),
                                   row_of(2, Outcome::damaged, 0.0, 0.0), row_of(3, Outcome::diverged, 0.0, 0.0)};
  for (ScenarioRow& row : rows) row.result.metrics[Metric::peak_rise_steps] = 3.0;
  EXPECT_EQ(impact_doubt(rows), "");
  rows[1].result.metrics[Metric::peak_rise_steps] = 2.0;
  rows[2].result.metrics[Metric::peak_rise_steps] = 1.0;
  rows[3].result.metrics[Metric::peak_rise_steps] = 1.0;  // says nothing
  EXPECT_EQ(impact_doubt(rows),
            "in 2 scenarios the force rose by half of its peak within fewer than 3 time steps (fewest: 1, "
            "scenario 2): an "
            "impact that the step does not resolve, so the true peak, and the damage, are higher; use a smaller "
            "simulation.time_step_s");
}

}  // namespace
}  // namespace unbruised::studies

/// @file
/// Searches through the whole stack against closed forms of physics.md section 7: the shipped configs find them.

#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "tests/places.hpp"
#include "tests/studies/kinds/search_testing.hpp"

namespace unbruised::studies::testing {
namespace {

constexpr double kGravity = 9.80665;

Study shipped(const std::string& name, const std::vector<std::string>& sets = {}) {
  const std::string root = std::string(UNBRUISED_SOURCE_DIR) + "/configs";
  return read_study(root + "/" + name, sets, root).value();
}

std::string active_constraints(const StudyReport& report) {
  const ResultTable& constraints = table_of(report, "constraints");
  std::string all;
  for (std::size_t i = 0; i < row_count(constraints); ++i) {
    if (number_in(constraints, "active", i) == 1.0) all += text_in(constraints, "text", i) + ";";
  }
  return all;
}

TEST(HeavySearchPhysics, LeastCreepSetOfALiftIsAtAnAccelerationOfG) {
  const StudyReport report = run_fresh(shipped("creep_optimum.toml"), core_simulator());
  const ResultTable& best = table_of(report, "best");
  ASSERT_EQ(number_in(best, "feasible", 0), 1.0);
  const double a = number_in(best, "strategy.lift_acceleration_m_s2", 0);
  std::printf("acceleration of the least creep set: %.4f m/s2, %.2f %% from g\n", a, 100.0 * (a / kGravity - 1.0));
  EXPECT_NEAR(a, kGravity, 0.01 * kGravity);
  EXPECT_EQ(active_constraints(report), "friction_margin_min >= 0.2;");
}

TEST(HeavySearchPhysics, FastestLiftAtAForceLimitIsTheClosedForm) {
  const StudyReport report = run_fresh(shipped("lift_limit.toml"), core_simulator());
  const ResultTable& best = table_of(report, "best");
  ASSERT_EQ(number_in(best, "feasible", 0), 1.0);
  EXPECT_NEAR(number_in(best, "strategy.grip_force_N", 0), 3.0, 0.01);
  const double exact = 2.0 * 0.6 * 3.0 / 0.1 - kGravity;
  const double a = number_in(best, "strategy.lift_acceleration_m_s2", 0);
  std::printf("fastest lift: %.3f m/s2, closed form %.3f\n", a, exact);
  EXPECT_NEAR(a, exact, 0.02 * exact);
  EXPECT_EQ(active_constraints(report), "friction_margin_min >= 0;");
}

TEST(HeavySearchPhysics, NothingIsFeasibleForTofuAndTheForceLimitOrTheHoldBinds) {
  const StudyReport report = run_fresh(shipped("tofu_optimize.toml"), core_simulator());
  const ResultTable& best = table_of(report, "best");
  EXPECT_EQ(number_in(best, "feasible", 0), 0.0);
  EXPECT_FALSE(text_in(best, "binding", 0).empty());
  for (const ScenarioRow& row : report.tables.rows) EXPECT_NE(row.result.outcome, Outcome::held) << row.id;
}

TEST(SearchPhysics, CoarseTofuIsNotFeasibleEither) {
  const Study study =
      shipped("tofu_optimize.toml", {"product.cell_size_m=0.025", "search.starts=2", "search.budget=32",
                                     "cell.transfer_m=[0.0,0.0]", "simulation.time_step_s=2e-3"});
  const StudyReport report = run_fresh(study, core_simulator());
  EXPECT_EQ(number_in(table_of(report, "best"), "feasible", 0), 0.0);
}

TEST(GripImpulse, IsForceTimesTimeOfAQuietHold) {
  // 20 s of hold at 2 N: the impulse of gripping and carrying is known to the ramp's 0.1 s x 0.3 .. 2 N.
  const std::string text = R"([study]
name = "impulse"
kind = "simulate"
[strategy]
grip_force_N = 2.0
hold_s = 20.0
)" + kFormulaCell;
  const StudyReport report = run_fresh(study_of(text, {"simulation.time_step_s=2e-3"}), core_simulator());
  const Metrics& metrics = report.tables.rows.at(0).result.metrics;
  const double release_s = metrics[Metric::cycle_time_s] - 0.005 / 0.1;
  const double held_s = release_s - metrics[Metric::first_contact_time_s];
  // Within the ramp the force is at most 1.7 N below, and the drive's viscous guide and the pads take a little.
  EXPECT_NEAR(metrics[Metric::grip_impulse_N_s], 2.0 * held_s, 1.7 * 0.1 + 1e-3 * 2.0 * held_s);
}

}  // namespace
}  // namespace unbruised::studies::testing

/// @file
/// What the kinds that search may call best: never a strategy that does not keep the product, never on fewer
/// products than are told.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/studies/execution/formula_simulator.hpp"
#include "tests/studies/kinds/search_testing.hpp"

namespace unbruised::studies::testing {
namespace {

std::string study_text(const std::string& kind, const std::string& search) {
  const std::string products =
      kind == "robust" ? "[[random]]\nkey = \"product.friction\"\ndistribution = \"uniform\"\nfrom = 0.4\nto = "
                         "0.6\n[sampling]\ncount = 64\n"
                       : "";
  return "[study]\nname = \"test\"\nkind = \"" + kind + "\"\n[search]\nstarts = 2\nbudget = 16\n" + search +
         "[[variable]]\nkey = \"strategy.grip_force_N\"\nfrom = 1.0\nto = 3.0\n" + products + kFormulaCell;
}

StudyReport run_text(const std::string& kind, const std::string& search, const Formula& formula) {
  return run_fresh(study_of(study_text(kind, search)), FormulaSimulator(formula));
}

/// Every line of the summary, one after the other.
std::string summary_of(const StudyReport& report, const std::string& kind) {
  std::string text;
  for (const std::string& line : summary_lines(report.tables, kind)) text += line + "\n";
  return text;
}

bool says(const StudyReport& report, const std::string& kind, const std::string& words) {
  return summary_of(report, kind).find(words) != std::string::npos;
}

double friction_of(const Scenario& s) { return std::get<LatticeParameters>(s.product).friction; }

/// A cycle whose product lies on the floor takes its time all the same.
ScenarioResult always_dropped(const Scenario& s) {
  ScenarioResult result = held_with({{Metric::cycle_time_s, 1.0 / s.strategy.grip_force_N},
                                     {Metric::peak_finger_force_N, s.strategy.grip_force_N},
                                     {Metric::slip_max_m, 0.0}});
  result.outcome = Outcome::dropped;
  return result;
}

TEST(SearchClaims, DroppingEveryProductIsNotUndamaged) {
  const StudyReport report = run_text("robust", "constraints = [\"P(not damaged) >= 0.95\"]\n", always_dropped);
  EXPECT_EQ(number_in(table_of(report, "best"), "feasible", 0), 0.0);
  EXPECT_EQ(number_in(table_of(report, "best"), "probability", 0), 0.0);
  EXPECT_TRUE(says(report, "robust", "none feasible")) << summary_of(report, "robust");
  EXPECT_TRUE(says(report, "robust", "binding: P(not damaged) >= 0.95")) << summary_of(report, "robust");
  EXPECT_TRUE(says(report, "robust", "dropped 64")) << summary_of(report, "robust");
}

TEST(SearchClaims, AStrategyThatDropsIsNotBestEvenWithoutConstraints) {
  for (const char* objective : {"cycle_time_s", "peak_finger_force_N"}) {
    const StudyReport report =
        run_text("optimize", std::string("constraints = []\nobjective = \"") + objective + "\"\n", always_dropped);
    EXPECT_EQ(number_in(table_of(report, "best"), "feasible", 0), 0.0) << objective;
    EXPECT_TRUE(says(report, "optimize", std::string("none feasible: ") + objective + " exists for none of the "))
        << summary_of(report, "optimize");
    EXPECT_TRUE(says(report, "optimize", "(dropped)")) << summary_of(report, "optimize");
  }
}

TEST(SearchClaims, WhoNamesDropsGetsThem) {
  const StudyReport report = run_text(
      "optimize", "constraints = [\"held or dropped\"]\nobjective = \"peak_finger_force_N\"\n", always_dropped);
  EXPECT_EQ(number_in(table_of(report, "best"), "feasible", 0), 1.0);
  EXPECT_EQ(text_in(table_of(report, "best"), "outcomes", 0), "dropped");
  EXPECT_TRUE(says(report, "optimize", ", dropped\n")) << summary_of(report, "optimize");
}

TEST(SearchClaims, AnObjectiveThatNeverExistsIsNamed) {
  const auto formula = [](const Scenario&) { return held_with({{Metric::slip_max_m, 0.0}}); };
  const StudyReport report = run_text("optimize", "objective = \"hold_drift_m_s\"\n", formula);
  EXPECT_TRUE(says(report, "optimize", "none feasible: hold_drift_m_s exists for none of the "))
      << summary_of(report, "optimize");
  EXPECT_FALSE(says(report, "optimize", "-100 %"));
}

TEST(SearchClaims, AChangeOfAZeroObjectiveIsNoPercentage) {
  const auto formula = [](const Scenario&) { return held_with({{Metric::slip_max_m, 0.0}}); };
  const StudyReport report = run_text("optimize", "objective = \"slip_max_m\"\n", formula);
  EXPECT_TRUE(
      says(report, "optimize", "checked, half the time step: objective 0 as before, every constraint kept"))
      << summary_of(report, "optimize");
  const auto finer_is_worse = [](const Scenario& s) {
    return held_with({{Metric::slip_max_m, s.simulation.time_step_s < 1e-3 ? 1e-4 : 0.0}});
  };
  const StudyReport worse = run_text("optimize", "objective = \"slip_max_m\"\n", finer_is_worse);
  EXPECT_TRUE(says(worse, "optimize", "half the time step: objective 0.0001 (0 as found)"))
      << summary_of(worse, "optimize");
}

TEST(SearchClaims, AProbabilityMetByTheEstimateIsNotCalledShown) {
  const auto formula = [](const Scenario& s) {
    return held_with({{Metric::cycle_time_s, s.strategy.grip_force_N}, {Metric::slip_max_m, 0.0}});
  };
  const StudyReport report = run_text("robust", "constraints = [\"P(held) >= 0.99\"]\n", formula);
  const ResultTable& constraints = table_of(report, "constraints");
  EXPECT_EQ(number_in(constraints, "estimate", 0), 1.0);
  EXPECT_EQ(number_in(constraints, "wanted", 0), 0.99);
  EXPECT_EQ(number_in(constraints, "shown", 0), 0.0);
  EXPECT_TRUE(says(report, "robust",
                   "P(held) >= 0.99: met by the estimate only, not shown: the interval begins at 94.3 %; "
                   "sampling.count = 381 would show it"))
      << summary_of(report, "robust");
  const StudyReport shown = run_text("robust", "constraints = [\"P(held) >= 0.9\"]\n", formula);
  EXPECT_EQ(number_in(table_of(shown, "constraints"), "shown", 0), 1.0);
  EXPECT_TRUE(says(shown, "robust", "P(held) >= 0.9: shown by the interval")) << summary_of(shown, "robust");
}

TEST(SearchClaims, AMeanSaysHowManyProductsItIsNotOf) {
  // One product in four is dropped: the rest may be asked for, but the mean is of the rest only.
  const auto formula = [](const Scenario& s) {
    ScenarioResult result =
        held_with({{Metric::cycle_time_s, s.strategy.grip_force_N}, {Metric::slip_max_m, 0.0}});
    if (friction_of(s) < 0.45) result.outcome = Outcome::dropped;
    return result;
  };
  const StudyReport report = run_text("robust", "constraints = [\"P(not damaged) >= 0.5\"]\n", formula);
  EXPECT_EQ(number_in(table_of(report, "best"), "without_objective", 0), 16.0);
  EXPECT_EQ(number_in(table_of(report, "best"), "probability_held", 0), 0.75);
  EXPECT_TRUE(says(report, "robust", "it does not exist for 16 of 64 (held 48, dropped 16)"))
      << summary_of(report, "robust");
}

TEST(SearchClaims, AnAnswerThatHoldsFewProductsSaysSo) {
  const auto formula = [](const Scenario& s) {
    ScenarioResult result =
        held_with({{Metric::cycle_time_s, s.strategy.grip_force_N}, {Metric::slip_max_m, 0.1}});
    result.outcome = Outcome::slipped;
    return result;
  };
  const StudyReport report = run_text("robust", "constraints = [\"P(not dropped) >= 0.5\"]\n", formula);
  EXPECT_EQ(number_in(table_of(report, "best"), "feasible", 0), 1.0);
  EXPECT_TRUE(says(report, "robust", "careful: with this strategy most products are not held (slipped 64)"))
      << summary_of(report, "robust");
}

}  // namespace
}  // namespace unbruised::studies::testing

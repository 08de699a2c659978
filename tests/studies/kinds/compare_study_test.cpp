/// @file
/// compare, sensitivity and sample over formulas: no difference where there is none, a planted one found, known
/// indices.

#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "studies/findings/found_lines.hpp"
#include "tests/studies/execution/formula_simulator.hpp"
#include "tests/studies/kinds/search_testing.hpp"

namespace unbruised::studies::testing {
namespace {

std::string compare_text(const std::string& b_force, int count) {
  return "[study]\nname = \"compare\"\nkind = \"compare\"\n[sampling]\ncount = " + std::to_string(count) + R"(
[[random]]
key = "product.friction"
distribution = "normal"
mean = 0.5
standard_deviation = 0.05
at_least = 0.2
[[candidate]]
name = "a"
grip_force_N = 2.0
[[candidate]]
name = "b"
grip_force_N = )" +
         b_force + "\n" + kFormulaCell;
}

/// Cycle time that varies by 10 % from product to product, and is less by 5 % at 2.1 N.
ScenarioResult noisy_time(const Scenario& s) {
  const double friction = std::get<LatticeParameters>(s.product).friction;
  const double factor = s.strategy.grip_force_N == 2.1 ? 0.95 : 1.0;
  return held_with({{Metric::cycle_time_s, factor * (1.0 + 2.0 * (friction - 0.5))}, {Metric::slip_max_m, 0.0}});
}

TEST(CompareStudy, ShowsNoDifferenceOfAStrategyFromItself) {
  const StudyReport report = run_fresh(study_of(compare_text("2.0", 40)), FormulaSimulator(noisy_time));
  const ResultTable& comparison = table_of(report, "comparison");
  EXPECT_EQ(number_in(comparison, "ties", 0), 40.0);
  EXPECT_EQ(number_in(comparison, "mean_difference", 0), 0.0);
  EXPECT_EQ(text_attribute(comparison, "verdict"), "a and b: no difference shown");
  EXPECT_EQ(text_attribute(comparison, "headline"),
            "no winner: no strategy is shown to be better than the other, holding first, then cycle_time_s");
}

TEST(CompareStudy, FindsAPlantedDifferenceOfFivePercent) {
  const StudyReport report = run_fresh(study_of(compare_text("2.1", 40)), FormulaSimulator(noisy_time));
  const ResultTable& comparison = table_of(report, "comparison");
  EXPECT_EQ(number_in(comparison, "losses", 0), 40.0);
  EXPECT_NEAR(number_in(comparison, "mean_difference", 0), -0.05, 0.002);  // 5 % of a mean of one
  EXPECT_LT(number_in(comparison, "high", 0), 0.0);
  const std::string verdict = text_attribute(comparison, "verdict");
  EXPECT_TRUE(verdict.starts_with(
      "held equally often (a 40 of 40, b 40 of 40); b needs less cycle_time_s than a: by 0.05"))
      << verdict;
  EXPECT_NE(verdict.find(" s or 5 % (95 % interval 0.0"), std::string::npos) << verdict;
  EXPECT_EQ(text_attribute(comparison, "headline"),
            "winner: b, held on 40 of 40 products (a on 40); less cycle_time_s decides");
  EXPECT_EQ(text_attribute(comparison, "winner"), "b");
}

/// b is better by 5 %, but its impacts are not resolved, and it is held no more at half the step by products whose
/// friction is above the bound.
FormulaSimulator quick_by_impacts(double dropped_above_friction) {
  return FormulaSimulator([=](const Scenario& s) {
    ScenarioResult result = noisy_time(s);
    const bool is_b = s.strategy.grip_force_N == 2.1;
    result.metrics[Metric::peak_rise_steps] = is_b ? 2.0 : 8.0;
    result.metrics[Metric::peak_finger_force_N] = s.simulation.time_step_s < 0.9e-3 ? 3.0 : 2.5;
    const bool is_half = s.simulation.time_step_s < 0.9e-3;
    if (is_b && is_half && std::get<LatticeParameters>(s.product).friction > dropped_above_friction) {
      result.outcome = Outcome::dropped;
    }
    return result;
  });
}

TEST(CompareStudy, LooksAgainAtAWinnerThatRestsOnImpacts) {
  const Study study = study_of(compare_text("2.1", 40));
  const StudyReport stays = run_fresh(study, quick_by_impacts(1.0));
  const ResultTable& checks = table_of(stays, "verification");
  EXPECT_EQ(number_in(checks, "feasible", 1), 1.0);
  EXPECT_EQ(number_attribute(checks, "repeated"), 40.0) << "those of b alone";
  EXPECT_EQ(number_in(checks, "peak_finger_force_N", 0), 2.5);
  EXPECT_EQ(number_in(checks, "peak_finger_force_N", 1), 3.0);
  EXPECT_TRUE(text_in(checks, "says", 1).starts_with("b stays the winner; mean cycle_time_s 0.9"))
      << text_in(checks, "says", 1);
  ASSERT_EQ(stays.warnings.size(), 1U);  // that impacts are not resolved
  const std::vector<std::string> lines = found_lines(stays.tables.found, "held");
  EXPECT_TRUE(lines.back().starts_with("checked, half the time step: b stays the winner")) << lines.back();
}

TEST(CompareStudy, SaysThatAWinnerDoesNotSurviveHalfTheStepAndKeepsItsAnswer) {
  const StudyReport report = run_fresh(study_of(compare_text("2.1", 40)), quick_by_impacts(0.5));
  EXPECT_EQ(text_attribute(table_of(report, "comparison"), "winner"), "b");
  const ResultTable& checks = table_of(report, "verification");
  EXPECT_EQ(number_in(checks, "feasible", 1), 0.0);
  EXPECT_TRUE(text_in(checks, "says", 1).starts_with("b is not the winner any more (winner: a, held on 40 of 40"))
      << text_in(checks, "says", 1);
  EXPECT_TRUE(report.warnings[0].starts_with(
      "the winner does not stand a check: with half the time step (simulation.time_step_s = 0.0005) b is not"))
      << report.warnings[0];
}

TEST(CompareStudy, ComparesOnTheSameProductsSoThatAnUnpairedSpreadDoesNotHideTheDifference) {
  // Eight products: unpaired, a spread of 10 % hides 5 %.
  const StudyReport report = run_fresh(study_of(compare_text("2.1", 8)), FormulaSimulator(noisy_time));
  EXPECT_LT(number_in(table_of(report, "comparison"), "high", 0), 0.0);
}

TEST(CompareStudy, AProductThatIsNotHeldLoses) {
  const FormulaSimulator simulator([](const Scenario& s) {
    ScenarioResult result = noisy_time(s);
    if (s.strategy.grip_force_N == 2.1) {
      result.outcome = Outcome::dropped;
      result.metrics[Metric::cycle_time_s] = kAbsent;
    }
    return result;
  });
  const StudyReport report = run_fresh(study_of(compare_text("2.1", 20)), simulator);
  const ResultTable& comparison = table_of(report, "comparison");
  EXPECT_EQ(number_in(comparison, "wins", 0), 20.0);
  EXPECT_EQ(number_in(comparison, "pairs", 0), 0.0);
  EXPECT_TRUE(text_attribute(comparison, "verdict").starts_with("a is held more often"))
      << text_attribute(comparison, "verdict");
  EXPECT_EQ(number_in(table_of(report, "candidates"), "dropped", 1), 20.0);
}

/// The faster b damages the products of the highest friction.
FormulaSimulator quick_and_damaging(double damaged_from_friction) {
  return FormulaSimulator([=](const Scenario& s) {
    ScenarioResult result = noisy_time(s);
    const double friction = std::get<LatticeParameters>(s.product).friction;
    result.metrics[Metric::peak_finger_force_N] = s.strategy.grip_force_N;
    if (s.strategy.grip_force_N == 2.1 && friction > damaged_from_friction) result.outcome = Outcome::damaged;
    return result;
  });
}

const std::vector<std::string> kJudged = {"limits.damage=judged", "limits.finger_force_N=50.0"};

TEST(CompareStudy, HoldingWithoutDamageComesBeforeBeingFaster) {
  // b damages half of the products: the interval of the difference lies far from zero.
  const StudyReport report = run_fresh(study_of(compare_text("2.1", 40), kJudged), quick_and_damaging(0.5));
  const ResultTable& comparison = table_of(report, "comparison");
  EXPECT_EQ(text_attribute(comparison, "winner"), "a");
  EXPECT_EQ(text_attribute(comparison, "headline"),
            "winner: a, held without damage on 40 of 40 products (b on 20); holding more often is shown");
  EXPECT_TRUE(
      text_attribute(comparison, "verdict")
          .starts_with("a is held without damage more often than b: a 40 of 40, b 20 of 40; on 50 % more of "
                       "the products (95 % interval "))
      << text_attribute(comparison, "verdict");
  EXPECT_NE(text_attribute(comparison, "verdict").find("; but b needs less cycle_time_s than a"),
            std::string::npos)
      << text_attribute(comparison, "verdict");
  EXPECT_NEAR(number_in(comparison, "held_difference", 0), -0.5, 1e-12);
  EXPECT_LT(number_in(comparison, "held_high", 0), 0.0);
}

TEST(CompareStudy, AFasterStrategyDoesNotWinWhileItDamagesMoreThanTheOther) {
  // Two or three of 40 damaged: not shown to be more than none, and yet no reason to praise b.
  const StudyReport report = run_fresh(study_of(compare_text("2.1", 40), kJudged), quick_and_damaging(0.578));
  const ResultTable& comparison = table_of(report, "comparison");
  ASSERT_GT(number_in(table_of(report, "candidates"), "damaged", 1), 0.0);
  ASSERT_EQ(number_in(comparison, "held_high", 0) >= 0.0, true) << "else it is shown, and another test";
  EXPECT_EQ(text_attribute(comparison, "winner"), "");
  EXPECT_TRUE(text_attribute(comparison, "headline").starts_with("no winner"))
      << text_attribute(comparison, "headline");
  EXPECT_TRUE(
      text_attribute(comparison, "verdict").starts_with("held without damage: no difference shown (a 40 of 40"))
      << text_attribute(comparison, "verdict");
}

TEST(CompareStudy, ShowsWhatTheCandidatesAre) {
  const StudyReport report = run_fresh(study_of(compare_text("2.1", 8)), FormulaSimulator(noisy_time));
  const ResultTable& candidates = table_of(report, "candidates");
  EXPECT_EQ(number_in(candidates, "strategy.grip_force_N", 0), 2.0);
  EXPECT_EQ(number_in(candidates, "strategy.grip_force_N", 1), 2.1);
  EXPECT_EQ(keys_text(candidates, 1), "grip_force_N = 2.1") << "settings that all share are not repeated";
  EXPECT_EQ(number_in(candidates, "products_cycle_time_s", 0), 8.0);
  const std::vector<std::string> lines = summary_lines(report.tables, "compare");
  EXPECT_TRUE(std::any_of(lines.begin(), lines.end(), [](const std::string& line) {
    return line.starts_with("b (grip_force_N = 2.1): P(held) = 1");
  }));
}

/// Ishigami's function of three keys that are uniform on (-pi, pi) after a shift.
ScenarioResult ishigami(const Scenario& s) {
  const double x1 = s.strategy.grip_force_N - 10.0;
  const double x2 = s.strategy.lift_acceleration_m_s2 - 10.0;
  const double x3 = s.strategy.hold_s - 10.0;
  const double f = std::sin(x1) + 7.0 * std::sin(x2) * std::sin(x2) + 0.1 * x3 * x3 * x3 * x3 * std::sin(x1);
  return held_with({{Metric::cycle_time_s, f}, {Metric::slip_max_m, 0.0}});
}

std::string ishigami_text(const std::string& method, int samples) {
  std::string text =
      "[study]\nname = \"ishigami\"\nkind = \"sensitivity\"\n[sensitivity]\nmetrics = [\"cycle_time_s\"]\nmethod "
      "= \"" +
      method + "\"\nsamples = " + std::to_string(samples) + "\n";
  for (const char* key : {"strategy.grip_force_N", "strategy.lift_acceleration_m_s2", "strategy.hold_s"}) {
    text += std::string("[[random]]\nkey = \"") + key +
            "\"\ndistribution = \"uniform\"\nfrom = 6.858407346410207\nto = 13.141592653589793\n";
  }
  return text + kFormulaCell;
}

TEST(SensitivityStudy, FindsTheSobolIndicesOfIshigamisFunction) {
  const StudyReport report = run_fresh(study_of(ishigami_text("sobol", 1024)), FormulaSimulator(ishigami));
  const ResultTable& table = table_of(report, "sensitivity");
  // Closed form with a = 7, b = 0.1 (Ishigami and Homma 1990).
  const double pi = 3.14159265358979323846;
  const double v1 = 0.5 * std::pow(1.0 + 0.1 * std::pow(pi, 4) / 5.0, 2);
  const double v2 = 49.0 / 8.0;
  const double v13 = 0.01 * std::pow(pi, 8) * (1.0 / 18.0 - 1.0 / 50.0);
  const double v = v1 + v2 + v13;
  const double first[3] = {v1 / v, v2 / v, 0.0};
  const double total[3] = {(v1 + v13) / v, v2 / v, v13 / v};
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_LE(number_in(table, "first_order_low", k), first[k]) << k;
    EXPECT_GE(number_in(table, "first_order_high", k), first[k]) << k;
    EXPECT_LE(number_in(table, "total_low", k), total[k]) << k;
    EXPECT_GE(number_in(table, "total_high", k), total[k]) << k;
    EXPECT_NEAR(number_in(table, "total", k), total[k], 0.05) << k;
  }
  EXPECT_EQ(report.tables.rows.size(), 1024U * 5U);
}

TEST(SensitivityStudy, ScreensByMorrisWithoutSquareTerms) {
  const StudyReport report = run_fresh(study_of(ishigami_text("morris", 64)), FormulaSimulator(ishigami));
  const ResultTable& table = table_of(report, "sensitivity");
  ASSERT_EQ(row_count(table), 3U);
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_GT(number_in(table, "mean_absolute_high", k), number_in(table, "mean_absolute_low", k));
  EXPECT_EQ(report.tables.rows.size(), 64U * 4U);
}

bool has_line(const StudyReport& report, const std::string& kind, const std::string& wanted) {
  const std::vector<std::string> lines = summary_lines(report.tables, kind);
  return std::find(lines.begin(), lines.end(), wanted) != lines.end();
}

TEST(SensitivityStudy, SaysThatAMetricDoesNotVaryAndNeverNaN) {
  for (const std::string method : {"sobol", "morris"}) {
    const Study study = study_of(ishigami_text(method, 16));
    const StudyReport constant = run_fresh(study, FormulaSimulator([](const Scenario&) {
                                             return held_with({{Metric::cycle_time_s, 2.0}});
                                           }));
    EXPECT_TRUE(has_line(constant, "sensitivity", "cycle_time_s does not vary, whatever the keys are")) << method;
    const StudyReport missing = run_fresh(study, FormulaSimulator([](const Scenario&) {
                                            return held_with({{Metric::slip_max_m, 0.0}});
                                          }));
    EXPECT_TRUE(has_line(missing, "sensitivity",
                         "cycle_time_s has no effects that could be told: each of the 16 samples has a run in "
                         "which it does not exist"))
        << method;
    for (const StudyReport* report : {&constant, &missing}) {
      for (const std::string& line : summary_lines(report->tables, "sensitivity")) {
        EXPECT_EQ(line.find("nan"), std::string::npos) << line;
        EXPECT_EQ(line.find("cycle_time_s, "), std::string::npos) << line << ": an effect of a key";
      }
    }
  }
}

TEST(SensitivityStudy, SaysThatOneSampleGivesNoInterval) {
  const ResultTable table{.name = "sensitivity",
                          .row = "effect",
                          .columns = {{"key", "", "", std::vector<std::string>{"strategy.hold_s"}},
                                      {"metric", "", "", std::vector<std::string>{"cycle_time_s"}},
                                      {"first_order", "", "", std::vector<double>{0.5}},
                                      {"total", "", "", std::vector<double>{0.6}},
                                      {"total_low", "", "", std::vector<double>{-INFINITY}},
                                      {"total_high", "", "", std::vector<double>{INFINITY}}},
                          .attributes = {{"method", std::string("sobol")}}};
  const std::vector<std::string> lines = found_lines({table}, "held");
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0],
            "cycle_time_s, strategy.hold_s: total effect 0.6 (too few samples for an interval), alone 0.5");
}

TEST(CompareStudy, SaysThatACandidateHoldsNothing) {
  const auto none = [](const Scenario&) {
    ScenarioResult result = held_with({{Metric::cycle_time_s, 1.0}});
    result.outcome = Outcome::dropped;
    return result;
  };
  const StudyReport report = run_fresh(study_of(compare_text("2.1", 8)), FormulaSimulator(none));
  const std::vector<std::string> lines = summary_lines(report.tables, "compare");
  EXPECT_TRUE(std::any_of(lines.begin(), lines.end(), [](const std::string& line) {
    return line.ends_with("; cycle_time_s is of no product: none is held");
  }));
  for (const std::string& line : lines) EXPECT_EQ(line.find("nan"), std::string::npos) << line;
}

TEST(SampleStudy, ReportsHowOftenProductsAreHeldAndHowMetricsSpread) {
  const std::string text =
      "[study]\nname = \"sample\"\nkind = \"sample\"\n[sampling]\ncount = 200\n[[random]]\nkey = "
      "\"product.friction\"\ndistribution = \"uniform\"\nfrom = 0.4\nto = 0.6\n" +
      kFormulaCell;
  const FormulaSimulator simulator([](const Scenario& s) {
    const double friction = std::get<LatticeParameters>(s.product).friction;
    ScenarioResult result = held_with({{Metric::cycle_time_s, friction}});
    if (friction < 0.45) result.outcome = Outcome::slipped;
    return result;
  });
  const StudyReport report = run_fresh(study_of(text), simulator);
  const ResultTable& table = table_of(report, "statistics");
  EXPECT_NEAR(*number_attribute(table, "probability"), 0.75, 0.01);  // Sobol: strata of 1/128
  EXPECT_NEAR(number_in(table, "mean", 0), 0.5, 0.002);
}

}  // namespace
}  // namespace unbruised::studies::testing

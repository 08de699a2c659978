/// @file
/// Whole studies of the kinds that search, over simulators whose answers are formulas: known optima, known fronts,
/// the same bits whatever the timing, resumed anywhere.

#include <algorithm>
#include <atomic>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/studies/execution/formula_simulator.hpp"
#include "tests/studies/kinds/search_testing.hpp"

namespace unbruised::studies::testing {
namespace {

const std::string kTwoVariables = R"(
[[variable]]
key = "strategy.grip_force_N"
from = 0.5
to = 8.0
scale = "log"
[[variable]]
key = "strategy.lift_acceleration_m_s2"
from = 0.5
to = 20.0
scale = "log"
)";

std::string study_text(const std::string& kind, const std::string& search, const std::string& more = "") {
  return "[study]\nname = \"test\"\nkind = \"" + kind + "\"\n[search]\n" + search + kTwoVariables + more +
         kFormulaCell;
}

/// Time 1 / a, friction margin 2 mu N / (m (g + a)) - 1, yield ratio N / 4: the best has both constraints active,
/// N = 4 and a = 2 mu N / m / 1.2 - g.
ScenarioResult grip_formula(const Scenario& s) {
  const double N = s.strategy.grip_force_N;
  const double a = s.strategy.lift_acceleration_m_s2;
  const auto& product = std::get<LatticeParameters>(s.product);
  ScenarioResult result = held_with(
      {{Metric::cycle_time_s, 1.0 + 1.0 / a},
       {Metric::friction_margin_min, 2.0 * product.friction * N / (*product.mass_kg * (9.80665 + a)) - 1.0},
       {Metric::contact_yield_ratio_max, N / 4.0},
       {Metric::peak_finger_force_N, N},
       {Metric::slip_max_m, 0.0}});
  if (result.metrics[Metric::friction_margin_min] < 0.0) {
    result.outcome = Outcome::slipped;
    result.metrics[Metric::slip_max_m] = 2e-3 * (1.0 - result.metrics[Metric::friction_margin_min]);
  }
  if (result.metrics[Metric::friction_margin_min] < -0.5) {
    result.outcome = Outcome::dropped;
    result.metrics[Metric::cycle_time_s] = kAbsent;
  }
  return result;
}

const std::string kGripSearch =
    "constraints = [\"held\", \"friction_margin_min >= 0.2\", \"contact_yield_ratio_max <= 1.0\"]\nstarts = "
    "8\nbudget = 800\n";

TEST(OptimizeStudy, FindsTheStrategyWhereBothConstraintsAreActive) {
  const StudyReport report = run_fresh(study_of(study_text("optimize", kGripSearch), {"product.mass_kg=0.15"}),
                                       FormulaSimulator(grip_formula));
  const ResultTable& best = table_of(report, "best");
  EXPECT_EQ(number_in(best, "feasible", 0), 1.0);
  // COBYLA stops at steps of 1e-3 of the range: log(8/0.5) and log(20/0.5) make that 0.3 and 0.4 %.
  EXPECT_NEAR(number_in(best, "strategy.grip_force_N", 0), 4.0, 4.0 * 0.005);
  const double exact = 2.0 * 0.5 * 4.0 / 0.15 / 1.2 - 9.80665;
  // A force that is 0.3 % too small lowers a by 0.3 % of g + a: 0.5 % of a.
  EXPECT_NEAR(number_in(best, "strategy.lift_acceleration_m_s2", 0), exact, 0.01 * exact);
}

TEST(OptimizeStudy, NamesTheActiveConstraintsAndChecksTheWinnerTwice) {
  const StudyReport report = run_fresh(study_of(study_text("optimize", kGripSearch), {"product.mass_kg=0.15"}),
                                       FormulaSimulator(grip_formula));
  const ResultTable& checks = table_of(report, "verification");
  ASSERT_EQ(row_count(checks), 3U);
  EXPECT_EQ(text_in(checks, "check", 1), "half the time step");
  EXPECT_EQ(text_in(checks, "change", 1), "simulation.time_step_s = 0.0005");
  EXPECT_EQ(text_in(checks, "check", 2), "finer mesh");
  // The formula knows no time step and no mesh.
  EXPECT_EQ(number_in(checks, "objective_change", 1), 0.0);
  const ResultTable& constraints = table_of(report, "constraints");
  bool yield_is_active = false;
  for (std::size_t i = 0; i < row_count(constraints); ++i) {
    if (text_in(constraints, "text", i) == "contact_yield_ratio_max <= 1.0") {
      yield_is_active = number_in(constraints, "active", i) == 1.0;
    }
  }
  EXPECT_TRUE(yield_is_active);
}

TEST(OptimizeStudy, WarnsWhereTheMarginAgainstDamageHangsOnTheTimeStep) {
  // With the yield ratio (N / 4)(1 ms / dt)^(1/4) half the step raises it by 19 %: from the bound of 0.8 to 0.95.
  const auto depends_on_step = [](const Scenario& s) {
    ScenarioResult result = grip_formula(s);
    result.metrics[Metric::contact_yield_ratio_max] *= std::pow(1e-3 / s.simulation.time_step_s, 0.25);
    return result;
  };
  const std::string search =
      "constraints = [\"held\", \"peak_finger_force_N <= 3.2\"]\nstarts = 4\nbudget = 200\n";
  const std::vector<std::string> sets = {"product.mass_kg=0.15",           "product.yield_stress_Pa=1e4",
                                         "product.tangent_modulus_Pa=1e4", "limits.contact_yield_ratio=1.0",
                                         "limits.damage=judged",           "simulation.time_step_s=1e-3"};
  const StudyReport report =
      run_fresh(study_of(study_text("optimize", search), sets), FormulaSimulator(depends_on_step));
  const ResultTable& checks = table_of(report, "verification");
  EXPECT_NEAR(number_in(checks, "damage_margin", 0), 0.2, 0.01);  // COBYLA's step: half a per cent of the force
  EXPECT_NEAR(number_in(checks, "damage_margin", 1), 0.05, 0.01);
  ASSERT_EQ(report.warnings.size(), 1U);
  EXPECT_NE(report.warnings[0].find("half the time step"), std::string::npos) << report.warnings[0];
  const StudyReport steady =
      run_fresh(study_of(study_text("optimize", search), sets), FormulaSimulator(grip_formula));
  EXPECT_TRUE(steady.warnings.empty());
}

TEST(OptimizeStudy, SaysNoneFeasibleAndWhichConstraintBinds) {
  const std::string search =
      "constraints = [\"held\", \"peak_finger_force_N <= 0.4\"]\nstarts = 4\nbudget = 200\n";
  // So light that every force holds it: the force limit alone is broken, least at 0.5 N, by a quarter.
  const StudyReport report = run_fresh(study_of(study_text("optimize", search), {"product.mass_kg=0.005"}),
                                       FormulaSimulator(grip_formula));
  const ResultTable& best = table_of(report, "best");
  EXPECT_EQ(number_in(best, "feasible", 0), 0.0);
  EXPECT_NEAR(number_in(best, "violation", 0), 0.25, 0.01);
  EXPECT_EQ(text_in(best, "binding", 0), "peak_finger_force_N <= 0.4");
  const std::vector<std::string> lines = summary_lines(report.tables, "optimize");
  EXPECT_TRUE(std::any_of(lines.begin(), lines.end(), [](const std::string& line) {
    return line.starts_with("none feasible") && line.find("peak_finger_force_N <= 0.4") != std::string::npos;
  }));
  EXPECT_EQ(find_table(report.tables.found, "verification"), nullptr);
}

TEST(OptimizeStudy, TakesTheSameWayWhateverTheThreadsAndTheTiming) {
  const Study study = study_of(study_text("optimize", kGripSearch));
  const FormulaSimulator simulator(grip_formula);
  const std::string digest = rows_digest(run_fresh(study, simulator, {.threads = 1}).tables.rows);
  for (const int threads : {2, 3, 8}) {
    EXPECT_EQ(rows_digest(run_fresh(study, simulator, {.threads = threads}).tables.rows), digest) << threads;
  }
  EXPECT_EQ(rows_digest(run_fresh(study, simulator, {.threads = 2, .concurrent_searches = 1}).tables.rows), digest)
      << "one search after the other";
  EXPECT_EQ(rows_digest(run_fresh(study, simulator, {.threads = 2, .concurrent_searches = 3}).tables.rows),
            digest);
}

TEST(OptimizeStudy, NumbersItsScenariosBySearchAndQuestion) {
  const StudyReport report =
      run_fresh(study_of(study_text("optimize", kGripSearch)), FormulaSimulator(grip_formula));
  std::uint64_t expected = 0;
  std::uint64_t last = 0;
  for (const ScenarioRow& row : report.tables.rows) {
    EXPECT_EQ(row.id, expected++);
    ASSERT_TRUE(row.place.has_value());
    EXPECT_GE(journal_id(row), last);
    last = journal_id(row);
  }
}

/// Stops a study after a number of scenarios, as Ctrl-C would, until it ends by itself.
std::string run_in_pieces(const Study& study, const Formula& formula, int scenarios_each, int& pieces) {
  const TemporaryFolder folder("pieces");
  for (pieces = 1; pieces < 1000; ++pieces) {
    std::atomic<bool> stop = false;
    std::atomic<int> left = scenarios_each;
    const FormulaSimulator simulator([&](const Scenario& scenario) {
      if (--left < 0) stop = true;
      return formula(scenario);
    });
    const StudyReport report = run_in(folder.path(), study, simulator, {.threads = 2, .stop = &stop});
    if (!report.interrupted) return rows_digest(report.tables.rows);
  }
  return "never ended";
}

TEST(SearchStudies, EndWithTheSameDigestHoweverOftenTheyAreInterrupted) {
  const std::string randoms =
      "[[random]]\nkey = \"product.friction\"\ndistribution = \"uniform\"\nfrom = 0.45\nto = "
      "0.55\n[sampling]\ncount = 8\n";
  const std::string pareto =
      "objectives = [\"cycle_time_s\", \"peak_finger_force_N\"]\npoints = 3\nbudget = 200\n";
  const std::string robust = "constraints = [\"P(held) >= 0.9\"]\nbudget = 40\n";
  for (const Study& study : {study_of(study_text("optimize", kGripSearch)), study_of(study_text("pareto", pareto)),
                             study_of(study_text("robust", robust, randoms))}) {
    const std::string whole = rows_digest(run_fresh(study, FormulaSimulator(grip_formula)).tables.rows);
    int pieces = 0;
    EXPECT_EQ(run_in_pieces(study, grip_formula, 41, pieces), whole) << study_kind_word(study.kind());
    EXPECT_GT(pieces, 2) << study_kind_word(study.kind()) << " was not interrupted";
  }
}

TEST(OptimizeStudy, RefusesARecordOfAnotherSearch) {
  const Study study = study_of(study_text("optimize", kGripSearch));
  const TemporaryFolder folder("foreign");
  {
    auto run = RunDirectory::open(
        {.directory = folder.path(), .config_toml = study.resolved_toml(), .build = "test", .fresh = false});
    ScenarioRow row{.id = journal_id(SearchPlace{0, 0, 0}), .result = {}, .inputs = {1.0, 2.0, 3.0, 4.0}};
    row.result.outcome = Outcome::held;
    ASSERT_FALSE((*run)->append(row));
  }
  EXPECT_THROW(run_in(folder.path(), study, FormulaSimulator(grip_formula)), std::runtime_error);
}

/// ZDT1 (Zitzler, Deb and Thiele 2000) in two variables: the front is f2 = 1 - sqrt(f1), 0 <= f1 <= 1, where the
/// second variable is at its lower bound.
ScenarioResult zdt1_formula(const Scenario& s) {
  const double x = (s.strategy.grip_force_N - 1.0) / 2.0;
  const double g = 1.0 + 9.0 * (s.strategy.lift_acceleration_m_s2 - 1.0);
  return held_with({{Metric::cycle_time_s, x},
                    {Metric::peak_finger_force_N, g * (1.0 - std::sqrt(x / g))},
                    {Metric::slip_max_m, 0.0}});
}

std::string zdt1_study(const std::string& method) {
  return R"([study]
name = "zdt1"
kind = "pareto"
[search]
objectives = ["cycle_time_s", "peak_finger_force_N"]
method = ")" +
         method + R"("
points = 100
starts = 1
budget = 9000
tolerance = 1e-4
[[variable]]
key = "strategy.grip_force_N"
from = 1.0
to = 3.0
[[variable]]
key = "strategy.lift_acceleration_m_s2"
from = 1.0
to = 2.0
)" + kFormulaCell;
}

TEST(ParetoStudy, CoversAKnownFrontWithinOnePercentOfItsHypervolume) {
  for (const std::string method : {"epsilon_constraint", "chebyshev"}) {
    const StudyReport report = run_fresh(study_of(zdt1_study(method)), FormulaSimulator(zdt1_formula));
    const ResultTable& front = table_of(report, "pareto");
    const double r1 = *number_attribute(front, "reference_1");
    const double r2 = *number_attribute(front, "reference_2");
    // The front's ends are (0, 1) and (1, 0), so the reference lies a tenth beyond: (1.1, 1.1).
    EXPECT_NEAR(r1, 1.1, 1e-3) << method;
    EXPECT_NEAR(r2, 1.1, 1e-3) << method;
    // 100 points leave steps of 1/101 in f2: half of them, 0.5 % of the unit square, stays uncovered.
    // Area dominated by y = 1 - sqrt(x): integral of (r2 - 1 + sqrt(x)) over 0..1, and the strip from x = 1 to r1.
    const double exact = (r2 - 1.0) + 2.0 / 3.0 + (r1 - 1.0) * r2;
    EXPECT_NEAR(*number_attribute(front, "hypervolume"), exact, 0.01 * exact) << method;
    EXPECT_LE(*number_attribute(front, "hypervolume"), exact + 1e-9) << method;
  }
}

TEST(ParetoStudy, FindsTheKneeOfTheFront) {
  const StudyReport report = run_fresh(study_of(zdt1_study("epsilon_constraint")), FormulaSimulator(zdt1_formula));
  const ResultTable& front = table_of(report, "pareto");
  double knee = kAbsent;
  for (std::size_t i = 0; i < row_count(front); ++i) {
    if (number_in(front, "knee", i) == 1.0) knee = number_in(front, "objective_1", i);
  }
  // x + 1 - sqrt(x) is least at x = 1/4; 100 points in f2 lie 0.01 apart there.
  EXPECT_NEAR(knee, 0.25, 0.03);
}

TEST(ParetoStudy, LooksAgainAtEveryPointOfTheFrontThatRestsOnAnImpact) {
  // At half the step the second objective is a tenth higher: points between 0.727 and 0.8 break the bound.
  const auto on_impacts = [](double rise_steps) {
    return FormulaSimulator([=](const Scenario& s) {
      ScenarioResult result = zdt1_formula(s);
      result.metrics[Metric::peak_rise_steps] = rise_steps;
      if (s.simulation.time_step_s < 0.9e-3) result.metrics[Metric::peak_finger_force_N] *= 1.1;
      return result;
    });
  };
  const std::string search =
      "objectives = [\"cycle_time_s\", \"peak_finger_force_N\"]\nconstraints = [\"peak_finger_force_N <= "
      "0.8\"]\npoints = 3\nbudget = 200\n";
  std::string text = study_text("pareto", search);
  text.replace(text.find("from = 0.5\nto = 8.0\nscale = \"log\""), 34, "from = 1.0\nto = 3.0\n");
  text.replace(text.find("from = 0.5\nto = 20.0\nscale = \"log\""), 35, "from = 1.0\nto = 2.0\n");
  const Study study = study_of(text);
  const StudyReport report = run_fresh(study, on_impacts(1.0));
  const ResultTable& front = table_of(report, "pareto");
  double broken = 0.0;
  for (std::size_t i = 0; i < row_count(front); ++i) {
    // A ratio of two products of doubles.
    EXPECT_NEAR(number_in(front, "half_step_objective_2", i), 1.1 * number_in(front, "objective_2", i), 1e-12);
    broken += number_in(front, "half_step_violation", i) > 0.0 ? 1.0 : 0.0;
  }
  EXPECT_GT(broken, 0.0);
  const bool is_told = std::any_of(report.warnings.begin(), report.warnings.end(), [](const std::string& warning) {
    return warning.find("of the front break a constraint at half the time step") != std::string::npos ||
           warning.find("of the front breaks a constraint at half the time step") != std::string::npos;
  });
  EXPECT_TRUE(is_told);
  const std::vector<std::string> lines = summary_lines(report.tables, "pareto");
  EXPECT_TRUE(std::any_of(lines.begin(), lines.end(), [](const std::string& line) {
    return line.find("peak_finger_force_N moves by at most 10 %") != std::string::npos;
  }));
  const StudyReport resolved = run_fresh(study, on_impacts(8.0));
  EXPECT_TRUE(std::isnan(number_in(table_of(resolved, "pareto"), "half_step_objective_2", 0)));
}

const std::string kFrictionVaries = R"(
[[random]]
key = "product.friction"
distribution = "uniform"
from = 0.4
to = 0.6
[sampling]
count = 100
)";

TEST(RobustStudy, KeepsTheProbabilityThatWasAskedFor) {
  // Held when 2 mu N >= m (g + a): on 90 % of the products mu >= 0.42, so the best a at N = 8 is 2 x 0.42 x 8 / m
  // - g.
  const std::string search = "constraints = [\"P(held) >= 0.9\"]\nstarts = 4\nbudget = 320\ntolerance = 1e-4\n";
  const StudyReport report =
      run_fresh(study_of(study_text("robust", search, kFrictionVaries), {"product.mass_kg=0.4"}),
                FormulaSimulator(grip_formula));
  const ResultTable& best = table_of(report, "best");
  EXPECT_GE(number_in(best, "probability", 0), 0.9);
  EXPECT_LT(number_in(best, "probability_low", 0), 0.9);  // 100 products do not show it
  const double exact = 2.0 * 0.42 * 8.0 / 0.4 - 9.80665;
  // The sampled quantile of friction lies within a stratum of 0.002 of 0.42: 0.5 % of 16.8; and COBYLA's own step.
  EXPECT_NEAR(number_in(best, "strategy.lift_acceleration_m_s2", 0), exact, 0.02 * exact + 0.1);
  const ResultTable& checks = table_of(report, "verification");
  EXPECT_EQ(text_in(checks, "check", row_count(checks) - 1), "other products");
}

TEST(RobustStudy, SearchesAForceThatScatters) {
  // A block of 0.15 kg lifted with 2 m/s2 is held by F0 = m (g + a) / (2 mu) = 1.771 N. The force that acts is
  // within
  // +-20 % of the one that is set, evenly: nine tenths of them are above N (1 - 0.2 + 0.04), so N = F0 / 0.84.
  const std::string text =
      "[study]\nname = \"scatters\"\nkind = \"robust\"\n[search]\nobjective = \"mean(peak_finger_force_N)\"\n"
      "constraints = [\"P(held) >= 0.9\"]\nstarts = 4\nbudget = 320\ntolerance = 1e-4\n[sampling]\ncount = 200\n"
      "[[variable]]\nkey = \"strategy.grip_force_N\"\nfrom = 0.5\nto = 8.0\n"
      "[[random]]\nkey = \"strategy.grip_force_N\"\nrelative = 0.2\n";
  const StudyReport report =
      run_fresh(study_of(text + kFormulaCell, {"product.mass_kg=0.15"}), FormulaSimulator(grip_formula));
  const ResultTable& best = table_of(report, "best");
  EXPECT_EQ(number_in(best, "feasible", 0), 1.0);
  const double exact_N = 0.15 * (9.80665 + 2.0) / (2.0 * 0.5) / 0.84;
  // 200 products put a quantile of the error within 0.4 / 200 of its place; COBYLA's own step is smaller.
  EXPECT_NEAR(number_in(best, "strategy.grip_force_N", 0), exact_N, 0.01 * exact_N);
  const std::vector<ColumnInfo>& inputs = report.tables.inputs;
  EXPECT_TRUE(std::any_of(inputs.begin(), inputs.end(), [](const ColumnInfo& column) {
    return column.key == "strategy.grip_force_N_relative_error" && column.units == "1";
  }));
}

TEST(RobustStudy, JudgesTheStrategyAsWrittenWhenNothingIsSearched) {
  const std::string text = "[study]\nname = \"as_written\"\nkind = \"robust\"\n[strategy]\ngrip_force_N = 1.5\n" +
                           kFrictionVaries + kFormulaCell;
  const StudyReport report = run_fresh(study_of(text), FormulaSimulator(grip_formula));
  const ResultTable& best = table_of(report, "best");
  // 2 mu 1.5 >= 0.1 (g + 2): mu >= 0.3936: all of them.
  EXPECT_EQ(number_in(best, "probability", 0), 1.0);
  EXPECT_EQ(number_in(best, "scenario", 0), 0.0);
}

}  // namespace
}  // namespace unbruised::studies::testing

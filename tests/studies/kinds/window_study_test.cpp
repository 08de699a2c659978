/// @file
/// Window studies and sweeps over formulas: set-points, half the time step, the answer as a strategy file.

#include <algorithm>
#include <atomic>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "studies/kinds/kind_table.hpp"
#include "studies/results/durable_files.hpp"
#include "tests/studies/execution/formula_simulator.hpp"
#include "tests/studies/kinds/search_testing.hpp"

namespace unbruised::studies::testing {
namespace {

constexpr double kTimeStep = 1e-3;

/// What differs from 1 N of F_hold and 4 N of F_damage.
struct Physics {
  double half_step_damage_N = 4.0;
  /// Of the products of 1 MPa; below kFewestRiseSteps an impact is not resolved.
  double rise_steps = 8.0;
};

/// Held from 1 N on (a product of 2 MPa: 1.5 N), marked above 4 N; the faster the approach the shorter the cycle.
Formula formula_of(const Physics& physics, std::atomic<int>* left = nullptr, std::atomic<bool>* stop = nullptr) {
  return [=](const Scenario& s) {
    if (left != nullptr && --*left < 0) *stop = true;
    const double stiffness = std::get<LatticeParameters>(s.product).youngs_modulus_Pa;
    const double hold_N = stiffness > 1.5e6 ? 1.5 : 1.0;
    const double damage_N = s.simulation.time_step_s < 0.9 * kTimeStep ? physics.half_step_damage_N : 4.0;
    const double force_N = s.strategy.grip_force_N;
    ScenarioResult result = held_with({{Metric::cycle_time_s, 3.0 - s.strategy.approach_speed_m_s},
                                       {Metric::friction_margin_min, force_N - hold_N},
                                       {Metric::slip_max_m, force_N < hold_N ? 1.0 : 0.0},
                                       {Metric::peak_finger_force_N, 4.0 * force_N / damage_N},
                                       {Metric::peak_rise_steps, stiffness > 1.5e6 ? 8.0 : physics.rise_steps}});
    if (force_N > damage_N) result.outcome = Outcome::damaged;
    if (force_N < hold_N) result.outcome = Outcome::slipped;
    return result;
  };
}

/// The formula's product with the limit of damage that the formula breaks.
std::string head(const std::string& name, const std::string& kind) {
  const std::string unjudged = "damage = \"not considered\"";
  std::string cell = kFormulaCell;
  cell.replace(cell.find(unjudged), unjudged.size(), "finger_force_N = 4.0");
  return "[study]\nname = \"" + name + "\"\nkind = \"" + kind + "\"\n" + cell;
}

const std::string kTwoModuli = "[[vary]]\nkey = \"product.youngs_modulus_Pa\"\nvalues = [1e6, 2e6]\n";

Study window_study(const std::string& vary = "") {
  return study_of(head("formula_window", "window") + "[window]\nfrom_N = 0.2\nto_N = 12.0\n" + vary);
}

TEST(WindowStudy, AnswersWithASetPointOverAllProducts) {
  const StudyReport report = run_fresh(window_study(kTwoModuli), FormulaSimulator(formula_of({})));
  const ResultTable& answer = table_of(report, "set_points");
  ASSERT_EQ(row_count(answer), 1U);
  EXPECT_NEAR(number_in(answer, "hold_force_N", 0), 1.5, 1.5 * 0.005);  // the search's tolerance
  EXPECT_NEAR(number_in(answer, "damage_force_N", 0), 4.0, 4.0 * 0.005);
  EXPECT_EQ(number_in(answer, "set_point_N", 0), 2.5);  // sqrt(1.5 x 4) = 2.45
  EXPECT_EQ(text_attribute(answer, "over"), "youngs_modulus_Pa");
  EXPECT_TRUE(report.warnings.empty());
  EXPECT_EQ(number_in(table_of(report, "best"), "strategy.grip_force_N", 0), 2.5);
}

TEST(WindowStudy, LooksForTheEndsAgainAtHalfTheTimeStep) {
  const StudyReport report =
      run_fresh(window_study(kTwoModuli), FormulaSimulator(formula_of({.half_step_damage_N = 3.0})));
  const WindowTable& window = report.tables.window.value();
  const double tolerance = 0.005;
  EXPECT_NEAR(window.rows[0].damage_force_half_step_N, 3.0, 3.0 * tolerance);
  EXPECT_EQ(window.rows[1].hold_force_half_step_N, window.rows[1].hold_force_N);
  EXPECT_TRUE(std::isnan(window.rows[0].hold_force_half_step_N)) << "it does not set the common window";
  // sqrt(1.5 x 3) = 2.12 instead of 2.45
  EXPECT_EQ(number_in(table_of(report, "set_points"), "set_point_N", 0), 2.0);
  ASSERT_EQ(report.warnings.size(), 1U);
  EXPECT_TRUE(report.warnings[0].starts_with("F_damage falls from ")) << report.warnings[0];
  EXPECT_NE(report.warnings[0].find("simulation.time_step_s = 0.0005 or less"), std::string::npos);
  for (std::size_t i = 0; i < report.tables.rows.size(); ++i) EXPECT_EQ(report.tables.rows[i].id, i);
}

TEST(WindowStudy, LooksAgainAtEveryEndThatRestsOnAnImpactWhichTheStepDoesNotResolve) {
  const StudyReport report = run_fresh(
      window_study(kTwoModuli), FormulaSimulator(formula_of({.half_step_damage_N = 3.0, .rise_steps = 1.0})));
  const WindowTable& window = report.tables.window.value();
  EXPECT_EQ(window.rows[0].hold_force_half_step_N, window.rows[0].hold_bracket_high_N)
      << "it does not set the common window, but rests on an impact";
  EXPECT_TRUE(std::isnan(window.rows[1].damage_force_half_step_N)) << "resolved, and not the end that decides";
}

TEST(WindowStudy, SaysWhenNothingIsLeftAtHalfTheTimeStep) {
  const StudyReport report = run_fresh(window_study(), FormulaSimulator(formula_of({.half_step_damage_N = 0.9})));
  EXPECT_TRUE(report.tables.window->rows[0].exists);
  EXPECT_FALSE(report.tables.window->rows[0].set_point_exists);
  EXPECT_EQ(report.tables.window->rows[0].set_point_note, "no window at half the time step");
  EXPECT_EQ(find_table(report.tables.found, "best"), nullptr);
}

TEST(WindowStudy, GivesTheSameBitsForAnyThreadsAndAfterAnInterruption) {
  const Study study = window_study(kTwoModuli);
  const StudyReport whole =
      run_fresh(study, FormulaSimulator(formula_of({.half_step_damage_N = 3.0})), {.threads = 1});
  for (const int runs_before : {3, 20, 45, 60}) {
    const TemporaryFolder folder("window_resume");
    std::atomic<int> left = runs_before;
    std::atomic<bool> stop = false;
    run_in(folder.path(), study, FormulaSimulator(formula_of({.half_step_damage_N = 3.0}, &left, &stop)),
           {.threads = 2, .stop = &stop});
    if (!stop) continue;
    const StudyReport resumed =
        run_in(folder.path(), study, FormulaSimulator(formula_of({.half_step_damage_N = 3.0})));
    EXPECT_EQ(rows_digest(resumed.tables.rows), rows_digest(whole.tables.rows)) << runs_before;
    EXPECT_EQ(number_in(table_of(resumed, "set_points"), "set_point_N", 0),
              number_in(table_of(whole, "set_points"), "set_point_N", 0));
    EXPECT_EQ(resumed.warnings, whole.warnings);
  }
}

TEST(WindowStudy, ItsRowsGiveBackTheirScenarios) {
  const Study study = window_study(kTwoModuli);
  const StudyReport report = run_fresh(study, FormulaSimulator(formula_of({.half_step_damage_N = 3.0})));
  std::size_t halves = 0;
  for (const ScenarioRow& row : report.tables.rows) {
    const std::optional<Scenario> scenario = scenario_of_row(study, row);
    ASSERT_TRUE(scenario);
    EXPECT_EQ(scenario->strategy.grip_force_N, std::get<double>(row.inputs.back()));
    halves += scenario->simulation.time_step_s == 0.5 * kTimeStep ? 1U : 0U;
  }
  EXPECT_GT(halves, 3U);  // two forces at each end at least
}

TEST(StrategyFile, OfAWindowIsWhatACompareStudyTakes) {
  const TemporaryFolder folder("strategy");
  run_in(folder.path(),
         window_study("[[vary]]\nkey = \"strategy.approach_speed_m_s\"\nvalues = [0.05, 0.2]\n"
                      "[[strategy.waypoint]]\nplace_m = [0.0, 0.1, 0.2]\nrotation_rad = [0.0, 0.0, 0.5]\n"),
         FormulaSimulator(formula_of({})));
  const std::string file = (folder.path() / "strategy.toml").string();
  ASSERT_TRUE(std::filesystem::exists(file));
  const std::string compare = R"(
[[random]]
key = "product.friction"
distribution = "uniform"
from = 0.4
to = 0.6
[[candidate]]
name = "found"
use = ")" + file + R"("
[[candidate]]
name = "other"
grip_force_N = 1.0
)";
  const Study study = study_of(head("compare", "compare") + compare);
  const StrategyParameters& found = study.candidates()[0].scenario.strategy;
  EXPECT_EQ(found.grip_force_N, 2.0);        // sqrt(1 x 4)
  EXPECT_EQ(found.approach_speed_m_s, 0.2);  // the shorter cycle
  EXPECT_EQ(found.contact_force_N, 0.2);     // window.from_N, below the default of 0.3 N
  ASSERT_EQ(found.waypoint.size(), 1U);
  EXPECT_EQ(found.waypoint[0].place_m, (std::array<double, 3>{0.0, 0.1, 0.2}));
  EXPECT_EQ(found.waypoint[0].rotation_rad, (std::array<double, 3>{0.0, 0.0, 0.5}));
}

TEST(StrategyFile, IsInTheTableBestAndSaysWhereItComesFrom) {
  const TemporaryFolder folder("strategy");
  const StudyReport report = run_in(folder.path(), window_study(kTwoModuli), FormulaSimulator(formula_of({})));
  const std::string text = text_attribute(table_of(report, "best"), "strategy_toml");
  EXPECT_EQ(text, *read_text_file(folder.path() / "strategy.toml"));
  for (const std::string part : {"formula_window", "config sha256 ", "digest of the results ",
                                 "set 2.5 N, may be off by 0.9", "for all youngs_modulus_Pa of the study"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
  }
}

TEST(StrategyFile, OfAnEarlierRunGoesWhereThereIsNoAnswer) {
  const TemporaryFolder folder("strategy");
  std::filesystem::create_directories(folder.path());
  std::ofstream(folder.path() / "strategy.toml") << "grip_force_N = 9.0\n";
  const Study hopeless = study_of(head("hopeless", "window") + "[window]\nfrom_N = 0.2\nto_N = 0.9\n");
  const StudyReport report = run_in(folder.path(), hopeless, FormulaSimulator(formula_of({})));
  EXPECT_FALSE(report.tables.window->rows[0].exists);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "strategy.toml"));
}

TEST(SweepStudy, AnswersWithASetPointAndNotWithTheEdgeOfDamageOnTheSoftestProduct) {
  const std::string forces = "[[vary]]\nkey = \"strategy.grip_force_N\"\nfrom = 0.5\nto = 5.0\ncount = 10\n";
  const StudyReport report =
      run_fresh(study_of(head("sweep", "sweep") + forces + kTwoModuli), FormulaSimulator(formula_of({})));
  const ResultTable& answer = table_of(report, "set_points");
  EXPECT_EQ(number_in(answer, "hold_force_N", 0), 1.5);
  EXPECT_EQ(number_in(answer, "damage_force_N", 0), 4.0);
  EXPECT_EQ(number_in(answer, "set_point_N", 0), 2.5);
  const std::vector<std::string> lines = summary_lines(report.tables, "sweep");
  const std::string set_point = "set-point: set 2.5 N, may be off by 1 N either way, for all youngs_modulus_Pa";
  EXPECT_NE(std::find(lines.begin(), lines.end(), set_point), lines.end());
}

const std::string kForces = "[[vary]]\nkey = \"strategy.grip_force_N\"\nfrom = 0.5\nto = 5.0\ncount = 10\n";

TEST(SweepStudy, LooksAgainAtEndsThatRestOnAnImpactWhichTheStepDoesNotResolve) {
  const Study study = study_of(head("sweep", "sweep") + kForces + kTwoModuli);
  const StudyReport report =
      run_fresh(study, FormulaSimulator(formula_of({.half_step_damage_N = 3.0, .rise_steps = 2.0})));
  const WindowTable& window = report.tables.window.value();
  // Known as well as the grid has it: half a newton.
  EXPECT_LE(window.rows[0].damage_force_half_step_N, 3.0);
  EXPECT_GE(window.rows[0].damage_force_half_step_N, 2.5);
  EXPECT_EQ(window.rows[0].hold_force_half_step_N, 1.0);
  EXPECT_TRUE(std::isnan(window.rows[1].damage_force_half_step_N)) << "its impacts are resolved";
  EXPECT_EQ(window.rows[0].damage_force_N, 4.0) << "the answer of the step as written stays";
  EXPECT_LT(number_in(table_of(report, "set_points"), "set_point_N", 0), 2.5) << "between 1.5 and 3 N";
  ASSERT_EQ(report.warnings.size(), 2U);
  EXPECT_TRUE(report.warnings[0].starts_with("F_damage falls from 4 to ")) << report.warnings[0];
  EXPECT_EQ(report.tables.rows.size(), study.scenario_count()) << "what is run again is no row of the study";
  const std::vector<std::string> lines = summary_lines(report.tables, "sweep");
  EXPECT_TRUE(std::any_of(lines.begin(), lines.end(), [](const std::string& line) {
    return line.starts_with("checked at half the time step, ") &&
           line.find(": F_hold stays at 1 N, F_damage falls from 4 to ") != std::string::npos;
  })) << ::testing::PrintToString(lines);
}

TEST(SweepStudy, LeavesEndsAloneWhoseImpactsAreResolved) {
  const StudyReport report = run_fresh(study_of(head("sweep", "sweep") + kForces + kTwoModuli),
                                       FormulaSimulator(formula_of({.half_step_damage_N = 3.0})));
  EXPECT_TRUE(std::isnan(report.tables.window->rows[0].damage_force_half_step_N));
  EXPECT_TRUE(report.warnings.empty());
}

TEST(SweepStudy, SaysThatItsBestStrategyDoesNotSurviveHalfTheStep) {
  const std::string speeds = "[[vary]]\nkey = \"strategy.approach_speed_m_s\"\nvalues = [0.05, 0.2]\n";
  const Study study = study_of(head("sweep", "sweep") + speeds + kTwoModuli, {"strategy.grip_force_N=3.5"});
  const StudyReport marked =
      run_fresh(study, FormulaSimulator(formula_of({.half_step_damage_N = 3.0, .rise_steps = 1.0})));
  // Of its two runs the one on 1 MPa has an impact.
  const ResultTable& checks = table_of(marked, "verification");
  EXPECT_EQ(text_in(checks, "change", 1), "simulation.time_step_s = 0.0005");
  EXPECT_EQ(number_in(checks, "feasible", 1), 0.0);
  EXPECT_EQ(text_in(checks, "outcomes", 1), "held 1, damaged 1");
  EXPECT_NEAR(number_in(checks, "peak_finger_force_N", 1), 4.0 * 3.5 / 3.0, 1e-12);
  EXPECT_TRUE(marked.warnings[0].starts_with(
      "the winner does not stand a check: with half the time step (simulation.time_step_s = 0.0005) the best "
      "strategy is held in 1 of 2 runs only (held 1, damaged 1)"))
      << marked.warnings[0];
  EXPECT_EQ(number_in(table_of(marked, "best"), "strategy.approach_speed_m_s", 0), 0.2) << "it is not replaced";
  const StudyReport stays = run_fresh(study, FormulaSimulator(formula_of({.rise_steps = 1.0})));
  EXPECT_EQ(summary_lines(stays.tables, "sweep").back(),
            "checked, half the time step: the best strategy stays held; cycle_time_s 2.8 (2.8 as found), largest "
            "peak_finger_force_N 3.5 (3.5 as found); 1 run repeated, whose impact the step does not resolve");
  EXPECT_EQ(find_table(run_fresh(study, FormulaSimulator(formula_of({}))).tables.found, "verification"), nullptr);
}

TEST(SweepStudy, WithoutGripForcesAnswersWithTheFastestStrategyThatHoldsOverAllProducts) {
  const std::string speeds = "[[vary]]\nkey = \"strategy.approach_speed_m_s\"\nvalues = [0.05, 0.2]\n";
  const std::string text = head("sweep", "sweep") + speeds + kTwoModuli;
  const StudyReport held =
      run_fresh(study_of(text, {"strategy.grip_force_N=2.0"}), FormulaSimulator(formula_of({})));
  EXPECT_EQ(
      summary_lines(held.tables, "sweep").back(),
      "best: approach_speed_m_s = 0.2: the shortest cycle, 2.8 s, of 2 strategies held without damage over all "
      "youngs_modulus_Pa");
  const StudyReport slips =
      run_fresh(study_of(text, {"strategy.grip_force_N=1.2"}), FormulaSimulator(formula_of({})));
  EXPECT_EQ(summary_lines(slips.tables, "sweep").back(),
            "best: none; no strategy is held without damage over all youngs_modulus_Pa");
}

}  // namespace
}  // namespace unbruised::studies::testing

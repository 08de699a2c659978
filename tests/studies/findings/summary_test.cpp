#include "studies/findings/summary.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "studies/findings/grip_window.hpp"
#include "studies/findings/window_lines.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

ScenarioRow row_of(std::uint64_t id, Outcome outcome, double cycle_time_s, double margin) {
  ScenarioRow row;
  row.id = id;
  row.result.outcome = outcome;
  row.result.metrics[Metric::cycle_time_s] = cycle_time_s;
  row.result.metrics[Metric::friction_margin_min] = margin;
  row.inputs = {0.5 * static_cast<double>(id)};
  return row;
}

TEST(Summary, TheBestRowIsHeldThenShortThenFirst) {
  const std::vector<ScenarioRow> rows = {row_of(0, Outcome::damaged, 1.0, 9.0), row_of(1, Outcome::held, 2.0, 0.1),
                                         row_of(2, Outcome::held, 2.0, 0.4), row_of(3, Outcome::held, 3.0, 9.0),
                                         row_of(4, Outcome::held, 2.0, kAbsent)};
  ASSERT_TRUE(best_row(rows));
  EXPECT_EQ(best_row(rows)->id, 1U);
  EXPECT_FALSE(best_row({rows[0]}));
}

TEST(Summary, GivesNoBestOfASearchBeforeItsEnd) {
  StudyTables tables;
  tables.inputs = {{"strategy.grip_force_N", "N", ""}};
  tables.rows = {row_of(0, Outcome::held, 1.0, 9.0)};
  EXPECT_TRUE(summary_lines(tables, "simulate").back().starts_with("best: scenario 0"));
  EXPECT_EQ(summary_lines(tables, "sweep").back(), "answer: none yet; a study of kind sweep has it at its end");
  EXPECT_EQ(summary_lines(tables, "robust").back(), "answer: none yet; a study of kind robust has it at its end");
}

TEST(Summary, TheAnswerInALineIsTheBestElseTheOutcomeOfTheOnlyScenario) {
  StudyTables tables;
  tables.inputs = {{"strategy.grip_force_N", "N", ""}};
  std::vector<ScenarioRow> rows = {row_of(0, Outcome::damaged, 1.0, 9.0)};
  rows[0].result.cause = "contact_yield_ratio_max > limits.contact_yield_ratio";
  tables.rows = rows;
  EXPECT_EQ(answer_line(tables, "simulate"), "damaged: contact_yield_ratio_max > limits.contact_yield_ratio");
  rows.push_back(row_of(1, Outcome::held, 2.0, 0.1));
  tables.rows = rows;
  EXPECT_TRUE(answer_line(tables, "simulate").starts_with("best: scenario 1")) << answer_line(tables, "simulate");
}

TEST(Summary, SaysThatNobodyLookedAtDamageBeforeAnythingElseIsClaimed) {
  StudyTables tables;
  tables.rows = {row_of(0, Outcome::slipped, 1.0, 9.0)};
  tables.damage_note = "damage was not looked at: no limit of damage can act";
  const std::vector<std::string> lines = summary_lines(tables, "simulate");
  EXPECT_EQ(lines.at(1), tables.damage_note);
  EXPECT_EQ(lines.back(), "best: none; no scenario was held");
}

TEST(Summary, AWindowWithoutAJudgementOfDamageHasNoUpperEnd) {
  std::vector<GripSample> samples;
  for (const double force_N : {1.0, 2.0, 4.0}) {
    samples.push_back({.grip_force_N = force_N,
                       .holds = force_N < 2.0 ? Verdict::no : Verdict::yes,
                       .undamaged = Verdict::yes,
                       .damage = DamageClaim::not_considered});
  }
  WindowTable window;
  window.rows = {read_grip_window(samples)};
  EXPECT_TRUE(window.rows[0].exists);
  EXPECT_TRUE(std::isnan(window.rows[0].damage_bracket_low_N)) << "4 N are not known to do no damage";
  EXPECT_EQ(window_lines(window, nullptr, 10).at(0),
            "grip window: held from 2 N on (F_hold in (1, 2]); damage was not considered");
}

TEST(Summary, SaysPlainlyWhereThereIsNoWindow) {
  WindowTable window;
  window.inputs = {{.key = "strategy.approach_speed_m_s", .units = "m s-1", .long_name = {}}};
  WindowRow good;
  good.inputs = {0.05};
  good.exists = true;
  good.margin = 1.0;
  good.hold_force_N = good.hold_bracket_high_N = 1.0;
  good.hold_bracket_low_N = 0.9;
  good.damage_force_N = good.damage_bracket_low_N = 2.0;
  good.damage_bracket_high_N = 2.2;
  WindowRow none;
  none.inputs = {0.25};
  none.note = "no window: the impact alone damages at this speed";
  window.rows = {good, none};
  const std::vector<std::string> lines = window_lines(window, nullptr, 10);
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(
      lines[0],
      "grip window at approach_speed_m_s = 0.05: [1, 2] N, margin 100 % (F_hold in (0.9, 1], F_damage in [2, "
      "2.2))");
  EXPECT_EQ(lines[1], "no window at approach_speed_m_s = 0.25: the impact alone damages at this speed");
}

TEST(Summary, TellsOfManyKeysOnlyThoseThatDifferFromTheFirstCombination) {
  WindowTable window;
  for (const char* key : {"product.mass_kg", "product.friction", "gripper.finger_mass_kg", "gripper.stroke_m"}) {
    window.inputs.push_back({.key = key, .units = "1", .long_name = {}});
  }
  WindowRow row;
  row.note = "no window: dropped at every force";
  row.inputs = {0.1, 0.5, 0.2, 0.04};
  window.rows = {row, row};
  window.rows[1].inputs[1] = 0.4;
  const std::vector<std::string> lines = window_lines(window, nullptr, 10);
  EXPECT_EQ(lines.at(0),
            "no window at mass_kg = 0.1, friction = 0.5, finger_mass_kg = 0.2, stroke_m = 0.04: dropped at every "
            "force");
  EXPECT_EQ(lines.at(1), "no window at friction = 0.4, else as the first: dropped at every force");
}

TEST(Summary, TellsAWideWindowAsAFactor) {
  WindowRow row;
  row.exists = true;
  row.hold_force_N = row.hold_bracket_high_N = 0.5;
  row.hold_bracket_low_N = 0.49;
  row.damage_force_N = row.damage_bracket_low_N = 15.0;
  row.damage_bracket_high_N = 15.1;
  row.margin = row.damage_force_N / row.hold_force_N - 1.0;
  WindowTable window;
  window.rows = {row};
  EXPECT_EQ(
      window_lines(window, nullptr, 10).at(0),
      "grip window: [0.5, 15] N, F_damage is 30 times F_hold (F_hold in (0.49, 0.5], F_damage in [15, 15.1))");
}

TEST(Summary, ShowsTheMostSeriousRowsWithTheirCommand) {
  StudyTables tables;
  std::vector<ScenarioRow> rows = {row_of(0, Outcome::damaged, 1, 1), row_of(1, Outcome::held, 1, 1),
                                   row_of(2, Outcome::diverged, 1, 1)};
  rows[2].result.cause = "not finite";
  tables.rows = rows;
  const std::vector<std::string> lines = replay_lines(tables, "unbruised run a.toml --scenario");
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_EQ(lines[1], "  unbruised run a.toml --scenario 2   # diverged: not finite");
}

TEST(NumberText, IsForPeople) {
  EXPECT_EQ(short_number(1.23456), "1.235");
  EXPECT_EQ(with_thousands(1234567), "1,234,567");
  EXPECT_EQ(with_thousands(999), "999");
  EXPECT_EQ(duration_text(200.0), "3 min 20 s");
  EXPECT_EQ(duration_text(7500.0), "2 h 5 min");
  EXPECT_EQ(bytes_text(3.4e9), "3.4 GB");
}

}  // namespace
}  // namespace unbruised::studies

#include "studies/findings/window_answer.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "studies/findings/summary.hpp"
#include "studies/findings/table_text.hpp"
#include "studies/findings/window_lines.hpp"

namespace unbruised::studies {
namespace {

WindowRow row_of(std::vector<InputValue> inputs, double hold_N, double damage_N) {
  WindowRow row;
  row.inputs = std::move(inputs);
  row.exists = hold_N <= damage_N;
  row.hold_force_N = row.hold_bracket_high_N = hold_N;
  row.hold_bracket_low_N = 0.99 * hold_N;
  row.damage_force_N = row.damage_bracket_low_N = damage_N;
  row.damage_bracket_high_N = 1.01 * damage_N;
  row.margin = damage_N / hold_N - 1.0;
  return row;
}

ScenarioRow held_row(std::vector<InputValue> inputs, double cycle_time_s) {
  ScenarioRow row;
  row.inputs = std::move(inputs);
  row.result.outcome = Outcome::held;
  row.result.metrics[Metric::cycle_time_s] = cycle_time_s;
  return row;
}

ForceSetting any_force(std::size_t /*row*/) {
  return {.min_N = 0.0, .max_N = INFINITY, .accuracy = 0.0, .step_N = 0.0};
}

const std::vector<ColumnInfo> kInputs = {{"strategy.grip_force_N", "N", ""},
                                         {"product.youngs_modulus_Pa", "Pa", ""},
                                         {"strategy.approach_speed_m_s", "m s-1", ""}};

WindowTable two_speeds() {
  WindowTable window;
  window.inputs = {kInputs[1], kInputs[2]};
  window.rows = {row_of({1e5, 0.1}, 1.0, 4.0), row_of({1e5, 0.2}, 1.0, 3.0), row_of({2e5, 0.1}, 2.0, 8.0),
                 row_of({2e5, 0.2}, 3.5, 8.0)};
  return window;
}

TEST(WindowAnswer, ChoosesNoKeyOfTheProduct) {
  const std::vector<ScenarioRow> rows = {held_row({2.0, 1e5, 0.1}, 3.0), held_row({4.0, 2e5, 0.1}, 3.2),
                                         held_row({3.0, 2e5, 0.1}, 3.1)};
  const WindowAnswer answer = window_answer(two_speeds(), any_force, kInputs, rows);
  ASSERT_EQ(answer.strategies.size(), 2U);
  ASSERT_EQ(answer.keys.size(), 1U);
  EXPECT_EQ(answer.keys[0].key, "strategy.approach_speed_m_s");
  EXPECT_EQ(answer.over[0].key, "product.youngs_modulus_Pa");
  const StrategyWindow& slow = answer.strategies[0];
  EXPECT_TRUE(slow.exists);
  EXPECT_EQ(slow.hold_force_N, 2.0);
  EXPECT_EQ(slow.damage_force_N, 4.0);
  EXPECT_EQ(slow.hold_row, 2U);
  EXPECT_EQ(slow.damage_row, 0U);
  EXPECT_EQ(slow.set_point.force_N, 3.0);  // between 2 and 4: 2.83, of grids of 5, 2, 1 N
  EXPECT_EQ(slow.cycle_time_s, 3.1);       // the longest of the nearest held runs
  EXPECT_TRUE(slow.is_best);
  const StrategyWindow& fast = answer.strategies[1];  // holding 2e5 Pa needs 3.5 N, 1e5 Pa is marked from 3 N on
  EXPECT_FALSE(fast.exists);
  EXPECT_FALSE(fast.set_point.exists);
  EXPECT_FALSE(fast.is_best);
}

TEST(WindowAnswer, IsSaidWithWhatItHoldsOver) {
  const std::vector<ScenarioRow> rows = {held_row({2.0, 1e5, 0.1}, 3.0), held_row({3.0, 2e5, 0.1}, 3.1)};
  const WindowTable window = two_speeds();
  const ResultTable table = set_points_table(window_answer(window, any_force, kInputs, rows));
  const std::vector<std::string> lines = window_lines(window, &table, 10);
  ASSERT_EQ(lines.size(), 9U);
  EXPECT_TRUE(lines[4].starts_with(
      "grip window over all youngs_modulus_Pa at approach_speed_m_s = 0.1: [2, 4] N (F_hold in (1.98, 2]"))
      << lines[4];
  EXPECT_EQ(
      lines[5],
      "set-point at approach_speed_m_s = 0.1: set 3 N, may be off by 1 N either way, for all youngs_modulus_Pa");
  EXPECT_EQ(
      lines[6],
      "no window common to all youngs_modulus_Pa at approach_speed_m_s = 0.2: holding needs 3.5 N at "
      "youngs_modulus_Pa = 2e+05, approach_speed_m_s = 0.2, but damage begins above 3 N at youngs_modulus_Pa "
      "= 1e+05, approach_speed_m_s = 0.2");
  EXPECT_EQ(lines[7], "no set-point at approach_speed_m_s = 0.2: no window common to all");
  EXPECT_EQ(
      lines[8],
      "best: set 3 N, may be off by 1 N either way with approach_speed_m_s = 0.1: the shortest cycle, 3.1 s, "
      "of 1 strategy with a set-point");
}

TEST(WindowAnswer, TellsOfTheFastestWithASetPointInOneSentence) {
  const std::vector<ScenarioRow> rows = {held_row({2.0, 1e5, 0.1}, 3.0), held_row({3.0, 2e5, 0.1}, 3.1)};
  const ResultTable table = set_points_table(window_answer(two_speeds(), any_force, kInputs, rows));
  EXPECT_EQ(number_attribute(table, "told"), 0.0);
  EXPECT_EQ(text_attribute(table, "answer"),
            "set 3 N, may be off by 1 N either way (F_hold 2 N, F_damage 4 N; approach speed 0.1 m/s)");
}

TEST(WindowAnswer, TellsOfAWindowWithoutASetPointAndOfNone) {
  WindowTable window;
  window.inputs = {kInputs[2]};
  window.rows = {row_of({0.1}, 4.0, 3.0), row_of({0.2}, 1.0, 2.0)};
  const SettingOfRow strong = [](std::size_t) { return ForceSetting{.min_N = 3.0, .max_N = 40.0}; };
  const ResultTable table = set_points_table(window_answer(window, strong, kInputs, {}));
  EXPECT_EQ(number_attribute(table, "told"), 1.0);  // the one with a window
  EXPECT_EQ(text_attribute(table, "answer"),
            "not for this gripper: it cannot hold less than 3 N, and the product is marked from 2 N on (F_hold 1 "
            "N, F_damage 2 N; approach speed 0.2 m/s)");
  window.rows.pop_back();
  EXPECT_EQ(text_attribute(set_points_table(window_answer(window, any_force, kInputs, {})), "answer"),
            "no window (approach speed 0.1 m/s)");
}

TEST(WindowAnswer, ClaimsNothingOfForcesThatWereNotTried) {
  // Held and unmarked at every force tried: 3.2 N and more with one product, 1.4 N and less with the other.
  WindowTable window;
  window.inputs = {kInputs[1]};
  window.rows = {row_of({1e5}, 1.0, 1.4), row_of({2e5}, 3.2, 5.0)};
  window.rows[0].damage_bracket_high_N = kAbsent;
  window.rows[1].hold_bracket_low_N = kAbsent;
  const ResultTable table = set_points_table(window_answer(window, any_force, kInputs, {}));
  EXPECT_EQ(
      window_lines(window, &table, 10).at(2),
      "no force was tried that could suit all youngs_modulus_Pa: forces from 3.2 N on at youngs_modulus_Pa = "
      "2e+05, up to 1.4 N at youngs_modulus_Pa = 1e+05");
}

TEST(WindowAnswer, NamesTheGripperFirstWhereItIsTheReason) {
  WindowTable window;
  window.inputs = {kInputs[2]};
  window.rows = {row_of({0.1}, 1.0, 2.0)};
  const SettingOfRow strong = [](std::size_t) { return ForceSetting{.min_N = 3.0, .max_N = 40.0}; };
  const ResultTable table = set_points_table(window_answer(window, strong, kInputs, {}));
  EXPECT_EQ(window_lines(window, &table, 10).at(1),
            "not for this gripper at approach_speed_m_s = 0.1: it cannot hold less than 3 N, and the product is "
            "marked from 2 N on");
}

TEST(WindowAnswer, TheShortestCycleWinsAndNotTheMarginAgainstSlip) {
  WindowTable window;
  window.inputs = {kInputs[2]};
  window.rows = {row_of({0.1}, 1.0, 9.0), row_of({0.2}, 1.0, 4.0)};
  const std::vector<ScenarioRow> rows = {held_row({3.0, 1e5, 0.1}, 3.0), held_row({2.0, 1e5, 0.2}, 2.5)};
  const WindowAnswer answer = window_answer(window, any_force, kInputs, rows);
  EXPECT_TRUE(answer.strategies[1].is_best);
  EXPECT_EQ(answer.strategies[1].set_point.force_N, 2.0);
}

TEST(WindowAnswer, EachGripperHasABestOfItsOwn) {
  WindowTable window;
  window.inputs = {{"gripper.finger_mass_kg", "kg", ""}};
  window.rows = {row_of({0.1}, 1.0, 4.0), row_of({0.2}, 1.0, 4.0)};
  const WindowAnswer answer = window_answer(window, any_force, kInputs, {});
  EXPECT_TRUE(answer.strategies[0].is_best);
  EXPECT_TRUE(answer.strategies[1].is_best);
}

TEST(WindowAnswer, TheNarrowerEndsOfHalfTheTimeStepCount) {
  WindowTable window;
  window.inputs = {kInputs[1]};
  window.rows = {row_of({1e5}, 1.0, 9.0), row_of({2e5}, 2.0, 8.0)};
  window.rows[1].hold_force_half_step_N = 1.9;    // wider: not believed
  window.rows[1].damage_force_half_step_N = 4.0;  // half as much
  add_set_points(window, any_force);
  EXPECT_EQ(window.rows[0].set_point_N, 3.0);  // sqrt(1 x 9)
  EXPECT_EQ(window.rows[1].set_point_N, 3.0);  // sqrt(2 x 4) = 2.83
  const WindowAnswer answer = window_answer(window, any_force, kInputs, {});
  EXPECT_EQ(answer.strategies[0].damage_force_N, 8.0);     // as found
  EXPECT_EQ(answer.strategies[0].set_point.force_N, 3.0);  // sqrt(2 x 4)
  EXPECT_EQ(answer.strategies[0].set_point.tolerance_N, 1.0);
}

}  // namespace
}  // namespace unbruised::studies

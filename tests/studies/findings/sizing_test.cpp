// The sizing sheet: what the rules ask for against closed forms, where it lies in a window, and what a gripper
// bears.

#include "studies/findings/sizing.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "studies/findings/table_text.hpp"

namespace unbruised::studies {
namespace {

constexpr double kGravity = 9.80665;

/// 95 g at a friction of 0.6, lifted with 2 m/s2.
Scenario kiwi() {
  LatticeParameters product;
  product.size_m = {0.05, 0.07, 0.05};
  product.mass_kg = 0.095;
  product.friction = 0.6;
  Scenario scenario;
  scenario.product = product;
  scenario.gripper = ParallelJawParameters{};
  scenario.strategy.lift_acceleration_m_s2 = 2.0;
  return scenario;
}

StrategyWindow window_of(double hold_N, double damage_N) {
  StrategyWindow strategy;
  strategy.rows = {0};
  strategy.exists = hold_N <= damage_N;
  strategy.hold_force_N = hold_N;
  strategy.damage_force_N = damage_N;
  strategy.set_point.exists = strategy.exists;
  strategy.set_point.force_N = std::sqrt(hold_N * damage_N);
  strategy.set_point.sentence = "set it";
  strategy.is_best = true;
  return strategy;
}

ResultTable sheet(const Scenario& scenario, const StrategyWindow& strategy) {
  WindowAnswer answer;
  answer.strategies = {strategy};
  return sizing_table(answer, [&](std::size_t) { return scenario; });
}

std::size_t row_of(const ResultTable& table, const std::string& item) {
  for (std::size_t i = 0; i < row_count(table); ++i) {
    if (text_in(table, "item", i) == item) return i;
  }
  ADD_FAILURE() << "no item " << item;
  return 0;
}
double value(const ResultTable& table, const std::string& item) {
  return number_in(table, "value", row_of(table, item));
}
std::string verdict(const ResultTable& table, const std::string& item) {
  return text_in(table, "verdict", row_of(table, item));
}

TEST(Sizing, ReckonsTheRulesOfEachFinger) {
  const ResultTable table = sheet(kiwi(), window_of(1.0, 3.0));
  const double just_N = 0.095 * (kGravity + 2.0) / (2.0 * 0.6);
  EXPECT_NEAR(value(table, "just_holds"), just_N, 1e-12);
  EXPECT_NEAR(value(table, "maker_rule"), 2.0 * just_N, 1e-12) << "2 where no safety factor is given";
  EXPECT_NEAR(value(table, "pneumatic_rule"), 0.5 * 13.0 * 0.095 * kGravity, 1e-12);
  const std::size_t pneumatic = row_of(table, "pneumatic_rule");
  EXPECT_NEAR(number_in(table, "together", pneumatic), 12.1, 0.02) << "13 m g of the kiwi, both fingers";
  EXPECT_NEAR(value(table, "emergency_stop"), 0.095 * (kGravity + 10.0) / (2.0 * 0.6), 1e-12);
  EXPECT_NEAR(value(table, "margin"), 3.0, 1e-12);
}

TEST(Sizing, TakesTheMakersSafetyFactorAndTheNumberOfFingers) {
  Scenario scenario = kiwi();
  jaw_of(scenario).safety_factor = 2.4;
  jaw_of(scenario).finger.resize(3);
  const ResultTable table = sheet(scenario, window_of(1.0, 3.0));
  EXPECT_NEAR(value(table, "maker_rule"), 2.4 * 0.095 * (kGravity + 2.0) / (3.0 * 0.6), 1e-12);
  EXPECT_NEAR(number_in(table, "together", row_of(table, "maker_rule")), 2.4 * 0.095 * (kGravity + 2.0) / 0.6,
              1e-12);
}

TEST(Sizing, TakesTheLargestAccelerationOfThePath) {
  Scenario scenario = kiwi();
  scenario.strategy.lower_acceleration_m_s2 = 3.0;
  scenario.strategy.transfer_acceleration_m_s2 = 5.0;
  EXPECT_EQ(value(sheet(scenario, window_of(1.0, 3.0)), "acceleration"), 5.0);
  scenario.cell.transfer_m = {0.0, 0.0};
  EXPECT_EQ(value(sheet(scenario, window_of(1.0, 3.0)), "acceleration"), 3.0);
}

TEST(Sizing, SaysWhereARuleLiesInTheWindow) {
  const ResultTable table = sheet(kiwi(), window_of(1.0, 3.0));
  EXPECT_EQ(verdict(table, "just_holds"), "too weak");
  EXPECT_EQ(verdict(table, "maker_rule"), "inside");
  EXPECT_EQ(verdict(table, "pneumatic_rule"), "too strong");
  EXPECT_EQ(text_in(table, "says", row_of(table, "pneumatic_rule")),
            "the rule of thumb for pneumatic grippers, 13 m g, asks for 6.06 N on each of 2 fingers, 12.1 N "
            "together, above the window: it marks the product");
  StrategyWindow bound = window_of(1.0, 3.0);
  bound.hold_is_bound = bound.damage_is_bound = true;
  EXPECT_EQ(verdict(sheet(kiwi(), bound), "just_holds"), "not tried");
  EXPECT_EQ(verdict(sheet(kiwi(), bound), "pneumatic_rule"), "not tried");
  StrategyWindow unjudged = window_of(1.0, 3.0);
  unjudged.damage_force_N = kAbsent;
  EXPECT_EQ(verdict(sheet(kiwi(), unjudged), "pneumatic_rule"), "holds");
  StrategyWindow none = window_of(4.0, 1.5);
  EXPECT_EQ(verdict(sheet(kiwi(), none), "maker_rule"), "too weak") << "no window, and it does not hold";
}

TEST(Sizing, HoldsTheForceToSetAgainstWhatTheGripperAllows) {
  Scenario scenario = kiwi();
  ResultTable table = sheet(scenario, window_of(1.0, 4.0));  // 2 N
  EXPECT_EQ(verdict(table, "payload"), "not given");
  EXPECT_EQ(verdict(table, "jaw_moment"), "not given");
  EXPECT_EQ(verdict(table, "largest_force"), "within");
  EXPECT_EQ(verdict(table, "emergency_stop"), "held");
  jaw_of(scenario).payload_kg = 0.05;
  jaw_of(scenario).finger_length_m = 0.1;
  jaw_of(scenario).jaw_moment_N_m = 0.3;
  scenario.cell.stop_deceleration_m_s2 = 30.0;
  table = sheet(scenario, window_of(1.0, 4.0));
  EXPECT_EQ(verdict(table, "payload"), "beyond");
  EXPECT_EQ(verdict(table, "jaw_moment"), "within");
  EXPECT_NEAR(value(table, "jaw_moment"), 0.2, 1e-12);
  EXPECT_EQ(verdict(table, "emergency_stop"), "slips");
  // 2 N hold (2 x 2 x 0.6 / 0.095) - g.
  EXPECT_NE(text_in(table, "says", row_of(table, "emergency_stop")).find("hold 15.5 m/s2"), std::string::npos)
      << text_in(table, "says", row_of(table, "emergency_stop"));
}

TEST(Sizing, TakesTheProductThatAsksForMost) {
  StrategyWindow strategy = window_of(1.0, 3.0);
  strategy.rows = {0, 1};
  WindowAnswer answer;
  answer.strategies = {strategy};
  const ResultTable table = sizing_table(answer, [&](std::size_t row) {
    Scenario scenario = kiwi();
    if (row == 1) std::get<LatticeParameters>(scenario.product).mass_kg = 0.12;
    return scenario;
  });
  EXPECT_NEAR(value(table, "mass"), 0.12, 1e-12);
}

TEST(Sizing, TellsTheRulesAndWhatIsBeyondItsLimit) {
  Scenario scenario = kiwi();
  jaw_of(scenario).payload_kg = 0.05;
  WindowAnswer answer;
  answer.strategies = {window_of(1.0, 3.0)};
  const std::vector<ResultTable> tables = {set_points_table(answer),
                                           sizing_table(answer, [&](std::size_t) { return scenario; })};
  const std::vector<std::string> lines = sizing_lines(tables);
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_TRUE(lines[0].starts_with("sizing: the makers' rule, m (g + a) S / mu with S = 2 (assumed), asks for"));
  EXPECT_TRUE(lines[1].starts_with("sizing: the rule of thumb for pneumatic grippers"));
  EXPECT_TRUE(lines[2].starts_with("sizing: the mass carried by friction, 0.095 kg, is more than"));
  EXPECT_TRUE(sizing_lines({}).empty());
}

}  // namespace
}  // namespace unbruised::studies

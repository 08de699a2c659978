// A sweep without windows: which strategy is held over all products, and what follows the product is none.

#include "studies/findings/grid_answer.hpp"

#include <gtest/gtest.h>

#include "studies/findings/table_text.hpp"

namespace unbruised::studies {
namespace {

ScenarioRow row_of(std::vector<InputValue> inputs, double cycle_time_s, Outcome outcome = Outcome::held) {
  ScenarioRow row;
  row.result.outcome = outcome;
  row.result.metrics[Metric::cycle_time_s] = cycle_time_s;
  row.inputs = std::move(inputs);
  return row;
}

std::vector<ScenarioRow> numbered(std::vector<ScenarioRow> rows) {
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i].id = i;
  return rows;
}

const ColumnInfo kProduct{"product.use", "", ""};
const ColumnInfo kSpeed{"strategy.speed_m_s", "m s-1", ""};
const ColumnInfo kForce{"strategy.grip_force_N", "N", ""};
const ColumnInfo kGripper{"gripper.use", "", ""};
const std::string kKiwi = "kiwi.toml";
const std::string kApple = "apple.toml";

TEST(GridAnswer, TakesTheFastestStrategyThatIsHeldOverAllProducts) {
  const GridAnswer answer = grid_answer(
      {kProduct, kSpeed}, numbered({row_of({kKiwi, 0.5}, 3.0), row_of({kApple, 0.5}, 3.1),
                                    row_of({kKiwi, 1.0}, 2.0), row_of({kApple, 1.0}, 2.1, Outcome::dropped),
                                    row_of({kKiwi, 0.7}, 2.5), row_of({kApple, 0.7}, 2.6)}));
  ASSERT_TRUE(answer.best);
  EXPECT_EQ(*answer.best, 4U);  // the first row of 0.7 m/s; at 1 m/s the apple falls
  EXPECT_EQ(std::get<double>(answer.best_values.at(0)), 0.7);
  EXPECT_TRUE(answer.following.empty());
  EXPECT_EQ(number_in(answer.table, "cycle_time_s", 2), 2.6);  // the longest of the products
}

TEST(GridAnswer, AForceForEachFruitFollowsTheFruitAndIsNoStrategy) {
  const std::string soft = "soft.toml";
  const std::string firm = "firm.toml";
  const GridAnswer answer =
      grid_answer({kProduct, kForce, kGripper},
                  numbered({row_of({kKiwi, 1.4, soft}, 3.0), row_of({kKiwi, 1.4, firm}, 3.0, Outcome::damaged),
                            row_of({kApple, 3.2, soft}, 3.1), row_of({kApple, 3.2, firm}, 3.1)}));
  ASSERT_EQ(answer.following.size(), 1U);
  EXPECT_EQ(answer.following[0].key, kForce.key);
  EXPECT_EQ(text_attribute(answer.table, "over"), "product.use, grip_force_N");
  ASSERT_EQ(row_count(answer.table), 2U) << "the grippers";
  EXPECT_EQ(number_in(answer.table, "held", 0), 2.0);
  EXPECT_EQ(number_in(answer.table, "held", 1), 1.0);
  ASSERT_TRUE(answer.best);
  EXPECT_EQ(std::get<std::string>(answer.best_values.at(0)), soft);
}

}  // namespace
}  // namespace unbruised::studies

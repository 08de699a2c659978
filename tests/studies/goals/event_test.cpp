// What counts as undamaged, not dropped, not slipped: never a product that was not kept.

#include "studies/goals/event.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "studies/goals/goal.hpp"

namespace unbruised::studies {
namespace {

OutcomeEvent event(std::string_view text) { return parse_constraint(text, GoalContext::single).value().event; }

ScenarioResult ended(Outcome outcome, double plastic_strain = 0.0) {
  ScenarioResult result;
  result.outcome = outcome;
  result.metrics[Metric::plastic_strain_max] = plastic_strain;
  result.metrics[Metric::slip_max_m] = outcome == Outcome::slipped ? 1.0 : 0.0;
  result.metrics[Metric::cycle_time_s] = 1.0;
  return result;
}

LimitParameters one_percent() {
  LimitParameters limits;
  limits.plastic_strain = 0.01;
  return limits;
}

TEST(Events, AProductThatIsNotKeptIsNeitherUndamagedNorUnslippedNorUndropped) {
  for (const Outcome outcome :
       {Outcome::dropped, Outcome::not_grasped, Outcome::diverged, Outcome::out_of_range, Outcome::not_run}) {
    for (const char* text : {"not damaged", "not slipped", "not dropped", "not not_grasped", "not diverged"}) {
      EXPECT_FALSE(event_happens(event(text), ended(outcome), one_percent()))
          << text << " of " << outcome_word(outcome);
      EXPECT_GT(event_measure(event(text), ended(outcome), one_percent()), 0.0);
    }
  }
}

TEST(Events, AProductThatSlippedIsDamagedWhenItExceedsALimit) {
  // The outcome names only the slip: it comes first.
  EXPECT_TRUE(event_happens(event("not damaged"), ended(Outcome::slipped, 0.005), one_percent()));
  EXPECT_FALSE(event_happens(event("not damaged"), ended(Outcome::slipped, 0.02), one_percent()));
  EXPECT_DOUBLE_EQ(event_measure(event("not damaged"), ended(Outcome::slipped, 0.02), one_percent()), 1.0);
  EXPECT_TRUE(event_happens(event("not damaged"), ended(Outcome::slipped, 0.02), {})) << "no limit, no damage";
  EXPECT_TRUE(event_happens(event("slipped"), ended(Outcome::slipped, 0.02), one_percent()));
}

TEST(Events, AProductThatStandsBesideItsPlaceIsKeptAndUndamagedButNotHeld) {
  LimitParameters limits;
  limits.place_error_m = 0.002;
  ScenarioResult result = ended(Outcome::misplaced);
  result.metrics[Metric::slip_max_rad] = 0.0;
  result.metrics[Metric::place_error_m] = 0.003;
  EXPECT_TRUE(event_happens(event("not damaged"), result, limits));
  EXPECT_TRUE(event_happens(event("misplaced"), result, limits));
  EXPECT_FALSE(event_happens(event("held"), result, limits));
  EXPECT_FALSE(event_happens(event("not misplaced"), result, limits));
  EXPECT_DOUBLE_EQ(event_measure(event("held"), result, limits), 0.5) << "half as far again as it may";
  result.outcome = Outcome::held;
  result.metrics[Metric::place_error_m] = 0.001;
  EXPECT_LE(event_measure(event("held"), result, limits), 0.0);
}

TEST(Events, WhoWantsDropsToCountWritesThem) {
  EXPECT_TRUE(event_happens(event("held or dropped"), ended(Outcome::dropped, 0.5), one_percent()));
  EXPECT_TRUE(event_happens(event("not damaged or dropped"), ended(Outcome::dropped), one_percent()));
  EXPECT_FALSE(event_happens(event("held or dropped"), ended(Outcome::not_grasped), one_percent()));
}

TEST(Events, AProductThatIsNotKeptHasNoObjectiveUnlessItsEndIsNamed) {
  const auto objective = parse_objective("plastic_strain_max", GoalContext::single).value();
  const auto time = parse_objective("cycle_time_s", GoalContext::single).value();
  const ScenarioResult dropped = ended(Outcome::dropped);
  EXPECT_TRUE(std::isnan(objective_value(objective, dropped)));
  EXPECT_EQ(objective_value(objective, dropped, event("held or dropped")), 0.0);
  EXPECT_TRUE(std::isnan(objective_value(time, dropped, event("held or dropped"))))
      << "without its product a cycle has no time";
  EXPECT_EQ(objective_value(time, ended(Outcome::slipped)), 1.0);
}

TEST(Events, AMeanTellsHowManyProductsItIsNotOf) {
  const auto mean = parse_objective("mean(cycle_time_s)", GoalContext::sampled).value();
  const std::vector<ScenarioResult> products = {ended(Outcome::held), ended(Outcome::dropped),
                                                ended(Outcome::slipped)};
  EXPECT_EQ(objective_value(mean, products), 1.0);
  EXPECT_EQ(products_without(mean, products), 1U);
}

}  // namespace
}  // namespace unbruised::studies

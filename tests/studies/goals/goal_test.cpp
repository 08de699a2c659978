// Goals evaluated: values computed by hand, and what holds for any results.

#include "studies/goals/goal.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace unbruised::studies {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Objective objective(std::string_view text) {
  Parsed<Objective> single = parse_objective(text, GoalContext::single);
  if (single.has_value()) return *std::move(single);
  return parse_objective(text, GoalContext::sampled).value();
}

Constraint constraint(std::string_view text) {
  Parsed<Constraint> single = parse_constraint(text, GoalContext::single);
  if (single.has_value()) return *std::move(single);
  return parse_constraint(text, GoalContext::sampled).value();
}

/// A run that was held, well inside the limits below.
ScenarioResult held_result() {
  ScenarioResult result;
  result.outcome = Outcome::held;
  result.metrics[Metric::cycle_time_s] = 2.0;
  result.metrics[Metric::peak_finger_force_N] = 3.0;
  result.metrics[Metric::friction_margin_min] = 0.25;
  result.metrics[Metric::permanent_set_max_m] = 2.5e-5;
  result.metrics[Metric::plastic_strain_max] = 0.005;
  result.metrics[Metric::slip_max_m] = 5e-4;
  result.metrics[Metric::slip_max_rad] = 0.25 * LimitParameters{}.slip_rad;
  return result;
}

LimitParameters two_limits() {
  LimitParameters limits;
  limits.permanent_set_m = 1e-4;
  limits.plastic_strain = 0.01;
  limits.slip_m = 2e-3;
  return limits;
}

std::vector<ScenarioResult> with_metric(Metric metric, const std::vector<double>& values) {
  std::vector<ScenarioResult> all;
  for (const double value : values) {
    all.push_back(held_result());
    all.back().metrics[metric] = value;
  }
  return all;
}

TEST(Goals, AnObjectiveIsTheWeightedSumOfItsMetrics) {
  EXPECT_EQ(objective_value(objective("cycle_time_s"), held_result()), 2.0);
  EXPECT_EQ(objective_value(objective("cycle_time_s + 0.5 * peak_finger_force_N - 4 * friction_margin_min"),
                            held_result()),
            2.0 + 1.5 - 1.0);
  EXPECT_TRUE(std::isnan(objective_value(objective("cycle_time_s + energy_input_J"), held_result())))
      << "energy_input_J is not there";
}

TEST(Goals, StatisticsOverProductsAreThoseOfTheirDefinitions) {
  const auto results = with_metric(Metric::cycle_time_s, {4.0, 1.0, 2.0, 3.0});
  EXPECT_EQ(objective_value(objective("mean(cycle_time_s)"), results), 2.5);
  EXPECT_EQ(objective_value(objective("worst(cycle_time_s)"), results), 4.0);
  // The k-th smallest of 4, k = ceil(4 p).
  EXPECT_EQ(objective_value(objective("quantile(cycle_time_s, 0.5)"), results), 2.0);
  EXPECT_EQ(objective_value(objective("quantile(cycle_time_s, 0.51)"), results), 3.0);
  EXPECT_EQ(objective_value(objective("quantile(cycle_time_s, 0.75)"), results), 3.0);
  EXPECT_EQ(objective_value(objective("mean(cycle_time_s) + 2 * worst(cycle_time_s)"), results), 10.5);
  EXPECT_EQ(objective_value(objective("-worst(cycle_time_s)"), results), -1.0)
      << "the worst of what is maximised is the least";
}

TEST(Goals, AProductWithoutTheMetricIsTheWorstOfAllAndNotInTheMean) {
  const auto one = with_metric(Metric::cycle_time_s, {1.0, 2.0, kNaN, 3.0});
  EXPECT_EQ(objective_value(objective("mean(cycle_time_s)"), one), 2.0);
  EXPECT_EQ(objective_value(objective("worst(cycle_time_s)"), one), kInfinity);
  EXPECT_EQ(objective_value(objective("-worst(cycle_time_s)"), one), kInfinity);
  EXPECT_EQ(objective_value(objective("quantile(cycle_time_s, 0.75)"), one), 3.0);
  EXPECT_EQ(objective_value(objective("quantile(cycle_time_s, 0.76)"), one), kInfinity);
  const auto half = with_metric(Metric::cycle_time_s, {1.0, kNaN, kNaN, 3.0});
  EXPECT_EQ(objective_value(objective("mean(cycle_time_s)"), half), 2.0);
  const auto fewer = with_metric(Metric::cycle_time_s, {1.0, kNaN, kNaN, kNaN});
  EXPECT_TRUE(std::isnan(objective_value(objective("mean(cycle_time_s)"), fewer)));
}

TEST(Goals, AMetricConstraintIsMeasuredInPartsOfItsBound) {
  const ScenarioResult result = held_result();
  const LimitParameters limits = two_limits();
  EXPECT_DOUBLE_EQ(violation(constraint("cycle_time_s <= 1.6"), result, limits), 0.25);  // 2 / 1.6 - 1
  EXPECT_DOUBLE_EQ(violation(constraint("cycle_time_s >= 1.6"), result, limits), -0.25);
  EXPECT_DOUBLE_EQ(violation(constraint("friction_margin_min >= 0.5"), result, limits), 0.5);
  EXPECT_DOUBLE_EQ(violation(constraint("friction_margin_min >= -0.5"), result, limits), -1.5);
  EXPECT_DOUBLE_EQ(violation(constraint("friction_margin_min >= 0"), result, limits), -0.25)
      << "a bound of zero: the value itself";
  EXPECT_EQ(violation(constraint("cycle_time_s <= 2"), result, limits), 0.0) << "on its bound it is met";
}

TEST(Goals, HeldIsOneComponentPerLimit) {
  const Constraint held = constraint("held");
  const LimitParameters limits = two_limits();
  const std::vector<std::string> names = violation_names(held, limits);
  const std::vector<double> parts = violations(held, held_result(), limits);
  ASSERT_EQ(names.size(), 5U);
  ASSERT_EQ(parts.size(), 5U);
  EXPECT_NE(names[0].find("limits.permanent_set_m"), std::string::npos);
  EXPECT_NE(names[1].find("limits.plastic_strain"), std::string::npos);
  EXPECT_NE(names[2].find("limits.slip_m"), std::string::npos);
  EXPECT_NE(names[3].find("limits.slip_rad"), std::string::npos);
  EXPECT_DOUBLE_EQ(parts[0], -0.75);
  EXPECT_DOUBLE_EQ(parts[1], -0.5);
  EXPECT_DOUBLE_EQ(parts[2], -0.75);
  EXPECT_DOUBLE_EQ(parts[3], -0.75);
  EXPECT_EQ(parts[4], -1.0) << "the cycle is completed";
  EXPECT_DOUBLE_EQ(violation(held, held_result(), limits), -0.5);
}

TEST(Goals, DamageShowsInTheComponentOfItsLimit) {
  ScenarioResult result = held_result();
  result.outcome = Outcome::damaged;
  result.metrics[Metric::permanent_set_max_m] = 1.5e-4;
  const std::vector<double> parts = violations(constraint("held"), result, two_limits());
  EXPECT_DOUBLE_EQ(parts[0], 0.5);
  EXPECT_DOUBLE_EQ(parts[1], -0.5);
  EXPECT_EQ(violation(constraint("not damaged"), result, two_limits()), parts[0]);
  EXPECT_LE(violation(constraint("not dropped"), result, two_limits()), 0.0);
}

TEST(Goals, AnEarlyEndHasARankThatGrowsWithHowEarlyItIs) {
  const Constraint held = constraint("held");
  double before = 0.0;
  for (const auto& [outcome, rank] : {std::pair{Outcome::dropped, 1.0}, std::pair{Outcome::not_grasped, 2.0},
                                      std::pair{Outcome::out_of_range, 3.0}, std::pair{Outcome::diverged, 4.0}}) {
    ScenarioResult result;  // no metric at all
    result.outcome = outcome;
    const std::vector<double> parts = violations(held, result, two_limits());
    EXPECT_EQ(parts, std::vector<double>(5, rank)) << outcome_word(outcome);
    EXPECT_EQ(violation(constraint("slip_max_m <= 1e-3"), result, two_limits()), rank);
    EXPECT_GT(rank, before);
    before = rank;
  }
}

TEST(Goals, AnEventWithoutHeldIsMetOrNot) {
  const Constraint slipped = constraint("slipped");
  EXPECT_EQ(violations(slipped, held_result(), two_limits()), std::vector<double>{1.0});
  ScenarioResult result = held_result();
  result.outcome = Outcome::slipped;
  EXPECT_EQ(violations(slipped, result, two_limits()), std::vector<double>{-1.0});
  EXPECT_EQ(violation_names(slipped, two_limits()), std::vector<std::string>{"slipped"});
}

TEST(Goals, AProbabilityIsMeasuredByTheQuantileOfItsViolations) {
  // Ten products with plastic strains of 10 % to 100 % of twice the limit: five of them are damaged.
  std::vector<ScenarioResult> results;
  for (int i = 1; i <= 10; ++i) {
    results.push_back(held_result());
    results.back().metrics[Metric::plastic_strain_max] = 0.002 * i;
    results.back().outcome = i > 5 ? Outcome::damaged : Outcome::held;
  }
  EXPECT_EQ(frequency(held_event(), results, two_limits()), 0.5);
  EXPECT_DOUBLE_EQ(violation(constraint("P(held) >= 0.5"), results, two_limits()), 0.0);
  EXPECT_DOUBLE_EQ(violation(constraint("P(held) >= 0.6"), results, two_limits()), 0.2);  // 0.012 / 0.01 - 1
  EXPECT_DOUBLE_EQ(violation(constraint("P(held) >= 1"), results, two_limits()), 1.0);
  EXPECT_LT(violation(constraint("P(held) >= 0.4"), results, two_limits()), 0.0);
}

TEST(Goals, AStatisticIsBoundedOverProducts) {
  const auto results = with_metric(Metric::friction_margin_min, {0.5, 0.1, 0.3, 0.2});
  EXPECT_DOUBLE_EQ(violation(constraint("worst(friction_margin_min) >= 0.2"), results, {}), 0.5)
      << "worst is the least";
  EXPECT_DOUBLE_EQ(violation(constraint("worst(friction_margin_min) <= 0.4"), results, {}), 0.25)
      << "worst is the largest";
  EXPECT_DOUBLE_EQ(violation(constraint("mean(friction_margin_min) >= 0.55"), results, {}), 0.5);
  const auto none = with_metric(Metric::friction_margin_min, {kNaN, kNaN});
  for (const char* text : {"worst(friction_margin_min) >= 0.2", "mean(friction_margin_min) >= 0.2",
                           "quantile(friction_margin_min, 0.5) <= 0.2"}) {
    const double broken = violation(constraint(text), none, {});
    EXPECT_TRUE(std::isfinite(broken) && broken > 0.0) << text << " gives " << broken;
  }
}

/// A result as the simulator makes them: the outcome agrees with the metrics and limits, but early ends have none.
ScenarioResult random_result(std::mt19937_64& random, const LimitParameters& limits) {
  const auto part = [&] { return 2e-3 * static_cast<double>(random() % 1000); };  // 0 .. 2 by steps, so 1 occurs
  ScenarioResult result;
  const unsigned dice = static_cast<unsigned>(random() % 12);
  if (dice < 4) {
    constexpr std::array<Outcome, 4> kEnds = {Outcome::dropped, Outcome::not_grasped, Outcome::diverged,
                                              Outcome::out_of_range};
    result.outcome = kEnds[dice];
    if (random() % 2 == 0) return result;
  }
  result.metrics[Metric::slip_max_m] = part() * limits.slip_m;
  result.metrics[Metric::cycle_time_s] = part();
  if (limits.permanent_set_m) result.metrics[Metric::permanent_set_max_m] = part() * *limits.permanent_set_m;
  if (limits.plastic_strain) result.metrics[Metric::plastic_strain_max] = part() * *limits.plastic_strain;
  if (limits.finger_force_N) result.metrics[Metric::peak_finger_force_N] = part() * *limits.finger_force_N;
  if (dice < 4) return result;
  const auto over = [&](Metric metric, const std::optional<double>& limit) {
    return limit && result.metrics[metric] > *limit;
  };
  const bool damaged = over(Metric::permanent_set_max_m, limits.permanent_set_m) ||
                       over(Metric::plastic_strain_max, limits.plastic_strain) ||
                       over(Metric::peak_finger_force_N, limits.finger_force_N);
  result.outcome = result.metrics[Metric::slip_max_m] > limits.slip_m ? Outcome::slipped
                   : damaged                                          ? Outcome::damaged
                                                                      : Outcome::held;
  return result;
}

LimitParameters random_limits(std::mt19937_64& random) {
  LimitParameters limits;
  limits.slip_m = 2e-3;
  if (random() % 2 == 0) limits.permanent_set_m = 1e-4;
  if (random() % 2 == 0) limits.plastic_strain = 0.01;
  if (random() % 2 == 0) limits.finger_force_N = 30.0;
  return limits;
}

std::vector<Constraint> event_constraints() {
  std::vector<Constraint> all;
  for (const char* text : {"held", "not damaged", "not slipped", "not dropped", "not dropped and not not_grasped",
                           "not slipped and not damaged", "slipped", "damaged", "held or dropped", "not diverged",
                           "not damaged or not_grasped"}) {
    all.push_back(constraint(text));
  }
  return all;
}

TEST(Goals, AViolationIsAtMostZeroExactlyWhenTheEventHappens) {
  std::mt19937_64 random(1);
  const std::vector<Constraint> constraints = event_constraints();
  for (int i = 0; i < 5'000; ++i) {
    const LimitParameters limits = random_limits(random);
    const ScenarioResult result = random_result(random, limits);
    for (const Constraint& c : constraints) {
      const std::vector<double> parts = violations(c, result, limits);
      EXPECT_EQ(parts.size(), violation_names(c, limits).size()) << c.text;
      for (const double each : parts) ASSERT_TRUE(std::isfinite(each)) << c.text;
      EXPECT_EQ(violation(c, result, limits), *std::max_element(parts.begin(), parts.end()));
      ASSERT_EQ(violation(c, result, limits) <= 0.0, event_happens(c.event, result, limits))
          << c.text << " after " << outcome_word(result.outcome) << ", case " << i;
    }
  }
}

TEST(Goals, AProbabilityIsMetExactlyWhenTheFrequencyIs) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 500; ++i) {
    const LimitParameters limits = random_limits(random);
    std::vector<ScenarioResult> results;
    const std::size_t count = 1 + random() % 200;
    for (std::size_t k = 0; k < count; ++k) results.push_back(random_result(random, limits));
    for (const Constraint& event : event_constraints()) {
      Constraint goal = event;
      goal.kind = Constraint::Kind::probability;
      goal.at_least = true;
      // Also probabilities that are whole numbers of products, where one more or less decides.
      const auto met = static_cast<double>(1 + random() % count);
      goal.bound =
          random() % 2 == 0 ? met / static_cast<double>(count) : 0.01 * static_cast<double>(1 + random() % 100);
      const double part = frequency(goal.event, results, limits);
      // k of n products make up the part k/n; as numbers the two may differ by a rounding.
      ASSERT_EQ(violation(goal, results, limits) <= 0.0, part >= goal.bound - 1e-12)
          << std::setprecision(17) << goal.text << " in " << part << " of " << count << ", wanted " << goal.bound;
    }
  }
}

TEST(Goals, AMetricConstraintIsMetExactlyWhenItsInequalityIs) {
  std::mt19937_64 random(3);
  const LimitParameters limits = two_limits();
  for (int i = 0; i < 5'000; ++i) {
    const ScenarioResult result = random_result(random, limits);
    Constraint goal = constraint("cycle_time_s <= 1");
    goal.at_least = random() % 2 == 0;
    goal.bound = 2e-3 * static_cast<double>(random() % 1000) - 0.5;
    // Without its product a cycle has no time.
    const double value =
        kept_event().contains(ending_of(result, limits)) ? result.metrics[Metric::cycle_time_s] : kNaN;
    const bool met = goal.at_least ? value >= goal.bound : value <= goal.bound;  // false for NaN
    const double broken = violation(goal, result, limits);
    ASSERT_TRUE(std::isfinite(broken));
    ASSERT_EQ(broken <= 0.0, met) << value << (goal.at_least ? " >= " : " <= ") << goal.bound;
  }
}

TEST(Goals, AnEventNeverHappensInARunThatWasNotRun) {
  const ScenarioResult none;
  for (const Constraint& c : event_constraints()) {
    EXPECT_FALSE(event_happens(c.event, none, two_limits())) << c.text;
    EXPECT_GT(violation(c, none, two_limits()), 0.0) << c.text;
  }
}

}  // namespace
}  // namespace unbruised::studies

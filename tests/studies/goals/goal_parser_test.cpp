// What can be written as an objective or a constraint, and what is answered to the rest.

#include <gtest/gtest.h>

#include "studies/goals/goal.hpp"

namespace unbruised::studies {
namespace {

constexpr GoalContext kSingle = GoalContext::single;
constexpr GoalContext kSampled = GoalContext::sampled;

Objective objective(std::string_view text, GoalContext context = kSingle) {
  const Parsed<Objective> parsed = parse_objective(text, context);
  if (!parsed) {
    ADD_FAILURE() << text << ": " << parsed.error();
    return {};
  }
  return *parsed;
}

Constraint constraint(std::string_view text, GoalContext context = kSingle) {
  const Parsed<Constraint> parsed = parse_constraint(text, context);
  if (!parsed) {
    ADD_FAILURE() << text << ": " << parsed.error();
    return {};
  }
  return *parsed;
}

template <class Goal>
std::string why_not(const Parsed<Goal>& parsed) {
  return parsed ? "it is one" : parsed.error();
}

std::uint32_t bits(std::initializer_list<Ending> endings) {
  std::uint32_t all = 0;
  for (const Ending ending : endings) all |= 1U << static_cast<unsigned>(ending);
  return all;
}

TEST(GoalParser, AMetricAloneIsAnObjective) {
  const Objective goal = objective("cycle_time_s");
  ASSERT_EQ(goal.terms.size(), 1U);
  EXPECT_EQ(goal.terms[0].weight, 1.0);
  EXPECT_EQ(goal.terms[0].statistic, Statistic::none);
  EXPECT_EQ(goal.terms[0].metric, Metric::cycle_time_s);
  EXPECT_EQ(goal.text, "cycle_time_s");
}

TEST(GoalParser, EveryMetricCanBeNamed) {
  for (const MetricInfo& info : kMetricTable) {
    EXPECT_EQ(objective(info.name).terms.at(0).metric, info.metric);
    EXPECT_EQ(constraint(std::string(info.name) + " <= 1").term.metric, info.metric);
    EXPECT_EQ(parse_metric(info.name).value(), info.metric);
  }
}

TEST(GoalParser, WeightsSignsAndBlanksMakeAWeightedSum) {
  for (const char* text : {"cycle_time_s + 0.5 * peak_finger_force_N - 1e3*slip_max_m",
                           "  cycle_time_s+0.5*peak_finger_force_N-1e3 *slip_max_m\n",
                           "cycle_time_s\t+ .5 * peak_finger_force_N - 1000.0 * slip_max_m"}) {
    const Objective goal = objective(text);
    ASSERT_EQ(goal.terms.size(), 3U) << text;
    EXPECT_EQ(goal.terms[0].weight, 1.0);
    EXPECT_EQ(goal.terms[1].weight, 0.5);
    EXPECT_EQ(goal.terms[1].metric, Metric::peak_finger_force_N);
    EXPECT_EQ(goal.terms[2].weight, -1000.0);
    EXPECT_EQ(goal.terms[2].metric, Metric::slip_max_m);
  }
  EXPECT_EQ(objective("- 2 * friction_margin_min").terms.at(0).weight, -2.0) << "a leading minus maximises";
  EXPECT_EQ(objective(" -friction_margin_min ").text, "-friction_margin_min");
}

TEST(GoalParser, StatisticsStandOverProducts) {
  const Objective goal =
      objective("mean(cycle_time_s) + 2*quantile( slip_max_m , 0.95 ) - worst(friction_margin_min)", kSampled);
  ASSERT_EQ(goal.terms.size(), 3U);
  EXPECT_EQ(goal.terms[0].statistic, Statistic::mean);
  EXPECT_EQ(goal.terms[1].statistic, Statistic::quantile);
  EXPECT_EQ(goal.terms[1].level, 0.95);
  EXPECT_EQ(goal.terms[1].weight, 2.0);
  EXPECT_EQ(goal.terms[2].statistic, Statistic::worst);
  EXPECT_EQ(goal.terms[2].weight, -1.0);
}

TEST(GoalParser, AMetricIsBoundedFromEitherSide) {
  const Constraint least = constraint("friction_margin_min >= 0.2");
  EXPECT_EQ(least.kind, Constraint::Kind::metric);
  EXPECT_TRUE(least.at_least);
  EXPECT_EQ(least.bound, 0.2);
  EXPECT_EQ(least.term.metric, Metric::friction_margin_min);
  EXPECT_EQ(least.text, "friction_margin_min >= 0.2");
  const Constraint most = constraint("energy_balance_error<=-1e-3");
  EXPECT_FALSE(most.at_least);
  EXPECT_EQ(most.bound, -1e-3);
  const Constraint worst = constraint("worst(permanent_set_max_m) <= 1e-4", kSampled);
  EXPECT_EQ(worst.term.statistic, Statistic::worst);
  EXPECT_EQ(constraint("quantile(slip_max_m, 0.9) <= 1e-3", kSampled).term.level, 0.9);
}

TEST(GoalParser, WordsAreTheirOutcomesAndNotSpeaksOfProductsThatWereKept) {
  using enum Ending;
  const auto event = [](const char* text) { return constraint(text).event.endings; };
  EXPECT_EQ(event("held"), bits({held}));
  EXPECT_EQ(event("slipped"), bits({slipped, slipped_and_damaged}));
  EXPECT_EQ(event("not damaged"), bits({held, slipped, misplaced}));
  EXPECT_EQ(event("not dropped"), bits({held, slipped, damaged, misplaced, slipped_and_damaged}));
  EXPECT_EQ(event("not not_grasped"), event("not dropped"));
  EXPECT_EQ(event("not diverged"), event("not dropped"));
  EXPECT_EQ(event("not dropped and not damaged"), bits({held, slipped, misplaced}));
  EXPECT_EQ(event(" not  slipped and not slipped "), bits({held, damaged, misplaced}));
  EXPECT_EQ(event("held and not damaged"), bits({held}));
  EXPECT_EQ(event("held or dropped"), bits({held, dropped}));
  EXPECT_EQ(event("not damaged or dropped or not_grasped"),
            bits({held, slipped, misplaced, dropped, not_grasped}));
  EXPECT_EQ(constraint("held").event, held_event());
  for (const std::string_view word : kOutcomeWords) {
    EXPECT_EQ(constraint(word).kind, Constraint::Kind::outcome) << word;
  }
}

TEST(GoalParser, AProbabilityIsBoundedFromBelow) {
  for (const char* text : {"P(held) >= 0.99", "P(held)>=0.99", " P ( held ) >= 9.9e-1 "}) {
    const Constraint goal = constraint(text, kSampled);
    EXPECT_EQ(goal.kind, Constraint::Kind::probability);
    EXPECT_EQ(goal.event, held_event());
    EXPECT_EQ(goal.bound, 0.99);
    EXPECT_TRUE(goal.at_least);
  }
  EXPECT_EQ(constraint("P(not damaged and not dropped) >= 1", kSampled).bound, 1.0);
}

TEST(GoalParser, EventWordsSayTheSameAgain) {
  for (const char* text : {"held", "not damaged", "slipped", "not slipped", "not dropped", "held or dropped",
                           "not damaged or dropped", "slipped and not damaged", "held or slipped", "misplaced",
                           "not misplaced", "held or misplaced"}) {
    EXPECT_EQ(event_words(constraint(text).event), text);
  }
}

TEST(GoalParser, EventWordsReadBackToTheSameEvent) {
  const std::vector<std::string> parts = {"held",        "slipped",     "dropped",     "damaged",
                                          "not_grasped", "not damaged", "not slipped", "not dropped"};
  for (const std::string& a : parts) {
    for (const std::string& b : parts) {
      for (const std::string& c : parts) {
        const OutcomeEvent event = constraint(a + " or " + b + " or " + c).event;
        EXPECT_EQ(constraint(event_words(event)).event, event) << a << ", " << b << ", " << c;
      }
    }
  }
}

struct Refusal {
  GoalContext context;
  const char* text;
  const char* why;
};

TEST(GoalParser, ObjectivesThatAreNoneAreAnsweredWithExactlyThis) {
  for (const Refusal& refusal : std::initializer_list<Refusal>{
           {kSingle, "", "expected the name of a metric at its end"},
           {kSingle, "cycle_tim_s", "unknown metric 'cycle_tim_s'; did you mean 'cycle_time_s'?"},
           {kSingle, "cycle_time", "unknown metric 'cycle_time'; did you mean 'cycle_time_s'?"},
           {kSingle, "colour", "unknown metric 'colour'"},
           {kSingle, "cycle_time_s +", "expected the name of a metric at its end"},
           {kSingle, "cycle_time_s slip_max_m", "expected '+' or '-' and another term at 'slip_max_m'"},
           {kSingle, "cycle_time_s / 2", "expected '+' or '-' and another term at '/ 2'"},
           {kSingle, "0.5 cycle_time_s", "expected '*' and a metric at 'cycle_time_s'"},
           {kSingle, "0.5", "expected '*' and a metric at its end"},
           {kSingle, "1e999 * cycle_time_s", "expected a number at '1e999 * cycle_time_s'"},
           {kSingle, "- - cycle_time_s", "expected the name of a metric at '- cycle_time_s'"},
           {kSingle, "(cycle_time_s)", "expected the name of a metric at '(cycle_time_s)'"},
           {kSingle, "mean(cycle_time_s)", "mean(...) needs random products: kind = \"robust\""},
           {kSingle, "quantile(cycle_time_s, 0.9)", "quantile(...) needs random products: kind = \"robust\""},
           {kSampled, "cycle_time_s",
            "say over which products: mean(cycle_time_s), quantile(cycle_time_s, 0.95) or worst(cycle_time_s)"},
           {kSampled, "median(cycle_time_s)", "unknown statistic 'median'; did you mean 'mean'?"},
           {kSampled, "sum(cycle_time_s)", "unknown statistic 'sum'; known: mean, quantile, worst"},
           {kSampled, "wurst(cycle_time_s)", "unknown statistic 'wurst'; did you mean 'worst'?"},
           {kSampled, "mean(cycle_tim_s)", "unknown metric 'cycle_tim_s'; did you mean 'cycle_time_s'?"},
           {kSampled, "mean(cycle_time_s", "expected ')' at its end"},
           {kSampled, "mean(cycle_time_s, 0.9)", "expected ')' at ', 0.9)'"},
           {kSampled, "quantile(cycle_time_s)", "expected ',' at ')'"},
           {kSampled, "quantile(cycle_time_s, x)", "expected a number at 'x)'"},
           {kSampled, "quantile(cycle_time_s, 1)", "the level of a quantile must be > 0 and < 1"},
       }) {
    EXPECT_EQ(why_not(parse_objective(refusal.text, refusal.context)), refusal.why) << refusal.text;
  }
}

TEST(GoalParser, ConstraintsThatAreNoneAreAnsweredWithExactlyThis) {
  for (const Refusal& refusal : std::initializer_list<Refusal>{
           {kSingle, "", "expected the name of a metric at its end"},
           {kSingle, "hold", "unknown outcome 'hold'; did you mean 'held'?"},
           {kSingle, "not damagd", "unknown outcome 'damagd'; did you mean 'damaged'?"},
           {kSingle, "not",
            "unknown outcome ''; known: held, slipped, dropped, damaged, not_grasped, diverged, "
            "out_of_range, misplaced"},
           {kSingle, "not blue",
            "unknown outcome 'blue'; known: held, slipped, dropped, damaged, not_grasped, diverged, "
            "out_of_range, misplaced"},
           {kSingle, "held >= 0.9", "expected 'and' or 'or' and another outcome at '>= 0.9'"},
           {kSingle, "held or",
            "unknown outcome ''; known: held, slipped, dropped, damaged, not_grasped, diverged, "
            "out_of_range, misplaced"},
           {kSingle, "held and dropped", "no outcome is all of that at once"},
           {kSingle, "dropped and not damaged", "no outcome is all of that at once"},
           {kSingle, "not held",
            "'not held' does not say which ends are meant: name them, e.g. 'slipped or dropped'"},
           {kSingle, "slip_max_m", "expected '<=' or '>=' at its end"},
           {kSingle, "slip_max_m < 0.1", "expected '<=' or '>=' at '< 0.1'"},
           {kSingle, "slip_max_m = 0.1", "expected '<=' or '>=' at '= 0.1'"},
           {kSingle, "slip_max_m <= ", "expected a number at its end"},
           {kSingle, "slip_max_m <= inf", "expected a number at 'inf'"},
           {kSingle, "slip_max_m <= 1 mm", "expected nothing more at 'mm'"},
           {kSingle, "0.1 >= slip_max_m", "unknown metric '0'"},
           {kSingle, "slip_mx_m <= 1", "unknown metric 'slip_mx_m'; did you mean 'slip_max_m'?"},
           {kSingle, "P(held) >= 0.9", "P(...) needs random products: kind = \"robust\""},
           {kSingle, "worst(slip_max_m) <= 1", "worst(...) needs random products: kind = \"robust\""},
           {kSampled, "held", "say how often: P(held) >= 0.99"},
           {kSampled, "P held >= 0.9", "expected '(' at 'held >= 0.9'"},
           {kSampled, "P(held >= 0.9", "expected ')' at '>= 0.9'"},
           {kSampled, "P(held)", "expected '<=' or '>=' at its end"},
           {kSampled, "P(held) <= 0.9", "a probability is bounded from below: P(...) >= number"},
           {kSampled, "P(held) >= 99 %", "a probability must be > 0 and <= 1"},
           {kSampled, "P(held) >= 0", "a probability must be > 0 and <= 1"},
           {kSampled, "P(slip_max_m) >= 0.9",
            "unknown outcome 'slip_max_m'; known: held, slipped, dropped, damaged, not_grasped, diverged, "
            "out_of_range, misplaced"},
           {kSampled, "slip_max_m <= 1",
            "say over which products: mean(slip_max_m), quantile(slip_max_m, 0.95) or worst(slip_max_m)"},
       }) {
    EXPECT_EQ(why_not(parse_constraint(refusal.text, refusal.context)), refusal.why) << refusal.text;
  }
}

TEST(GoalParser, EveryTruncationAndEveryChangedByteIsSurvived) {
  std::size_t refused = 0;
  for (const std::string text : {"mean(cycle_time_s) + 0.5*quantile(slip_max_m, 0.95)",
                                 "P(not damaged and held) >= 0.99", "friction_margin_min >= -0.2"}) {
    for (std::size_t i = 0; i < text.size(); ++i) {
      for (const char c : {'\0', ' ', '(', ')', '*', ',', '.', '9', '=', '>', 'P', 'e', '\xFF'}) {
        std::string other = text.substr(0, c == '\0' ? i : text.size());
        if (c != '\0') other[i] = c;
        for (const GoalContext context : {kSingle, kSampled}) {
          refused += !parse_objective(other, context).has_value() ? 1U : 0U;
          refused += !parse_constraint(other, context).has_value() ? 1U : 0U;
        }
      }
    }
  }
  EXPECT_GT(refused, 3'000U);
}

}  // namespace
}  // namespace unbruised::studies

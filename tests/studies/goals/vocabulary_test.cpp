#include "studies/goals/vocabulary.hpp"

#include <fstream>
#include <regex>
#include <sstream>

#include <gtest/gtest.h>

#include "studies/goals/goal.hpp"
#include "tests/places.hpp"

namespace unbruised::studies {
namespace {

std::string page_text() {
  std::ifstream page(UNBRUISED_SOURCE_DIR "/docs/metrics.md");
  std::ostringstream text;
  text << page.rdbuf();
  return std::regex_replace(text.str(), std::regex("`"), "");
}

TEST(Vocabulary, ExplainsEveryWordItKnowsWithTheWordFirst) {
  for (const std::string& word : vocabulary()) {
    const auto text = explain_word(word);
    ASSERT_TRUE(text.has_value()) << word;
    EXPECT_GT(text->size(), word.size() + 20) << *text;
  }
  EXPECT_EQ(explain_word("no_such_word"), std::nullopt);
}

TEST(Vocabulary, SaysOfEveryMetricItsUnitAndWhatDecidesByIt) {
  for (const MetricInfo& metric : kMetricTable) {
    const std::string text = explain_word(metric.name).value();
    EXPECT_NE(text.find("unit: " + unit_text(metric.units)), std::string::npos) << text;
    EXPECT_NE(text.find(std::string(metric.long_name)), std::string::npos) << text;
  }
  EXPECT_NE(explain_word("permanent_set_max_m")->find("limits.permanent_set_m"), std::string::npos);
  EXPECT_NE(explain_word("friction_margin_min")->find("better: more"), std::string::npos);
  EXPECT_EQ(unit_text("m s-1"), "m/s");
  EXPECT_EQ(unit_text("m s-2"), "m/s2");
  EXPECT_EQ(unit_text("N m"), "N m");
}

TEST(Vocabulary, SaysOfEveryOutcomeWhatTheMetricsPageSaysInItsOrder) {
  const std::string page = page_text();
  std::size_t at = page.find("## Outcomes");
  ASSERT_NE(at, std::string::npos);
  for (const OutcomeMeaning& meaning : kOutcomeMeanings) {
    const std::string word(outcome_word(meaning.outcome));
    const std::string row = "| " + word + " | " + std::to_string(static_cast<int>(meaning.outcome)) + " | " +
                            std::string(meaning.when) + " |";
    at = page.find(row, at);
    ASSERT_NE(at, std::string::npos) << row;
  }
}

/// What a goal's explanation gives as an example is taken by the parser.
TEST(Vocabulary, GivesExamplesThatParse) {
  for (const char* word : {"objective", "constraint", "P", "mean", "quantile", "worst", "not", "and", "held"}) {
    const std::string text = explain_word(word).value();
    const std::regex quoted("\"([^\"]*)\"");
    const std::string examples = text.substr(text.find("as in: "));
    for (std::sregex_iterator it(examples.begin(), examples.end(), quoted), end; it != end; ++it) {
      const std::string goal = (*it)[1];
      bool parses = false;
      for (const GoalContext context : {GoalContext::single, GoalContext::sampled}) {
        parses =
            parses || parse_constraint(goal, context).has_value() || parse_objective(goal, context).has_value();
      }
      EXPECT_TRUE(parses) << word << ": " << goal;
    }
  }
}

}  // namespace
}  // namespace unbruised::studies

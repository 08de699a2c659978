#include "studies/config/study_kind.hpp"

#include <set>
#include <string>

#include <gtest/gtest.h>

#include "studies/config/schema.hpp"

namespace unbruised::studies {
namespace {

TEST(StudyKinds, EachHasItsFullRow) {
  std::set<std::string_view> words;
  std::set<std::string_view> questions;
  for (const StudyKindRow& row : study_kind_table()) {
    EXPECT_EQ(&row_of(row.kind), &row);
    EXPECT_TRUE(words.insert(row.word).second) << row.word;
    EXPECT_TRUE(questions.insert(row.asks).second) << row.word << ": " << row.asks;
    EXPECT_FALSE(row.word.empty());
    EXPECT_FALSE(row.asks.empty()) << row.word;
  }
}

TEST(StudyKinds, OfTheConfigAreThoseOfTheTableInItsOrder) {
  const KeySpec& spec = *find_key("study.kind").spec;
  ASSERT_EQ(spec.choices.size(), study_kind_table().size());
  for (std::size_t i = 0; i < spec.choices.size(); ++i) {
    EXPECT_EQ(spec.choices[i], study_kind_table()[i].word);
    EXPECT_NE(spec.meaning.find(study_kind_table()[i].asks), std::string_view::npos) << spec.choices[i];
  }
}

/// What the rows say must fit together, whatever kinds there will be.
TEST(StudyKinds, AreFoundByTheirWords) {
  for (const StudyKindRow& row : study_kind_table()) EXPECT_EQ(study_kind_named(row.word), row.kind) << row.word;
  EXPECT_EQ(study_kind_named("of another version"), std::nullopt);
}

TEST(StudyKinds, HaveTheBlocksThatTheirScenariosComeFrom) {
  for (const StudyKindRow& row : study_kind_table()) {
    EXPECT_EQ(row.scenarios == ScenarioSource::questions, row.variable != Blocks::refused) << row.word;
    EXPECT_EQ(row.scenarios == ScenarioSource::questions, row.objectives != Objectives::none) << row.word;
    EXPECT_EQ(row.scenarios == ScenarioSource::curves, row.parameter == Blocks::required) << row.word;
    EXPECT_EQ(row.scenarios == ScenarioSource::pairs, row.candidate == Blocks::required) << row.word;
    const bool is_drawn = row.scenarios == ScenarioSource::products || row.scenarios == ScenarioSource::design;
    EXPECT_TRUE(!is_drawn || row.random == Blocks::required) << row.word;
    const bool has_grid = row.scenarios == ScenarioSource::grid || row.scenarios == ScenarioSource::forces;
    EXPECT_TRUE(has_grid || row.vary == Blocks::refused) << row.word;
  }
}

TEST(StudyKinds, AreListedInSentences) {
  EXPECT_EQ(why_unused(Use::search, Scenario{}),
            "not used: only studies of kind = \"optimize\", \"robust\" or \"pareto\" have it");
  EXPECT_EQ(why_unused(Use::sampling, Scenario{}),
            "not used: only studies of kind = \"sample\", \"robust\" or \"compare\" have it");
}

}  // namespace
}  // namespace unbruised::studies

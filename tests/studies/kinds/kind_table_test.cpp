#include "studies/kinds/kind_table.hpp"

#include <string>

#include <gtest/gtest.h>

#include "tests/studies/kinds/search_testing.hpp"

namespace unbruised::studies {
namespace {

TEST(KindTable, HasAFullRowForEveryKindOfTheConfig) {
  ASSERT_EQ(kind_table().size(), study_kind_table().size());
  for (const StudyKindRow& known : study_kind_table()) {
    const KindRow& row = runner_of(known.kind);
    EXPECT_EQ(row.kind, known.kind) << known.word << ": the rows stand in another order";
    EXPECT_NE(row.run, nullptr) << known.word;
    EXPECT_NE(row.template_part, nullptr) << known.word;
    ASSERT_NE(row.scenarios, nullptr) << known.word;
    EXPECT_NE(row.scenarios->columns, nullptr) << known.word;
    EXPECT_NE(row.scenarios->scenario_of_row, nullptr) << known.word;
    EXPECT_NE(row.scenarios->known, nullptr) << known.word;
    EXPECT_NE(row.scenarios->evaluations, nullptr) << known.word;
  }
}

TEST(KindTable, CountsScenariosBeforehandWhereNobodyAsksForThem) {
  for (const StudyKindRow& row : study_kind_table()) {
    const bool asks = row.scenarios == ScenarioSource::forces || row.scenarios == ScenarioSource::questions ||
                      row.scenarios == ScenarioSource::curves;
    EXPECT_NE(has_fixed_scenarios(row.kind), asks) << row.word;
  }
}

/// What `unbruised new` writes names the blocks that the kind requires, and none that it refuses.
TEST(KindTable, WritesTheBlocksThatAKindRequires) {
  TemplateNumbers numbers;
  numbers.force_N = 2.0;
  numbers.force_from_N = 1.0;
  numbers.force_to_N = 9.0;
  numbers.friction = 0.5;
  for (const StudyKindRow& known : study_kind_table()) {
    const std::string text = runner_of(known.kind).template_part(numbers);
    const auto expect_blocks = [&](const char* header, Blocks blocks) {
      const bool is_there = text.find(header) != std::string::npos;
      EXPECT_TRUE(blocks != Blocks::required || is_there) << known.word << " without " << header << text;
      EXPECT_TRUE(blocks != Blocks::refused || !is_there) << known.word << " with " << header << text;
    };
    expect_blocks("[[vary]]", known.vary);
    expect_blocks("[[variable]]", known.variable);
    expect_blocks("[[parameter]]", known.parameter);
    expect_blocks("[[random]]", known.random);
    expect_blocks("[[candidate]]", known.candidate);
  }
}

}  // namespace
}  // namespace unbruised::studies

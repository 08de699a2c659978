#include "studies/results/outcome_counts.hpp"

#include <gtest/gtest.h>

namespace unbruised::studies {
namespace {

TEST(OutcomeCounts, SayWhatHappenedInTheOrderOfTheOutcomes) {
  OutcomeCounts counts;
  EXPECT_EQ(counts_text(counts), "");
  counts.add(Outcome::not_run);
  for (int i = 0; i < 1500; ++i) counts.add(Outcome::dropped);
  counts.add(Outcome::held);
  EXPECT_EQ(counts_text(counts), "held 1, dropped 1,500, not run 1");
}

TEST(OutcomeCounts, VisitEveryOutcomeOnce) {
  std::vector<std::string> words;
  for_each_outcome(OutcomeCounts{}, [&](Outcome outcome, std::size_t count) {
    words.emplace_back(outcome_word(outcome));
    EXPECT_EQ(count, 0U);
  });
  std::vector<std::string> expected(kOutcomeWords.begin(), kOutcomeWords.end());
  expected.emplace_back("not_run");
  EXPECT_EQ(words, expected);
}

}  // namespace
}  // namespace unbruised::studies

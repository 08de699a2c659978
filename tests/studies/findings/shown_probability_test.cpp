// Met by the estimate and shown by the interval are two things.

#include "studies/findings/shown_probability.hpp"

#include <gtest/gtest.h>

#include "tests/studies/config/config_testing.hpp"

namespace unbruised::studies {
namespace {

using testing::search_block;
using testing::study_of;

constexpr double kConfidence = 0.95;

Proportion all_of(std::size_t count) { return proportion(std::vector<bool>(count, true), {}, kConfidence); }

TEST(ShownProbability, FortyOutOfFortyMeetNinetyNinePercentButDoNotShowIt) {
  EXPECT_EQ(shown(0.99, all_of(40)), Shown::met_by_the_estimate);
  EXPECT_EQ(shown(0.9, all_of(40)), Shown::shown);  // 40 / (40 + 1.96^2) = 0.912
  EXPECT_EQ(shown(0.99, proportion({true, false}, {}, kConfidence)), Shown::broken);
}

TEST(ShownProbability, TheNeededSampleShowsItAndOneProductFewerDoesNot) {
  const auto needed = needed_sample(0.99, all_of(40), {}, FactorGroups::own);
  ASSERT_TRUE(needed);
  EXPECT_EQ(needed->products, 381U);  // z^2 0.99 / 0.01 = 380.3
  EXPECT_EQ(shown(0.99, all_of(needed->products)), Shown::shown);
  EXPECT_EQ(shown(0.99, all_of(needed->products - 1)), Shown::met_by_the_estimate);
}

TEST(ShownProbability, TheNeededSampleOfAnEstimateBelowOneShowsItToo) {
  // 19 of 20 held, wanted 0.9: the same part of a sample as large as that.
  std::vector<bool> outcomes(20, true);
  outcomes[0] = false;
  const Proportion found = proportion(outcomes, {}, kConfidence);
  const auto needed = needed_sample(0.9, found, {}, FactorGroups::own);
  ASSERT_TRUE(needed);
  const auto n = static_cast<double>(needed->products);
  EXPECT_GE(wilson_interval(0.95 * n, n, kConfidence).low, 0.9);
  EXPECT_LT(wilson_interval(0.95 * (n - 1.0), n - 1.0, kConfidence).low, 0.9);
}

TEST(ShownProbability, NoSampleShowsWhatTheEstimateOnlyReaches) {
  const Proportion half = proportion({true, false}, {}, kConfidence);
  EXPECT_FALSE(needed_sample(0.5, half, {}, FactorGroups::own));
}

TEST(ShownProbability, ProductsThatShareGroupsNeedMoreGroups) {
  // 40 products of 4 groups, all held: they count as 4.
  std::vector<std::size_t> group;
  for (std::size_t i = 0; i < 40; ++i) group.push_back(i % 4);
  const Proportion found = proportion(std::vector<bool>(40, true), group, kConfidence);
  ASSERT_NEAR(found.effective_size, 4.0, 1e-9);
  const SamplingSettings sampling{.count = 40, .factor_groups = 4, .confidence = kConfidence};
  const auto needed = needed_sample(0.99, found, sampling, FactorGroups::shared);
  ASSERT_TRUE(needed);
  EXPECT_EQ(needed->factor_groups, 381U);
  EXPECT_EQ(needed->products, 3810U);  // still ten of each group
}

TEST(ShownProbability, CheckSaysBeforeTheRunWhatCannotBeShown) {
  const auto doubts = [](const std::vector<std::string>& sets) {
    return probability_doubts(study_of(search_block("robust"), sets));
  };
  ASSERT_EQ(doubts({"sampling.count=40"}).size(), 1U);
  EXPECT_EQ(doubts({"sampling.count=40"}).front(),
            "P(held) >= 0.99 cannot be shown by 40 products: even if it holds for all of them the 95 % interval "
            "begins at 91.2 %; sampling.count = 381 could show it");
  EXPECT_TRUE(doubts({"sampling.count=381"}).empty()) << "friction changes no factor: each product is its own";
  EXPECT_NE(doubts({"search.constraints=[\"P(held) >= 1\"]"}).front().find("no number of products"),
            std::string::npos);
}

TEST(ShownProbability, CheckSaysThatSharedGroupsMayHideIt) {
  const Study study = study_of(
      search_block("robust"),
      {"sampling.count=400", "random[0].key=product.youngs_modulus_Pa", "random[0].from=1e5", "random[0].to=2e5"});
  EXPECT_TRUE(probability_doubts(study).empty()) << "the answer will say whether it is shown";
  const std::vector<std::string> notes = probability_notes(study);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_NE(notes.front().find("share 16 factor groups"), std::string::npos) << notes.front();
  EXPECT_NE(notes.front().find("sampling.factor_groups = 0"), std::string::npos) << notes.front();
}

}  // namespace
}  // namespace unbruised::studies

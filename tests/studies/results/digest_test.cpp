#include "studies/results/digest.hpp"

#include <bit>
#include <cmath>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "tests/studies/results/sample_rows.hpp"

namespace unbruised::studies {
namespace {

TEST(Digest, ChangesWithEveryBitOfEveryMetric) {
  const ScenarioResult original = sample_row(3).result;
  std::set<std::uint64_t> digests = {result_digest(original)};
  for (std::size_t m = 0; m < kMetricCount; ++m) {
    ScenarioResult changed = original;
    double& value = changed.metrics.values()[m];
    value = std::isnan(value) ? 1.0 : std::nextafter(value, 1e300);
    digests.insert(result_digest(changed));
  }
  EXPECT_EQ(digests.size(), kMetricCount + 1);
}

TEST(Digest, ChangesWithOutcomeAndTimeButNotWithTheWordsOfTheCause) {
  const ScenarioResult original = sample_row(3).result;
  ScenarioResult changed = original;
  changed.outcome = Outcome::diverged;
  EXPECT_NE(result_digest(changed), result_digest(original));
  changed = original;
  changed.outcome_time_s += 1e-3;
  EXPECT_NE(result_digest(changed), result_digest(original));
  changed = original;
  changed.cause = "other words";
  EXPECT_EQ(result_digest(changed), result_digest(original));
}

TEST(Digest, TakesEveryNanForOneAndMinusZeroForZero) {
  ScenarioResult a = sample_row(1).result;
  ScenarioResult b = a;
  a.metrics[Metric::slip_max_m] = std::bit_cast<double>(std::uint64_t{0x7FF8000000000000});
  b.metrics[Metric::slip_max_m] = std::bit_cast<double>(std::uint64_t{0xFFF8000000001234});
  a.metrics[Metric::lift_time_s] = 0.0;
  b.metrics[Metric::lift_time_s] = -0.0;
  EXPECT_EQ(result_digest(a), result_digest(b));
}

TEST(Digest, OfDigestsDependsOnTheirOrder) {
  const std::vector<std::uint64_t> forward = {1, 2, 3};
  const std::vector<std::uint64_t> backward = {3, 2, 1};
  EXPECT_NE(digest_of_digests(forward), digest_of_digests(backward));
}

// The digest is part of the results format: these numbers change only with kResultsFormatVersion or the metric
// table, and CHANGELOG says so then. The XXH3 of nothing is that of the reference implementation.
TEST(Digest, KeepsItsGoldenValues) {
  EXPECT_EQ(digest_text(digest_of_digests({})), "2d06800538d394c2");
  EXPECT_EQ(digest_text(result_digest(ScenarioResult{})), "28ba57ab8767605f");
  EXPECT_EQ(digest_text(result_digest(sample_row(7).result)), "ade3948a58054938");
}

TEST(Digest, IsPrintedAsSixteenHexDigits) {
  EXPECT_EQ(digest_text(0x0123456789abcdefULL), "0123456789abcdef");
  EXPECT_EQ(digest_text(0), "0000000000000000");
}

}  // namespace
}  // namespace unbruised::studies

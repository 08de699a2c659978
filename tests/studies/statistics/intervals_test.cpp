#include "studies/statistics/intervals.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "studies/statistics/design.hpp"
#include "studies/statistics/distribution.hpp"

namespace unbruised::studies {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kZ95 = 1.959963984540054;

bool contains(const Interval& interval, double value) { return interval.low <= value && value <= interval.high; }

double standard_normal(std::uint64_t seed, std::uint64_t stream, std::uint64_t k) {
  static const Distribution kNormal{.kind = DistributionKind::normal, .mean = 0.0, .standard_deviation = 1.0};
  return quantile(kNormal, unit_random(seed, stream, k));
}

double binomial_probability(std::size_t n, std::size_t k, double p) {
  const auto N = static_cast<double>(n);
  const auto K = static_cast<double>(k);
  return std::exp(std::lgamma(N + 1.0) - std::lgamma(K + 1.0) - std::lgamma(N - K + 1.0) + K * std::log(p) +
                  (N - K) * std::log1p(-p));
}

/// g clusters of m values in order: 0 0 0 1 1 1 ...
std::vector<std::size_t> equal_clusters(std::size_t clusters, std::size_t size) {
  std::vector<std::size_t> cluster(clusters * size);
  for (std::size_t i = 0; i < cluster.size(); ++i) cluster[i] = i / size;
  return cluster;
}

// -- Wilson. -----------------------------------------------------------------------------------------------

TEST(WilsonInterval, GivesPublishedValues) {
  // Newcombe (1998), Statistics in Medicine 17:857-872, table I, method 3.
  const std::tuple<double, double, double, double> published[] = {
      {81, 263, 0.2553, 0.3662}, {15, 148, 0.0624, 0.1605}, {0, 20, 0.0000, 0.1611}, {1, 29, 0.0061, 0.1718}};
  for (const auto& [successes, trials, low, high] : published) {
    const Interval found = wilson_interval(successes, trials, 0.95);
    EXPECT_NEAR(found.low, low, 0.5e-4) << successes << " of " << trials;
    EXPECT_NEAR(found.high, high, 0.5e-4) << successes << " of " << trials;
  }
}

TEST(WilsonInterval, EndsWhereTheScoreTestRejects) {
  for (const auto& [successes, trials] : {std::pair{8.0, 10.0}, {1.0, 3.0}, {99.5, 120.25}}) {
    const Interval found = wilson_interval(successes, trials, 0.95);
    for (const double p : {found.low, found.high}) {
      const double score = std::abs(p - successes / trials) / std::sqrt(p * (1.0 - p) / trials);
      EXPECT_NEAR(score, kZ95, 1e-12);
    }
  }
  EXPECT_NEAR(wilson_interval(8, 10, 0.95).low, 0.4902, 0.5e-4);
  EXPECT_NEAR(wilson_interval(8, 10, 0.95).high, 0.9433, 0.5e-4);
}

TEST(WilsonInterval, ReachesTheEndsExactlyAndNeverLeavesThem) {
  EXPECT_EQ(wilson_interval(0, 7, 0.95).low, 0.0);
  EXPECT_EQ(wilson_interval(7, 7, 0.95).high, 1.0);
  EXPECT_EQ(wilson_interval(0, 0, 0.95).low, 0.0);
  EXPECT_EQ(wilson_interval(0, 0, 0.95).high, 1.0);
  for (std::size_t n = 1; n < 200; ++n) {
    const Interval few = wilson_interval(0.0, static_cast<double>(n), 0.999);
    EXPECT_TRUE(few.low >= 0.0 && few.high <= 1.0 && few.low < few.high);
  }
}

TEST(WilsonInterval, CoversAsOftenAsItSays) {
  // Exact, by summing the binomial distribution: no simulation noise. The lattice of successes makes the coverage
  // of one p oscillate; over p it is what it says (Brown, Cai and DasGupta 2001).
  for (const std::size_t n : {10, 30, 100, 300}) {
    double mean = 0.0;
    double least = 1.0;
    constexpr int kParts = 99;
    for (int i = 1; i <= kParts; ++i) {
      const double p = i / (kParts + 1.0);
      double coverage = 0.0;
      for (std::size_t k = 0; k <= n; ++k) {
        const Interval interval = wilson_interval(static_cast<double>(k), static_cast<double>(n), 0.95);
        if (contains(interval, p)) coverage += binomial_probability(n, k, p);
      }
      mean += coverage / kParts;
      least = std::min(least, coverage);
    }
    EXPECT_GT(mean, 0.945) << n;
    EXPECT_LT(mean, 0.965) << n;
    EXPECT_GT(least, 0.83) << n;  // near p = 0 and 1, as Brown, Cai and DasGupta show
  }
}

TEST(TrialsToShow, IsTheLeastNumberWhoseIntervalLiesAbove) {
  for (const double confidence : {0.8, 0.95, 0.99}) {
    for (const double p : {0.0, 0.1, 0.5, 0.9, 0.95, 0.99, 0.999}) {
      std::size_t n = 1;
      while (!(wilson_interval(static_cast<double>(n), static_cast<double>(n), confidence).low > p)) ++n;
      EXPECT_EQ(trials_to_show(p, confidence), n) << p << " at " << confidence;
    }
  }
  EXPECT_EQ(trials_to_show(0.99, 0.95), 381U);  // z^2 p / (1 - p) = 3.841459 * 99 = 380.3
  EXPECT_EQ(trials_to_show(1.0, 0.95), std::numeric_limits<std::size_t>::max());
}

// -- Clusters. ---------------------------------------------------------------------------------------------

TEST(EffectiveSize, FollowsFromTheAnalysisOfVariance) {
  // Clusters {1, 2}, {3, 4}, {5, 9}: B = (18.75 + 0.75 + 27) 2/3 ... by hand: mean 4; between 2 (6.25 + 0.25 + 9)
  // = 31, B = 15.5; within 0.5 + 0.5 + 8 = 9, W = 3; icc = 12.5 / 18.5; deff = 1 + icc.
  const std::vector<double> values = {1, 2, 3, 4, 5, 9};
  EXPECT_NEAR(effective_size(values, equal_clusters(3, 2)), 6.0 / (1.0 + 12.5 / 18.5), 1e-12);
}

TEST(EffectiveSize, LiesBetweenTheNumbersOfClustersAndOfValues) {
  // All values of a cluster the same: the clusters are the observations.
  EXPECT_NEAR(effective_size(std::vector<double>{1, 1, 5, 5, 2, 2}, equal_clusters(3, 2)), 3.0, 1e-12);
  // Clusters alike in the mean: no effect of theirs, and never more than n.
  EXPECT_EQ(effective_size(std::vector<double>{1, 2, 1, 2, 2, 1}, equal_clusters(3, 2)), 6.0);
}

TEST(EffectiveSize, IsTheNumberOfValuesWhereNothingCanBeTold) {
  const std::vector<double> values = {1, 2, 3, 4};
  EXPECT_EQ(effective_size(values, {}), 4.0);
  EXPECT_EQ(effective_size(values, std::vector<std::size_t>{0, 1, 2, 3}), 4.0);
  EXPECT_EQ(effective_size(values, std::vector<std::size_t>{7, 7, 7, 7}), 4.0);
  EXPECT_EQ(effective_size(std::vector<double>{1, 1, 1, 1}, equal_clusters(2, 2)), 4.0);
  EXPECT_THROW(effective_size(values, std::vector<std::size_t>{0}), std::invalid_argument);
}

TEST(EffectiveSize, DoesNotHangOnTheOrderOfValuesOrTheNamesOfClusters) {
  const std::vector<double> values = {1, 2, 3, 4, 5, 9};
  const std::vector<double> other = {9, 3, 1, 5, 4, 2};
  EXPECT_NEAR(effective_size(values, equal_clusters(3, 2)),
              effective_size(other, std::vector<std::size_t>{4, 1, 900, 4, 1, 900}), 1e-12);
}

TEST(ProportionOf, IndependentOutcomesHasWilsonsInterval) {
  const std::vector<bool> successes = {true, true, true, true, true, true, true, true, false, false};
  const std::vector<std::size_t> own = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
  for (const std::vector<std::size_t>& cluster :
       {std::vector<std::size_t>{}, own, std::vector<std::size_t>(10, 3)}) {
    const Proportion found = proportion(successes, cluster, 0.95);
    EXPECT_DOUBLE_EQ(found.estimate, 0.8);
    EXPECT_EQ(found.effective_size, 10.0);
    EXPECT_EQ(found.interval.low, wilson_interval(8, 10, 0.95).low);
    EXPECT_EQ(found.interval.high, wilson_interval(8, 10, 0.95).high);
  }
  EXPECT_TRUE(std::isnan(proportion({}, {}, 0.95).estimate));
}

TEST(ProportionOf, OutcomesAllAlikeCountsClusters) {
  const Proportion found = proportion(std::vector<bool>(100, true), equal_clusters(20, 5), 0.95);
  EXPECT_EQ(found.estimate, 1.0);
  EXPECT_DOUBLE_EQ(found.effective_size, 20.0);
  EXPECT_DOUBLE_EQ(found.interval.low, wilson_interval(20, 20, 0.95).low);
}

TEST(ProportionOf, ClusteredOutcomesStaysBetweenTheNumbersOfClustersAndOutcomes) {
  for (std::uint64_t run = 0; run < 200; ++run) {
    std::vector<bool> successes;
    for (std::uint64_t i = 0; i < 60; ++i) successes.push_back(unit_random(3, run, i) < 0.7);
    const double size = proportion(successes, equal_clusters(12, 5), 0.95).effective_size;
    EXPECT_GE(size, 12.0 * (1.0 - 1e-12));
    EXPECT_LE(size, 60.0);
  }
}

struct Coverage {
  double naive = 0.0;
  double clustered = 0.0;
};

/// Outcomes that follow their cluster's draw with probability `follow`, else their own: icc = follow^2.
Coverage coverage_of_proportions(std::size_t clusters, std::size_t size, double p, double follow) {
  constexpr std::size_t kRuns = 1000;
  const std::vector<std::size_t> cluster = equal_clusters(clusters, size);
  Coverage out;
  for (std::uint64_t run = 0; run < kRuns; ++run) {
    std::vector<bool> successes;
    for (std::size_t i = 0; i < cluster.size(); ++i) {
      const bool follows = unit_random(21, run, i) < follow;
      const double u = follows ? unit_random(22, run, cluster[i]) : unit_random(23, run, i);
      successes.push_back(u < p);
    }
    if (contains(proportion(successes, {}, 0.95).interval, p)) out.naive += 1.0 / kRuns;
    if (contains(proportion(successes, cluster, 0.95).interval, p)) out.clustered += 1.0 / kRuns;
  }
  return out;
}

TEST(ProportionOf, ClustersThatShareAnEffectCoversNearlyAsOftenAsItSays) {
  // 1000 runs: the standard error of a coverage of 0.95 is 0.007. Eight clusters do not know their icc well
  // enough.
  for (const auto& [clusters, least] : {std::pair<std::size_t, double>{8, 0.84}, {20, 0.92}, {50, 0.92}}) {
    for (const double p : {0.5, 0.8}) {
      const Coverage found = coverage_of_proportions(clusters, 10, p, std::sqrt(0.5));
      EXPECT_GT(found.clustered, least) << clusters << " clusters, p = " << p;
      EXPECT_LT(found.naive, 0.7) << clusters << " clusters, p = " << p;
    }
  }
}

TEST(ProportionOf, ClustersNearOneCoversThoughHalfOfTheSamplesShowNoFailure) {
  // Rare failures that come in whole clusters: 20 of 20 clusters hold in half of the runs, and naively 200 of 200.
  const Coverage found = coverage_of_proportions(20, 10, 0.97, std::sqrt(0.9));
  EXPECT_GT(found.clustered, 0.93);
  EXPECT_LT(found.naive, 0.4);
}

TEST(ProportionOf, ClustersWithoutAnEffectIsNotMuchTooWide) {
  const Coverage found = coverage_of_proportions(20, 5, 0.8, 0.0);
  EXPECT_GT(found.clustered, 0.93);
  EXPECT_GT(found.naive, 0.92);
}

// -- Means. ------------------------------------------------------------------------------------------------

TEST(MeanIntervalOf, IndependentValuesIsStudents) {
  // t(0.975, 4) = 2.776445105 (tables); values 1 ... 5: sd sqrt(2.5).
  const MeanInterval found = mean_interval(std::vector<double>{1, 2, 3, 4, 5}, {}, 0.95);
  const double half = 2.7764451051977987 * std::sqrt(2.5 / 5.0);
  EXPECT_DOUBLE_EQ(found.mean, 3.0);
  EXPECT_NEAR(found.interval.low, 3.0 - half, 1e-12);
  EXPECT_NEAR(found.interval.high, 3.0 + half, 1e-12);
  EXPECT_EQ(found.count, 5U);
}

TEST(MeanIntervalOf, EquallyLargeClustersIsStudentsOfTheirMeans) {
  const std::vector<double> values = {1, 3, 4, 6, 8, 8};
  const MeanInterval clustered = mean_interval(values, equal_clusters(3, 2), 0.95);
  const MeanInterval means = mean_interval(std::vector<double>{2, 5, 8}, {}, 0.95);
  EXPECT_DOUBLE_EQ(clustered.mean, means.mean);
  EXPECT_NEAR(clustered.interval.low, means.interval.low, 1e-12);
  EXPECT_NEAR(clustered.interval.high, means.interval.high, 1e-12);
  EXPECT_EQ(clustered.count, 6U);
}

TEST(MeanIntervalOf, UnequalClustersWeighsThemBySize) {
  // By hand: n = 6, mean 3; clusters {2}, {2, 4}, {2, 3, 5}: m_i / n (d_i - d) = -1/6, 0, 1/6.
  const MeanInterval found =
      mean_interval(std::vector<double>{2, 2, 4, 2, 3, 5}, std::vector<std::size_t>{0, 1, 1, 2, 2, 2}, 0.95);
  const double t = 0.95 * std::sqrt(2.0 / (4.0 * 0.975 * 0.025));  // with two degrees of freedom in closed form
  const double half = t * std::sqrt(1.5 * 2.0 / 36.0);
  EXPECT_DOUBLE_EQ(found.mean, 3.0);
  EXPECT_NEAR(found.interval.high - found.mean, half, 1e-12);
}

TEST(MeanIntervalOf, OneObservationIsUnbounded) {
  const MeanInterval one = mean_interval(std::vector<double>{4.0}, {}, 0.95);
  EXPECT_EQ(one.mean, 4.0);
  EXPECT_EQ(one.interval.low, -kInf);
  EXPECT_EQ(one.interval.high, kInf);
  EXPECT_TRUE(std::isnan(mean_interval({}, {}, 0.95).mean));
  // One cluster: its values are the observations.
  const std::vector<double> values = {1, 2, 3};
  EXPECT_EQ(mean_interval(values, std::vector<std::size_t>{5, 5, 5}, 0.95).interval.low,
            mean_interval(values, {}, 0.95).interval.low);
}

TEST(MeanIntervalOf, PairedDifferencesCoversAsOftenAsItSays) {
  // Two strategies on the same products: what a product adds to both cancels. 4000 runs: standard error 0.0034.
  constexpr std::size_t kRuns = 4000;
  for (const std::size_t n : {3, 10, 40}) {
    double coverage = 0.0;
    for (std::uint64_t run = 0; run < kRuns; ++run) {
      std::vector<double> differences;
      for (std::uint64_t i = 0; i < n; ++i) {
        const double product = 10.0 * standard_normal(31, run, i);
        const double a = product + standard_normal(32, run, i);
        const double b = product + 0.5 + standard_normal(33, run, i);
        differences.push_back(b - a);
      }
      if (contains(mean_interval(differences, {}, 0.95).interval, 0.5)) coverage += 1.0 / kRuns;
    }
    EXPECT_NEAR(coverage, 0.95, 0.015) << n;
  }
}

TEST(MeanIntervalOf, ClustersThatShareAnEffectCoversAsOftenAsItSays) {
  constexpr std::size_t kRuns = 2000;
  const std::vector<std::size_t> cluster = equal_clusters(10, 8);
  double naive = 0.0;
  double clustered = 0.0;
  for (std::uint64_t run = 0; run < kRuns; ++run) {
    std::vector<double> values;
    for (std::size_t i = 0; i < cluster.size(); ++i) {
      values.push_back(standard_normal(41, run, cluster[i]) + standard_normal(42, run, i));
    }
    if (contains(mean_interval(values, {}, 0.95).interval, 0.0)) naive += 1.0 / kRuns;
    if (contains(mean_interval(values, cluster, 0.95).interval, 0.0)) clustered += 1.0 / kRuns;
  }
  EXPECT_NEAR(clustered, 0.95, 0.02);  // standard error 0.005
  EXPECT_LT(naive, 0.75);
}

// -- Bootstrap and quantiles. ------------------------------------------------------------------------------

TEST(Bootstrap, OfAMeanIsAsWideAsTheNormalInterval) {
  constexpr std::size_t n = 400;
  std::vector<double> values;
  for (std::uint64_t i = 0; i < n; ++i) values.push_back(standard_normal(51, 0, i));
  const MeanAndSpread spread = mean_and_spread(values);
  const auto mean = [&](std::span<const std::size_t> rows) {
    double sum = 0.0;
    for (const std::size_t row : rows) sum += values[row];
    return sum / static_cast<double>(rows.size());
  };
  const Interval found = bootstrap_interval(n, 4000, 52, 0.95, mean);
  const double half = kZ95 * spread.standard_deviation / std::sqrt(static_cast<double>(n));
  // A 2.5 % quantile of 4000 replicates has a standard error of 0.042 of their sd: 2.2 % of the half width; four.
  EXPECT_NEAR(found.low, spread.mean - half, 0.09 * half);
  EXPECT_NEAR(found.high, spread.mean + half, 0.09 * half);
  const Interval again = bootstrap_interval(n, 4000, 52, 0.95, mean);
  EXPECT_EQ(found.low, again.low);
  EXPECT_EQ(found.high, again.high);
}

TEST(Proportion, KnowsFromAMeasureBehindTheOutcomesHowMuchClustersShare) {
  // All held. A measure without any share of the clusters leaves nearly all of the 200 products; one that the
  // clusters decide leaves the ten clusters.
  constexpr std::size_t kClusters = 10;
  constexpr std::size_t kEach = 20;
  const std::vector<bool> held(kClusters * kEach, true);
  std::vector<std::size_t> cluster;
  std::vector<double> own;
  std::vector<double> shared;
  for (std::size_t i = 0; i < held.size(); ++i) {
    cluster.push_back(i % kClusters);
    own.push_back(unit_random(3, 1, i));
    shared.push_back(static_cast<double>(i % kClusters) + 1e-3 * unit_random(3, 2, i));
  }
  const Proportion blind = proportion(held, cluster, 0.95);
  const Proportion free = proportion(held, cluster, 0.95, own);
  const Proportion bound = proportion(held, cluster, 0.95, shared);
  EXPECT_EQ(blind.effective_size, kClusters);
  // Without a share only Student's t of 9 degrees of freedom costs: (1.97 / 2.26)^2 = 0.76, and a chance share of
  // the measure up to about 0.05 makes that 0.4.
  EXPECT_GT(free.effective_size, 0.4 * 200.0);
  EXPECT_LE(free.effective_size, 200.0);
  EXPECT_NEAR(bound.effective_size, kClusters, 0.1 * kClusters);
  EXPECT_GT(free.interval.low, bound.interval.low);
}

TEST(Bootstrap, TakesTheSameNumberOfReplicatesOffBothEnds) {
  std::vector<double> replicates(1000);
  std::iota(replicates.begin(), replicates.end(), 1.0);
  const Interval found = percentile_interval(replicates, 0.95);
  EXPECT_EQ(found.low, 25.0);
  EXPECT_EQ(found.high, 976.0);
  const Interval few = percentile_interval({3.0, 1.0, 2.0}, 0.95);
  EXPECT_EQ(few.low, 1.0);
  EXPECT_EQ(few.high, 3.0);
  EXPECT_TRUE(std::isnan(percentile_interval({1.0, kNaN}, 0.95).low));
  EXPECT_TRUE(std::isnan(percentile_interval({}, 0.95).high));
}

TEST(SampleQuantile, IsTheLeastValueThatThePartDoesNotExceed) {
  std::vector<double> values(100);
  std::iota(values.begin(), values.end(), 1.0);
  std::reverse(values.begin(), values.end());
  for (int percent = 1; percent <= 100; ++percent) {
    EXPECT_EQ(sample_quantile(values, percent / 100.0), percent);  // 0.07 * 100 is 7 and a bit: still the seventh
  }
  EXPECT_EQ(sample_quantile(values, 0.0), 1.0);
  EXPECT_EQ(sample_quantile(values, 0.501), 51.0);
  EXPECT_EQ(sample_quantile({4.0, kInf}, 1.0), kInf);
  EXPECT_TRUE(std::isnan(sample_quantile({1.0, kNaN, 2.0}, 0.5)));
  EXPECT_TRUE(std::isnan(sample_quantile({}, 0.5)));
}

}  // namespace
}  // namespace unbruised::studies

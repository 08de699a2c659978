// Do intervals contain the truth as often as they say, and are they no wider than they need be? Studies on
// products whose answer is a formula of their properties, for every design, with and without factor groups.

#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "studies/scenarios/product_sample.hpp"
#include "studies/statistics/replicates.hpp"
#include "studies/statistics/sensitivity.hpp"
#include "tests/studies/config/config_testing.hpp"

namespace unbruised::studies {
namespace {

using testing::gripped_block;
using testing::study_of;

constexpr double kConfidence = 0.95;
constexpr double kZ95 = 1.959963984540054;

// -- Products of three properties, each uniform in (0, 1) once scaled. --------------------------------------

std::string random_key(const std::string& key, double from, double to) {
  return "[[random]]\nkey = \"" + key + "\"\ndistribution = \"uniform\"\nfrom = " + std::to_string(from) +
         "\nto = " + std::to_string(to) + "\n";
}

/// @param groups 0: all three properties are each product's own; else the third is shared by the factor's groups
Study sampled_study(const std::string& design, std::size_t count, std::size_t groups) {
  return study_of(gripped_block("sample") + random_key("product.friction", 0.0, 1.0) +
                  random_key("strategy.grip_force_N", 1.0, 2.0) +
                  (groups > 0 ? random_key("product.youngs_modulus_Pa", 1e5, 2e5)
                              : random_key("strategy.lift_acceleration_m_s2", 1.0, 2.0)) +
                  "[sampling]\ndesign = \"" + design + "\"\ncount = " + std::to_string(count) +
                  (groups > 0 ? "\nfactor_groups = " + std::to_string(groups) : "") + "\n");
}

/// The sum of the three uniform numbers of each product, less 1.5.
std::vector<double> sums_of(const ProductSample& sample, bool is_shared) {
  std::vector<double> sums;
  for (std::size_t i = 0; i < sample.size(); ++i) {
    const std::span<const double> v = sample.at(i);
    const double third = is_shared ? v[2] / 1e5 - 1.0 : v[2] - 1.0;
    sums.push_back(v[0] + v[1] - 1.0 + third - 1.5);
  }
  return sums;
}

/// P(sum <= x) of three uniform numbers less 1.5 (Irwin and Hall).
double part_below(double x) {
  const double t = x + 1.5;
  double sum = 0.0;
  for (int k = 0; k <= 3; ++k) {
    const double binomial = k == 0 || k == 3 ? 1.0 : 3.0;
    if (t > k) sum += (k % 2 == 0 ? 1.0 : -1.0) * binomial * std::pow(t - k, 3);
  }
  return sum / 6.0;
}
double sum_at(double part) {
  double low = -1.5, high = 1.5;
  for (int i = 0; i < 60; ++i) (part_below(0.5 * (low + high)) < part ? low : high) = 0.5 * (low + high);
  return low;
}

/// Intervals of one number over many studies.
class Coverage {
 public:
  explicit Coverage(double truth) : truth_(truth) {}
  void add(double estimate, const Interval& interval) {
    ++studies_;
    sum_ += estimate - truth_;
    squares_ += (estimate - truth_) * (estimate - truth_);
    const double width = interval.high - interval.low;
    if (std::isfinite(width)) {
      widths_ += width;
      bounded_ += 1.0;
    }
    if (interval.low <= truth_ && truth_ <= interval.high) covered_ += 1.0;
  }
  [[nodiscard]] double coverage() const { return covered_ / studies_; }
  [[nodiscard]] double bounded() const { return bounded_ / studies_; }
  /// The mean width over that of the true spread of the estimate.
  [[nodiscard]] double width() const {
    const double mean = sum_ / studies_;
    return widths_ / bounded_ / (2.0 * kZ95 * std::sqrt(squares_ / studies_ - mean * mean));
  }

 private:
  double truth_ = 0.0, studies_ = 0.0, sum_ = 0.0, squares_ = 0.0, widths_ = 0.0, bounded_ = 0.0, covered_ = 0.0;
};

struct Wanted {
  double least, most;  ///< coverage
  double width;        ///< at most
};

void expect(const Coverage& found, const Wanted& wanted, const std::string& what) {
  EXPECT_GE(found.coverage(), wanted.least) << what;
  EXPECT_LE(found.coverage(), wanted.most) << what;
  EXPECT_LE(found.width(), wanted.width) << what;
  EXPECT_GE(found.bounded(), 0.97) << what;  // a quantile near the end of a sample may be beyond it
  std::printf("%-60s coverage %.3f, width %.2f, bounded %.3f\n", what.c_str(), found.coverage(), found.width(),
              found.bounded());
}

struct Sampling {
  std::string design;
  std::size_t count = 0;
  std::size_t groups = 0;
  [[nodiscard]] std::string text() const {
    return design + ", " + std::to_string(count) + " products, " + std::to_string(groups) + " groups: ";
  }
};

/// 0.95 within 2.5 standard errors of 400 studies (0.011): 0.92 to 0.977; what is whole numbers, the few products
/// that fail, covers more often. Widths: 1.16 of the true spread from eight replicates, 5 % from the spread of
/// 400.
constexpr std::size_t kStudies = 400;
constexpr Wanted kOfMeans{0.92, 0.98, 1.3};
constexpr Wanted kOfParts{0.92, 0.99, 1.3};
constexpr Wanted kOfQuantiles{0.92, 0.995, 1.45};  ///< ends are values of the sample, the next ones outwards

void means_cover(const Sampling& sampling) {
  const Study study = sampled_study(sampling.design, sampling.count, sampling.groups);
  const double smooth_truth = std::pow(2.0 * std::sinh(0.5), 3);  // E exp of each number about its middle
  // E max(0, x) of the sum: 2 int_0^1.5 of its density over x / 2, 13 / 64 / ... by quadrature of part_below.
  double kinked_truth = 0.0;
  constexpr int kParts = 20000;
  for (int i = 0; i < kParts; ++i) kinked_truth += (1.0 - part_below(1.5 * (i + 0.5) / kParts)) * 1.5 / kParts;
  Coverage smooth(smooth_truth), kinked(kinked_truth);
  for (std::uint64_t seed = 0; seed < kStudies; ++seed) {
    const ProductSample sample = draw_products(study, sampling.count, 1000 + seed);
    std::vector<double> curved, bent;
    for (const double x : sums_of(sample, sampling.groups > 0)) {
      curved.push_back(std::exp(x));
      bent.push_back(std::max(0.0, x));
    }
    const MeanInterval of_curved = sampled_mean(curved, sample.structure(), kConfidence);
    const MeanInterval of_bent = sampled_mean(bent, sample.structure(), kConfidence);
    smooth.add(of_curved.mean, of_curved.interval);
    kinked.add(of_bent.mean, of_bent.interval);
  }
  expect(smooth, kOfMeans, sampling.text() + "smooth mean");
  expect(kinked, kOfMeans, sampling.text() + "kinked mean");
}

void proportions_cover(const Sampling& sampling, double p, const Wanted& wanted) {
  const Study study = sampled_study(sampling.design, sampling.count, sampling.groups);
  const double threshold = sum_at(p);
  Coverage part(p);
  for (std::uint64_t seed = 0; seed < kStudies; ++seed) {
    const ProductSample sample = draw_products(study, sampling.count, 2000 + seed);
    std::vector<bool> held;
    std::vector<double> measure;
    for (const double x : sums_of(sample, sampling.groups > 0)) {
      held.push_back(x < threshold);
      measure.push_back(threshold - x);
    }
    const Proportion found = sampled_proportion(held, sample.structure(), kConfidence, measure);
    part.add(found.estimate, found.interval);
  }
  expect(part, wanted, sampling.text() + "P = " + std::to_string(p));
}

void quantiles_cover(const Sampling& sampling, double p, const Wanted& wanted) {
  const Study study = sampled_study(sampling.design, sampling.count, sampling.groups);
  Coverage quantile(sum_at(p));
  for (std::uint64_t seed = 0; seed < kStudies; ++seed) {
    const ProductSample sample = draw_products(study, sampling.count, 3000 + seed);
    const std::vector<double> sums = sums_of(sample, sampling.groups > 0);
    quantile.add(sample_quantile(sums, p), quantile_interval(sums, p, sample.structure(), kConfidence));
  }
  expect(quantile, wanted, sampling.text() + "quantile " + std::to_string(p));
}

TEST(IntervalsOfDesigns, CoverAsOftenAsTheySayAndAreNoWiderThanTheyNeedBe) {
  means_cover({"sobol", 64, 0});
  proportions_cover({"sobol", 64, 0}, 0.8, kOfParts);
  quantiles_cover({"latin_hypercube", 64, 0}, 0.5, kOfParts);
  proportions_cover({"latin_hypercube", 64, 16}, 0.8, kOfParts);
}

TEST(HeavyIntervalsOfDesigns, CoverAsOftenAsTheySayAndAreNoWiderThanTheyNeedBe) {
  // Two of 200 products fail: half of the samples show too few to tell a spread, and the interval is Wilson's.
  const Wanted rare{0.92, 0.995, 1.8};
  std::vector<Sampling> all;
  for (const char* design : {"random", "sobol", "latin_hypercube"}) {
    for (const std::size_t count : {64U, 200U, 256U}) all.push_back({design, count, 0});
  }
  for (const char* design : {"sobol", "latin_hypercube"}) all.push_back({design, 200, 24});
  for (const Sampling& sampling : all) {
    means_cover(sampling);
    for (const double p : {0.03, 0.5, 0.9, 0.97}) proportions_cover(sampling, p, kOfParts);
    proportions_cover(sampling, 0.99, rare);
    quantiles_cover(sampling, 0.5, kOfParts);
    if (sampling.count < 200) continue;  // of 64 products three lie below the quantile of 5 %
    for (const double p : {0.05, 0.95}) quantiles_cover(sampling, p, kOfQuantiles);
  }
}

// -- Sensitivity. ------------------------------------------------------------------------------------------

/// Ishigami and Homma (1990): sin x1 + 7 sin^2 x2 + 0.1 x3^4 sin x1, x uniform in (-pi, pi).
double ishigami(std::span<const double> u) {
  const auto x = [u](std::size_t i) { return std::numbers::pi * (2.0 * u[i] - 1.0); };
  return std::sin(x(0)) * (1.0 + 0.1 * std::pow(x(2), 4)) + 7.0 * std::sin(x(1)) * std::sin(x(1));
}

void indices_cover(DesignKind kind, std::size_t samples, const Wanted& wanted) {
  const double kFirst[] = {0.313905, 0.442411, 0.0};
  const double kTotal[] = {0.557589, 0.442411, 0.243684};
  std::vector<Coverage> first(kFirst, kFirst + 3), total(kTotal, kTotal + 3);
  for (std::uint64_t seed = 0; seed < kStudies; ++seed) {
    const UnitDesign design = sobol_index_design(samples, 3, kind, 4000 + seed);
    std::vector<double> answers;
    for (std::size_t i = 0; i < design.size(); ++i) {
      answers.push_back(ishigami(std::span(design.values).subspan(3 * i, 3)));
    }
    const SobolResult found = sobol_indices(design, answers, 200, kConfidence, seed);
    for (std::size_t i = 0; i < 3; ++i) {
      first[i].add(found.indices[i].first, found.indices[i].first_interval);
      total[i].add(found.indices[i].total, found.indices[i].total_interval);
    }
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string what = std::to_string(samples) + " base samples, key " + std::to_string(i);
    expect(first[i], wanted, what + ", first order");
    expect(total[i], wanted, what + ", total");
  }
}

TEST(HeavyIntervalsOfDesigns, OfSobolIndicesCoverToo) {
  for (const DesignKind kind : {DesignKind::sobol, DesignKind::latin_hypercube}) {
    for (const std::size_t samples : {128, 256}) indices_cover(kind, samples, {0.91, 0.98, 1.3});
  }
}

}  // namespace
}  // namespace unbruised::studies

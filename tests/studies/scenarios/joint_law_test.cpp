// Products whose properties vary together: by rank correlations, or by the rows of data.

#include "studies/scenarios/joint_law.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "studies/scenarios/product_sample.hpp"
#include "studies/statistics/correlation.hpp"
#include "studies/statistics/replicates.hpp"
#include "studies/statistics/scores.hpp"
#include "tests/studies/config/config_testing.hpp"

namespace unbruised::studies {
namespace {

using testing::gripped_block;
using testing::study_of;

std::string random_block(const std::string& key, const std::string& distribution) {
  return "[[random]]\nkey = \"" + key + "\"\n" + distribution + "\n";
}

std::string correlation(const std::string& a, const std::string& b, double value) {
  return "[[correlation]]\nbetween = [\"" + a + "\", \"" + b + "\"]\nvalue = " + std::to_string(value) + "\n";
}

std::string sampling(const std::string& design, std::size_t count, std::size_t groups) {
  return "[sampling]\ndesign = \"" + design + "\"\ncount = " + std::to_string(count) +
         "\nfactor_groups = " + std::to_string(groups) + "\n";
}

const std::string kModulus = "product.youngs_modulus_Pa";
const std::string kFriction = "product.friction";
const std::string kYield = "product.yield_stress_Pa";
const std::string kMass = "product.mass_kg";

/// A study of products that yield.
std::string yielding_block() {
  std::string study = gripped_block("sample");
  return study.insert(study.find("[gripper]"), "yield_stress_Pa = 2e3\ntangent_modulus_Pa = 5e3\n");
}

/// Friction, modulus, yield stress and mass; the modulus and the mass change the factored matrix.
std::string four_keys() {
  return yielding_block() +
         random_block(kFriction,
                      "distribution = \"normal\"\nmean = 0.5\nstandard_deviation = 0.05\nat_least = 0.1") +
         random_block(kModulus,
                      "distribution = \"lognormal\"\nmean = 1e5\nrelative_deviation = 0.3\nat_least = 1e4") +
         random_block(kYield, "distribution = \"uniform\"\nfrom = 1e3\nto = 3e3") +
         random_block(kMass, "distribution = \"triangular\"\nfrom = 0.1\nmode = 0.11\nto = 0.14");
}

TEST(CorrelatedKeys, HaveTheRankCorrelationsThatWereAskedFor) {
  const std::map<std::pair<std::size_t, std::size_t>, double> wanted = {
      {{0, 1}, -0.4}, {{1, 2}, 0.79}, {{0, 2}, -0.2}, {{1, 3}, 0.3}, {{0, 3}, 0.0}, {{2, 3}, 0.0}};
  for (const char* design : {"random", "sobol", "latin_hypercube"}) {
    const Study study = study_of(four_keys() + correlation(kFriction, kModulus, -0.4) +
                                 correlation(kModulus, kYield, 0.79) + correlation(kYield, kFriction, -0.2) +
                                 correlation(kMass, kModulus, 0.3) + sampling(design, 10'000, 0));
    const ProductSample sample = draw_products(study, 10'000, 5);
    for (const auto& [pair, value] : wanted) {
      // The standard error of 10,000 independent pairs is at most 0.01.
      EXPECT_NEAR(spearman(sample.column(pair.first), sample.column(pair.second)), value, 0.02) << design;
    }
  }
}

TEST(CorrelatedKeys, KeepTheirOwnDistributions) {
  const Study study = study_of(four_keys() + correlation(kModulus, kYield, 0.79) + sampling("sobol", 4096, 0));
  const ProductSample sample = draw_products(study, 4096, 5);
  for (std::size_t k = 0; k < 4; ++k) {
    std::vector<double> column = sample.column(k);
    std::sort(column.begin(), column.end());
    double most = 0.0;
    for (std::size_t i = 0; i < column.size(); ++i) {
      const double part = cumulative(study.randoms()[k].distribution, column[i]);
      most = std::max(most, std::abs(part - (static_cast<double>(i) + 0.5) / 4096.0));
    }
    EXPECT_LT(most, 1.63 / std::sqrt(4096.0)) << study.randoms()[k].key;  // Kolmogorov's 1 % of independent draws
  }
}

TEST(CorrelatedKeys, LeaveTheOthersAndTheFirstOfThemAsTheyWere) {
  const Study with = study_of(four_keys() + correlation(kModulus, kYield, 0.79) + sampling("sobol", 64, 16));
  const Study without = study_of(four_keys() + sampling("sobol", 64, 16));
  const ProductSample a = draw_products(with, 64, 3);
  const ProductSample b = draw_products(without, 64, 3);
  for (const std::size_t k : {0U, 1U, 3U}) EXPECT_EQ(a.column(k), b.column(k));
  EXPECT_NE(a.column(2), b.column(2));
  EXPECT_EQ(a.group, b.group);
}

TEST(CorrelatedKeys, OfTheFactorAreSharedByTheirGroupAndOthersFollowThem) {
  const Study study = study_of(four_keys() + correlation(kYield, kModulus, 0.79) +
                               correlation(kModulus, kMass, 0.5) + sampling("sobol", 512, 64));
  const ProductSample sample = draw_products(study, 512, 3);
  std::map<std::size_t, std::pair<double, double>> of_group;
  for (std::size_t i = 0; i < sample.size(); ++i) {
    const std::pair<double, double> own = {sample.at(i)[1], sample.at(i)[3]};
    const auto [place, is_new] = of_group.try_emplace(sample.group[i], own);
    EXPECT_EQ(place->second, own);
  }
  EXPECT_EQ(of_group.size(), 64U);
  // 64 values of the modulus: the standard error of their correlation is about 0.4 / sqrt(64).
  EXPECT_NEAR(spearman(sample.column(1), sample.column(2)), 0.79, 0.1);
}

TEST(CorrelatedKeys, MayBeErrorsOfWhatARobotIsTold) {
  const std::string force = "strategy.grip_force_N";
  const Study study = study_of(four_keys() + random_block(force, "relative = 0.1") +
                               correlation(force, kYield, -0.6) + sampling("random", 10'000, 16));
  const ProductSample sample = draw_products(study, 10'000, 3);
  EXPECT_NEAR(spearman(sample.column(4), sample.column(2)), -0.6, 0.02);
}

/// Eight rows of modulus and yield stress, and of friction and mass.
const std::vector<double> kModuli = {1e5, 2e5, 3e5, 4e5, 5e5, 6e5, 7e5, 8e5};
const std::vector<double> kYields = {3e3, 1e3, 8e3, 2e3, 5e3, 4e3, 7e3, 6e3};

std::string rows() {
  const auto list = [](const std::vector<double>& values) {
    std::string text = "[";
    for (const double value : values) text += std::to_string(value) + ", ";
    return text + "]";
  };
  return yielding_block() + random_block(kFriction, "distribution = \"uniform\"\nfrom = 0.4\nto = 0.6") +
         random_block(kModulus, "distribution = \"data\"\nzip = \"fruit\"\ndata = " + list(kModuli)) +
         random_block(kYield, "distribution = \"data\"\nzip = \"fruit\"\ndata = " + list(kYields));
}

TEST(RowsOfData, AreDrawnWholeAndEvenly) {
  const Study study = study_of(rows() + sampling("sobol", 64, 0));
  const ProductSample sample = draw_products(study, 64, 9);
  std::map<std::size_t, std::size_t> times;
  for (std::size_t i = 0; i < sample.size(); ++i) {
    const auto row =
        static_cast<std::size_t>(std::find(kModuli.begin(), kModuli.end(), sample.at(i)[1]) - kModuli.begin());
    ASSERT_LT(row, kModuli.size());
    EXPECT_EQ(sample.at(i)[2], kYields[row]);
    ++times[row];
  }
  // Each of the eight designs has one point in each eighth.
  for (std::size_t row = 0; row < 8; ++row) EXPECT_EQ(times[row], 8U);
}

TEST(RowsOfData, AreSharedByAGroupWhenOneOfTheirKeysChangesTheFactor) {
  const Study study = study_of(rows() + sampling("sobol", 64, 16));
  const ProductSample sample = draw_products(study, 64, 9);
  std::map<std::size_t, std::pair<double, double>> of_group;
  for (std::size_t i = 0; i < sample.size(); ++i) {
    const std::pair<double, double> own = {sample.at(i)[1], sample.at(i)[2]};
    EXPECT_EQ(of_group.try_emplace(sample.group[i], own).first->second, own);
  }
  EXPECT_EQ(of_group.size(), 16U);
}

TEST(RowsOfData, OfOneKeyAloneAreDrawnByTheirQuantilesAndMayBeCorrelated) {
  const Study study =
      study_of(four_keys().substr(0, four_keys().find("[[random]]\nkey = \"" + kMass)) +
               random_block(kMass, "distribution = \"data\"\ndata = [0.13, 0.1, 0.12, 0.11, 0.14]") +
               correlation(kYield, kMass, 0.6) + sampling("random", 10'000, 0));
  const ProductSample sample = draw_products(study, 10'000, 4);
  // Five levels lose a little: the correlation of a number with its level of five is sqrt(1 - 1/25).
  EXPECT_NEAR(spearman(sample.column(2), sample.column(3)), 0.6 * std::sqrt(1.0 - 1.0 / 25.0), 0.02);
}

/// The part of the products with z_friction + z_modulus below z, both standard normal with a rank correlation:
/// Phi(z / sqrt(2 + 2 r)), r = 2 sin(pi rank / 6).
struct Coverage {
  double covered = 0.0;
  double width = 0.0;
};
Coverage coverage_of_parts(const std::string& design, std::size_t groups, double p) {
  constexpr std::size_t kStudies = 400;
  constexpr std::size_t kCount = 64;
  constexpr double kRank = 0.79;
  const Study study = study_of(
      yielding_block() +
      random_block(kFriction, "distribution = \"normal\"\nmean = 0.5\nstandard_deviation = 0.05\nat_least = 0.1") +
      random_block(kModulus, "distribution = \"normal\"\nmean = 1e6\nstandard_deviation = 1e5\nat_least = 1e5") +
      correlation(kFriction, kModulus, kRank) + sampling(design, kCount, groups));
  const double spread = std::sqrt(2.0 + 2.0 * normal_correlation(kRank));
  const double threshold = spread * normal_quantile(p);
  Coverage found;
  double squares = 0.0;
  for (std::uint64_t seed = 0; seed < kStudies; ++seed) {
    const ProductSample sample = draw_products(study, kCount, 4000 + seed);
    std::vector<bool> below;
    std::vector<double> measure;
    for (std::size_t i = 0; i < sample.size(); ++i) {
      const double sum = (sample.at(i)[0] - 0.5) / 0.05 + (sample.at(i)[1] - 1e6) / 1e5;
      below.push_back(sum < threshold);
      measure.push_back(threshold - sum);
    }
    const Proportion part = sampled_proportion(below, sample.structure(), 0.95, measure);
    found.covered += part.interval.low <= p && p <= part.interval.high ? 1.0 / kStudies : 0.0;
    found.width += (part.interval.high - part.interval.low) / kStudies;
    squares += (part.estimate - p) * (part.estimate - p) / kStudies;
  }
  found.width /= 2.0 * normal_score(0.95) * std::sqrt(squares);
  return found;
}

TEST(CorrelatedKeys, LeaveIntervalsOfProbabilitiesTheirCoverage) {
  for (const char* design : {"random", "sobol", "latin_hypercube"}) {
    for (const std::size_t groups : {0U, 16U}) {
      const Coverage found = coverage_of_parts(design, groups, 0.8);
      std::printf("%s, %zu groups: coverage %.3f, width %.2f of the true spread\n", design, groups, found.covered,
                  found.width);
      // As in interval_coverage_test: 0.95 within 2.5 standard errors of 400 studies.
      EXPECT_GE(found.covered, 0.92) << design << ' ' << groups;
      EXPECT_LE(found.covered, 0.99) << design << ' ' << groups;
    }
  }
}

}  // namespace
}  // namespace unbruised::studies

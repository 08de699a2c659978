// Products that are drawn: replicates and groups.

#include "studies/scenarios/product_sample.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/studies/config/config_testing.hpp"

namespace unbruised::studies {
namespace {

using testing::gripped_block;
using testing::study_of;

/// Friction, and with `is_shared` stiffness.
Study sampled_study(const std::string& design, std::size_t count, std::size_t groups) {
  const std::string stiffness =
      "[[random]]\nkey = \"product.youngs_modulus_Pa\"\ndistribution = \"uniform\"\nfrom = 1e5\nto = 2e5\n";
  return study_of(gripped_block("sample") +
                  "[[random]]\nkey = \"product.friction\"\ndistribution = \"uniform\"\nfrom = 0.0\nto = 1.0\n" +
                  (groups > 0 ? stiffness : "") + "[sampling]\ndesign = \"" + design +
                  "\"\ncount = " + std::to_string(count) +
                  (groups > 0 ? "\nfactor_groups = " + std::to_string(groups) : "") + "\n");
}

ProductSample drawn(const std::string& design, std::size_t count, std::size_t groups, std::uint64_t seed = 1) {
  return draw_products(sampled_study(design, count, groups), count, seed);
}

TEST(DrawnProducts, AreStratifiedWithinEachReplicate) {
  const ProductSample sample = drawn("sobol", 64, 0);
  for (std::size_t r = 0; r < 8; ++r) {
    std::set<int> strata;
    for (std::size_t i = 0; i < 64; ++i) {
      if (sample.replicate[i] == r) strata.insert(static_cast<int>(8.0 * sample.at(i)[0]));
    }
    EXPECT_EQ(strata.size(), 8U) << "replicate " << r;
  }
}

TEST(DrawnProducts, OfARandomDesignHaveNoReplicates) { EXPECT_TRUE(drawn("random", 64, 0).replicate.empty()); }

TEST(DrawnProducts, ShareGroupsOfTheirOwnReplicateOnlyAndEvenly) {
  for (const char* design : {"sobol", "latin_hypercube"}) {
    for (const std::size_t groups : {5U, 12U, 16U, 20U}) {
      const ProductSample sample = drawn(design, 200, groups);
      std::vector<std::set<std::size_t>> replicates(groups);
      std::vector<std::size_t> size(groups);
      for (std::size_t i = 0; i < sample.size(); ++i) {
        replicates[sample.group[i]].insert(sample.replicate[i]);
        ++size[sample.group[i]];
      }
      const auto [least, most] = std::minmax_element(size.begin(), size.end());
      for (const std::set<std::size_t>& own : replicates) EXPECT_EQ(own.size(), 1U) << design << ' ' << groups;
      // 20 groups are dealt to 8 replicates by twos and threes, of 25 products each.
      EXPECT_LE(*most, groups % 8 == 0 || groups < 16 ? *least + 1 : 2 * *least) << design << ' ' << groups;
    }
  }
}

TEST(DrawnProducts, OfOneGroupShareItsStiffnessAndNoOtherDoes) {
  const ProductSample sample = drawn("sobol", 64, 16);
  std::vector<std::set<double>> values(16);
  std::set<double> all;
  for (std::size_t i = 0; i < 64; ++i) values[sample.group[i]].insert(sample.at(i)[1]);
  for (const std::set<double>& own : values) {
    ASSERT_EQ(own.size(), 1U);
    all.insert(*own.begin());
  }
  EXPECT_EQ(all.size(), 16U);
}

TEST(DrawnProducts, FewAreDrawnOnTheirOwnAndTheFirstOfManyAreThoseOfFew) {
  EXPECT_EQ(replicate_count(DesignKind::sobol, 7), 7U);
  EXPECT_EQ(replicate_count(DesignKind::sobol, 12), 6U);
  EXPECT_EQ(replicate_count(DesignKind::latin_hypercube, 15), 7U);
  EXPECT_EQ(replicate_count(DesignKind::sobol, 16), 8U);
  EXPECT_EQ(replicate_count(DesignKind::sobol, 100000), 8U);
  EXPECT_EQ(replicate_count(DesignKind::random, 100000), 1U);
  const ProductSample few = drawn("sobol", 64, 0);
  const ProductSample first = drawn("sobol", 200, 0).first(64);
  EXPECT_EQ(few.values, first.values);
  EXPECT_EQ(few.replicate, first.replicate);
}

}  // namespace
}  // namespace unbruised::studies

#include "core/lanes/lane.hpp"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace unbruised {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Plain numbers, huge and tiny ones, zeros, infinities and NaN, different in every lane.
std::vector<Lane> samples() {
  std::mt19937 random(1998);
  std::uniform_real_distribution<double> mantissa(-2.0, 2.0);
  std::uniform_int_distribution<int> exponent(-300, 300);
  const std::vector<double> odd = {0.0, -0.0, 1.0, -1.0, kInfinity, -kInfinity, kNaN, 1e-310, 1e308};
  std::vector<Lane> all;
  for (int k = 0; k < 60; ++k) {
    Lane x(0.0);
    for (int lane = 0; lane < kLanes; ++lane) {
      const bool special = (k + lane) % 5 == 0;
      x.set(lane, special ? odd[static_cast<std::size_t>(k + 3 * lane) % odd.size()]
                          : std::ldexp(mantissa(random), k % 2 == 0 ? exponent(random) : 0));
    }
    all.push_back(x);
  }
  return all;
}

void expect_same(double lane_value, double scalar_value, const char* what, int lane) {
  if (std::isnan(scalar_value)) {
    EXPECT_TRUE(std::isnan(lane_value)) << what << " in lane " << lane;
  } else {
    EXPECT_EQ(lane_value, scalar_value) << what << " in lane " << lane;
  }
}

TEST(Lane, EveryOperationIsTheScalarOneInEveryLane) {
  const std::vector<Lane> x = samples();
  for (std::size_t i = 0; i + 1 < x.size(); ++i) {
    const Lane a = x[i], b = x[i + 1];
    const Lane sum = a + b, difference = a - b, product = a * b, quotient = a / b, negative = -a, size = abs(a);
    const Lane root = sqrt(abs(a));
    const Mask less = a<b, more = a> b, at_most = a <= b, at_least = a >= b, equal = a == b;
    const Lane chosen = select(less, a, b);
    Lane in_place = a;
    in_place += b;
    for (int lane = 0; lane < kLanes; ++lane) {
      const double p = a[lane], q = b[lane];
      expect_same(sum[lane], p + q, "+", lane);
      expect_same(in_place[lane], p + q, "+=", lane);
      expect_same(difference[lane], p - q, "-", lane);
      expect_same(product[lane], p * q, "*", lane);
      expect_same(quotient[lane], p / q, "/", lane);
      expect_same(negative[lane], -p, "negation", lane);
      expect_same(size[lane], std::abs(p), "abs", lane);
      expect_same(root[lane], std::sqrt(std::abs(p)), "sqrt", lane);
      EXPECT_EQ(less[lane], p < q);
      EXPECT_EQ(more[lane], p > q);
      EXPECT_EQ(at_most[lane], p <= q);
      EXPECT_EQ(at_least[lane], p >= q);
      EXPECT_EQ(equal[lane], p == q);
      EXPECT_EQ((less & at_most)[lane], p < q);
      EXPECT_EQ((less | more)[lane], p < q || p > q);
      EXPECT_EQ((!less)[lane], !(p < q));
      expect_same(chosen[lane], p < q ? p : q, "select", lane);
      if (std::isnan(p) || std::isnan(q)) continue;
      expect_same(max(a, b)[lane], std::max(p, q), "max", lane);
      expect_same(min(a, b)[lane], std::min(p, q), "min", lane);
    }
  }
}

TEST(Lane, OneLaneIsSetWithoutTouchingTheOthers) {
  for (int lane = 0; lane < kLanes; ++lane) {
    Lane x(3.0);
    x.set(lane, -7.0);
    Mask mask(false);
    mask.set(lane, true);
    EXPECT_TRUE(any(mask));
    for (int other = 0; other < kLanes; ++other) {
      EXPECT_EQ(x[other], other == lane ? -7.0 : 3.0);
      EXPECT_EQ(mask[other], other == lane);
    }
  }
  EXPECT_TRUE(none(Mask(false)));
}

TEST(LaneArray, RowsAreStoredLaneInnermostAndAligned) {
  LaneArray rows(5);
  EXPECT_EQ(rows.rows(), 5u);
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(rows.data()) % kLaneAlignment, 0u);
  for (int lane = 0; lane < kLanes; ++lane) rows.at(3, lane) = lane + 0.5;
  const Lane row = rows.get(3);
  for (int lane = 0; lane < kLanes; ++lane) EXPECT_EQ(row[lane], lane + 0.5);
  rows.clear_lane(2);
  EXPECT_EQ(rows.at(3, 2), 0.0);
  EXPECT_EQ(rows.at(3, 1), 1.5);
}

TEST(MaskArray, RowsKeepOneMaskPerLane) {
  MaskArray rows(3);
  EXPECT_TRUE(none(rows.get(1)));
  Mask odd(false);
  for (int lane = 1; lane < kLanes; lane += 2) odd.set(lane, true);
  rows.put(1, odd);
  for (int lane = 0; lane < kLanes; ++lane) EXPECT_EQ(rows.at(1, lane), lane % 2 == 1);
  rows.clear_lane(3);
  EXPECT_FALSE(rows.at(1, 3));
  EXPECT_TRUE(rows.at(1, 5));
  EXPECT_TRUE(none(rows.get(0)) && none(rows.get(2)));
}

}  // namespace
}  // namespace unbruised

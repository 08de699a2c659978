// Fits of closed forms: known keys are found, their intervals cover, and what a curve cannot tell is named.

#include "studies/kinds/curve_fit.hpp"

#include <cmath>
#include <cstdio>
#include <vector>

#include <gtest/gtest.h>

#include "studies/statistics/design.hpp"
#include "studies/statistics/scores.hpp"

namespace unbruised::studies {
namespace {

/// F = a (1 - exp(-x / b)), as a simulated curve of many steps.
Curve saturating(double a, double b) {
  Curve curve;
  for (int i = 1; i <= 2000; ++i) {
    const double x = 1e-6 * i;
    curve.time_s.push_back(0.01 * i);
    curve.closure_m.push_back(x);
    curve.force_N.push_back(a * -std::expm1(-x / b));
    curve.slide_N.push_back(0.0);
  }
  return curve;
}

std::vector<SearchVariable> two_keys() {
  return {{.key = "a", .units = "N", .from = 1.0, .to = 100.0, .scale = optimizer::Scale::log, .start = {}},
          {.key = "b", .units = "m", .from = 1e-4, .to = 5e-3, .scale = optimizer::Scale::linear, .start = {}}};
}

std::optional<std::vector<Curve>> saturating_at(const std::vector<std::vector<double>>& points) {
  std::vector<Curve> curves;
  for (const std::vector<double>& point : points) curves.push_back(saturating(point[0], point[1]));
  return curves;
}

/// Normal noise on 25 points.
MeasuredCurve measured(double a, double b, double noise_N, std::uint64_t seed) {
  MeasuredCurve curve{.specimen = "s", .x = {}, .y = {}, .outcome = {}};
  for (std::uint64_t i = 1; i <= 25; ++i) {
    const double x = 8e-5 * static_cast<double>(i);
    curve.x.push_back(x);
    curve.y.push_back(a * -std::expm1(-x / b) + noise_N * normal_quantile(unit_random(seed, 1, i)));
  }
  return curve;
}

TEST(CurveFits, FindWhatACurveWasMadeWith) {
  const auto fit = fit_specimen(two_keys(), {}, measured(7.0, 9e-4, 0.0, 1), saturating_at);
  ASSERT_TRUE(fit && fit->is_fitted);
  // The curve is linear between its steps of 1 um: x^2 / 8 F'' of it, 1e-7.
  EXPECT_NEAR(fit->values[0], 7.0, 7e-6);
  EXPECT_NEAR(fit->values[1], 9e-4, 9e-10);
  EXPECT_LT(fit->rms_residual, 1e-5);
  EXPECT_LE(fit->scenarios, fit_scenarios_at_most(2, 200));
}

/// Fits of so many noisy curves cover each key in 95 % of them, give or take three standard errors.
void expect_coverage(int cases) {
  int of_a = 0, of_b = 0, of_both = 0;
  for (int i = 0; i < cases; ++i) {
    const auto seed = static_cast<std::uint64_t>(i);
    const double a = 3.0 * std::pow(10.0, unit_random(seed, 2, 0));
    const double b = 4e-4 + 1e-3 * unit_random(seed, 2, 1);
    const auto fit = fit_specimen(two_keys(), {}, measured(a, b, 0.02 * a, seed), saturating_at);
    ASSERT_TRUE(fit && fit->is_fitted);
    const bool has_a = fit->low[0] <= a && a <= fit->high[0];
    const bool has_b = fit->low[1] <= b && b <= fit->high[1];
    of_a += has_a ? 1 : 0;
    of_b += has_b ? 1 : 0;
    of_both += has_a && has_b ? 1 : 0;
  }
  std::printf("inside their 95 %% intervals: a %d, b %d, both %d of %d\n", of_a, of_b, of_both, cases);
  const double most = 3.0 * std::sqrt(0.95 * 0.05 * cases);
  EXPECT_NEAR(of_a, 0.95 * cases, most);
  EXPECT_NEAR(of_b, 0.95 * cases, most);
}

TEST(CurveFits, HaveIntervalsThatCoverAsOftenAsTheySay) { expect_coverage(40); }

TEST(HeavyCurveFits, HaveIntervalsThatCoverAsOftenAsTheySay) { expect_coverage(400); }

TEST(CurveFits, NameTheKeysThatACurveDoesNotTellApart) {
  // F = a b x: the product alone.
  const auto product_at = [](const std::vector<std::vector<double>>& points) {
    std::vector<Curve> curves;
    for (const std::vector<double>& point : points) {
      Curve curve;
      for (int i = 1; i <= 100; ++i) {
        curve.time_s.push_back(i);
        curve.closure_m.push_back(1e-5 * i);
        curve.force_N.push_back(point[0] * point[1] * i);
        curve.slide_N.push_back(0.0);
      }
      curves.push_back(curve);
    }
    return std::optional(curves);
  };
  std::vector<SearchVariable> keys = two_keys();
  keys[1] = {.key = "b", .units = "1", .from = 1.0, .to = 100.0, .scale = optimizer::Scale::log, .start = {}};
  MeasuredCurve line{.specimen = "s", .x = {}, .y = {}, .outcome = {}};
  for (std::uint64_t i = 1; i <= 20; ++i) {
    line.x.push_back(5e-5 * static_cast<double>(i));
    line.y.push_back(500.0 * static_cast<double>(i) * (1.0 + 0.01 * normal_quantile(unit_random(3, 1, i))));
  }
  const auto fit = fit_specimen(keys, {}, line, product_at);
  ASSERT_TRUE(fit && fit->is_fitted);
  EXPECT_NEAR(fit->values[0] * fit->values[1], 100.0, 1.0);
  EXPECT_GT(fit->weakest_error, 0.5);
  // Any of the range goes, where the other follows.
  for (const KeyInterval& interval : fit->intervals) {
    EXPECT_EQ(interval.low.kind, EndKind::range);
    EXPECT_EQ(interval.high.kind, EndKind::range);
  }
  EXPECT_DOUBLE_EQ(fit->low[0], 1.0);
  EXPECT_DOUBLE_EQ(fit->high[0], 100.0);
  // On equal logarithmic scales the two trade one against one.
  EXPECT_NEAR(fit->weakest[0] + fit->weakest[1], 0.0, 1e-3);
  EXPECT_NEAR(std::abs(fit->weakest[0]), std::sqrt(0.5), 1e-3);
}

TEST(CurveFits, HaveIntervalsThatEndWhereTheSumOfSquaresHasGrownByStudentsPart) {
  // Half of the curve's bend lies beyond its end, so that a and b trade, and their intervals are lopsided.
  const MeasuredCurve curve = measured(10.0, 4e-3, 0.05, 3);
  std::vector<SearchVariable> keys = two_keys();
  keys[1].to = 5e-2;
  const auto fit = fit_specimen(keys, {}, curve, saturating_at);
  ASSERT_TRUE(fit && fit->is_fitted);
  const auto squares = [&](double a, double b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
      const double r = a * -std::expm1(-curve.x[i] / b) - curve.y[i];
      sum += r * r;
    }
    return sum;
  };
  // For a given b the best a is a regression through 0.
  const auto least_at_b = [&](double b) {
    double xy = 0.0, xx = 0.0;
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
      const double f = -std::expm1(-curve.x[i] / b);
      xy += f * curve.y[i];
      xx += f * f;
    }
    return squares(xy / xx, b);
  };
  const double t = student_score(23.0, 0.95);
  const double allowed = squares(fit->values[0], fit->values[1]) * (1.0 + t * t / 23.0);
  for (const double end : {fit->low[1], fit->high[1]}) {
    EXPECT_NEAR(least_at_b(end) / allowed, 1.0, 1e-3) << end;
  }
  const double below = fit->values[1] - fit->low[1], above = fit->high[1] - fit->values[1];
  EXPECT_GT(above, 1.1 * below);
  EXPECT_EQ(fit->intervals[1].low.kind, EndKind::found);
  EXPECT_EQ(fit->intervals[1].high.kind, EndKind::found);
}

TEST(CurveFits, GoOnPastScenariosWithoutACurve) {
  const auto some_fail = [](const std::vector<std::vector<double>>& points) {
    auto curves = saturating_at(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (points[i][0] > 60.0) (*curves)[i] = {};
    }
    return curves;
  };
  const auto fit = fit_specimen(two_keys(), {}, measured(7.0, 9e-4, 0.0, 1), some_fail);
  ASSERT_TRUE(fit && fit->is_fitted);
  EXPECT_NEAR(fit->values[0], 7.0, 1e-4);
  const auto none = fit_specimen(two_keys(), {}, measured(7.0, 9e-4, 0.0, 1), [](const auto& points) {
    return std::optional(std::vector<Curve>(points.size()));
  });
  ASSERT_TRUE(none);
  EXPECT_FALSE(none->is_fitted);
}

TEST(CurveFits, EndWhereTheyAreStopped) {
  EXPECT_FALSE(fit_specimen(two_keys(), {}, measured(7.0, 9e-4, 0.0, 1),
                            [](const auto&) { return std::optional<std::vector<Curve>>(); }));
}

TEST(CurveValues, AreReadWhereTheCurveFirstIs) {
  Curve curve{.time_s = {0.1, 0.2, 0.3, 0.4},
              .closure_m = {1e-3, 3e-3, 2e-3, 4e-3},
              .force_N = {1.0, 5.0, 2.0, 7.0},
              .slide_N = {0.0, 0.1, 0.2, 0.3}};
  const std::vector<double> x = {5e-4, 2e-3, 3.5e-3, 8e-3};
  const std::vector<double> press = values_at(curve, CurveTest::press, x);
  EXPECT_DOUBLE_EQ(press[0], 0.5);   // from no force at the first contact
  EXPECT_DOUBLE_EQ(press[1], 3.0);   // on the way up
  EXPECT_DOUBLE_EQ(press[2], 6.0);   // from 3 mm, where it was before it opened
  EXPECT_DOUBLE_EQ(press[3], 14.0);  // on along the line from the first contact
  const std::vector<double> times = {0.05, 0.25, 1.0};
  EXPECT_EQ(values_at(curve, CurveTest::relaxation, times), (std::vector<double>{0.5, 3.5, 7.0}));
  EXPECT_EQ(values_at(curve, CurveTest::creep, times)[2], 4e-3);
  EXPECT_DOUBLE_EQ(values_at(curve, CurveTest::slide, times)[1], 0.15);
  EXPECT_TRUE(values_at({}, CurveTest::press, x).empty());
}

}  // namespace
}  // namespace unbruised::studies

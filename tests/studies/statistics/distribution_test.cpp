#include "studies/statistics/distribution.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <gtest/gtest.h>

#include "studies/statistics/design.hpp"

namespace unbruised::studies {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

Distribution normal(double mean, double sd) {
  return {.kind = DistributionKind::normal, .mean = mean, .standard_deviation = sd};
}
Distribution lognormal(double mean, double sd) {
  return {.kind = DistributionKind::lognormal, .mean = mean, .standard_deviation = sd};
}
Distribution uniform(double from, double to) {
  return {.kind = DistributionKind::uniform, .from = from, .to = to};
}
Distribution triangular(double from, double mode, double to) {
  return {.kind = DistributionKind::triangular, .from = from, .to = to, .mode = mode};
}
Distribution truncated(Distribution d, double at_least, double at_most) {
  d.at_least = at_least;
  d.at_most = at_most;
  return d;
}

/// One or more of each kind, whole and cut.
std::vector<Distribution> examples() {
  return {uniform(2.0, 5.0),
          truncated(uniform(2.0, 5.0), 1.0, 3.0),
          normal(0.095, 0.01),
          normal(-3.0, 2.0),
          truncated(normal(0.095, 0.01), 0.08, 0.12),
          truncated(normal(0.0, 1.0), 3.0, kInf),
          truncated(normal(0.0, 1.0), -kInf, -3.0),
          truncated(normal(0.0, 1.0), -0.1, kInf),
          lognormal(2.0, 0.3),
          lognormal(1.0e6, 2.0e6),
          truncated(lognormal(2.0, 0.3), 2.1, 4.0),
          triangular(1.0, 1.5, 4.0),
          triangular(1.0, 1.0, 4.0),
          triangular(1.0, 4.0, 4.0),
          truncated(triangular(1.0, 1.5, 4.0), 1.2, 2.0)};
}

/// Integral of f(quantile(u)) over u, in two parts where the quantile has a kink.
template <class Function>
double expectation(const Distribution& d, Function f, double kink = 0.5) {
  boost::math::quadrature::tanh_sinh<double> integrator;
  const auto value = [&](double u) { return f(quantile(d, u)); };
  return integrator.integrate(value, 0.0, kink) + integrator.integrate(value, kink, 1.0);
}

struct Moments {
  double mean;
  double standard_deviation;
};
Moments moments_of(const Distribution& d, double kink = 0.5) {
  const double mean = expectation(
      d, [](double x) { return x; }, kink);
  const double variance = expectation(
      d, [mean](double x) { return (x - mean) * (x - mean); }, kink);
  return {mean, std::sqrt(variance)};
}

// -- Moments. ----------------------------------------------------------------------------------------------
// The quadrature is good to 1e-9, and what lies beyond the last u below one (2^-53) moves no moment by more.

TEST(Distribution, UniformHasItsMoments) {
  const Moments found = moments_of(uniform(2.0, 5.0));
  EXPECT_NEAR(found.mean, 3.5, 1e-9);
  EXPECT_NEAR(found.standard_deviation, 3.0 / std::sqrt(12.0), 1e-9);
}

TEST(Distribution, NormalHasItsMoments) {
  const Moments found = moments_of(normal(-3.0, 2.0));
  EXPECT_NEAR(found.mean, -3.0, 1e-9);
  EXPECT_NEAR(found.standard_deviation, 2.0, 1e-9);
}

TEST(Distribution, LognormalHasTheMeanAndDeviationOfTheVariableItself) {
  const Moments found = moments_of(lognormal(2.0, 0.7));
  EXPECT_NEAR(found.mean, 2.0, 1e-9);
  EXPECT_NEAR(found.standard_deviation, 0.7, 1e-9);
  // Median of a lognormal: mean / sqrt(1 + (sd / mean)^2).
  EXPECT_NEAR(quantile(lognormal(2.0, 0.7), 0.5), 2.0 / std::sqrt(1.0 + 0.35 * 0.35), 1e-12);
}

TEST(Distribution, VeryNarrowLognormalIsNormal) {
  // The two differ by s^2 z^2 / 2 relative to the mean; s = 1e-10 leaves rounding.
  EXPECT_NEAR(quantile(lognormal(1.0, 1e-10), 0.975) - 1.0, 1.959963984540054e-10, 4e-16);
}

TEST(Distribution, TriangularHasItsMoments) {
  const double a = 1.0;
  const double c = 1.5;
  const double b = 4.0;
  const Moments found = moments_of(triangular(a, c, b), (c - a) / (b - a));
  EXPECT_NEAR(found.mean, (a + b + c) / 3.0, 1e-9);
  EXPECT_NEAR(found.standard_deviation, std::sqrt((a * a + b * b + c * c - a * b - a * c - b * c) / 18.0), 1e-9);
}

TEST(Distribution, TruncatedNormalHasItsMoments) {
  // Johnson, Kotz and Balakrishnan (1994), section 13.10.1, with Z = Phi(beta) - Phi(alpha).
  const double mu = 0.095;
  const double sigma = 0.01;
  for (const auto& [low, high] : {std::pair{0.08, 0.12}, {0.1, 0.11}, {0.06, 0.09}}) {
    const double alpha = (low - mu) / sigma;
    const double beta = (high - mu) / sigma;
    const auto phi = [](double z) { return std::exp(-0.5 * z * z) / std::sqrt(2.0 * std::numbers::pi); };
    const double Z = 0.5 * (std::erf(beta / std::numbers::sqrt2) - std::erf(alpha / std::numbers::sqrt2));
    const double shift = (phi(alpha) - phi(beta)) / Z;
    const double variance = 1.0 + (alpha * phi(alpha) - beta * phi(beta)) / Z - shift * shift;
    const Moments found = moments_of(truncated(normal(mu, sigma), low, high));
    EXPECT_NEAR(found.mean, mu + sigma * shift, 1e-9 * sigma);
    EXPECT_NEAR(found.standard_deviation, sigma * std::sqrt(variance), 1e-8 * sigma);
  }
}

TEST(Distribution, FarTailKeepsItsDigits) {
  // Beyond z0 the normal tail is exponential with rate z0 + 1 / z0 - ...; its mean is phi(z0) / Q(z0).
  const double z0 = 6.5;
  const double phi = std::exp(-0.5 * z0 * z0) / std::sqrt(2.0 * std::numbers::pi);
  const double Q = 0.5 * std::erfc(z0 / std::numbers::sqrt2);
  EXPECT_NEAR(moments_of(truncated(normal(0.0, 1.0), z0, kInf)).mean, phi / Q, 1e-9);
  EXPECT_NEAR(moments_of(truncated(normal(0.0, 1.0), -kInf, -z0)).mean, -phi / Q, 1e-9);
}

// -- The quantile function. --------------------------------------------------------------------------------

TEST(Quantile, IsUndoneByTheCumulativeFunction) {
  for (const Distribution& d : examples()) {
    ASSERT_EQ(broken_rule(d), std::nullopt) << distribution_text(d);
    for (std::uint64_t k = 0; k < 1000; ++k) {
      const double u = unit_random(1, 2, k);
      // u is known to its rounding times x f(x): below 1e3 epsilons in all of these.
      EXPECT_NEAR(cumulative(d, quantile(d, u)), u, 1e-12) << distribution_text(d) << " at u = " << u;
    }
  }
}

TEST(Quantile, NeverFallsAsUGrows) {
  for (const Distribution& d : examples()) {
    double before = quantile(d, 1e-300);
    for (std::size_t i = 1; i < 20'000; ++i) {
      const double value = quantile(d, static_cast<double>(i) / 20'000.0);
      ASSERT_GE(value, before) << distribution_text(d) << " at i = " << i;
      before = value;
    }
    // Number by number, where the formula goes over from F to 1 - F and where it could.
    const double seam = cumulative(d, d.kind == DistributionKind::triangular ? d.mode : d.mean);
    for (const double start : {seam, 0.25, 0.5, 0.75, 0.9}) {
      double u = std::clamp(start, 1e-3, 0.999);
      for (int i = 0; i < 500; ++i) u = std::nextafter(u, 0.0);
      before = quantile(d, u);
      for (int i = 0; i < 1000; ++i) {
        u = std::nextafter(u, 1.0);
        const double value = quantile(d, u);
        ASSERT_GE(value, before) << distribution_text(d) << " at u = " << u;
        before = value;
      }
    }
  }
}

TEST(Quantile, IsFiniteAndInsideForEveryU) {
  for (const Distribution& d : examples()) {
    for (const double u : {5e-324, 1e-300, 0x1.0p-53, 1e-9, 0.5, 1.0 - 1e-9, 1.0 - 0x1.0p-53}) {
      const double value = quantile(d, u);
      EXPECT_TRUE(std::isfinite(value)) << distribution_text(d) << " at u = " << u;
      EXPECT_GE(value, d.at_least);
      EXPECT_LE(value, d.at_most);
    }
  }
}

TEST(Quantile, OfTheNormalIsThePublishedOne) {
  // Wichura (1988), AS 241: the test values of PPND16.
  EXPECT_NEAR(quantile(normal(0.0, 1.0), 0.25), -0.6744897501960817, 1e-15);
  EXPECT_NEAR(quantile(normal(0.0, 1.0), 0.001), -3.090232306167814, 1e-14);
  EXPECT_NEAR(quantile(normal(0.0, 1.0), 1e-20), -9.262340089798408, 1e-13);
}

TEST(Quantile, OfAPointIsThePointWhateverU) {
  for (const Distribution& d : {normal(3.0, 0.0), lognormal(3.0, 0.0)}) {
    EXPECT_EQ(broken_rule(d), std::nullopt);
    EXPECT_EQ(quantile(d, 0.01), 3.0);
    EXPECT_EQ(quantile(d, 0.99), 3.0);
    EXPECT_EQ(cumulative(d, 2.9), 0.0);
    EXPECT_EQ(cumulative(d, 3.0), 1.0);
  }
}

TEST(Cumulative, IsZeroBelowAndOneAbove) {
  for (const Distribution& d : examples()) {
    EXPECT_EQ(cumulative(d, -kInf), 0.0) << distribution_text(d);
    EXPECT_EQ(cumulative(d, kInf), 1.0) << distribution_text(d);
    EXPECT_EQ(cumulative(d, std::nextafter(d.at_least, -kInf)), 0.0) << distribution_text(d);
    EXPECT_EQ(cumulative(d, d.at_most), 1.0) << distribution_text(d);
  }
}

// -- Rules and words. --------------------------------------------------------------------------------------

TEST(DistributionRules, NameWhatIsBroken) {
  EXPECT_EQ(broken_rule(normal(kNaN, 1.0)), "mean must be finite");
  EXPECT_EQ(broken_rule(normal(0.0, -1.0)), "standard_deviation must be >= 0");
  EXPECT_EQ(broken_rule(normal(0.0, kNaN)), "standard_deviation must be >= 0");
  EXPECT_EQ(broken_rule(normal(0.0, kInf)), "standard_deviation must be finite");
  EXPECT_EQ(broken_rule(lognormal(0.0, 1.0)), "mean of a lognormal must be > 0");
  EXPECT_EQ(broken_rule(lognormal(1.0, 1e7)),
            "standard_deviation of a lognormal must be at most 1e6 times its mean");
  EXPECT_EQ(broken_rule(uniform(2.0, 2.0)), "from must be < to");
  EXPECT_EQ(broken_rule(uniform(0.0, kNaN)), "from must be < to");
  EXPECT_EQ(broken_rule(uniform(0.0, kInf)), "from and to must be finite");
  EXPECT_EQ(broken_rule(triangular(1.0, 3.5, 3.0)), "mode must lie between from and to");
  EXPECT_EQ(broken_rule(truncated(normal(0.0, 1.0), 1.0, 1.0)), "at_least must be < at_most");
  EXPECT_EQ(broken_rule(truncated(normal(0.0, 1.0), kNaN, 1.0)), "at_least must be < at_most");
  EXPECT_EQ(broken_rule(truncated(normal(0.0, 1.0), 9.0, kInf)), "nothing lies between at_least and at_most");
  EXPECT_EQ(broken_rule(truncated(normal(0.0, 1.0), -kInf, -9.0)), "nothing lies between at_least and at_most");
  EXPECT_EQ(broken_rule(truncated(uniform(0.0, 1.0), 1.0, 2.0)), "nothing lies between at_least and at_most");
  EXPECT_EQ(broken_rule(truncated(normal(3.0, 0.0), 3.1, 4.0)), "nothing lies between at_least and at_most");
  // What a kind does not need, it does not look at.
  Distribution d = uniform(0.0, 1.0);
  d.mean = kNaN;
  d.mode = kNaN;
  EXPECT_EQ(broken_rule(d), std::nullopt);
}

TEST(DistributionText, SaysWhatIsDrawnFrom) {
  EXPECT_EQ(distribution_text(truncated(normal(0.095, 0.01), 0.08, 0.12)),
            "normal(mean 0.095, sd 0.01), 0.08 to 0.12");
  EXPECT_EQ(distribution_text(lognormal(2.0e6, 3.0e5)), "lognormal(mean 2e+06, sd 300000)");
  EXPECT_EQ(distribution_text(uniform(1.0, 2.0)), "uniform(1 to 2)");
  EXPECT_EQ(distribution_text(truncated(triangular(1.0, 2.0, 3.0), 1.5, kInf)),
            "triangular(1 to 3, mode 2), at least 1.5");
  EXPECT_EQ(distribution_text(truncated(uniform(1.0, 2.0), -kInf, 1.5)), "uniform(1 to 2), at most 1.5");
}

TEST(MeanAndSpread, AreThoseOfTheValues) {
  const std::vector<double> values = {2.0, 4.0, 4.0, 4.0, 5.0, 5.0, 7.0, 9.0};
  EXPECT_DOUBLE_EQ(mean_and_spread(values).mean, 5.0);
  EXPECT_DOUBLE_EQ(mean_and_spread(values).standard_deviation, std::sqrt(32.0 / 7.0));
  EXPECT_EQ(mean_and_spread(std::vector<double>{3.0}).standard_deviation, 0.0);
  EXPECT_TRUE(std::isnan(mean_and_spread({}).mean));
}

}  // namespace
}  // namespace unbruised::studies

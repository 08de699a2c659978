// Stress below a patch that is pressed and dragged, against closed forms, and the table made from it.

#include "core/contact/patch_traction.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/contact/half_space.hpp"
#include "tests/comparison.hpp"

namespace unbruised {
namespace {

using namespace testing;

constexpr double kPi = std::numbers::pi;

EllipticPatch circle(double poisson_ratio) { return {1.0, 1.0, poisson_ratio}; }

TEST(PatchStress, OnTheAxisIsThatOfHertz) {
  // Johnson (1985), 3.45: sigma_z = -1 / (1 + z^2); sigma_r = -(1 + nu)(1 - z atan(1/z)) + 1 / (2 (1 + z^2)), in
  // p0, a.
  for (const double nu : {0.0, 0.3, 0.45}) {
    for (const double z : {0.1, 0.48, 1.0, 2.0}) {
      const Stress found = patch_stress({0.0, 0.0, z}, circle(nu)).normal;
      const double r = -(1.0 + nu) * (1.0 - z * std::atan(1.0 / z)) + 0.5 / (1.0 + z * z);
      EXPECT_NEAR(found[2], -1.0 / (1.0 + z * z), 1e-4) << z;  // the quadrature's own: 16 points on a ray
      EXPECT_NEAR(found[0], r, 1e-4) << z;
      EXPECT_NEAR(found[1], r, 1e-4) << z;
    }
  }
}

TEST(PatchStress, PeaksAtHalfARadiusWhereTablesSaySo) {
  // Johnson (1985), 4.2, for nu = 0.3: tau = 0.31 p0 at z = 0.48 a, on the axis, von Mises twice that.
  const Stress peak = patch_stress({0.0, 0.0, 0.48}, circle(0.3)).normal;
  EXPECT_NEAR(0.5 * (peak[0] - peak[2]), 0.310, 0.0005);
  EXPECT_NEAR(von_mises(peak), 0.620, 0.001);
  for (const double z : {0.44, 0.52}) {
    EXPECT_LT(von_mises(patch_stress({0.0, 0.0, z}, circle(0.3)).normal), von_mises(peak));
  }
}

TEST(PatchStress, OfTractionInTheSurfaceIsThatOfHamilton) {
  // Hamilton and Goodman (1966); Johnson (1985), 7.1: sigma_x = -pi/2 (1 + nu/4) x q0 / a inside the patch, tau_xz
  // = -q.
  const PatchQuadrature fine{64, 360};
  for (const double nu : {0.0, 0.3, 0.5}) {
    for (const double x : {-0.7, -0.3, 0.5}) {
      const Stress found = patch_stress({x, 0.0, 1e-3}, circle(nu), fine).tangential;
      EXPECT_NEAR(found[0], -0.5 * kPi * (1.0 + 0.25 * nu) * x, 3e-3);  // a depth of 1e-3 changes stress by 2e-3
      EXPECT_NEAR(found[4], -std::sqrt(1.0 - x * x), 3e-3);
    }
  }
}

TEST(PatchStress, FarAwayIsThatOfOneForce) {
  const HalfSpacePlace place{12.0, -9.0, 20.0};
  const PatchStress found = patch_stress(place, {1.2, 0.8, 0.35});
  const double force = 2.0 / 3.0 * kPi * 1.2 * 0.8;
  const Stress normal = normal_point_load(place, 0.35), tangential = tangential_point_load(place, 0.35);
  for (std::size_t i = 0; i < 6; ++i) {
    // The patch is a twentieth of the distance: its second moment changes the kernel by 1e-3 times its curvature.
    EXPECT_NEAR(found.normal[i], force * normal[i], 1e-2 * force * std::abs(normal[2])) << i;
    EXPECT_NEAR(found.tangential[i], force * tangential[i], 1e-2 * force * std::abs(normal[2])) << i;
  }
}

TEST(PatchStress, BalancesTheLoadAtEveryDepth) {
  // Over a plane below, sigma_zz carries the pressure and tau_xz the traction: sums over 8 radii miss the tails.
  const double z = 0.7, step = 0.2;
  double pressed = 0.0, dragged = 0.0;
  for (double x = -8.0 + 0.5 * step; x < 8.0; x += step) {
    for (double y = 0.5 * step; y < 8.0; y += step) {
      const PatchStress found = patch_stress({x, y, z}, {1.3, 0.7, 0.3}, {8, 12});
      pressed -= 2.0 * found.normal[2] * step * step;
      dragged -= 2.0 * found.tangential[4] * step * step;
    }
  }
  const double force = 2.0 / 3.0 * kPi * 1.3 * 0.7;
  EXPECT_NEAR(pressed, force, 0.01 * force);
  EXPECT_NEAR(dragged, force,
              0.13 * force);  // falls with x^2 / rho^5: 2 z / pi L = 6 % lie beyond L = 8 on either side
}

/// The largest stresses with several tractions, over depths of `skin` on in the plane of symmetry.
std::vector<double> peaks_with_traction(double poisson_ratio, const std::vector<double>& tractions, double skin) {
  std::vector<double> largest(tractions.size());
  for (const double z : {skin, 0.1, 0.2, 0.3, 0.34, 0.38, 0.42, 0.46, 0.5, 0.54}) {
    for (double x = -0.95; x < 0.96; x += 0.05) {
      const PatchQuadrature quadrature{16, z < 0.1 ? 64 : 24};
      const PatchStress stress = patch_stress({x + 1e-6, 0.0, z}, circle(poisson_ratio), quadrature);
      for (std::size_t k = 0; k < tractions.size(); ++k) {
        Stress both = stress.normal;
        for (std::size_t i = 0; i < both.size(); ++i) both[i] += tractions[k] * stress.tangential[i];
        largest[k] = std::max(largest[k], von_mises(both));
      }
    }
  }
  return largest;
}

TEST(TractionFactor, IsWhatTheStressOfThePatchSays) {
  const std::vector<double> tractions = {0.0, 0.1, 0.3, 0.45, 0.7};
  for (const double nu : {0.0, 0.3, 0.5}) {  // three of the six rows
    const std::vector<double> peak = peaks_with_traction(nu, tractions, kSkinDepth);
    EXPECT_NEAR(hertz_peak_stress(nu), peak[0], 0.002) << nu;
    const TractionFactor factor = TractionFactor::of_curved(nu);
    for (std::size_t k = 1; k < tractions.size(); ++k) {
      // Places a twentieth of a radius apart, half of a curved maximum's height: 0.5 %.
      EXPECT_NEAR(factor.at(tractions[k]), peak[k] / peak[0], 0.01) << nu << ' ' << tractions[k];
    }
  }
  // Between two rows: computed at nu = 0.35 it is 0.5973.
  EXPECT_NEAR(hertz_peak_stress(0.35), 0.5973, 0.001);
}

TEST(TractionFactor, LowersTheForceAtFirstYieldOfAKiwiByTheReferencesNumbers) {
  // Force goes with the cube of pressure. An independent computation for nu = 0.35 says 0.92, 0.82 and 0.71.
  const TractionFactor factor = TractionFactor::of_curved(0.35);
  const auto force = [&](double traction) { return std::pow(factor.at(traction), -3.0); };
  struct Case {
    double traction, independent;
  };
  for (const Case& each : {Case{0.2, 0.92}, Case{0.3, 0.82}, Case{0.4, 0.71}}) {
    const std::string ratio = std::to_string(each.traction).substr(0, 3);
    expect_agreement({"traction", "force at first yield with T/N = " + ratio + " over that without",
                      force(each.traction), each.independent},
                     0.02);
  }
}

TEST(TractionFactor, OfTheSurfaceItselfIsLargerFromATractionOfOneThirdOn) {
  // What is left out with the skin: at T / N = 0.4 and nu = 0.35 the surface has 1.22 times the peak without
  // traction.
  const double below = TractionFactor::of_curved(0.35).at(0.4);
  const double surface = peaks_with_traction(0.35, {0.4}, 5e-3)[0] / hertz_peak_stress(0.35);
  EXPECT_GT(surface, below + 0.05);
  EXPECT_NEAR(surface, 1.22, 0.03);  // looked at from a depth of 0.005 a
}

TEST(TractionFactor, GrowsWithTractionAndGoesOnBeyondItsTable) {
  for (const TractionFactor& factor : {TractionFactor::of_curved(0.35), TractionFactor::of_flat()}) {
    EXPECT_EQ(factor.at(0.0), 1.0);
    for (double t = 0.0; t < 1.5; t += 0.01) EXPECT_GT(factor.at(t + 0.01), factor.at(t));
    const Lane both = factor.at(Lane(0.33));
    EXPECT_EQ(both[3], factor.at(0.33));
  }
  EXPECT_NEAR(TractionFactor::of_flat().at(0.5), std::sqrt(1.75), 1e-3);
}

}  // namespace
}  // namespace unbruised

// Where a pad ends within a face, and strips: against boundary and finite elements.

#include "core/contact/pad_edge.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "core/contact/first_yield.hpp"
#include "tests/comparison.hpp"
#include "tests/core/contact/kiwi_scenes.hpp"

namespace unbruised {
namespace {

using namespace testing;

constexpr double kSoft_N_m3 = 1.333e8;

/// A product pressed evenly by a pad in the middle of its face.
struct EvenPress {
  LatticeParameters product;
  double side_m = 0.03;
  double layer_N_m3 = kSoft_N_m3;
  double edge_radius_m = 0.0;

  [[nodiscard]] double stress_Pa(double force_N) const {
    const PatchForm form = patch_form(product, 0, {1, 2}, {0.0, 0.0, 0.0});
    SurfaceLane pad;
    pad.size_m = {Lane(side_m), Lane(side_m)};
    pad.edge_radius_m = Lane(edge_radius_m);
    SurfaceTally tally;
    tally.normal = Lane(force_N);
    for (std::size_t t = 0; t < 2; ++t) {
      const double pressed = std::min(side_m, product.size_m[t + 1]);
      tally.second[t] = Lane(force_N * pressed * pressed / 12.0);
    }
    return yield_ratio({tally, form, {0.005, 0.005}, pad}, layer_N_m3, 1.0, 0);
  }
  [[nodiscard]] double first_yield_N(double yield_stress_Pa) const {
    double low = 0.1, high = 100.0;
    for (int i = 0; i < 60; ++i)
      (stress_Pa(0.5 * (low + high)) < yield_stress_Pa ? low : high) = 0.5 * (low + high);
    return low;
  }
};

/// The cube of the benchmarks: 0.1 MPa, nu 0.25.
EvenPress cube() {
  EvenPress press;
  press.product.size_m = {0.05, 0.05, 0.05};
  press.product.youngs_modulus_Pa = 0.1e6;
  press.product.poisson_ratio = 0.25;
  return press;
}

/// A cylinder of a kiwi's flesh across its axis.
EvenPress cylinder(double length_m) {
  EvenPress press;
  press.product = std::get<LatticeParameters>(kiwi_grip(0.005).product);
  press.product.shape = Shape::cylinder;
  press.product.axis = Axis::y;
  press.product.size_m = {0.04, length_m, 0.04};
  return press;
}

TEST(PadEdge, OfAPadWithinAFlatFaceIsThatOfFiniteElements) {
  const EvenPress press = cube();
  const double mean = 2.0 / (0.03 * 0.03);
  // 1.6 times the mean pressure in 10 mm^3 (independent quadratic elements); the table is of a half-space.
  expect_agreement({"edges", "cube, 30 mm pad: peak stress / mean pressure", press.stress_Pa(2.0) / mean, 1.6},
                   0.1);
}

TEST(PadEdge, AddsNothingWhereThePadEndsWithTheFace) {
  EvenPress press = cube();
  press.side_m = 0.05;
  EXPECT_NEAR(press.stress_Pa(2.0), 2.0 / (0.05 * 0.05), 1e-9);
  press.side_m = 0.06;
  EXPECT_NEAR(press.stress_Pa(2.0), 2.0 / (0.05 * 0.05), 1e-9);
  // No jump as the pad becomes smaller than the face.
  double last = press.stress_Pa(2.0) * 0.05 * 0.05;
  for (double side = 0.0505; side > 0.03; side -= 1e-4) {
    press.side_m = side;
    const double now = press.stress_Pa(2.0) * std::pow(std::min(side, 0.05), 2);
    EXPECT_NEAR(now, last, 0.02 * last) << side;
    last = now;
  }
}

TEST(PadEdge, GrowsWithTheStiffnessOfTheLayerAndWithARoundedEdge) {
  EvenPress soft = cube(), firm = cube(), rounded = cube();
  firm.layer_N_m3 = 10.0 * kSoft_N_m3;
  rounded.edge_radius_m = 0.002;
  EXPECT_GT(firm.stress_Pa(2.0), soft.stress_Pa(2.0));
  // Boundary elements (tests/reference/press_pad.py): 1.00 to 1.16 for 2 mm on a layer of lambda 6.
  EXPECT_GT(rounded.stress_Pa(2.0), soft.stress_Pa(2.0));
  EXPECT_LT(rounded.stress_Pa(2.0), 1.2 * soft.stress_Pa(2.0));
}

TEST(Strip, YieldsInItsMiddleAsFiniteElementsDo) {
  // Pads as long as the cylinder have no edge: the middle alone, with the force per length of a pad of 30 mm.
  const double middle_N = cylinder(0.03).first_yield_N(24e3 / PadEdge::kMiddleOfStrip);
  expect_agreement({"edges", "cylinder R 20 mm, 30 mm pad, first yield in the middle: N", middle_N, 10.8}, 0.05);
}

TEST(Strip, YieldsAtThePadsEdgesFirst) {
  // Boundary elements of the half-space: at 10.8 N 1.34 times the yield stress in 10 mm^3 at the ends of the pad.
  expect_agreement({"edges", "cylinder R 20 mm, 30 mm pad, 10.8 N: stress at the pad's ends / yield stress",
                    cylinder(0.06).stress_Pa(10.8) / 24e3, 1.340},
                   0.1);
}

}  // namespace
}  // namespace unbruised

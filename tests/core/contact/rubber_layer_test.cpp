// A bonded layer of rubber against its limits in closed form and against boundary elements.

#include "core/contact/rubber_layer.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "core/contact/first_yield.hpp"
#include "core/contact/layered_face.hpp"
#include "tests/comparison.hpp"
#include "tests/core/contact/kiwi_scenes.hpp"
#include "tests/reference_data.hpp"

namespace unbruised {
namespace {

using namespace testing;

/// (1 - nu) / ((1 + nu)(1 - 2 nu)): a layer that can only shrink along its thickness.
double confined(double nu) { return (1.0 - nu) / ((1.0 + nu) * (1.0 - 2.0 * nu)); }

TEST(LayerResponse, OfShortWavesIsThatOfAHalfSpaceAndOfLongOnesThatOfAConfinedLayer) {
  for (const double nu : {0.1, 0.3, 0.45, 0.49}) {
    EXPECT_NEAR(layer_response(30.0, nu, PadBulge::free), 1.0, 1e-12) << nu;
    // Held along itself, a half-space gives way by 4 kappa / (kappa + 1)^2 of that.
    const double kappa = 3.0 - 4.0 * nu;
    EXPECT_NEAR(layer_response(1e3, nu, PadBulge::held), 4.0 * kappa / ((kappa + 1.0) * (kappa + 1.0)), 0.05)
        << nu;
    for (const PadBulge bulge : {PadBulge::free, PadBulge::held}) {
      // u = p t / (E confined), of which L is u E q / (2 (1 - nu^2) p).
      const double x = 1e-3;
      EXPECT_NEAR(layer_response(x, nu, bulge), x / (2.0 * (1.0 - nu * nu) * confined(nu)), 1e-3 * x) << nu;
    }
  }
}

TEST(RubberFactor, OfAWideAndOfADeepPatch) {
  for (const PatchKind kind : {PatchKind::ellipse, PatchKind::strip}) {
    const RubberFactor rubber(kind, 0.3, PadBulge::free);
    EXPECT_NEAR(rubber.at(60.0), confined(0.3), 0.02 * confined(0.3)) << "a patch much wider than the layer";
    EXPECT_GT(rubber.at(0.25), 1.5) << "a patch on a half-space does not feel the layer's back";
  }
  EXPECT_EQ(RubberFactor().at(3.0), 1.0);
}

TEST(RubberFactor, GrowsWithThePoissonRatioAndWhereTheFaceIsHeld) {
  double last = 0.9;
  for (const double nu : {0.1, 0.3, 0.4, 0.45, 0.49, 0.4999, 0.5}) {
    const double free = RubberFactor(PatchKind::ellipse, nu, PadBulge::free).at(2.6);
    EXPECT_GT(free, last) << nu;
    EXPECT_GT(RubberFactor(PatchKind::ellipse, nu, PadBulge::held).at(2.6), free) << nu;
    last = free;
  }
}

TEST(WholePad, IsThatOfGentAndLindleyAndOfAConfinedLayer) {
  const double thickness = 0.003, side = 0.03, shape = side / (4.0 * thickness);
  EXPECT_NEAR(whole_pad_factor({side, side}, thickness, 0.5, PadBulge::held), 1.0 + 2.0 * shape * shape, 1e-6);
  EXPECT_NEAR(whole_pad_factor({side, side}, thickness, 0.0, PadBulge::free), 1.0, 1e-12);
  EXPECT_NEAR(whole_pad_factor({3.0, 3.0}, thickness, 0.45, PadBulge::held), confined(0.45), 1e-3);
}

/// Force at which the ripe kiwi first yields between pads of this layer [N].
double first_yield_N(const LayerParameters& layer) {
  Scenario scenario = kiwi_grip(0.005);
  ParallelJawParameters& jaw = jaw_of(scenario);
  jaw.pad_size_m = {0.06, 0.06};
  jaw.pad_modulus_Pa = layer.modulus_Pa;
  jaw.pad_thickness_m = layer.thickness_m;
  jaw.pad_poisson_ratio = layer.poisson_ratio;
  const auto& kiwi = std::get<LatticeParameters>(scenario.product);
  const PatchForm form = patch_form(kiwi, 0, {1, 2}, {0.0, 0.0, 0.0});
  const FaceLayer face = layer_at_pad(scenario);
  SurfaceLane pad;
  pad.size_m = {Lane(0.06), Lane(0.06)};
  double low = 1.0, high = 20.0;
  for (int i = 0; i < 50; ++i) {
    SurfaceTally tally;
    tally.normal = Lane(0.5 * (low + high));
    const double springs_N_m3 = face.stiffness_N_m3(0.5 * (low + high));
    const double ratio =
        yield_ratio({tally, form, {0.005, 0.005}, pad}, springs_N_m3, kiwi.yield_stress_Pa.value(), 0);
    (ratio < 1.0 ? low : high) = 0.5 * (low + high);
  }
  return low;
}

TEST(RubberLayer, MarksAKiwiAtTheForcesOfBoundaryElements) {
  struct Case {
    LayerParameters layer;
    double independent_N;  // fe_kiwi.csv
    const char* name;
  };
  for (const Case& each : {Case{{0.4e6, 0.003, 0.49}, 4.76, "rubber 0.4 MPa, 3 mm, nu 0.49"},
                           Case{{0.4e6, 0.003, 0.45}, 5.03, "rubber 0.4 MPa, 3 mm, nu 0.45"},
                           Case{{0.4e6, 0.003, 0.4999}, 4.69, "rubber 0.4 MPa, 3 mm, nu 0.4999"},
                           Case{{2.5e6, 0.002, 0.49}, 3.91, "rubber 2.5 MPa, 2 mm, nu 0.49"},
                           Case{{0.73e6, 0.005, 0.49}, 4.98, "rubber 0.73 MPa, 5 mm, nu 0.49"},
                           Case{{0.4e6, 0.003, 0.0}, 6.25, "springs 0.4 MPa, 3 mm"},
                           Case{{2.5e6, 0.002, 0.0}, 4.13, "springs 2.5 MPa, 2 mm"},
                           Case{{0.73e6, 0.005, 0.0}, 6.11, "springs 0.73 MPa, 5 mm"}}) {
    expect_agreement({"rubber", std::string("ripe kiwi, first yield, ") + each.name + ": N",
                      first_yield_N(each.layer), each.independent_N},
                     0.05);
  }
}

}  // namespace
}  // namespace unbruised

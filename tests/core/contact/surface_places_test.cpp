// The true surface as places: each belongs to one side, and together they are the surface.

#include "core/contact/surface_places.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace unbruised {
namespace {

constexpr double kPi = std::numbers::pi;

LatticeParameters product_of(Shape shape, const std::array<double, 3>& size_m, double cell_m) {
  LatticeParameters product;
  product.shape = shape;
  product.size_m = size_m;
  product.cell_size_m = cell_m;
  product.mass_kg = 0.1;
  return product;
}

std::vector<SurfacePlace> places_of(const LatticeParameters& product, ContactSet set = ContactSet::whole_surface) {
  return surface_places(product, build_lattice(product), set);
}

double area_m2(const std::vector<SurfacePlace>& places) {
  double sum = 0.0;
  for (const SurfacePlace& place : places) sum += place.area_m2;
  return sum;
}

TEST(SurfacePlaces, OfABoxAddUpToItsFaces) {
  const auto places = places_of(product_of(Shape::box, {0.06, 0.05, 0.04}, 0.01));
  EXPECT_NEAR(area_m2(places), 2.0 * (0.06 * 0.05 + 0.05 * 0.04 + 0.04 * 0.06), 1e-15);
  // A box is touched at its corners: the places of its particles.
  double lowest = 1.0;
  for (const SurfacePlace& place : places) lowest = std::min(lowest, place.place_m[0] + place.place_m[2]);
  EXPECT_NEAR(lowest, -0.03, 1e-15);
}

// Each place of the surface belongs to one side: counted twice or not at all where sides meet, the border's places
// alone would make 5 % of a sphere of five cells. Pieces are summed in 7 x 7 parts.
TEST(SurfacePlaces, OfRoundProductsAddUpToTheirSurface) {
  for (const double cell_m : {0.012, 0.006}) {
    EXPECT_NEAR(area_m2(places_of(product_of(Shape::sphere, {0.06, 0.06, 0.06}, cell_m))) / (kPi * 0.06 * 0.06),
                1.0, 0.005);
    EXPECT_NEAR(
        area_m2(places_of(product_of(Shape::cylinder, {0.06, 0.06, 0.06}, cell_m))) / (kPi * 0.06 * 0.06 * 1.5),
        1.0, 0.005);
  }
}

TEST(SurfacePlaces, FaceOutwardsAndLieOnTheSurface) {
  const LatticeParameters kiwi = product_of(Shape::ellipsoid, {0.05, 0.05, 0.065}, 0.005);
  const Lattice lattice = build_lattice(kiwi);
  for (const SurfacePlace& place : surface_places(kiwi, lattice, ContactSet::whole_surface)) {
    double on_surface = 0.0, length = 0.0, outward = 0.0;
    for (std::size_t d = 0; d < 3; ++d) {
      const double from_center = place.place_m[d] - lattice.center_m[d];
      on_surface += std::pow(2.0 * from_center / kiwi.size_m[d], 2);
      length += place.outward[d] * place.outward[d];
      outward += place.outward[d] * from_center;
    }
    EXPECT_NEAR(on_surface, 1.0, 1e-12);
    EXPECT_NEAR(length, 1.0, 1e-12);
    EXPECT_GT(outward, 0.0);
  }
}

TEST(SurfacePlaces, OfSixSidesLieNearTheirPoles) {
  const LatticeParameters kiwi = product_of(Shape::ellipsoid, {0.05, 0.05, 0.065}, 0.005);
  const auto near_poles = places_of(kiwi, ContactSet::six_sides), all = places_of(kiwi);
  EXPECT_LT(near_poles.size(), all.size());
  const Lattice lattice = build_lattice(kiwi);
  for (const SurfacePlace& place : near_poles) {
    bool near = false;
    for (std::size_t d = 0; d < 3; ++d) {
      near = near || std::abs(place.place_m[d] - lattice.center_m[d]) > 0.35 * kiwi.size_m[d] - 1e-12;
    }
    EXPECT_TRUE(near);
  }
}

}  // namespace
}  // namespace unbruised

#include "core/body/shape_mesh.hpp"

#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "core/scenario/product.hpp"
#include "core/scenario/vectors.hpp"
#include "tests/core/scenario/meshes.hpp"
#include "tests/core/scenario/solids.hpp"

namespace unbruised {
namespace {

LatticeParameters product_of(Shape shape, const std::array<double, 3>& size_m, Axis axis = Axis::z) {
  LatticeParameters product;
  product.shape = shape;
  product.size_m = size_m;
  product.axis = axis;
  return product;
}

const std::vector<LatticeParameters>& products() {
  static const std::vector<LatticeParameters> all = {
      product_of(Shape::box, {0.03, 0.05, 0.02}),
      product_of(Shape::sphere, {0.04, 0.04, 0.04}),
      product_of(Shape::ellipsoid, {0.05, 0.04, 0.06}),
      product_of(Shape::cylinder, {0.03, 0.05, 0.03}, Axis::y),
      testing::revolution_of(testing::pear_profile(), {0.06, 0.08, 0.06}, Axis::y),
      testing::revolution_of(testing::bottle_profile(), {0.03, 0.03, 0.066}),
      testing::superellipsoid_of({4.0, 2.5}, {0.05, 0.04, 0.03}),
      testing::mesh_product(testing::icosphere(3), {0.05, 0.05, 0.06})};
  return all;
}

/// Six times what a triangle adds to the volume inside of a closed surface.
double six_volumes(const ShapeMesh& mesh, const std::array<int, 3>& triangle) {
  const auto place = [&](int i) {
    return mesh.place_m[static_cast<std::size_t>(triangle[static_cast<std::size_t>(i)])];
  };
  return dot(place(0), cross(place(1), place(2)));
}

TEST(ShapeMesh, HasEveryPlaceOnTheTrueSurface) {
  for (const LatticeParameters& product : products()) {
    const ShapeMesh mesh = shape_mesh(product).value();
    const TrueShape shape = true_shape(product).value();
    EXPECT_GT(mesh.place_m.size(), 500U);
    EXPECT_LT(mesh.place_m.size(), 2000U);
    for (const auto& place : mesh.place_m) EXPECT_NEAR(shape.nearest(place).distance_m, 0.0, 1e-8);
  }
}

TEST(ShapeMesh, EnclosesTheVolumeOfTheShapeAndLooksOutwards) {
  for (const LatticeParameters& product : products()) {
    const ShapeMesh mesh = shape_mesh(product).value();
    double six = 0.0;
    for (const auto& triangle : mesh.triangle) six += six_volumes(mesh, triangle);
    // Chords cut a round shape by (pi / 14)^2 / 6 or so along each direction; flat sides by nothing.
    const double volume_m3 = true_shape(product)->volume_m3();
    EXPECT_NEAR(six / 6.0, volume_m3, 0.02 * volume_m3);
    EXPECT_LE(six / 6.0, volume_m3 * (1.0 + 1e-12));
  }
}

TEST(ShapeMesh, ClosesARoundSurface) {
  const ShapeMesh mesh = shape_mesh(products()[2]).value();
  std::map<std::pair<int, int>, int> edges;
  for (const auto& triangle : mesh.triangle) {
    for (std::size_t i = 0; i < 3; ++i) ++edges[{triangle[i], triangle[(i + 1) % 3]}];
  }
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    EXPECT_TRUE(edges.contains({edge.second, edge.first})) << "an edge with one side";
  }
}

// Of a fine mesh places are put together: the mean of those of a box lies inside, by less than a box.
TEST(ShapeMesh, DrawsAFineMeshWithFewerPlaces) {
  const LatticeParameters product = testing::mesh_product(testing::lobed_mesh(5), {0.08, 0.05, 0.05});
  const ShapeMesh mesh = shape_mesh(product).value();
  EXPECT_GT(mesh.place_m.size(), 500U);
  EXPECT_LT(mesh.place_m.size(), 2000U);
  const TrueShape shape = true_shape(product).value();
  for (const auto& place : mesh.place_m) EXPECT_NEAR(shape.nearest(place).distance_m, 0.0, 1e-3);
  double six = 0.0;
  for (const auto& triangle : mesh.triangle) six += six_volumes(mesh, triangle);
  EXPECT_NEAR(six / 6.0 / shape.volume_m3(), 1.0, 0.03);
}

TEST(ShapeMesh, IsNothingWithoutAShape) { EXPECT_FALSE(shape_mesh(NetworkParameters{}).has_value()); }

}  // namespace
}  // namespace unbruised

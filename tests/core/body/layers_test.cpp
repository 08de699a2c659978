// Layers and skins of lattice products: which cells are of what, and how stiff that makes them.

#include "core/body/layers.hpp"

#include <cmath>
#include <functional>
#include <iostream>
#include <map>
#include <numbers>

#include <gtest/gtest.h>

#include "core/body/body_model.hpp"
#include "core/door/eigen.hpp"
#include "tests/core/simulation/scenes.hpp"

namespace unbruised {
namespace {

using namespace testing;

constexpr double kE_Pa = 1e6, kNu = 0.3;

LatticeParameters solid(Shape shape, const std::array<double, 3>& size_m, double cell_size_m) {
  LatticeParameters product;
  product.shape = shape;
  product.size_m = size_m;
  product.cell_size_m = cell_size_m;
  product.density_kg_m3 = 1000.0;
  product.youngs_modulus_Pa = kE_Pa;
  product.poisson_ratio = kNu;
  return product;
}

ProductLayer layer(double from_depth_m, double youngs_modulus_Pa) {
  ProductLayer layer;
  layer.from_depth_m = from_depth_m;
  layer.youngs_modulus_Pa = youngs_modulus_Pa;
  return layer;
}

void give_skin(LatticeParameters& product, double thickness_m, double modulus_Pa) {
  product.skin_thickness_m = thickness_m;
  product.skin_modulus_Pa = modulus_Pa;
  product.skin_poisson_ratio = 0.3;
}

/// Energy of a displacement field in cells' additions, 1/2 u K u [J].
double energy_J(const LatticeParameters& product,
                const std::function<std::array<double, 3>(std::array<double, 3>)>& field) {
  const Lattice lattice = build_lattice(product);
  double energy = 0.0;
  for (const CellAddition& skin : cell_skins(product, lattice)) {
    std::array<double, 24> u{};
    for (std::size_t c = 0; c < 8; ++c) {
      const auto at = field(lattice.position_m[static_cast<std::size_t>(lattice.cell[skin.cell][c])]);
      for (std::size_t d = 0; d < 3; ++d) u[3 * c + d] = at[d];
    }
    for (std::size_t f = 0; f < 24; ++f) {
      for (std::size_t g = 0; g < 24; ++g) energy += 0.5 * u[f] * skin.K[24 * f + g] * u[g];
    }
  }
  return energy;
}

TEST(Layers, TakeTheCellsWhoseMiddlesLieThatDeep) {
  LatticeParameters ball = solid(Shape::sphere, {0.06, 0.06, 0.06}, 0.003);
  ball.layer = {layer(0.01, 2e6), layer(0.02, 3e6)};
  const std::vector<std::size_t> count = cells_of_materials(ball);
  ASSERT_EQ(count.size(), 3U);
  const double all = static_cast<double>(count[0] + count[1] + count[2]);
  // Of the radius 30 mm the inner 20 and 10: 8/27 and 1/27 of the volume, as far as 3 mm cells show it.
  EXPECT_NEAR(static_cast<double>(count[1] + count[2]) / all, 8.0 / 27.0, 0.03);
  EXPECT_NEAR(static_cast<double>(count[2]) / all, 1.0 / 27.0, 0.01);
  EXPECT_EQ(cells_of_materials(solid(Shape::box, {0.02, 0.02, 0.02}, 0.01)), std::vector<std::size_t>{8});
}

TEST(Layers, TakeAnEllipsoidOutOfAnother) {
  LatticeParameters box = solid(Shape::box, {0.06, 0.08, 0.04}, 0.002);
  box.layer = {layer(0.01, 2e6), ProductLayer{}};
  box.layer[1].size_m = {0.03, 0.02, 0.016};
  box.layer[1].center_m = {0.01, -0.02, 0.004};
  const Lattice lattice = build_lattice(box);
  const std::vector<int> material = cell_materials(box, lattice);
  std::array<double, 3> middle_m{};
  double count = 0.0;
  for (std::size_t cell = 0; cell < material.size(); ++cell) {
    if (material[cell] != 2) continue;
    count += 1.0;
    const auto& low = lattice.position_m[static_cast<std::size_t>(lattice.cell[cell][0])];
    for (std::size_t d = 0; d < 3; ++d) middle_m[d] += low[d] + 0.001 - lattice.center_m[d];
  }
  // As large and where it is said to be, as far as 2 mm cells show it; what lies in both is of the later one.
  EXPECT_NEAR(count * 8e-9, std::numbers::pi / 6.0 * 0.03 * 0.02 * 0.016, 0.03 * 5e-6);
  for (std::size_t d = 0; d < 3; ++d) EXPECT_NEAR(middle_m[d] / count, (*box.layer[1].center_m)[d], 1e-4);
}

TEST(Layers, AreAlikeInMirroredPlaces) {
  for (const Shape shape : {Shape::box, Shape::ellipsoid, Shape::cylinder}) {
    LatticeParameters product = solid(shape, {0.04, 0.06, 0.05}, 0.005);
    product.layer = {layer(0.0075, 2e6)};  // on the middles of cells, of a box
    const Lattice lattice = build_lattice(product);
    const std::vector<int> material = cell_materials(product, lattice);
    std::map<std::array<long, 3>, int> found;
    const auto middle = [&](std::size_t cell) {
      const auto& at = lattice.position_m[static_cast<std::size_t>(lattice.cell[cell][0])];
      std::array<long, 3> twice{};
      for (std::size_t d = 0; d < 3; ++d) {
        twice[d] = std::lround(2.0 * (at[d] - lattice.center_m[d]) / lattice.cell_extent_m[d] + 1.0);
      }
      return twice;
    };
    for (std::size_t cell = 0; cell < material.size(); ++cell) found.emplace(middle(cell), material[cell]);
    for (const auto& [at, one] : found) EXPECT_EQ(one, found.at({-at[0], -at[1], -at[2]}));
  }
}

// Two faces of each pair are stretched along two axes; what lies on the cells' faces is exact.
TEST(Skin, OfABoxIsAMembraneOnItsFaces) {
  LatticeParameters box = solid(Shape::box, {0.04, 0.06, 0.05}, 0.005);
  give_skin(box, 0.0004, 5e6);
  const std::array<double, 3> e = {1e-3, -2e-3, 0.5e-3};
  const double shear = 0.7e-3;  // du_x/dy
  const double measured = energy_J(box, [&](const std::array<double, 3>& x) {
    return std::array<double, 3>{e[0] * x[0] + shear * x[1], e[1] * x[1], e[2] * x[2]};
  });
  const double nu = *box.skin_poisson_ratio, D = 0.0004 * 5e6 / (1.0 - nu * nu);
  double closed = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t a = (axis + 1) % 3, b = (axis + 2) % 3;
    const double area = 2.0 * box.size_m[a] * box.size_m[b], gamma = axis == 2 ? shear : 0.0;
    closed +=
        0.5 * D * area * (e[a] * e[a] + e[b] * e[b] + 2.0 * nu * e[a] * e[b] + 0.5 * (1.0 - nu) * gamma * gamma);
  }
  EXPECT_NEAR(measured, closed, 1e-12 * closed);
}

// Blown up, every piece of the skin of a ball is stretched alike along both directions: E t A e^2 / (1 - nu). The
// triangles' area is 0.7 % short of the ball's.
TEST(Skin, OfABallIsStretchedAlikeEverywhere) {
  LatticeParameters ball = solid(Shape::sphere, {0.05, 0.05, 0.05}, 0.005);
  give_skin(ball, 0.0004, 5e6);
  const double measured = energy_J(ball, [](const std::array<double, 3>& x) {
    return std::array<double, 3>{1e-3 * x[0], 1e-3 * x[1], 1e-3 * x[2]};
  });
  const double closed = 5e6 * 0.0004 * std::numbers::pi * 0.05 * 0.05 * 1e-6 / (1.0 - *ball.skin_poisson_ratio);
  EXPECT_NEAR(measured, closed, 0.01 * closed);
}

TEST(Skin, DoesNotMindRigidMotions) {
  for (const Shape shape : {Shape::box, Shape::ellipsoid, Shape::cylinder, Shape::superellipsoid}) {
    LatticeParameters product = solid(shape, {0.04, 0.06, 0.05}, 0.005);
    if (shape == Shape::superellipsoid) product.exponents = {3.0, 3.0};
    give_skin(product, 0.0004, 5e6);
    const double turned = energy_J(product, [](const std::array<double, 3>& x) {
      return std::array<double, 3>{1e-3 - 0.02 * x[1] + 0.03 * x[2], 0.02 * x[0] - 0.01 * x[2],
                                   -0.03 * x[0] + 0.01 * x[1]};
    });
    const double blown = energy_J(product, [](const std::array<double, 3>& x) {
      return std::array<double, 3>{0.02 * x[0], 0.02 * x[1], 0.02 * x[2]};
    });
    EXPECT_LT(std::abs(turned), 1e-12 * blown);
  }
}

/// Force over the way of each of two frictionless square punches of 16 mm that press on the sides -x and +x.
double pressed_N_m(const LatticeParameters& product) {
  std::string error;
  const auto body = build_body(product, WilsonTheta(1e-3, 1.4), error);
  EXPECT_TRUE(body) << error;
  std::vector<std::size_t> freedoms;
  for (const std::size_t side : {0U, 1U}) {
    for (const SurfacePoint& point : body->lattice->side[side]) {
      const auto& at = body->position_m[static_cast<std::size_t>(point.node)];
      if (std::abs(at[1]) > 0.00801 || std::abs(at[2] - body->lattice->center_m[2]) > 0.00801) continue;
      freedoms.push_back(3 * static_cast<std::size_t>(point.node));
    }
  }
  const auto n = static_cast<Eigen::Index>(freedoms.size() / 2);
  const std::vector<double> all = body->statics->compliance(freedoms);
  const Eigen::Map<const Eigen::MatrixXd> C(all.data(), 2 * n, 2 * n);
  // Equal and opposite: the shift of the statics holds rigid motions, which cancel.
  const Eigen::MatrixXd relative = C.topLeftCorner(n, n) - C.topRightCorner(n, n);
  return relative.ldlt().solve(Eigen::VectorXd::Ones(n)).sum();
}

/// A pressed block by finite elements: trilinear bricks with membranes (tests/reference/layered_block.py, limits
/// of 10 and 20 bricks along half an edge).
struct Pressed {
  const char* name;
  bool core, skin;
  double reference_N_m;
};
constexpr Pressed kPressed[] = {{"plain", false, false, 27719.9},
                                {"core", true, false, 38916.7},
                                {"skin", false, true, 29476.6},
                                {"both", true, true, 40076.7}};

double measured_N_m(const Pressed& each, double cell_size_m) {
  LatticeParameters block = solid(Shape::box, {0.04, 0.04, 0.04}, cell_size_m);
  if (each.core) block.layer = {layer(0.008, 3.0 * kE_Pa)};
  if (each.skin) give_skin(block, 0.0015, 6.8 * kE_Pa);
  return pressed_N_m(block);
}

// On cells of 4 mm the edge of the punch makes all of them too stiff alike.
TEST(Layers, AndSkinsStiffenABlockAsInFiniteElements) {
  const double plain_N_m = measured_N_m(kPressed[0], 0.004);
  for (const Pressed& each : kPressed) {
    const double ratio = measured_N_m(each, 0.004) / plain_N_m;
    EXPECT_NEAR(ratio, each.reference_N_m / kPressed[0].reference_N_m, 0.05) << each.name;
  }
}

// The error at the edge of the punch falls with the first power of the cell: it is taken out as in the reference.
TEST(HeavyLayers, AndSkinsMakeABlockAsStiffAsFiniteElementsDo) {
  for (const Pressed& each : kPressed) {
    const double limit_N_m = 2.0 * measured_N_m(each, 0.002) - measured_N_m(each, 0.004);
    EXPECT_NEAR(limit_N_m, each.reference_N_m, 0.02 * each.reference_N_m) << each.name;
    std::cout << "[ measured ] " << each.name << ": " << limit_N_m / each.reference_N_m
              << " of the finite elements\n";
  }
}

TEST(Layers, OfTheProductsOwnMaterialChangeNothing) {
  Scenario scenario = small_box();
  lattice_of(scenario).size_m = {0.04, 0.04, 0.04};
  lattice_of(scenario).yield_stress_Pa = 500.0;
  lattice_of(scenario).tangent_modulus_Pa = 2e4;
  const ScenarioResult plain = run(scenario);
  ASSERT_GT(plain.metrics[Metric::plastic_strain_max], 0.0);
  ProductLayer same = layer(0.01, lattice_of(scenario).youngs_modulus_Pa);
  same.yield_stress_Pa = 500.0;
  same.tangent_modulus_Pa = 2e4;
  lattice_of(scenario).layer = {same};
  ASSERT_GT(cells_of_materials(lattice_of(scenario))[1], 0U);
  expect_same_bits(run(scenario), plain, "layer");
}

// As stiff as flesh and a millionth of a cell thick it bears some millionths of the force.
TEST(Skin, ThatVanishesChangesNothing) {
  Scenario scenario = small_box();
  LatticeParameters& product = lattice_of(scenario);
  product.yield_stress_Pa = 500.0;
  product.tangent_modulus_Pa = 2e4;
  const ScenarioResult plain = run(scenario);
  ASSERT_GT(plain.metrics[Metric::plastic_strain_max], 0.0);
  give_skin(product, 1e-6 * product.cell_size_m, product.youngs_modulus_Pa);
  const ScenarioResult skinned = run(scenario);
  EXPECT_EQ(skinned.outcome, plain.outcome);
  for (const Metric metric : {Metric::compression_max_m, Metric::contact_yield_ratio_max,
                              Metric::plastic_strain_max, Metric::permanent_set_max_m, Metric::grip_impulse_N_s}) {
    EXPECT_NEAR(skinned.metrics[metric], plain.metrics[metric], 1e-4 * std::abs(plain.metrics[metric]));
  }
}

TEST(Layers, OfASoftCoreFlowWhereTheOutsideDoesNot) {
  Scenario scenario = small_box();
  LatticeParameters& product = lattice_of(scenario);
  product.size_m = {0.04, 0.04, 0.04};
  product.layer = {layer(0.01, product.youngs_modulus_Pa)};
  scenario.strategy.grip_force_N = 1.0;
  EXPECT_EQ(run(scenario).metrics[Metric::plastic_strain_max], 0.0);
  product.layer.front().yield_stress_Pa = 300.0;
  product.layer.front().tangent_modulus_Pa = 2e4;
  const ScenarioResult result = run(scenario);
  EXPECT_GT(result.metrics[Metric::plastic_strain_max], 1e-4);
  EXPECT_GT(result.metrics[Metric::permanent_set_max_m], 0.0);
  EXPECT_LT(std::abs(result.metrics[Metric::energy_balance_error]), 0.01);
}

TEST(Layers, WhatCannotBeIsRefused) {
  const auto broken = [](const std::function<void(LatticeParameters&)>& change) {
    Scenario scenario = small_box();
    change(lattice_of(scenario));
    const Violations all = validate(scenario);
    return all.empty() ? std::string("nothing") : all.front().field + ": " + all.front().rule;
  };
  EXPECT_EQ(broken([](LatticeParameters& p) {
              p.layer = {layer(0.004, 1e5), layer(0.003, 1e5)};
            }),
            "product.layer[1].from_depth_m: must be > 0.004, where the layer before it begins: layers go inwards");
  EXPECT_NE(broken([](LatticeParameters& p) { p.layer = {layer(0.02, 1e5)}; }).find("nothing lies deeper"),
            std::string::npos);
  EXPECT_EQ(broken([](LatticeParameters& p) {
              p.layer = {layer(0.004, 1e5)};
              p.layer.front().yield_stress_Pa = 1e3;
            }),
            "product.layer[0].tangent_modulus_Pa: missing; yield_stress_Pa needs it");
  EXPECT_EQ(broken([](LatticeParameters& p) { p.skin_thickness_m = 1e-4; }),
            "product.skin_modulus_Pa: missing; skin_thickness_m needs it");
  EXPECT_NE(broken([](LatticeParameters& p) { give_skin(p, 0.02, 1e6); }).find("over a [[product.layer]]"),
            std::string::npos);
}

}  // namespace
}  // namespace unbruised

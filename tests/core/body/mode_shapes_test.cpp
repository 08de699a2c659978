// Free vibrations of lattices: closed forms of a bar, both ways to find them, and what they leave out.

#include "core/body/mode_shapes.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/body/modal_basis.hpp"
#include "core/body/node_compliance.hpp"

namespace unbruised {
namespace {

const WilsonTheta kStep(1e-3, 1.4);

/// A box of cubic cells of 1 cm, 1 MPa and 1000 kg/m3.
BodyModel box(const std::array<double, 3>& cells, double poisson_ratio) {
  LatticeParameters product;
  product.shape = Shape::box;
  product.cell_size_m = 0.01;
  for (std::size_t i = 0; i < 3; ++i) product.size_m[i] = 0.01 * cells[i];
  product.density_kg_m3 = 1000.0;
  product.youngs_modulus_Pa = 1e6;
  product.poisson_ratio = poisson_ratio;
  product.relaxation_time_s = 1e-3;
  std::string error;
  auto body = build_body(product, kStep, error);
  EXPECT_TRUE(body) << error;
  return std::move(*body);
}

/// s' M t of two modes.
double mass_product(const BodyModel& body, const double* s, const double* t) {
  double sum = 0.0;
  for (std::size_t i = 0; i < 3 * body.particle_count; ++i) sum += s[i] * body.mass_kg[i / 3] * t[i];
  return sum;
}

std::vector<double> stiffness_times(const BodyModel& body, const double* s) {
  std::vector<double> force(3 * body.particle_count);
  multiply(body.K, std::span<const double>(s, force.size()), std::span<double>(force));
  return force;
}

void expect_modes(const BodyModel& body, const ModeShapes& modes) {
  for (std::size_t i = 0; i < modes.count(); ++i) {
    const std::vector<double> force = stiffness_times(body, modes.of(i));
    for (std::size_t j = 0; j < modes.count(); ++j) {
      EXPECT_NEAR(mass_product(body, modes.of(i), modes.of(j)), i == j ? 1.0 : 0.0, 1e-9) << i << ", " << j;
      double product = 0.0;
      for (std::size_t k = 0; k < force.size(); ++k) product += force[k] * modes.of(j)[k];
      EXPECT_NEAR(product, i == j ? modes.square_1_s2[i] : 0.0, 1e-7 * modes.square_1_s2.back()) << i << ", " << j;
    }
  }
}

TEST(ModeShapes, AreOrthonormalWhicheverWayTheyAreFound) {
  const BodyModel body = box({4, 5, 6}, 0.3);
  const ModeShapes some = slowest_modes(body, 40);
  const ModeShapes most = slowest_modes(body, 400);
  ASSERT_EQ(some.count(), 46u);
  expect_modes(body, some);
  expect_modes(body, most);
  for (std::size_t i = 0; i < some.count(); ++i) {
    EXPECT_NEAR(some.square_1_s2[i], most.square_1_s2[i], 1e-9 * most.square_1_s2[i]) << i;
  }
  EXPECT_LT(some.residual, 1e-8);
}

// A bar without lateral strain is a chain of masses m (half of it at the ends) and springs E A / h: omega_k =
// 2 sqrt(E / rho) / h sin(k pi / (2 n)).
TEST(ModeShapes, OfABarAreThoseOfAChain) {
  constexpr int kCells = 12;
  const BodyModel body = box({kCells, 2, 2}, 0.0);
  const ModeShapes modes = slowest_modes(body, 60);
  for (int k = 1; k <= 3; ++k) {
    const double omega = 2.0 * std::sqrt(1e6 / 1000.0) / 0.01 * std::sin(k * std::numbers::pi / (2.0 * kCells));
    double nearest = HUGE_VAL;
    for (const double square : modes.square_1_s2) nearest = std::min(nearest, std::abs(std::sqrt(square) - omega));
    EXPECT_LT(nearest, 1e-7 * omega) << k;
  }
}

TEST(ModeShapes, ThereAreNoMoreThanFreedoms) {
  const BodyModel body = box({2, 2, 2}, 0.3);
  EXPECT_EQ(slowest_modes(body, 2000).count(), 3 * body.particle_count);
}

/// Particles of the side +x.
std::vector<int> side_of(const BodyModel& body) {
  std::vector<int> nodes;
  for (const SurfacePoint& point : body.lattice->side[1]) nodes.push_back(point.node);
  return nodes;
}

// Forces on the side that are in balance: modes and what they leave out give the static shape, however many modes.
TEST(ModalBasis, KeepsTheStaticShape) {
  const BodyModel body = box({4, 5, 6}, 0.3);
  const std::vector<int> nodes = side_of(body);
  std::vector<double> force(3 * nodes.size(), 0.0), all(3 * body.particle_count, 0.0);
  // Two opposite pulls along z at equal x and y.
  std::size_t low = 0, high = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const auto& at = body.position_m[static_cast<std::size_t>(nodes[i])];
    const auto& first = body.position_m[static_cast<std::size_t>(nodes[low])];
    if (at[1] == first[1] && at[2] > body.position_m[static_cast<std::size_t>(nodes[high])][2]) high = i;
  }
  force[3 * low + 2] = -1.0;
  force[3 * high + 2] = 1.0;
  for (std::size_t i = 0; i < force.size(); ++i)
    all[3 * static_cast<std::size_t>(nodes[i / 3]) + i % 3] = force[i];
  const std::vector<double> exact = body.statics->free_shape(all);
  const auto stretch = [&](const std::vector<double>& u) {
    return u[3 * static_cast<std::size_t>(nodes[high]) + 2] - u[3 * static_cast<std::size_t>(nodes[low]) + 2];
  };
  double left_before = 1.0;
  for (const std::size_t count : {std::size_t{5}, std::size_t{40}, std::size_t{400}}) {
    const ModalBasis basis = modal_basis(body, count, nodes);
    std::vector<double> shape = rest_shapes(basis, body, std::vector<std::vector<double>>{force}).front();
    for (std::size_t mode = kRigidModes; mode < basis.modes.count(); ++mode) {
      double along = 0.0;
      for (std::size_t i = 0; i < all.size(); ++i) along += basis.modes.of(mode)[i] * all[i];
      for (std::size_t i = 0; i < all.size(); ++i) {
        shape[i] += basis.modes.of(mode)[i] * along / basis.modes.square_1_s2[mode];
      }
    }
    EXPECT_NEAR(stretch(shape), stretch(exact), 1e-5 * stretch(exact)) << count;
    std::vector<int> every(nodes.size());
    for (std::size_t i = 0; i < every.size(); ++i) every[i] = static_cast<int>(i);
    const double left = share_left_out(basis, every, 0);
    EXPECT_GE(left, -1e-9) << count;
    EXPECT_LT(left, left_before) << count;
    left_before = left;
  }
}

// Within a step the compliance by all modes is that of the factor.
TEST(ModalBasis, OfAllModesYieldsAsTheFactorDoes) {
  const BodyModel body = box({3, 3, 3}, 0.3);
  const std::vector<int> nodes = side_of(body);
  const ModalBasis basis = modal_basis(body, 2000, nodes);
  const std::vector<double> modal = modal_compliance(basis, body, kStep);
  const std::vector<double> exact = node_compliance(body.factor, body.slot, nodes).block;
  ASSERT_EQ(modal.size(), exact.size());
  for (std::size_t i = 0; i < exact.size(); ++i) EXPECT_NEAR(modal[i], exact[i], 1e-12 * exact[0]) << i;
}

}  // namespace
}  // namespace unbruised

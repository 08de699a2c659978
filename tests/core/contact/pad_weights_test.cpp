// How forces are passed from the product's pieces to a pad with particles of its own: constant pressure exactly,
// and with the same force and moment on both bodies.

#include "core/contact/pad_weights.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace unbruised {
namespace {

/// A flat face of this many cells from -1 to 1.
std::vector<Tributary> flat_face(int cells) {
  std::vector<Tributary> face;
  for (int k = 0; k <= cells; ++k) {
    face.push_back(
        {.place_m = -1.0 + 2.0 * k / cells, .extent_m = 2.0 / cells, .curved = false, .cells = {k, cells - k}});
  }
  return face;
}

std::vector<double> pad_places(int cells, double half) {
  std::vector<double> places;
  for (int j = 0; j <= cells; ++j) places.push_back(-half + 2.0 * half * j / cells);
  return places;
}

/// What of a piece lies under the pad [m], by the very rule that the contacts use.
double covered_m(const Tributary& piece, double half, double middle) {
  const Stretch pad{Lane(middle - half), Lane(middle + half)};
  return full_weight_m(piece) * piece.covered_by(pad, Lane(0.0)).share[0];
}

/// Sum over pieces of what each carries, on each particle of the pad.
std::vector<double> load_on_pad(const std::vector<Tributary>& face, const std::vector<double>& pad, double middle,
                                double (*pressure)(double)) {
  std::vector<double> load(pad.size(), 0.0);
  const auto weights = pad_weights(face, pad, middle);
  for (std::size_t k = 0; k < face.size(); ++k) {
    const double force = pressure(face[k].place_m) * covered_m(face[k], pad.back(), middle);
    for (std::size_t i = 0; i < weights[k].weight.size(); ++i) {
      load[weights[k].first + i] += force * weights[k].weight[i];
    }
  }
  return load;
}

double one(double) { return 1.0; }

struct Meshes {
  int product, pad;
  double half, middle;
};

class Meshings : public ::testing::TestWithParam<Meshes> {};

TEST_P(Meshings, PassAConstantPressureAsThePadItselfWouldTakeIt) {
  const auto [product, cells, half, middle] = GetParam();
  const std::vector<double> pad = pad_places(cells, half);
  const std::vector<double> load = load_on_pad(flat_face(product), pad, middle, one);
  for (std::size_t j = 0; j < load.size(); ++j) {
    // The integral of its hat function over the face.
    double expected = 0.0;
    const double h = pad[1] - pad[0];
    for (int side = 0; side < 2; ++side) {
      if ((side == 0 && j == 0) || (side == 1 && j + 1 == pad.size())) continue;
      const double far = pad[j] + (side == 0 ? -h : h);
      const double low = std::max(-1.0 - middle, std::min(pad[j], far));
      const double high = std::min(1.0 - middle, std::max(pad[j], far));
      if (high <= low) continue;
      const auto hat = [&](double y) { return 1.0 - std::abs(y - pad[j]) / h; };
      expected += (high - low) * hat(0.5 * (low + high));
    }
    EXPECT_NEAR(load[j], expected, 1e-14) << "particle " << j;
  }
}

TEST_P(Meshings, GiveEachForceToThePadInItsOwnPlace) {
  const auto [product, cells, half, middle] = GetParam();
  const std::vector<double> pad = pad_places(cells, half);
  const std::vector<Tributary> face = flat_face(product);
  const auto weights = pad_weights(face, pad, middle);
  for (std::size_t k = 0; k < face.size(); ++k) {
    double sum = 0.0, moment = 0.0;
    for (std::size_t i = 0; i < weights[k].weight.size(); ++i) {
      sum += weights[k].weight[i];
      moment += weights[k].weight[i] * (pad[weights[k].first + i] + middle);
    }
    EXPECT_NEAR(sum, 1.0, 1e-13) << "piece " << k;
    if (covered_m(face[k], half, middle) < 1e-12) continue;  // carries nothing
    EXPECT_NEAR(moment, face[k].place_m, 1e-12) << "piece " << k;
  }
}

INSTANTIATE_TEST_SUITE_P(PadWeights, Meshings,
                         ::testing::Values(Meshes{7, 7, 1.0, 0.0}, Meshes{7, 5, 1.0, 0.0}, Meshes{5, 12, 1.0, 0.0},
                                           Meshes{7, 7, 0.6, 0.0}, Meshes{7, 4, 0.6, 0.1}, Meshes{6, 9, 0.5, 0.7},
                                           Meshes{3, 8, 1.4, 0.0}, Meshes{8, 3, 1.3, -0.2}));

TEST(PadWeights, OfASliverUnderThePadsEdgeStayPositive) {
  // The pad reaches 2 % of a cell past a particle: duals would be a hundred times the mean there.
  const std::vector<Tributary> face = flat_face(10);
  const double half = 0.404;
  const auto weights = pad_weights(face, pad_places(6, half), 0.0);
  double sum = 0.0;
  for (const double weight : weights[8].weight) {
    EXPECT_GE(weight, 0.0);
    sum += weight;
  }
  EXPECT_NEAR(sum, 1.0, 1e-13);
  const std::vector<double> load = load_on_pad(face, pad_places(6, half), 0.0, one);
  double total = 0.0;
  for (const double part : load) total += part;
  EXPECT_NEAR(total, 2.0 * half, 1e-14);
}

TEST(PadWeights, OfACurvedPieceSpreadItOverItsCell) {
  std::vector<Tributary> face = flat_face(8);
  for (Tributary& piece : face) piece.curved = true;
  const std::vector<double> pad = pad_places(16, 1.0);  // two cells of the pad to one of the product
  const auto weights = pad_weights(face, pad, 0.0);
  // In the middle: a whole hat, and halves of the two beside it.
  ASSERT_EQ(weights[4].weight.size(), 3U);
  EXPECT_NEAR(weights[4].weight[0], 0.25, 1e-14);
  EXPECT_NEAR(weights[4].weight[1], 0.5, 1e-14);
  EXPECT_NEAR(weights[4].weight[2], 0.25, 1e-14);
}

TEST(PadWeights, OfAPieceBesideThePadAreThoseOfItsEdge) {
  const auto weights = pad_weights(flat_face(10), pad_places(4, 0.3), 0.0);
  ASSERT_FALSE(weights.front().weight.empty());
  EXPECT_EQ(weights.front().first, 0U);
  EXPECT_EQ(weights.front().weight.front(), 1.0);
  EXPECT_EQ(weights.back().first + weights.back().weight.size(), 5U);
  EXPECT_EQ(weights.back().weight.back(), 1.0);
}

}  // namespace
}  // namespace unbruised

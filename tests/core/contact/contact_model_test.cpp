// What a model knows of contact before anything moves: candidates, the relief of a curved side, compliance,
// patches.

#include "core/contact/contact_model.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/simulation/model_parts.hpp"
#include "tests/core/simulation/scenes.hpp"

namespace unbruised {
namespace {

using namespace testing;

Scenario ball() {
  Scenario scenario = small_box();
  lattice_of(scenario).shape = Shape::sphere;
  lattice_of(scenario).size_m = {0.04, 0.04, 0.04};
  lattice_of(scenario).cell_size_m = 0.005;
  return scenario;
}

/// Round-off of sums of some hundred areas.
constexpr double kSum = 1e-12;

TEST(ContactModel, AFlatSideIsSharedOutAmongItsCandidates) {
  const auto model = build(small_box());
  const ContactModel& contact = model->parts().contact;
  std::array<double, kFirstCellSurface> area{};
  for (const ContactCandidate& c : contact.candidate) {
    EXPECT_TRUE(c.flat);
    EXPECT_EQ(c.cell_compliance_m_Pa, 0.0);
    area[c.surface] += c.area_m2;
  }
  for (const double each : area) EXPECT_NEAR(each, 0.02 * 0.02, kSum * each);
  EXPECT_EQ(contact.pole_m[kLeftPad], -contact.pole_m[kRightPad]);
  EXPECT_DOUBLE_EQ(contact.pole_m[kRightPad], 0.01);
}

TEST(ContactModel, CandidatesAreListedByNodeAndSurface) {
  const auto model = build(ball());
  const ContactModel& contact = model->parts().contact;
  ASSERT_EQ(contact.first_candidate.size(), contact.node_count() + 1);
  for (std::size_t node = 0; node < contact.node_count(); ++node) {
    for (int c = contact.first_candidate[node]; c < contact.first_candidate[node + 1]; ++c) {
      EXPECT_EQ(contact.candidate[static_cast<std::size_t>(c)].node, contact.node[node]);
      EXPECT_EQ(contact.candidate[static_cast<std::size_t>(c)].contact_node, static_cast<int>(node));
    }
  }
}

TEST(ContactModel, TheReliefOfABallIsItsSphere) {
  const auto model = build(ball());
  const Model::Parts& parts = model->parts();
  const double radius = 0.02;
  for (const ContactCandidate& c : parts.contact.candidate) {
    EXPECT_FALSE(c.flat);
    // From the centre of the ball, in the plane of the surface.
    const auto tangents = tangent_axes(c.surface);
    std::array<double, 2> middle{};
    for (std::size_t t = 0; t < 2; ++t) middle[t] = c.tributary[t].place_m - parts.body.center_m()[tangents[t]];
    const double here = radius * radius - middle[0] * middle[0] - middle[1] * middle[1];
    for (int q = 0; q < kReliefPlaces; ++q) {
      const auto offset = place_offset_m(c, q);
      const double y = middle[0] + offset[0];
      const double z = middle[1] + offset[1];
      const double there = radius * radius - y * y - z * z;
      if (there < 0.0) {
        EXPECT_GT(c.relief_m[q], 1.0) << "never touches";
      } else {
        // sqrt of differences of squares of centimetres: round-off of 1e-16 m, more where `there` vanishes.
        EXPECT_NEAR(c.relief_m[q], std::sqrt(here) - std::sqrt(there), 1e-10);
      }
    }
    const double modulus = 1e5 / (1.0 - 0.25 * 0.25);
    EXPECT_NEAR(c.cell_compliance_m_Pa, 0.4 * c.tributary[0].extent_m / modulus, kSum * c.cell_compliance_m_Pa);
  }
}

TEST(ContactModel, TheComplianceIsSymmetricAndYieldsUnderEveryForce) {
  const auto model = build(ball());
  const ContactModel& contact = model->parts().contact;
  const std::size_t m = contact.node_count();
  double largest = 0.0;
  for (const double value : contact.compliance) largest = std::max(largest, std::abs(value));
  for (std::size_t i = 0; i < m; ++i) {
    for (std::size_t j = 0; j < m; ++j) {
      for (std::size_t k = 0; k < 9; ++k) {
        const double there = contact.compliance[9 * (i * m + j) + k];
        const double back = contact.compliance[9 * (j * m + i) + 3 * (k % 3) + k / 3];
        // Solves with a factor of some thousand rows: relative round-off well below 1e-10.
        ASSERT_NEAR(there, back, 1e-10 * largest);
      }
    }
    for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_GT(contact.compliance[9 * (i * m + i) + 4 * axis], 0.0);
  }
}

TEST(ContactModel, ARoundFlatFaceIsSharedOutInFullHoweverCoarse) {
  for (const double cell : {0.01, 0.007, 0.003}) {
    Scenario scenario = small_box();
    LatticeParameters& product = lattice_of(scenario);
    product.shape = Shape::cylinder;
    product.axis = Axis::x;
    product.size_m = {0.02, 0.03, 0.024};
    product.cell_size_m = cell;
    const auto model = build(scenario);
    double area = 0.0, first = 0.0, second = 0.0;
    for (const ContactCandidate& c : model->parts().contact.candidate) {
      if (c.surface != kLeftPad) continue;
      EXPECT_TRUE(c.flat);
      EXPECT_GT(c.area_m2, 0.0);
      const double y = c.tributary[0].place_m;
      area += c.area_m2;
      first += c.area_m2 * y;
      second += c.area_m2 * y * y;
    }
    const double ellipse = std::numbers::pi / 4.0 * 0.03 * 0.024;
    EXPECT_NEAR(area, ellipse, kSum * ellipse) << cell;
    EXPECT_NEAR(first, 0.0, kSum * ellipse * 0.03) << cell;
    // A hat function's second moment exceeds that of the area by h^2/6 per unit of area; at the rim, whose share
    // of cells falls with h, particles stand for what lies beyond them.
    EXPECT_NEAR(second, ellipse * (0.015 * 0.015 / 4.0), ellipse * cell * cell * 0.6) << cell;
  }
}

TEST(ContactModel, TheHertzPatchOfABallIsItsCircle) {
  // a^3 = 3 F R / (4 E*), so A = pi (3 F R / (4 E*))^(2/3).
  const double radius_m = 0.02, modulus_Pa = 1e6;
  const PatchArea area = ellipse_area({radius_m, radius_m}, modulus_Pa);
  EXPECT_NEAR(area.body, std::numbers::pi * std::pow(0.75 * radius_m / modulus_Pa, 2.0 / 3.0), kSum * area.body);
  EXPECT_DOUBLE_EQ(area.semi_axis[0], area.semi_axis[1]);
  // Turned by a quarter, the ellipse is the same one turned.
  const PatchArea flat = ellipse_area({0.04, 0.02}, modulus_Pa), turned = ellipse_area({0.02, 0.04}, modulus_Pa);
  EXPECT_EQ(flat.body, turned.body);
  EXPECT_EQ(flat.semi_axis[0], turned.semi_axis[1]);
  EXPECT_GT(flat.semi_axis[0], flat.semi_axis[1]) << "longer along the flatter side";
}

TEST(ContactModel, ParticlesOfANetworkTouchTheSupportThroughTheirOwnLayer) {
  NetworkParameters network;
  network.particle.resize(2);
  network.particle[1].position_m = {0.1, 0.2, 0.3};
  network.particle[1].contact_stiffness_N_m = 50.0;
  const ContactModel contact = network_contact(network);
  ASSERT_EQ(contact.candidate.size(), 1U);
  EXPECT_EQ(contact.candidate[0].surface, kSupport);
  EXPECT_EQ(contact.candidate[0].node, 1);
  EXPECT_EQ(contact.candidate[0].surface_m, 0.3);
  EXPECT_EQ(contact.candidate[0].stiffness_N_m, 50.0);
}

}  // namespace
}  // namespace unbruised

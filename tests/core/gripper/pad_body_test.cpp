// Pads that are bodies, at rest: their stiffness against layers where these are right, against finite elements
// where they are not, and a pressure that goes through two bodies whose meshes do not match.

#include "core/gripper/pad_body.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "core/contact/contact_model.hpp"
#include "core/contact/pad_weights.hpp"
#include "core/door/eigen.hpp"
#include "core/scenario/pad_lattice.hpp"
#include "tests/core/gripper/pad_stiffness.hpp"

namespace unbruised {
namespace {

using namespace testing;

constexpr double kSide_m = 0.03;
constexpr double kModulus_Pa = 1e6;
constexpr double kArea_m2 = kSide_m * kSide_m;

PadBody make_pad(double thickness_m, double poisson_ratio, double cell_m) {
  ParallelJawParameters jaw;
  jaw.pad.kind = PadKind::lattice;
  jaw.pad_size_m = {kSide_m, kSide_m};
  jaw.pad_thickness_m = thickness_m;
  jaw.pad_modulus_Pa = kModulus_Pa;
  jaw.pad_poisson_ratio = poisson_ratio;
  jaw.pad.cell_size_m = cell_m;
  std::string error;
  auto pad = build_pad(jaw, WilsonTheta(1e-3, 1.4), error);
  EXPECT_TRUE(pad.has_value()) << error;
  return std::move(*pad);
}

/// How far particles of a body move at rest under forces on them, [3n, 3n].
Eigen::MatrixXd compliance_at_rest(const BodyModel& body, const std::vector<int>& node) {
  const Eigen::Index n = 3 * static_cast<Eigen::Index>(node.size());
  Eigen::MatrixXd G(n, n);
  std::vector<double> force(3 * body.particle_count, 0.0);
  for (Eigen::Index column = 0; column < n; ++column) {
    const auto loaded = static_cast<std::size_t>(3 * node[static_cast<std::size_t>(column / 3)] + column % 3);
    force[loaded] = 1.0;
    const std::vector<double> u = body.statics->free_shape(force);
    force[loaded] = 0.0;
    for (Eigen::Index row = 0; row < n; ++row) {
      G(row, column) = u[static_cast<std::size_t>(3 * node[static_cast<std::size_t>(row / 3)] + row % 3)];
    }
  }
  return G;
}

TEST(PadBody, ThatKeepsItsWidthIsALayer) {
  // Nu = 0: nothing goes aside, and the pad is E A / t to rounding, whatever its thickness.
  for (const double thickness_m : {0.003, 0.01}) {
    const PadBody pad = make_pad(thickness_m, 0.0, thickness_m == 0.003 ? 0.0015 : 0.00333);
    EXPECT_NEAR(stiffness_N_m(pad, 0, false) / (kModulus_Pa * kArea_m2 / thickness_m), 1.0, 1e-9);
  }
}

TEST(PadBody, IsPlacedAndWeighedAsItIsGiven) {
  const PadBody pad = make_pad(0.01, 0.45, 0.00333);
  EXPECT_NEAR(pad.body.total_mass_kg, 1100.0 * kArea_m2 * 0.01, 1e-15);
  EXPECT_EQ(pad.face.size(), pad.place_m[0].size() * pad.place_m[1].size());
  EXPECT_EQ(pad.columns(), 10U);
  for (const auto& along : pad.place_m) {
    EXPECT_NEAR(along.front(), -0.5 * kSide_m, 1e-15);
    EXPECT_NEAR(along.back(), 0.5 * kSide_m, 1e-15);
  }
  // In a step so short that nothing is passed on, the finger feels what is bonded to it alone; in a long one the
  // whole pad.
  EXPECT_LT(pad.felt_mass_kg, pad.body.total_mass_kg);
  EXPECT_GT(pad.felt_mass_kg, 0.0);
}

// Finite elements of 27 nodes (tests/reference/press_pad_body.py): 211.0, 201.9 and 199.7, and 128.7, 126.4 and
// 125.7 kN/m with 3, 5 and 7 of them a side, taken on to many, within 0.5 %. E A / t is 90 kN/m.
constexpr double kThickHeld_N_m = 197.6e3, kThickFree_N_m = 125.2e3;

TEST(PadBody, BulgesAsFiniteElementsOfThickRubberDo) {
  // 10 mm, nu 0.49. What goes aside is a parabola across the thickness where the face is held, half of one where
  // it slides: straight cells are too stiff for it, and along the edges of back and face stress has no bound.
  const struct {
    double cell_m, of_held, of_free;
  } finer[] = {{0.005, 0.5, 0.2}, {0.0033, 0.22, 0.08}, {0.0025, 0.115, 0.05}, {0.00167, 0.07, 0.03}};
  for (const auto& [cell_m, of_held, of_free] : finer) {
    const PadBody pad = make_pad(0.01, 0.49, cell_m);
    const double held = stiffness_N_m(pad, 0, true) / kThickHeld_N_m - 1.0;
    const double free = stiffness_N_m(pad, 0, false) / kThickFree_N_m - 1.0;
    EXPECT_LT(std::abs(held), of_held) << cell_m;
    EXPECT_LT(std::abs(free), of_free) << cell_m;
    std::cout << "[ measured ] cells of " << 1e3 * cell_m << " mm: a face that sticks " << 100.0 * held
              << " %, one that slides " << 100.0 * free << " % off\n";
  }
}

// Half a minute; the whole table is in docs/validation.md.
TEST(HeavyPadBody, OfEightCellsIsWithinFivePerCentOfFiniteElements) {
  const PadBody pad = make_pad(0.01, 0.49, 0.00125);
  const double held = stiffness_N_m(pad, 0, true) / kThickHeld_N_m - 1.0;
  EXPECT_LT(std::abs(held), 0.05);
  std::cout << "[ measured ] eight cells: a face that sticks " << 100.0 * held << " % off\n";
}

TEST(PadBody, IsShearedAsAThinBlockIs) {
  // G A / t of a block whose face goes along itself; what its free sides lack is of the order t / side.
  const double thickness_m = 0.003, poisson_ratio = 0.3;
  const PadBody pad = make_pad(thickness_m, poisson_ratio, 0.0015);
  const double simple = kModulus_Pa / (2.0 * (1.0 + poisson_ratio)) * kArea_m2 / thickness_m;
  const double ratio = stiffness_N_m(pad, 2, true) / simple;
  EXPECT_LT(ratio, 1.0);
  EXPECT_GT(ratio, 1.0 - thickness_m / kSide_m);
}

/// A product of other cells before the pad, held at its far side, and what its candidates against the right pad
/// are.
struct PressedBlock {
  LatticeParameters parameters;
  BodyModel body;
  ContactModel contact;
};

PressedBlock make_block(double size_x_m, double side_m, double cell_m) {
  LatticeParameters block;
  block.size_m = {size_x_m, side_m, side_m};
  block.cell_size_m = cell_m;
  block.density_kg_m3 = 1000.0;
  block.youngs_modulus_Pa = 0.3e6;
  block.poisson_ratio = 0.0;
  std::string error;
  auto body = build_held_body(block, WilsonTheta(1e-3, 1.4), error);
  EXPECT_TRUE(body.has_value()) << error;
  ContactModel contact =
      lattice_contact(block, *body->lattice, {.set = ContactSet::pads_and_support, .pressure_patch_m = 0.01});
  return {block, std::move(*body), std::move(contact)};
}

TEST(PadFaces, PassAConstantPressureThroughTwoBodies) {
  // 6 cells meet 9, neither body goes aside: the stress is the same everywhere, and the springs are in series.
  const PadBody pad = make_pad(0.01, 0.0, 0.00333);
  const PressedBlock block = make_block(0.02, kSide_m, 0.005);
  const PadFaces faces = pad_faces(block.contact, pad, WilsonTheta(1e-3, 1.4), {0.0, 0.5 * kSide_m});
  const PadFaces::Face& face = faces.face[kRightPad];
  const Eigen::Index m = static_cast<Eigen::Index>(face.candidate.size());
  std::vector<int> node;
  for (const int c : face.candidate) node.push_back(block.contact.candidate[static_cast<std::size_t>(c)].node);
  const Eigen::MatrixXd W = compliance_at_rest(block.body, node), G = compliance_at_rest(pad.body, pad.face);
  Eigen::MatrixXd B = Eigen::MatrixXd::Zero(m, static_cast<Eigen::Index>(pad.face.size()));
  for (Eigen::Index k = 0; k < m; ++k) {
    for (int w = face.first[static_cast<std::size_t>(k)]; w < face.first[static_cast<std::size_t>(k) + 1]; ++w) {
      B(k, face.node[static_cast<std::size_t>(w)]) += face.weight[static_cast<std::size_t>(w)];
    }
  }
  const double skin_N_m3 = kPadSkin * kModulus_Pa / 0.01;
  Eigen::MatrixXd all(m, m);
  Eigen::MatrixXd Gx(B.cols(), B.cols());
  for (Eigen::Index i = 0; i < B.cols(); ++i) {
    for (Eigen::Index j = 0; j < B.cols(); ++j) Gx(i, j) = G(3 * i, 3 * j);
  }
  all = B * Gx * B.transpose();
  std::vector<double> area(static_cast<std::size_t>(m));
  for (Eigen::Index i = 0; i < m; ++i) {
    const auto at = static_cast<std::size_t>(i);
    area[at] = block.contact.candidate[static_cast<std::size_t>(face.candidate[at])].area_m2;
    for (Eigen::Index j = 0; j < m; ++j) all(i, j) += W(3 * i, 3 * j);
    all(i, i) += 1.0 / (skin_N_m3 * area[at]);
  }
  const double closed_m = 1e-3;
  const Eigen::VectorXd force = all.ldlt().solve(Eigen::VectorXd::Constant(m, closed_m));
  const double pressure =
      closed_m / (0.02 / block.parameters.youngs_modulus_Pa + 0.01 / kModulus_Pa + 1.0 / skin_N_m3);
  for (Eigen::Index i = 0; i < m; ++i) {
    EXPECT_NEAR(force[i] / (pressure * area[static_cast<std::size_t>(i)]), 1.0, 1e-10) << "candidate " << i;
  }
  // The face of the pad goes back as a whole.
  const Eigen::VectorXd back = Gx * (B.transpose() * force);
  for (Eigen::Index i = 0; i < back.size(); ++i)
    EXPECT_NEAR(back[i] / (pressure * 0.01 / kModulus_Pa), 1.0, 1e-10);
}

TEST(PadFaces, GiveBothBodiesTheSameWrench) {
  // The pad ends within the face, 0.3 of a cell past a particle.
  const PadBody pad = make_pad(0.01, 0.49, 0.00333);
  const PressedBlock block = make_block(0.02, 0.0483, 0.0069);
  const PadFaces faces = pad_faces(block.contact, pad, WilsonTheta(1e-3, 1.4), {0.0, 0.5 * 0.0483});
  for (int surface = 0; surface < kJawFingers; ++surface) {
    const PadFaces::Face& face = faces.face[static_cast<std::size_t>(surface)];
    for (std::size_t k = 0; k < face.candidate.size(); ++k) {
      const ContactCandidate& candidate = block.contact.candidate[static_cast<std::size_t>(face.candidate[k])];
      double sum = 0.0, y = 0.0, z = 0.0;
      for (int w = face.first[k]; w < face.first[k + 1]; ++w) {
        const auto at = static_cast<std::size_t>(face.node[static_cast<std::size_t>(w)]);
        const double weight = face.weight[static_cast<std::size_t>(w)];
        sum += weight;
        y += weight * pad.place_m[0][at % pad.columns()];
        z += weight * (pad.place_m[1][at / pad.columns()] + 0.5 * 0.0483);
      }
      EXPECT_NEAR(sum, 1.0, 1e-13);
      bool covered = true;
      for (std::size_t t = 0; t < 2; ++t) {
        const double middle = t == 0 ? 0.0 : 0.5 * 0.0483;
        const Stretch under{Lane(middle - 0.5 * kSide_m), Lane(middle + 0.5 * kSide_m)};
        covered = covered && candidate.tributary[t].covered_by(under, Lane(0.0)).share[0] > 1e-9;
      }
      if (!covered) continue;  // carries nothing
      EXPECT_NEAR(y, candidate.tributary[0].place_m, 1e-14);
      EXPECT_NEAR(z, candidate.tributary[1].place_m, 1e-14);
    }
  }
}

TEST(PadFaces, HaveTheSameComplianceBothWays) {
  const PadBody pad = make_pad(0.01, 0.49, 0.005);
  const PressedBlock block = make_block(0.02, kSide_m, 0.01);
  const PadFaces faces = pad_faces(block.contact, pad, WilsonTheta(1e-3, 1.4), {0.0, 0.5 * kSide_m});
  for (const PadFaces::Face& face : faces.face) {
    const std::size_t m = face.candidate.size();
    for (std::size_t k = 0; k < m; ++k) {
      for (std::size_t l = 0; l < m; ++l) {
        for (std::size_t i = 0; i < 9; ++i) {
          const double there = face.compliance[9 * (k * m + l) + i];
          const double back = face.compliance[9 * (l * m + k) + 3 * (i % 3) + i / 3];
          EXPECT_NEAR(there, back, 1e-12 * face.compliance[9 * k * (m + 1)]);
        }
      }
    }
  }
}

}  // namespace
}  // namespace unbruised

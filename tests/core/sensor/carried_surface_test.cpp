// Rays against the true surface that particles carry: closed forms for bodies that move, turn and deform.

#include "core/sensor/carried_surface.hpp"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

namespace unbruised {
namespace {

using Place = std::array<double, 3>;

LatticeParameters product(Shape shape, Place size_m, double cell_size_m = 0.005) {
  LatticeParameters parameters;
  parameters.shape = shape;
  parameters.size_m = size_m;
  parameters.cell_size_m = cell_size_m;
  parameters.mass_kg = 0.1;
  return parameters;
}

/// A lattice whose particles are displaced by a field over the place from the middle, in lane 1.
struct Carried {
  Carried(const LatticeParameters& parameters, const std::function<Place(const Place&)>& field)
      : lattice(build_lattice(parameters)),
        surface(TrueShape(parameters), lattice),
        u(3 * lattice.position_m.size()) {
    pose.center_m = lattice.center_m;
    for (std::size_t p = 0; p < lattice.position_m.size(); ++p) {
      Place from_middle{};
      for (std::size_t d = 0; d < 3; ++d) from_middle[d] = lattice.position_m[p][d] - lattice.center_m[d];
      const Place moved = field(from_middle);
      for (std::size_t d = 0; d < 3; ++d) {
        u.at(3 * p + d, kLane) = moved[d];
        pose.mean_displacement_m[d] += moved[d] / static_cast<double>(lattice.position_m.size());
      }
    }
  }
  /// Of a ray from a place that is given from the middle.
  [[nodiscard]] std::optional<double> distance_m(const Place& from_middle, const Place& direction) const {
    Ray ray{from_middle, direction};
    for (std::size_t d = 0; d < 3; ++d) ray.start_m[d] += lattice.center_m[d];
    return surface.distance_m(ray, pose, u, kLane);
  }

  static constexpr int kLane = 1;
  Lattice lattice;
  CarriedSurface surface;
  BodyPose pose;
  LaneArray u;
};

Place still(const Place&) { return {}; }

/// Sums of some ten terms of centimetres, and the last round of the displacement.
constexpr double kRounding_m = 1e-12;

TEST(CarriedSurface, IsMetWhereTheBoxTheBallAndTheEllipsoidAre) {
  const Carried box(product(Shape::box, {0.04, 0.05, 0.06}), still);
  EXPECT_NEAR(box.distance_m({-0.05, 0.02, -0.02}, {1.0, 0.0, 0.0}).value(), 0.03, kRounding_m);
  EXPECT_FALSE(box.distance_m({-0.05, 0.0251, 0.0}, {1.0, 0.0, 0.0}));
  EXPECT_FALSE(box.distance_m({-0.05, 0.0, 0.0}, {-1.0, 0.0, 0.0}));
  EXPECT_EQ(box.distance_m({-0.019, 0.0, 0.0}, {1.0, 0.0, 0.0}), 0.0);
  const Carried ball(product(Shape::sphere, {0.06, 0.06, 0.06}), still);
  // Off the axis by (0.012, -0.009): the chord's half is sqrt(0.03^2 - 0.015^2).
  EXPECT_NEAR(ball.distance_m({0.05, 0.012, -0.009}, {-1.0, 0.0, 0.0}).value(), 0.05 - std::sqrt(0.000675),
              kRounding_m);
  const Carried egg(product(Shape::ellipsoid, {0.05, 0.071, 0.04}), still);
  const double rest = 1.0 - std::pow(0.02 / 0.0355, 2) - std::pow(0.01 / 0.02, 2);
  EXPECT_NEAR(egg.distance_m({-0.04, 0.02, 0.01}, {1.0, 0.0, 0.0}).value(), 0.04 - 0.025 * std::sqrt(rest),
              kRounding_m);
}

TEST(CarriedSurface, GoesWithABodyThatIsShifted) {
  const Carried egg(product(Shape::ellipsoid, {0.05, 0.071, 0.04}), [](const Place&) {
    return Place{0.3, -0.2, 0.1};
  });
  EXPECT_NEAR(egg.distance_m({0.26, -0.2 + 0.02, 0.1}, {1.0, 0.0, 0.0}).value(),
              0.04 - 0.025 * std::sqrt(1.0 - std::pow(0.02 / 0.0355, 2)), kRounding_m);
}

TEST(CarriedSurface, GoesWithABodyThatHasTurned) {
  Carried egg(product(Shape::ellipsoid, {0.05, 0.071, 0.04}), still);
  // By 90 degrees about z: what lay along y lies along -x.
  egg.pose.axes = {{{0.0, -1.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}}};
  EXPECT_NEAR(egg.distance_m({-0.05, 0.01, 0.0}, {1.0, 0.0, 0.0}).value(),
              0.05 - 0.0355 * std::sqrt(1.0 - std::pow(0.01 / 0.025, 2)), kRounding_m);
  // By 30 degrees, against the ellipse in axes turned back.
  const double c = std::cos(M_PI / 6.0), s = std::sin(M_PI / 6.0);
  egg.pose.axes = {{{c, -s, 0.0}, {s, c, 0.0}, {0.0, 0.0, 1.0}}};
  const double x = -0.05 * c, y = 0.05 * s, A = 0.025 * 0.025, B = 0.0355 * 0.0355;
  const double a = c * c / A + s * s / B, b = x * c / A - y * s / B, k = x * x / A + y * y / B - 1.0;
  EXPECT_NEAR(egg.distance_m({-0.05, 0.0, 0.0}, {1.0, 0.0, 0.0}).value(), (-b - std::sqrt(b * b - a * k)) / a,
              kRounding_m);
}

TEST(CarriedSurface, OfASquashedBoxMovesAsItsParticlesDo) {
  // Strains of 5 % along x and -2 % along y, and a shear: a linear field is interpolated exactly, and the
  // surface's particles lie on the surface.
  const Carried box(product(Shape::box, {0.04, 0.05, 0.06}), [](const Place& X) {
    return Place{-0.05 * X[0] + 0.03 * X[1], 0.02 * X[1], 0.0};
  });
  const double Y = 0.0102 / 1.02;
  EXPECT_NEAR(box.distance_m({-0.05, 0.0102, 0.003}, {1.0, 0.0, 0.0}).value(), 0.05 - 0.02 * 0.95 + 0.03 * Y,
              kRounding_m);
}

TEST(CarriedSurface, OfACurvedBodyIsOffByTheStrainOverHalfACellAtMost) {
  // Uniform compression of a ball by 2 % along x: an ellipsoid. Its particles stand up to a cell inside the true
  // surface, whose displacement is taken to be theirs, as contact does.
  constexpr double kStrain = 0.02, kCell_m = 0.005;
  const Carried ball(product(Shape::sphere, {0.06, 0.06, 0.06}, kCell_m), [](const Place& X) {
    return Place{-kStrain * X[0], 0.0, 0.0};
  });
  for (const double y : {0.0, 0.004, 0.009, 0.015}) {
    const double exact = 0.05 - 0.03 * (1.0 - kStrain) * std::sqrt(1.0 - y * y / 9e-4);
    EXPECT_NEAR(ball.distance_m({-0.05, y, 0.0}, {1.0, 0.0, 0.0}).value(), exact, kStrain * kCell_m) << y;
  }
}

TEST(CarriedSurface, InterpolatesABentFaceToSecondOrderInTheCell) {
  // u_x = k y^2 / 2 on a flat face: between particles a straight line is at most k h^2 / 8 off.
  constexpr double kBend_1_m = 4.0;
  const auto off_m = [](double cell_size_m) {
    const Carried box(product(Shape::box, {0.04, 0.04, 0.04}, cell_size_m), [](const Place& X) {
      return Place{0.5 * kBend_1_m * X[1] * X[1], 0.0, 0.0};
    });
    const double y = 0.01 + 0.5 * cell_size_m;
    return std::abs(box.distance_m({-0.05, y, 0.0}, {1.0, 0.0, 0.0}).value() - 0.03 - 0.5 * kBend_1_m * y * y);
  };
  EXPECT_NEAR(off_m(0.005), kBend_1_m * 0.005 * 0.005 / 8.0, 1e-9);
  EXPECT_NEAR(off_m(0.0025), kBend_1_m * 0.0025 * 0.0025 / 8.0, 1e-9);
}

}  // namespace
}  // namespace unbruised

#include "core/contact/half_space.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace unbruised {
namespace {

constexpr double kPi = std::numbers::pi;

void add(Stress& sum, double weight, const Stress& stress) {
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += weight * stress[i];
}

struct Node {
  double at = 0.0, weight = 0.0;
};

/// Gauss and Legendre's points in (0, 1), roots by Newton's method.
std::vector<Node> gauss_points(int count) {
  std::vector<Node> nodes;
  for (int i = 0; i < count; ++i) {
    double x = std::cos(kPi * (i + 0.75) / (count + 0.5)), slope = 1.0;
    for (int round = 0; round < 50; ++round) {
      double last = 1.0, value = x;
      for (int k = 2; k <= count; ++k) {
        const double next = ((2.0 * k - 1.0) * x * value - (k - 1.0) * last) / k;
        last = value;
        value = next;
      }
      slope = count * (x * value - last) / (x * x - 1.0);
      const double step = value / slope;
      x -= step;
      if (std::abs(step) < 1e-15) break;
    }
    nodes.push_back({0.5 * (x + 1.0), 1.0 / ((1.0 - x * x) * slope * slope)});
  }
  return nodes;
}

/// A part of the patch's force, where it sits relative to the place.
struct Load {
  double x = 0.0, y = 0.0, force = 0.0;
};

void add_load(PatchStress& sum, const Load& load, double z, double poisson_ratio) {
  const HalfSpacePlace from_load{-load.x, -load.y, z};
  add(sum.normal, load.force, normal_point_load(from_load, poisson_ratio));
  add(sum.tangential, load.force, tangential_point_load(from_load, poisson_ratio));
}

/// Below the patch: rays from above the place, r = z sinh(t), to the edge, where points gather since the pressure
/// ends there as a square root. Along a ray it is sqrt(C - 2 B r - A r^2).
PatchStress stress_below(const HalfSpacePlace& place, const EllipticPatch& patch,
                         const PatchQuadrature& quadrature) {
  const std::vector<Node> nodes = gauss_points(quadrature.radial);
  const double a2 = patch.semi_x * patch.semi_x, b2 = patch.semi_y * patch.semi_y;
  const double C = 1.0 - place.x * place.x / a2 - place.y * place.y / b2;
  PatchStress sum;
  for (int j = 0; j < quadrature.angular; ++j) {
    const double angle = 2.0 * kPi * (j + 0.5) / quadrature.angular;
    const double cosine = std::cos(angle), sine = std::sin(angle);
    const double A = cosine * cosine / a2 + sine * sine / b2;
    const double B = place.x * cosine / a2 + place.y * sine / b2;
    const double length = std::asinh((std::sqrt(B * B + A * C) - B) / A / place.z);
    for (const Node& node : nodes) {
      const double t = length * (1.0 - node.at * node.at);
      const double r = place.z * std::sinh(t), dr = place.z * std::cosh(t) * length * 2.0 * node.at;
      const double pressure = std::sqrt(std::max(0.0, C - 2.0 * B * r - A * r * r));
      const double force = node.weight * dr * r * pressure * 2.0 * kPi / quadrature.angular;
      add_load(sum, {r * cosine, r * sine, force}, place.z, patch.poisson_ratio);
    }
  }
  return sum;
}

/// Beside the patch, or deep below: ellipses about its middle, at sin(t) of the semi-axes, where the pressure is
/// cos(t).
PatchStress stress_beside(const HalfSpacePlace& place, const EllipticPatch& patch,
                          const PatchQuadrature& quadrature) {
  const std::vector<Node> nodes = gauss_points(quadrature.radial);
  PatchStress sum;
  for (int j = 0; j < quadrature.angular; ++j) {
    const double angle = 2.0 * kPi * (j + 0.5) / quadrature.angular;
    for (const Node& node : nodes) {
      const double t = 0.5 * kPi * node.at, s = std::sin(t);
      const double area =
          patch.semi_x * patch.semi_y * s * std::cos(t) * 0.5 * kPi * 2.0 * kPi / quadrature.angular;
      add_load(sum,
               {patch.semi_x * s * std::cos(angle) - place.x, patch.semi_y * s * std::sin(angle) - place.y,
                node.weight * area * std::cos(t)},
               place.z, patch.poisson_ratio);
    }
  }
  return sum;
}

}  // namespace

double von_mises(const Stress& s) {
  const double xy = s[0] - s[1], yz = s[1] - s[2], zx = s[2] - s[0];
  return std::sqrt(0.5 * (xy * xy + yz * yz + zx * zx) + 3.0 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]));
}

Stress normal_point_load(const HalfSpacePlace& place, double poisson_ratio) {
  const auto [x, y, z] = place;
  const double r2 = std::max(x * x + y * y, 1e-24 * z * z), rho = std::sqrt(r2 + z * z);
  const double rho3 = rho * rho * rho, rho5 = rho3 * rho * rho;
  const double c = (1.0 - 2.0 * poisson_ratio) / r2;
  const double turn = 1.0 / (rho * (rho + z)), lift = z / rho3;
  const double load = 0.5 / kPi;
  return {load * (c * ((x * x - y * y) * turn + y * y * lift) - 3.0 * z * x * x / rho5),
          load * (c * ((y * y - x * x) * turn + x * x * lift) - 3.0 * z * y * y / rho5),
          load * -3.0 * z * z * z / rho5,
          load * (c * x * y * (turn - lift) - 3.0 * x * y * z / rho5),
          load * -3.0 * x * z * z / rho5,
          load * -3.0 * y * z * z / rho5};
}

Stress tangential_point_load(const HalfSpacePlace& place, double poisson_ratio) {
  const auto [x, y, z] = place;
  const double rho = std::sqrt(x * x + y * y + z * z), s = rho + z;
  const double rho3 = rho * rho * rho, rho5 = rho3 * rho * rho;
  const double c = 1.0 - 2.0 * poisson_ratio;
  const double bend = 1.0 / (rho3 * s * s) + 2.0 / (rho * rho * s * s * s), turn = 1.0 / (rho * s * s);
  const double load = 0.5 / kPi;
  return {load * x * (-3.0 * x * x / rho5 + c * (1.0 / rho3 - 3.0 * turn + x * x * bend)),
          load * x * (-3.0 * y * y / rho5 + c * (1.0 / rho3 - turn + y * y * bend)),
          load * -3.0 * x * z * z / rho5,
          load * y * (-3.0 * x * x / rho5 + c * (x * x * bend - turn)),
          load * -3.0 * x * x * z / rho5,
          load * -3.0 * x * y * z / rho5};
}

PatchStress patch_stress(const HalfSpacePlace& place, const EllipticPatch& patch,
                         const PatchQuadrature& quadrature) {
  const double x = place.x / patch.semi_x, y = place.y / patch.semi_y;
  const bool is_deep = place.z > std::max(patch.semi_x, patch.semi_y);
  return x * x + y * y < 1.0 && !is_deep ? stress_below(place, patch, quadrature)
                                         : stress_beside(place, patch, quadrature);
}

double peak_stress_below(const EllipticPatch& patch) {
  const double sharper = std::min(patch.semi_x, patch.semi_y);
  const auto at = [&](double depth) { return von_mises(patch_stress({0.0, 0.0, depth * sharper}, patch).normal); };
  // Between a third of the shorter semi-axis, for a circle of nu = 0, and beyond the 0.79 of a strip; by thirds.
  double low = 0.3, high = 0.9;
  while (high - low > 0.01) {
    const double third = (high - low) / 3.0;
    if (at(low + third) < at(high - third)) {
      low += third;
    } else {
      high -= third;
    }
  }
  return at(0.5 * (low + high));
}

}  // namespace unbruised

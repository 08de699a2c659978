#include "core/scenario/superellipsoid.hpp"

#include <algorithm>
#include <cmath>

namespace unbruised {
namespace {

/// A pole is flatter than any circle for exponents above 2: its radius is that of the parabola by which the
/// leading term falls away as much at this share of the half extent, about where a patch ends.
constexpr double kCurvedOver = 1.0 / 3.0;

using Place = std::array<double, 3>;

}  // namespace

Superellipsoid::Superellipsoid(const LatticeParameters& parameters)
    : p_(parameters.exponents[0]), q_(parameters.exponents[1]) {
  for (std::size_t d = 0; d < 3; ++d) half_m_[d] = 0.5 * parameters.size_m[d];
}

/// Jaklic, Leonardis, Solina, "Segmentation and Recovery of Superquadrics", 2000, chapter 2; e1 = 2 / q, e2 = 2 /
/// p.
double Superellipsoid::volume_m3() const {
  const double e1 = 2.0 / q_, e2 = 2.0 / p_;
  return 2.0 * half_m_[0] * half_m_[1] * half_m_[2] * e1 * e2 * std::beta(0.5 * e1 + 1.0, e1) *
         std::beta(0.5 * e2, 0.5 * e2);
}

double Superellipsoid::mean_square_m2(std::size_t axis) const {
  const double e1 = 2.0 / q_, e2 = 2.0 / p_;
  const double extents = half_m_[0] * half_m_[1] * half_m_[2] * e1 * e2;
  const double share = axis == 2 ? std::beta(0.5 * e2, 0.5 * e2) * std::beta(1.5 * e1, e1 + 1.0)
                                 : 0.5 * std::beta(1.5 * e2, 0.5 * e2) * std::beta(0.5 * e1, 2.0 * e1 + 1.0);
  return half_m_[axis] * half_m_[axis] * extents * share / volume_m3();
}

double Superellipsoid::section_m2(std::size_t axis) const {
  const double e = axis == 2 ? p_ : q_;
  const double root = std::tgamma(1.0 + 1.0 / e);
  return 4.0 * half_m_[(axis + 1) % 3] * half_m_[(axis + 2) % 3] * root * root / std::tgamma(1.0 + 2.0 / e);
}

double Superellipsoid::gauge(const Place& place_m) const {
  std::array<double, 3> s{};
  for (std::size_t d = 0; d < 3; ++d) s[d] = std::abs(place_m[d]) / half_m_[d];
  const double across = std::pow(std::pow(s[0], p_) + std::pow(s[1], p_), q_ / p_);
  return std::pow(across + std::pow(s[2], q_), 1.0 / q_);
}

bool Superellipsoid::contains(const Place& place_m) const { return gauge(place_m) <= 1.0; }

std::optional<double> Superellipsoid::column_m(std::size_t side, const Place& place_m) const {
  const std::size_t axis = side_axis(side);
  std::array<double, 3> s{};
  for (std::size_t d = 0; d < 3; ++d) s[d] = std::abs(place_m[d]) / half_m_[d];
  if (axis == 2) {
    const double rest = 1.0 - std::pow(std::pow(s[0], p_) + std::pow(s[1], p_), q_ / p_);
    return rest < 0.0 ? std::nullopt : std::optional(half_m_[2] * std::pow(rest, 1.0 / q_));
  }
  if (s[2] > 1.0) return std::nullopt;
  const double rest = std::pow(1.0 - std::pow(s[2], q_), p_ / q_) - std::pow(s[1 - axis], p_);
  return rest < 0.0 ? std::nullopt : std::optional(half_m_[axis] * std::pow(rest, 1.0 / p_));
}

/// Of (|x/a|^p + |y/b|^p)^(q/p) + |z/c|^q, over q.
std::array<double, 3> Superellipsoid::slope(const Place& place_m) const {
  std::array<double, 3> s{}, slope{};
  for (std::size_t d = 0; d < 3; ++d) s[d] = std::abs(place_m[d]) / half_m_[d];
  const double across = std::pow(s[0], p_) + std::pow(s[1], p_);
  for (std::size_t d = 0; d < 2 && across > 0.0; ++d) {
    slope[d] = std::copysign(std::pow(across, q_ / p_ - 1.0) * std::pow(s[d], p_ - 1.0) / half_m_[d], place_m[d]);
  }
  slope[2] = std::copysign(std::pow(s[2], q_ - 1.0) / half_m_[2], place_m[2]);
  return slope;
}

std::array<double, 3> Superellipsoid::outward(std::size_t, const Place& place_m) const {
  Place normal = slope(place_m);
  const double length = std::hypot(normal[0], normal[1], normal[2]);
  for (double& n : normal) n /= length;
  return normal;
}

std::array<double, 3> Superellipsoid::pole_m(std::size_t side) const {
  Place pole{};
  pole[side_axis(side)] = side_sign(side) * half_m_[side_axis(side)];
  return pole;
}

double Superellipsoid::pole_curvature_1_m(std::size_t side, std::size_t along) const {
  const std::size_t axis = side_axis(side);
  const double e = axis == 2 || along == 2 ? q_ : p_;
  return 2.0 / e * std::pow(kCurvedOver, e - 2.0) * half_m_[axis] / (half_m_[along] * half_m_[along]);
}

/// The norm dual to the gauge.
double Superellipsoid::reach_m(const Place& direction) const {
  std::array<double, 3> s{};
  for (std::size_t d = 0; d < 3; ++d) s[d] = std::abs(direction[d]) * half_m_[d];
  const double p = p_ / (p_ - 1.0), q = q_ / (q_ - 1.0);
  const double across = std::pow(std::pow(s[0], p) + std::pow(s[1], p), q / p);
  return std::pow(across + std::pow(s[2], q), 1.0 / q);
}

/// Slides over the surface towards the place for as long as that comes nearer; from the middle the nearest pole.
NearestSurface Superellipsoid::nearest(const Place& place_m) const {
  constexpr int kRounds = 2000;
  constexpr double kSettled = 1e-14;
  Place foot = place_m;
  const double out = gauge(place_m);
  if (!(out > 0.0)) {
    const auto shortest = std::min_element(half_m_.begin(), half_m_.end());
    return {-*shortest, outward(0, pole_m(2 * static_cast<std::size_t>(shortest - half_m_.begin()) + 1))};
  }
  for (double& f : foot) f /= out;
  const auto square = [&](const Place& there) {
    double sum = 0.0;
    for (std::size_t d = 0; d < 3; ++d) sum += (place_m[d] - there[d]) * (place_m[d] - there[d]);
    return sum;
  };
  double least = square(foot), step = 1.0;
  for (int round = 0; round < kRounds && step > kSettled; ++round) {
    const Place normal = outward(0, foot);
    double along = 0.0;
    for (std::size_t d = 0; d < 3; ++d) along += (place_m[d] - foot[d]) * normal[d];
    Place next{};
    for (std::size_t d = 0; d < 3; ++d) {
      next[d] = foot[d] + step * (place_m[d] - foot[d] - along * normal[d]);
    }
    const double stretch = gauge(next);
    for (double& n : next) n /= stretch;
    const double there = square(next);
    if (there < least) {
      least = there;
      foot = next;
      step = std::min(4.0, 1.5 * step);
    } else {
      step *= 0.5;
    }
  }
  return {(out <= 1.0 ? -1.0 : 1.0) * std::sqrt(least), outward(0, foot)};
}

/// The gauge is convex along a ray: down to its least place, and back to where it has come in.
std::optional<ShapeHit> Superellipsoid::first_hit(const Place& place_m, const Place& direction) const {
  if (contains(place_m)) return ShapeHit{0.0, {-direction[0], -direction[1], -direction[2]}};
  const auto at = [&](double t) {
    Place there{};
    for (std::size_t d = 0; d < 3; ++d) there[d] = place_m[d] + t * direction[d];
    return there;
  };
  constexpr double kGolden = 0.6180339887498949;
  const double reach_m = std::hypot(half_m_[0], half_m_[1], half_m_[2]);
  double low = 0.0, high = std::hypot(place_m[0], place_m[1], place_m[2]) + reach_m;
  double outside = 0.0, inside = -1.0;
  for (int i = 0; i < 100; ++i) {
    const double a = high - kGolden * (high - low), b = low + kGolden * (high - low);
    const double of_a = gauge(at(a)), of_b = gauge(at(b));
    if (std::min(of_a, of_b) <= 1.0) {
      inside = of_a <= 1.0 ? a : b;
      break;
    }
    (of_a < of_b ? high : low) = of_a < of_b ? b : a;
  }
  if (inside < 0.0) return std::nullopt;
  for (double middle = 0.5 * inside; middle != outside && middle != inside; middle = 0.5 * (outside + inside)) {
    (gauge(at(middle)) > 1.0 ? outside : inside) = middle;
  }
  return ShapeHit{inside, slope(at(inside))};
}

}  // namespace unbruised

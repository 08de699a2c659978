#include "core/scenario/revolution.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace unbruised {
namespace {

/// Of a profile's curvature times its radius: less is straight, as a circle of fifty times the radius.
constexpr double kStraight = 0.02;
/// Curvature along the axis is that over so much of the radius to both sides of the widest place.
constexpr double kCurvedOver = 1.0 / 3.0;
/// Places of a piece from which the least of a function is looked for.
constexpr int kStarts = 8;

using Place = std::array<double, 3>;

}  // namespace

Revolution::Revolution(const LatticeParameters& p)
    : axis_(static_cast<std::size_t>(p.axis)),
      first_((axis_ + 1) % 3),
      second_((axis_ + 2) % 3),
      curve_(p.profile_height, p.profile_radius, p.size_m[axis_], 0.5 * p.size_m[first_]),
      widest_m_(0.5 * p.size_m[first_]),
      length_m_(p.size_m[axis_]) {}

/// Five points of Gauss a piece: exact for the square of q and for q times a square.
template <class Weight>
double Revolution::integral(const Weight& weight) const {
  constexpr std::array<double, 5> kPlace = {-0.906179845938664, -0.538469310105683, 0.0, 0.538469310105683,
                                            0.906179845938664};
  constexpr std::array<double, 5> kShare = {0.236926885056189, 0.478628670499366, 0.568888888888889,
                                            0.478628670499366, 0.236926885056189};
  double sum = 0.0;
  for (const auto& piece : curve_.pieces()) {
    for (std::size_t i = 0; i < kPlace.size(); ++i) {
      const double way = 0.5 * piece.length * (1.0 + kPlace[i]);
      sum += 0.5 * piece.length * kShare[i] * weight(piece.start + way, piece.q.at(way));
    }
  }
  return sum;
}

double Revolution::volume_m3() const {
  return std::numbers::pi * integral([](double, double q) { return q; });
}

std::array<double, 3> Revolution::center_of_mass_m() const {
  Place center{};
  center[axis_] = std::numbers::pi * integral([](double s, double q) { return s * q; }) / volume_m3();
  return center;
}

double Revolution::mean_square_m2(std::size_t axis) const {
  const double sum = axis == axis_ ? integral([](double s, double q) { return s * s * q; })
                                   : integral([](double, double q) { return 0.25 * q * q; });
  return std::numbers::pi * sum / volume_m3();
}

double Revolution::section_m2(std::size_t axis) const {
  if (axis == axis_) return std::numbers::pi * widest_m_ * widest_m_;
  return integral([](double, double q) { return 2.0 * std::sqrt(std::max(0.0, q)); });
}

bool Revolution::contains(const Place& place_m) const {
  return std::abs(place_m[axis_]) <= 0.5 * length_m_ && squared_radius(place_m) <= curve_.q(place_m[axis_]);
}

std::optional<double> Revolution::column_m(std::size_t side, const Place& place_m) const {
  const std::size_t axis = side_axis(side);
  if (axis == axis_) {
    const double square = squared_radius(place_m);
    const auto height = side % 2 == 0 ? curve_.first_as_wide(square) : curve_.last_as_wide(square);
    if (!height) return std::nullopt;
    return side_sign(side) * *height;
  }
  if (std::abs(place_m[axis_]) > 0.5 * length_m_) return std::nullopt;
  const std::size_t other = first_ + second_ - axis;
  const double rest = curve_.q(place_m[axis_]) - place_m[other] * place_m[other];
  return rest < 0.0 ? std::nullopt : std::optional(std::sqrt(rest));
}

std::array<double, 3> Revolution::outward(std::size_t side, const Place& place_m) const {
  Place normal{};
  const double flat_m2 = flat_end_m2(side);
  if (flat_m2 > 0.0 && std::numbers::pi * squared_radius(place_m) <= flat_m2) {
    normal[axis_] = side_sign(side);
    return normal;
  }
  normal[first_] = place_m[first_];
  normal[second_] = place_m[second_];
  normal[axis_] = -0.5 * curve_.slope(place_m[axis_]);
  const double length = std::hypot(normal[0], normal[1], normal[2]);
  for (double& n : normal) n /= length;
  return normal;
}

std::array<double, 3> Revolution::pole_m(std::size_t side) const {
  Place pole{};
  pole[axis_] = side_axis(side) == axis_ ? side_sign(side) * 0.5 * length_m_ : curve_.widest_m();
  if (side_axis(side) != axis_) pole[side_axis(side)] = side_sign(side) * widest_m_;
  return pole;
}

double Revolution::pole_curvature_1_m(std::size_t side, std::size_t along) const {
  if (side_axis(side) == axis_) {
    if (flat_end_m2(side) > 0.0) return 0.0;
    return 2.0 / std::abs(curve_.slope(side_sign(side) * 0.5 * length_m_));
  }
  if (along != axis_) return 1.0 / widest_m_;
  const double at = curve_.widest_m(), room = std::min(curve_.high() - at, at - curve_.low());
  const double d = std::min(kCurvedOver * widest_m_, room);
  const double falls = 2.0 * curve_.q(at) - curve_.q(at + d) - curve_.q(at - d);
  const double curvature = falls / (2.0 * widest_m_ * d * d);
  return curvature * widest_m_ < kStraight ? 0.0 : curvature;
}

double Revolution::flat_end_m2(std::size_t side) const {
  if (side_axis(side) != axis_) return 0.0;
  const auto& piece = side % 2 == 0 ? curve_.pieces().front() : curve_.pieces().back();
  const double q = side % 2 == 0 ? piece.q.at(0.0) : piece.q.at(piece.length);
  constexpr double kRounding = 1e-12;
  return q > kRounding * widest_m_ * widest_m_ ? std::numbers::pi * q : 0.0;
}

/// The best of several places of each piece, then golden sections around it.
template <class Of>
double Revolution::least_of(const Of& of) const {
  double best = curve_.low(), least = of(best), step = 0.0;
  for (const auto& piece : curve_.pieces()) {
    step = std::max(step, piece.length / kStarts);
    for (int i = 1; i <= kStarts; ++i) {
      const double there = piece.start + piece.length * i / kStarts, value = of(there);
      if (value < least) best = there, least = value;
    }
  }
  constexpr double kGolden = 0.6180339887498949;
  double low = std::max(curve_.low(), best - step), high = std::min(curve_.high(), best + step);
  for (int i = 0; i < 80; ++i) {
    const double a = high - kGolden * (high - low), b = low + kGolden * (high - low);
    const bool is_lower = of(a) < of(b);
    (is_lower ? high : low) = is_lower ? b : a;
  }
  const double found = 0.5 * (low + high);
  return of(found) < least ? found : best;
}

double Revolution::reach_m(const Place& direction) const {
  const double across = std::hypot(direction[first_], direction[second_]);
  const auto behind = [&](double s) { return -(direction[axis_] * s + across * std::sqrt(curve_.q(s))); };
  return -behind(least_of(behind));
}

NearestSurface Revolution::nearest(const Place& place_m) const {
  const double radius = std::sqrt(squared_radius(place_m)), height = place_m[axis_];
  const auto square = [&](double s) {
    const double out = radius - std::sqrt(curve_.q(s));
    return out * out + (height - s) * (height - s);
  };
  double foot_height = least_of(square), foot_radius = std::sqrt(curve_.q(foot_height));
  double least = square(foot_height);
  bool on_flat_end = false;
  for (const std::size_t side : {2 * axis_, 2 * axis_ + 1}) {
    const double end = side_sign(side) * 0.5 * length_m_, away = (height - end) * (height - end);
    if (flat_end_m2(side) == 0.0 || std::numbers::pi * radius * radius > flat_end_m2(side) || away >= least)
      continue;
    least = away;
    foot_height = end;
    foot_radius = radius;
    on_flat_end = true;
  }
  NearestSurface nearest{(contains(place_m) ? -1.0 : 1.0) * std::sqrt(least), {0.0, 0.0, 0.0}};
  if (on_flat_end) {
    nearest.normal[axis_] = foot_height < 0.0 ? -1.0 : 1.0;
    return nearest;
  }
  Place foot{};
  foot[first_] = radius > 0.0 ? foot_radius * place_m[first_] / radius : foot_radius;
  foot[second_] = radius > 0.0 ? foot_radius * place_m[second_] / radius : 0.0;
  foot[axis_] = foot_height;
  nearest.normal = outward(2 * first_, foot);
  return nearest;
}

ShapeHit Revolution::hit_at(double distance_m, const Place& place_m, const Place& direction) const {
  Place there{};
  for (std::size_t d = 0; d < 3; ++d) there[d] = place_m[d] + distance_m * direction[d];
  const bool at_end = std::abs(there[axis_]) >= 0.5 * length_m_ * (1.0 - 1e-12) && direction[axis_] != 0.0;
  return {distance_m, outward(at_end ? 2 * axis_ + (there[axis_] < 0.0 ? 0 : 1) : 2 * first_, there)};
}

/// Along the ray, the squared distance from the axis less q is a cubic within each piece.
std::optional<ShapeHit> Revolution::first_hit(const Place& place_m, const Place& direction) const {
  if (contains(place_m)) return ShapeHit{0.0, {-direction[0], -direction[1], -direction[2]}};
  const double A = direction[first_] * direction[first_] + direction[second_] * direction[second_];
  const double B = place_m[first_] * direction[first_] + place_m[second_] * direction[second_];
  const double C = squared_radius(place_m), along = direction[axis_], height = place_m[axis_];
  if (along == 0.0) {
    if (std::abs(height) > 0.5 * length_m_ || A == 0.0) return std::nullopt;
    const double square = B * B - A * (C - curve_.q(height));
    if (square < 0.0 || B > 0.0) return std::nullopt;
    return hit_at((-B - std::sqrt(square)) / A, place_m, direction);
  }
  const auto& pieces = curve_.pieces();
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const auto& piece = pieces[along > 0.0 ? i : pieces.size() - 1 - i];
    const double t = (piece.start - height) / along;  // where the ray passes the start of the piece
    double from = 0.0, to = piece.length / along;
    if (along < 0.0) std::swap(from, to);
    from = std::max(from, -t);
    if (!(to > from)) continue;
    const auto& c = piece.q.c;
    const Cubic outside{{A * t * t + 2.0 * B * t + C - c[0], 2.0 * (A * t + B) - c[1] * along,
                         A - c[2] * along * along, -c[3] * along * along * along}};
    if (const auto way = first_not_positive(outside, from, to)) return hit_at(t + *way, place_m, direction);
  }
  return std::nullopt;
}

}  // namespace unbruised

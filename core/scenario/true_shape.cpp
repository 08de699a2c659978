#include "core/scenario/true_shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/scenario/finger_axes.hpp"

namespace unbruised {
namespace {

/// The ellipse or ellipsoid over the round axes, and a place in its positive octant.
struct EllipsoidPlace {
  std::array<double, 3> half_m{1.0, 1.0, 1.0};
  std::array<double, 3> y{};  ///< 0 along axes that are not round
  std::size_t shortest = 0;   ///< of the round axes

  /// s + e^2 - e_shortest^2, under which the foot of the normal through y is e^2 y / that.
  [[nodiscard]] double below(std::size_t d, double s) const {
    return s + (half_m[d] * half_m[d] - half_m[shortest] * half_m[shortest]);
  }
  [[nodiscard]] double foot(std::size_t d, double s) const {
    return y[d] == 0.0 ? 0.0 : half_m[d] * half_m[d] * y[d] / below(d, s);
  }
  /// Sum of (foot / e)^2: 1 where the foot lies on the surface; falls with s.
  [[nodiscard]] double sum(double s) const {
    double total = 0.0;
    for (std::size_t d = 0; d < 3; ++d) {
      const double q = foot(d, s) / half_m[d];
      total += q * q;
    }
    return total;
  }
};

/// The foot on the surface of the normal through y (Eberly, "Distance from a point to an ellipse, an ellipsoid or
/// a hyperellipsoid", 2013): s bisected to the last bit.
std::array<double, 3> foot_of(const EllipsoidPlace& place) {
  double low = 0.0, high = 0.0;
  for (std::size_t d = 0; d < 3; ++d) high = std::max(high, std::sqrt(3.0) * place.half_m[d] * place.y[d]);
  // In the plane across the shortest axis, and so near the middle that the foot lies on that axis' side.
  const bool above_middle = place.y[place.shortest] == 0.0 && place.sum(0.0) < 1.0;
  for (double middle = 0.5 * high; !above_middle && low < middle && middle < high; middle = 0.5 * (low + high)) {
    (place.sum(middle) > 1.0 ? low : high) = middle;
  }
  const double s = above_middle ? 0.0 : high;
  std::array<double, 3> foot = {place.foot(0, s), place.foot(1, s), place.foot(2, s)};
  if (above_middle) foot[place.shortest] = place.half_m[place.shortest] * std::sqrt(1.0 - place.sum(0.0));
  return foot;
}

}  // namespace

TrueShape::TrueShape(const LatticeParameters& parameters)
    : size_m_(parameters.size_m), solid_(solid_of(parameters)) {
  round_.fill(parameters.shape != Shape::box);
  if (parameters.shape == Shape::cylinder) round_[static_cast<std::size_t>(parameters.axis)] = false;
}

bool TrueShape::is_plane(std::size_t axis) const { return !solid_ && curvatures(2 * axis) == 0; }

bool TrueShape::curves(std::size_t side, std::size_t along) const {
  if (solid_) return solid_->pole_curvature_1_m(side, along) > 0.0;
  return round_[side_axis(side)] && round_[along];
}

int TrueShape::curvatures(std::size_t side) const {
  int count = 0;
  for (std::size_t d = 0; d < 3; ++d) count += d != side_axis(side) && curves(side, d) ? 1 : 0;
  return count;
}

double TrueShape::volume_m3() const {
  if (solid_) return solid_->volume_m3();
  const double box = size_m_[0] * size_m_[1] * size_m_[2];
  const auto round_axes = std::count(round_.begin(), round_.end(), true);
  if (round_axes == 0) return box;
  return std::numbers::pi / (round_axes == 3 ? 6.0 : 4.0) * box;
}

std::array<double, 3> TrueShape::center_of_mass_m() const {
  return solid_ ? solid_->center_of_mass_m() : std::array<double, 3>{};
}

double TrueShape::mean_square_share(std::size_t axis) const {
  if (solid_) return solid_->mean_square_m2(axis) / (size_m_[axis] * size_m_[axis]);
  if (!round_[axis]) return 1.0 / 12.0;
  return std::count(round_.begin(), round_.end(), true) == 3 ? 1.0 / 20.0 : 1.0 / 16.0;
}

double TrueShape::mean_product_share(std::size_t a, std::size_t b) const {
  return solid_ ? solid_->mean_product_m2(a, b) / (size_m_[a] * size_m_[b]) : 0.0;
}

double TrueShape::section_m2(std::size_t axis) const {
  if (solid_) return solid_->section_m2(axis);
  const auto [first, second] = face_tangents(axis);
  return 0.25 * std::numbers::pi * size_m_[first] * size_m_[second];
}

double TrueShape::face_area_m2(std::size_t axis) const {
  const double bounds = size_m_[(axis + 1) % 3] * size_m_[(axis + 2) % 3];
  return round_[(axis + 1) % 3] && round_[(axis + 2) % 3] ? std::numbers::pi / 4.0 * bounds : bounds;
}

std::array<double, 2> TrueShape::face_extents_m(std::size_t side) const {
  if (solid_ && solid_->flat_end_m2(side) > 0.0) {
    const double extent = std::sqrt(solid_->flat_end_m2(side));
    return {extent, extent};
  }
  const auto [first, second] = face_tangents(side_axis(side));
  return {size_m_[first], size_m_[second]};
}

bool TrueShape::contains(const std::array<double, 3>& place_m) const {
  if (solid_) return solid_->contains(place_m);
  double round_sum = 0.0;
  for (std::size_t d = 0; d < 3; ++d) {
    const double q = 2.0 * place_m[d] / size_m_[d];
    if (round_[d]) round_sum += q * q;
    if (!round_[d] && std::abs(q) > 1.0) return false;
  }
  return round_sum <= 1.0;
}

std::optional<double> TrueShape::column_m(std::size_t side, const std::array<double, 3>& place_m) const {
  if (solid_) return solid_->column_m(side, place_m);
  const std::size_t axis = side_axis(side);
  double rest = 1.0;
  for (std::size_t d = 0; d < 3; ++d) {
    if (d != axis && round_[d]) rest -= 4.0 * place_m[d] * place_m[d] / (size_m_[d] * size_m_[d]);
  }
  if (rest < 0.0) return std::nullopt;
  return 0.5 * size_m_[axis] * (round_[axis] ? std::sqrt(rest) : 1.0);
}

std::array<double, 3> TrueShape::outward(std::size_t side, const std::array<double, 3>& place_m) const {
  if (solid_) return solid_->outward(side, place_m);
  std::array<double, 3> normal{};
  if (!round_[side_axis(side)]) {
    normal[side_axis(side)] = side_sign(side);
    return normal;
  }
  double square = 0.0;
  for (std::size_t d = 0; d < 3; ++d) {
    if (round_[d]) normal[d] = place_m[d] / (size_m_[d] * size_m_[d]);
    square += normal[d] * normal[d];
  }
  for (double& component : normal) component /= std::sqrt(square);
  return normal;
}

std::array<double, 3> TrueShape::pole_m(std::size_t side) const {
  if (solid_) return solid_->pole_m(side);
  std::array<double, 3> pole{};
  pole[side_axis(side)] = 0.5 * side_sign(side) * size_m_[side_axis(side)];
  return pole;
}

double TrueShape::pole_radius_m(std::size_t side, std::size_t along) const {
  if (solid_) return 1.0 / solid_->pole_curvature_1_m(side, along);
  return 0.5 * size_m_[along] * size_m_[along] / size_m_[side_axis(side)];
}

double TrueShape::reach_m(const std::array<double, 3>& direction) const {
  if (solid_) return solid_->reach_m(direction);
  double flat_m = 0.0, round_m2 = 0.0;
  for (std::size_t d = 0; d < 3; ++d) {
    const double along_m = 0.5 * size_m_[d] * direction[d];
    if (round_[d]) round_m2 += along_m * along_m;
    if (!round_[d]) flat_m += std::abs(along_m);
  }
  return flat_m + std::sqrt(round_m2);
}

/// Of the ellipse or ellipsoid over the round axes.
NearestSurface TrueShape::nearest_round(const std::array<double, 3>& place_m) const {
  EllipsoidPlace place;
  double inside = 0.0;
  bool first = true;
  for (std::size_t d = 0; d < 3; ++d) {
    if (!round_[d]) continue;
    place.half_m[d] = 0.5 * size_m_[d];
    place.y[d] = std::abs(place_m[d]);
    inside += place.y[d] * place.y[d] / (place.half_m[d] * place.half_m[d]);
    // Of equal ones an axis along which the place lies off the middle: the foot is then on its side.
    const double so_far = place.half_m[place.shortest];
    const bool off_middle = place.half_m[d] == so_far && place.y[d] > place.y[place.shortest];
    if (first || place.half_m[d] < so_far || off_middle) place.shortest = d;
    first = false;
  }
  const std::array<double, 3> foot = foot_of(place);
  NearestSurface nearest{0.0, {0.0, 0.0, 0.0}};
  double distance2 = 0.0, slope2 = 0.0;
  for (std::size_t d = 0; d < 3; ++d) {
    distance2 += (place.y[d] - foot[d]) * (place.y[d] - foot[d]);
    nearest.normal[d] = std::copysign(foot[d] / (place.half_m[d] * place.half_m[d]), place_m[d]);
    slope2 += nearest.normal[d] * nearest.normal[d];
  }
  for (double& n : nearest.normal) n /= std::sqrt(slope2);
  nearest.distance_m = (inside < 1.0 ? -1.0 : 1.0) * std::sqrt(distance2);
  return nearest;
}

NearestSurface TrueShape::nearest(const std::array<double, 3>& place_m) const {
  if (solid_) return solid_->nearest(place_m);
  // The round axes together and each flat one bound the shape in directions that do not mix: outside, the
  // distances add up by squares; inside, the nearest of them counts.
  std::array<NearestSurface, 4> part;
  std::size_t count = 0;
  if (std::count(round_.begin(), round_.end(), true) > 0) part[count++] = nearest_round(place_m);
  for (std::size_t d = 0; d < 3; ++d) {
    if (round_[d]) continue;
    NearestSurface face{std::abs(place_m[d]) - 0.5 * size_m_[d], {0.0, 0.0, 0.0}};
    face.normal[d] = std::copysign(1.0, place_m[d]);
    part[count++] = face;
  }
  NearestSurface inner = part[0], outer{0.0, {0.0, 0.0, 0.0}};
  for (std::size_t i = 0; i < count; ++i) {
    if (part[i].distance_m > inner.distance_m) inner = part[i];
    const double out = std::max(0.0, part[i].distance_m);
    outer.distance_m += out * out;
    for (std::size_t d = 0; d < 3; ++d) outer.normal[d] += out * part[i].normal[d];
  }
  if (!(inner.distance_m > 0.0)) return inner;
  outer.distance_m = std::sqrt(outer.distance_m);
  for (double& n : outer.normal) n /= outer.distance_m;
  return outer;
}

struct TrueShape::Chord {
  double enter_m = -std::numeric_limits<double>::infinity();
  double leave_m = std::numeric_limits<double>::infinity();
  std::array<double, 3> normal{};  ///< where it enters
};

/// Within the ellipse or ellipsoid over the round axes: the roots of a t^2 + 2 b t + c.
TrueShape::Chord TrueShape::round_chord(const std::array<double, 3>& place_m,
                                        const std::array<double, 3>& direction) const {
  Chord chord;
  double a = 0.0, b = 0.0, c = -1.0;
  for (std::size_t d = 0; d < 3; ++d) {
    if (!round_[d]) continue;
    const double p = 2.0 * place_m[d] / size_m_[d], q = 2.0 * direction[d] / size_m_[d];
    a += q * q;
    b += p * q;
    c += p * p;
  }
  if (a == 0.0) {
    if (c > 0.0) chord.leave_m = chord.enter_m;
    return chord;
  }
  const double square = b * b - a * c;
  if (square < 0.0) {
    chord.leave_m = chord.enter_m;
    return chord;
  }
  chord.enter_m = (-b - std::sqrt(square)) / a;
  chord.leave_m = (-b + std::sqrt(square)) / a;
  for (std::size_t d = 0; d < 3; ++d) {
    if (round_[d]) chord.normal[d] = (place_m[d] + chord.enter_m * direction[d]) / (size_m_[d] * size_m_[d]);
  }
  return chord;
}

/// Between the two flat sides across an axis.
TrueShape::Chord TrueShape::flat_chord(std::size_t axis, double place_m, double direction) const {
  Chord chord;
  const double half_m = 0.5 * size_m_[axis];
  if (direction == 0.0) {
    if (std::abs(place_m) > half_m) chord.leave_m = chord.enter_m;
    return chord;
  }
  const double side = std::copysign(1.0, direction);
  chord.enter_m = (-side * half_m - place_m) / direction;
  chord.leave_m = (side * half_m - place_m) / direction;
  chord.normal[axis] = -side;
  return chord;
}

std::optional<ShapeHit> TrueShape::first_hit(const std::array<double, 3>& place_m,
                                             const std::array<double, 3>& direction) const {
  if (solid_) return solid_->first_hit(place_m, direction);
  Chord inside = round_chord(place_m, direction);
  for (std::size_t d = 0; d < 3; ++d) {
    if (round_[d]) continue;
    const Chord between = flat_chord(d, place_m[d], direction[d]);
    inside.leave_m = std::min(inside.leave_m, between.leave_m);
    if (between.enter_m <= inside.enter_m) continue;
    inside.enter_m = between.enter_m;
    inside.normal = between.normal;
  }
  if (inside.leave_m <= std::max(inside.enter_m, 0.0)) return std::nullopt;
  if (inside.enter_m <= 0.0) return ShapeHit{0.0, {-direction[0], -direction[1], -direction[2]}};
  return ShapeHit{inside.enter_m, inside.normal};
}

}  // namespace unbruised

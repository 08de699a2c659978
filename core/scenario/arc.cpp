#include "core/scenario/arc.hpp"

#include <cmath>
#include <numbers>

#include "core/scenario/vectors.hpp"

namespace unbruised {
namespace {

using Vector = std::array<double, 3>;

constexpr double kInLine = 1e-6;

}  // namespace

double Arc::radius_m() const { return length(from_center_m); }

/// The centre of the circle through three places: (|b|^2 (a x b) x a + |a|^2 b x (a x b)) / (2 |a x b|^2) from the
/// first, with a and b the ways from it to the others.
std::optional<Arc> arc_through(const Vector& from_m, const Vector& via_m, const Vector& to_m) {
  const Vector a = between(from_m, via_m), b = between(from_m, to_m), normal = cross(a, b);
  const double size = length(normal);
  if (!(size > kInLine * length(a) * length(b)) || !(size > kInLine * length(a) * length(between(via_m, to_m)))) {
    return std::nullopt;
  }
  const Vector toward_b = cross(normal, a), toward_a = cross(b, normal);
  const double A = dot(a, a), B = dot(b, b), scale = 0.5 / (size * size);
  Arc arc;
  for (std::size_t i = 0; i < 3; ++i) {
    const double way = scale * (B * toward_b[i] + A * toward_a[i]);
    arc.center_m[i] = from_m[i] + way;
    arc.from_center_m[i] = -way;
    arc.axis[i] = normal[i] / size;
  }
  const Vector end = between(arc.center_m, to_m);
  arc.angle_rad = std::atan2(dot(arc.axis, cross(arc.from_center_m, end)), dot(arc.from_center_m, end));
  // Seen along the axis, from, via and to follow each other counterclockwise.
  if (!(arc.angle_rad > 0.0)) arc.angle_rad += 2.0 * std::numbers::pi;
  return arc;
}

}  // namespace unbruised

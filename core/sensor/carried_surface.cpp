#include "core/sensor/carried_surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace unbruised {
namespace {

using Vector = std::array<double, 3>;

/// A displacement is looked up where it leads to at most this often; each time it is nearer by the size of strain
/// and rotation, at most 0.3.
constexpr int kMostRounds = 20;
constexpr double kSettled_m = 1e-12;

Vector in_axes(const std::array<Vector, 3>& R, const Vector& world) {
  Vector own{};
  for (std::size_t i = 0; i < 3; ++i) own[i] = R[0][i] * world[0] + R[1][i] * world[1] + R[2][i] * world[2];
  return own;
}

Vector along(const Vector& start, const Vector& shift, double way, const Vector& direction) {
  Vector place{};
  for (std::size_t i = 0; i < 3; ++i) place[i] = start[i] - shift[i] + way * direction[i];
  return place;
}

}  // namespace

BodyPose pose_of(const BodyMotion& body, const BodyModel& model, int lane) {
  BodyPose pose;
  pose.center_m = model.center_m();
  const FrameLanes* frame = body.frame();
  if (frame == nullptr) {
    for (std::size_t i = 0; i < 3; ++i) pose.mean_displacement_m[i] = body.mass_u()[i][lane] / model.total_mass_kg;
    return pose;
  }
  Vector lever{};  // from the centre of mass to the middle of the shape
  for (std::size_t i = 0; i < 3; ++i) {
    lever[i] = pose.center_m[i] - model.center_of_mass_m[i];
    for (std::size_t j = 0; j < 3; ++j) pose.axes[i][j] = frame->axes()(i, j)[lane];
  }
  for (std::size_t i = 0; i < 3; ++i) {
    pose.center_m[i] = model.center_of_mass_m[i] + frame->center_motion_m()[i][lane];
    for (std::size_t j = 0; j < 3; ++j) pose.center_m[i] += pose.axes[i][j] * lever[j];
  }
  return pose;
}

CarriedSurface::CarriedSurface(const TrueShape& shape, const Lattice& lattice)
    : shape_(shape), cells_(lattice.cell_count), cell_extent_m_(lattice.cell_extent_m) {
  for (std::size_t s = 0; s < side_.size(); ++s) side_[s] = make_side(lattice, s / 2, lattice.side[s]);
}

CarriedSurface::Side CarriedSurface::make_side(const Lattice& lattice, std::size_t axis,
                                               const std::vector<SurfacePoint>& points) const {
  Side side{.axis = axis, .tangent = {(axis + 1) % 3, (axis + 2) % 3}, .columns = {}, .node = {}};
  for (std::size_t t = 0; t < 2; ++t) side.columns[t] = cells_[side.tangent[t]] + 1;
  std::vector<std::array<int, 2>> column(points.size());
  for (std::size_t p = 0; p < points.size(); ++p) {
    const Vector& place_m = lattice.position_m[static_cast<std::size_t>(points[p].node)];
    for (std::size_t t = 0; t < 2; ++t) {
      const std::size_t d = side.tangent[t];
      const double from_middle = (place_m[d] - lattice.center_m[d]) / cell_extent_m_[d];
      column[p][t] = static_cast<int>(std::lround(from_middle + 0.5 * cells_[d]));
    }
  }
  for (int i = 0; i < side.columns[0]; ++i) {
    for (int j = 0; j < side.columns[1]; ++j) {
      int node = 0, least = std::numeric_limits<int>::max();
      for (std::size_t p = 0; p < points.size() && least > 0; ++p) {
        const int di = column[p][0] - i, dj = column[p][1] - j, square = di * di + dj * dj;
        if (square >= least) continue;
        least = square;
        node = points[p].node;
      }
      side.node.push_back(node);
    }
  }
  return side;
}

/// The one that faces the ray most where the ray meets the surface.
const CarriedSurface::Side& CarriedSurface::met_side(const Vector& direction, const Vector& normal) const {
  std::size_t axis = 0;
  for (std::size_t d = 1; d < 3; ++d) {
    if (-direction[d] * normal[d] > -direction[axis] * normal[axis]) axis = d;
  }
  return side_[2 * axis + (direction[axis] < 0.0 ? 1 : 0)];
}

/// Bilinear between four columns.
Vector CarriedSurface::displacement_m(const Side& side, const Vector& place_m, const LaneArray& u,
                                      int lane) const {
  std::array<int, 2> low{};
  std::array<double, 2> share{};
  for (std::size_t t = 0; t < 2; ++t) {
    const std::size_t d = side.tangent[t];
    const double at = place_m[d] / cell_extent_m_[d] + 0.5 * cells_[d];
    low[t] = std::clamp(static_cast<int>(std::floor(at)), 0, side.columns[t] - 2);
    share[t] = std::clamp(at - low[t], 0.0, 1.0);
  }
  Vector displacement{};
  for (int corner = 0; corner < 4; ++corner) {
    const int i = corner % 2, j = corner / 2;
    const double weight = (i == 0 ? 1.0 - share[0] : share[0]) * (j == 0 ? 1.0 - share[1] : share[1]);
    const auto column = static_cast<std::size_t>((low[0] + i) * side.columns[1] + low[1] + j);
    const auto row = 3 * static_cast<std::size_t>(side.node[column]);
    for (std::size_t d = 0; d < 3; ++d) displacement[d] += weight * u.at(row + d, lane);
  }
  return displacement;
}

std::optional<double> CarriedSurface::distance_m(const Ray& ray, const BodyPose& pose, const LaneArray& u,
                                                 int lane) const {
  Vector from_center{};
  for (std::size_t i = 0; i < 3; ++i) from_center[i] = ray.start_m[i] - pose.center_m[i];
  const Vector start = in_axes(pose.axes, from_center), direction = in_axes(pose.axes, ray.direction);
  Vector shift = pose.mean_displacement_m;
  for (int round = 0; round < kMostRounds; ++round) {
    const auto hit = shape_.first_hit(along(start, shift, 0.0, direction), direction);
    if (!hit) return std::nullopt;
    const Vector next =
        displacement_m(met_side(direction, hit->normal), along(start, shift, hit->distance_m, direction), u, lane);
    const double change = std::hypot(next[0] - shift[0], next[1] - shift[1], next[2] - shift[2]);
    shift = next;
    if (change < kSettled_m) break;
  }
  const auto hit = shape_.first_hit(along(start, shift, 0.0, direction), direction);
  if (!hit) return std::nullopt;
  return hit->distance_m;
}

}  // namespace unbruised

#include "core/scenario/mesh_solid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/scenario/vectors.hpp"

namespace unbruised {
namespace {

using Place = std::array<double, 3>;

/// Shares of a triangle's corners in the place of it that is nearest to another (Ericson, "Real-Time Collision
/// Detection", 2005, 5.1.5).
Place nearest_shares(const std::array<Place, 3>& corner, const Place& place) {
  const Place ab = between(corner[0], corner[1]), ac = between(corner[0], corner[2]);
  const Place ap = between(corner[0], place), bp = between(corner[1], place), cp = between(corner[2], place);
  const double d1 = dot(ab, ap), d2 = dot(ac, ap);
  if (d1 <= 0.0 && d2 <= 0.0) return {1.0, 0.0, 0.0};
  const double d3 = dot(ab, bp), d4 = dot(ac, bp);
  if (d3 >= 0.0 && d4 <= d3) return {0.0, 1.0, 0.0};
  const double d5 = dot(ab, cp), d6 = dot(ac, cp);
  if (d6 >= 0.0 && d5 <= d6) return {0.0, 0.0, 1.0};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return {1.0 - d1 / (d1 - d3), d1 / (d1 - d3), 0.0};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return {1.0 - d2 / (d2 - d6), 0.0, d2 / (d2 - d6)};
  const double va = d3 * d6 - d5 * d4, along = (d4 - d3) + (d5 - d6);
  if (va <= 0.0 && d4 >= d3 && d5 >= d6) return {0.0, (d5 - d6) / along, (d4 - d3) / along};
  const double total = va + vb + vc;
  return {va / total, vb / total, vc / total};
}

Place place_at(const std::array<Place, 3>& corner, const Place& share) {
  return sum(times(share[0], corner[0]), sum(times(share[1], corner[1]), times(share[2], corner[2])));
}

/// Does a ray pass through a box, and at most where? From 0 to `far`.
bool passes(const Bounds& box, const Place& start, const Place& direction, double far) {
  double from = 0.0, to = far;
  for (std::size_t d = 0; d < 3; ++d) {
    if (direction[d] == 0.0) {
      if (start[d] < box.low[d] || start[d] > box.high[d]) return false;
      continue;
    }
    const double a = (box.low[d] - start[d]) / direction[d], b = (box.high[d] - start[d]) / direction[d];
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  }
  return from <= to * (1.0 + 1e-12);
}

/// Distance along a ray and shares of the corners where it comes in through a triangle (Möller and Trumbore 1997);
/// none: it does not.
struct RayHit {
  double distance = 0.0;
  Place share{};
};
std::optional<RayHit> hit_of(const TriangleMesh& mesh, std::size_t t, const Place& start, const Place& direction) {
  constexpr double kBeside = 1e-9;  // of a triangle: a ray through an edge must not slip between two
  const Place &a = mesh.corner(t, 0), ab = between(a, mesh.corner(t, 1)), ac = between(a, mesh.corner(t, 2));
  const Place p = cross(direction, ac);
  const double det = dot(ab, p);
  if (!(det > 0.0)) return std::nullopt;  // seen from inside, or edge on
  const Place way = between(a, start), q = cross(way, ab);
  const double u = dot(way, p) / det, v = dot(direction, q) / det, distance = dot(ac, q) / det;
  if (u < -kBeside || v < -kBeside || u + v > 1.0 + kBeside || distance < 0.0) return std::nullopt;
  return RayHit{distance, {1.0 - u - v, u, v}};
}

}  // namespace

MeshSolid::MeshSolid(const LatticeParameters& parameters) : mesh_(parameters.mesh) {
  for (std::size_t d = 0; d < 3; ++d) stretch_m_[d] = parameters.size_m[d] / mesh_->extents()[d];
}

Place MeshSolid::in_mesh(const Place& place_m) const {
  return {place_m[0] / stretch_m_[0], place_m[1] / stretch_m_[1], place_m[2] / stretch_m_[2]};
}

Place MeshSolid::in_m(const Place& place) const {
  return {place[0] * stretch_m_[0], place[1] * stretch_m_[1], place[2] * stretch_m_[2]};
}

/// Of a surface that is stretched, normals are by the inverse.
Place MeshSolid::normal_m(const ProductMesh::On& on) const {
  const Place normal = in_mesh(mesh_->normal(on));
  return times(1.0 / length(normal), normal);
}

double MeshSolid::volume_m3() const { return mesh_->volume() * stretch_m_[0] * stretch_m_[1] * stretch_m_[2]; }
Place MeshSolid::center_of_mass_m() const { return in_m(mesh_->center_of_mass()); }

double MeshSolid::mean_product_m2(std::size_t a, std::size_t b) const {
  return mesh_->mean_product(a, b) * stretch_m_[a] * stretch_m_[b];
}

double MeshSolid::section_m2(std::size_t axis) const {
  return mesh_->section(axis) * stretch_m_[(axis + 1) % 3] * stretch_m_[(axis + 2) % 3];
}

bool MeshSolid::contains(const Place& place_m) const { return mesh_->contains(in_mesh(place_m)); }

std::optional<double> MeshSolid::column_m(std::size_t side, const Place& place_m) const {
  const auto column = mesh_->column(side, in_mesh(place_m));
  if (!column) return std::nullopt;
  return side_sign(side) * column->height * stretch_m_[side_axis(side)];
}

Place MeshSolid::outward(std::size_t side, const Place& place_m) const {
  const auto column = mesh_->column(side, in_mesh(place_m));
  return column ? normal_m(column->on) : nearest(place_m).normal;
}

Place MeshSolid::pole_m(std::size_t side) const { return in_m(mesh_->pole(side).place); }

double MeshSolid::pole_curvature_1_m(std::size_t side, std::size_t along) const {
  const double across_m = stretch_m_[along];
  return mesh_->pole(side).curvature[along] * stretch_m_[side_axis(side)] / (across_m * across_m);
}

double MeshSolid::flat_end_m2(std::size_t side) const {
  const std::size_t axis = side_axis(side);
  return mesh_->pole(side).flat_area * stretch_m_[(axis + 1) % 3] * stretch_m_[(axis + 2) % 3];
}

double MeshSolid::reach_m(const Place& direction) const {
  const Place way = in_m(direction);
  const TriangleMesh& surface = mesh_->surface();
  double farthest = -std::numeric_limits<double>::infinity();
  const auto short_of = [&](const Bounds& box) {
    double reach = 0.0;
    for (std::size_t d = 0; d < 3; ++d) reach += way[d] * (way[d] > 0.0 ? box.high[d] : box.low[d]);
    return -reach;
  };
  mesh_->tree().visit_from_least(
      short_of, [&] { return -farthest; },
      [&](int t) {
        for (std::size_t k = 0; k < 3; ++k) {
          farthest = std::max(farthest, dot(way, surface.corner(static_cast<std::size_t>(t), k)));
        }
      });
  return farthest;
}

NearestSurface MeshSolid::nearest(const Place& place_m) const {
  const TriangleMesh& surface = mesh_->surface();
  double least_m2 = std::numeric_limits<double>::infinity();
  ProductMesh::On nearest;
  const auto to_box = [&](const Bounds& box) {
    double square = 0.0;
    for (std::size_t d = 0; d < 3; ++d) {
      const double out =
          std::max({0.0, box.low[d] * stretch_m_[d] - place_m[d], place_m[d] - box.high[d] * stretch_m_[d]});
      square += out * out;
    }
    return square;
  };
  mesh_->tree().visit_from_least(
      to_box, [&] { return least_m2; },
      [&](int number) {
        const auto t = static_cast<std::size_t>(number);
        const std::array<Place, 3> corner = {in_m(surface.corner(t, 0)), in_m(surface.corner(t, 1)),
                                             in_m(surface.corner(t, 2))};
        const Place share = nearest_shares(corner, place_m);
        const Place way = between(place_m, place_at(corner, share));
        if (!(dot(way, way) < least_m2)) return;
        least_m2 = dot(way, way);
        nearest = {t, share};
      });
  return {(contains(place_m) ? -1.0 : 1.0) * std::sqrt(least_m2), normal_m(nearest)};
}

std::optional<ShapeHit> MeshSolid::first_hit(const Place& place_m, const Place& direction) const {
  if (contains(place_m)) return ShapeHit{0.0, times(-1.0, direction)};
  const TriangleMesh& surface = mesh_->surface();
  const Place start = in_mesh(place_m), way = in_mesh(direction);
  std::optional<RayHit> first;
  std::size_t triangle = 0;
  mesh_->tree().visit(
      [&](const Bounds& box) {
        return passes(box, start, way, first ? first->distance : std::numeric_limits<double>::infinity());
      },
      [&](int number) {
        const auto t = static_cast<std::size_t>(number);
        const auto hit = hit_of(surface, t, start, way);
        if (!hit || (first && hit->distance >= first->distance)) return;
        first = hit;
        triangle = t;
      });
  if (!first) return std::nullopt;
  ShapeHit hit{first->distance, normal_m({triangle, first->share})};
  if (dot(hit.normal, direction) >= 0.0) {  // grazes: the smooth normal looks away already, the triangle does not
    const Place a = in_m(surface.corner(triangle, 0));
    hit.normal =
        cross(between(a, in_m(surface.corner(triangle, 1))), between(a, in_m(surface.corner(triangle, 2))));
  }
  return hit;
}

}  // namespace unbruised

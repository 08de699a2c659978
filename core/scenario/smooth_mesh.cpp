#include "core/scenario/smooth_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <unordered_map>
#include <unordered_set>

#include "core/scenario/vectors.hpp"

namespace unbruised {
namespace {

using Place = std::array<double, 3>;

std::uint64_t edge_key(int a, int b) {
  const auto [low, high] = std::minmax(a, b);
  return (static_cast<std::uint64_t>(low) << 32) | static_cast<std::uint64_t>(high);
}

Place unit(const Place& x) {
  const double size = length(x);
  return size > 0.0 ? times(1.0 / size, x) : Place{};
}

Place facet_normal(const TriangleMesh& mesh, std::size_t t) {
  const Place& a = mesh.corner(t, 0);
  return unit(cross(between(a, mesh.corner(t, 1)), between(a, mesh.corner(t, 2))));
}

using Edges = std::unordered_set<std::uint64_t>;

Edges creases_of(const TriangleMesh& mesh) {
  std::unordered_map<std::uint64_t, std::size_t> first;
  Edges creases;
  for (std::size_t t = 0; t < mesh.triangle.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [at, is_new] = first.try_emplace(edge_key(mesh.triangle[t][k], mesh.triangle[t][(k + 1) % 3]), t);
      if (is_new) continue;
      if (dot(facet_normal(mesh, t), facet_normal(mesh, at->second)) < std::cos(kCrease_rad))
        creases.insert(at->first);
    }
  }
  return creases;
}

/// What a corner adds to the normal there, exact where the surface is a sphere (Max, "Weights for computing vertex
/// normals from facet normals", 1999).
Place corner_share(const TriangleMesh& mesh, std::size_t t, std::size_t k) {
  const Place& at = mesh.corner(t, k);
  const Place one = between(at, mesh.corner(t, (k + 1) % 3)), other = between(at, mesh.corner(t, (k + 2) % 3));
  const double sizes = dot(one, one) * dot(other, other);
  return sizes > 0.0 ? times(1.0 / sizes, cross(one, other)) : Place{};
}

/// Corners around one place that hang together over smooth edges have one normal.
std::vector<std::array<Place, 3>> normals_of(const TriangleMesh& mesh, const Edges& creases) {
  std::vector<std::vector<std::pair<std::size_t, std::size_t>>> around(mesh.place.size());
  for (std::size_t t = 0; t < mesh.triangle.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) around[static_cast<std::size_t>(mesh.triangle[t][k])].emplace_back(t, k);
  }
  std::vector<std::array<Place, 3>> normal(mesh.triangle.size());
  for (const auto& corners : around) {
    std::vector<std::size_t> group(corners.size());
    std::iota(group.begin(), group.end(), std::size_t{0});
    std::unordered_map<int, std::size_t> by_neighbour;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const auto [t, k] = corners[i];
      for (const std::size_t step : {1U, 2U}) {
        const int other = mesh.triangle[t][(k + step) % 3];
        const auto [at, is_new] = by_neighbour.try_emplace(other, i);
        if (is_new || creases.contains(edge_key(mesh.triangle[t][k], other))) continue;
        const std::size_t from = group[i], to = group[at->second];
        for (std::size_t& g : group) g = g == from ? to : g;
      }
    }
    for (std::size_t i = 0; i < corners.size(); ++i) {
      Place total{};
      for (std::size_t j = 0; j < corners.size(); ++j) {
        if (group[j] == group[i]) total = sum(total, corner_share(mesh, corners[j].first, corners[j].second));
      }
      const Place n = unit(total);
      normal[corners[i].first][corners[i].second] = length(n) > 0.0 ? n : facet_normal(mesh, corners[i].first);
    }
  }
  return normal;
}

/// How far the middle of an edge lies below the surface: half of what it lies below its ends' tangent planes, in
/// the mean. Along a parabola the chord is as far above as these planes are below, so that halfway is on it (the
/// shape factor of "Phong tessellation", Boubekeur and Alexa 2008, at which quadratic surfaces are met).
Place edge_rise(const Place& a, const Place& b, const Place& normal_a, const Place& normal_b) {
  const Place middle = times(0.5, sum(a, b));
  return sum(times(0.25 * dot(between(middle, a), normal_a), normal_a),
             times(0.25 * dot(between(middle, b), normal_b), normal_b));
}

/// Creases as curves: where two of them go on as one, within kCrease_rad, they have a tangent.
class CreaseCurves {
 public:
  CreaseCurves(const TriangleMesh& mesh, const Edges& creases) : mesh_(mesh) {
    for (const std::array<int, 3>& corner : mesh.triangle) {
      for (std::size_t k = 0; k < 3; ++k) {
        const int a = corner[k], b = corner[(k + 1) % 3];
        if (a < b && creases.contains(edge_key(a, b))) {
          ends_[a].push_back(b);
          ends_[b].push_back(a);
        }
      }
    }
  }

  /// How far the middle of a crease lies below its curve: that of the cubic with the tangents of its ends.
  [[nodiscard]] Place rise(int a, int b) const {
    const Place way = between(at(a), at(b));
    return times(-0.125 * length(way), sum(tangent(a, b, times(-1.0, way)), tangent(b, a, way)));
  }

 private:
  [[nodiscard]] const Place& at(int i) const { return mesh_.place[static_cast<std::size_t>(i)]; }

  /// At an end of a crease, away from its other one; the `straight` way where the curve has a corner or an end.
  [[nodiscard]] Place tangent(int end, int other, const Place& straight) const {
    const std::vector<int>& near = ends_.at(end);
    const Place out = unit(straight);
    if (near.size() != 2) return out;
    const Place on = between(at(end), at(near[0] == other ? near[1] : near[0]));
    if (dot(unit(on), out) < std::cos(kCrease_rad)) return out;
    // Exact on a circle, as the normals are on a sphere.
    return unit(sum(times(1.0 / dot(on, on), on), times(1.0 / dot(straight, straight), straight)));
  }

  const TriangleMesh& mesh_;
  std::unordered_map<int, std::vector<int>> ends_;
};

/// Each triangle in four.
class Division {
 public:
  Division(const SmoothMesh& from, const Edges& creases)
      : from_(from), creases_(creases), curves_(from.mesh, creases) {
    to_.place = from.mesh.place;
    for (std::size_t t = 0; t < from.mesh.triangle.size(); ++t) divide(t);
  }
  [[nodiscard]] const TriangleMesh& mesh() const { return to_; }
  [[nodiscard]] const Edges& creases() const { return half_creases_; }

 private:
  void divide(std::size_t t) {
    const std::array<int, 3>& corner = from_.mesh.triangle[t];
    std::array<int, 3> middle{};
    for (std::size_t k = 0; k < 3; ++k) middle[k] = middle_of(t, k);
    for (std::size_t k = 0; k < 3; ++k) to_.triangle.push_back({corner[k], middle[k], middle[(k + 2) % 3]});
    to_.triangle.push_back(middle);
  }

  int middle_of(std::size_t t, std::size_t k) {
    const std::size_t next = (k + 1) % 3;
    const int a = from_.mesh.triangle[t][k], b = from_.mesh.triangle[t][next];
    const std::uint64_t edge = edge_key(a, b);
    const auto [at, is_new] = middle_.try_emplace(edge, static_cast<int>(to_.place.size()));
    if (!is_new) return at->second;
    const Place &from = from_.mesh.corner(t, k), &to = from_.mesh.corner(t, next);
    Place place = times(0.5, sum(from, to));
    if (creases_.contains(edge)) {
      half_creases_.insert({edge_key(a, at->second), edge_key(at->second, b)});
      place = sum(place, curves_.rise(a, b));
    } else {
      place = sum(place, edge_rise(from, to, from_.normal[t][k], from_.normal[t][next]));
    }
    to_.place.push_back(place);
    return at->second;
  }

  const SmoothMesh& from_;
  const Edges& creases_;
  CreaseCurves curves_;
  TriangleMesh to_;
  Edges half_creases_;
  std::unordered_map<std::uint64_t, int> middle_;
};

double largest_rise(const SmoothMesh& smooth, const Edges& creases) {
  double largest = 0.0;
  const CreaseCurves curves(smooth.mesh, creases);
  for (std::size_t t = 0; t < smooth.mesh.triangle.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      const int a = smooth.mesh.triangle[t][k], b = smooth.mesh.triangle[t][next];
      if (creases.contains(edge_key(a, b))) {
        largest = std::max(largest, length(curves.rise(a, b)));
        continue;
      }
      largest = std::max(largest, length(edge_rise(smooth.mesh.corner(t, k), smooth.mesh.corner(t, next),
                                                   smooth.normal[t][k], smooth.normal[t][next])));
    }
  }
  return largest;
}

}  // namespace

SmoothMesh smooth_mesh(const TriangleMesh& mesh, double tolerance, std::size_t most_triangles) {
  Edges creases = creases_of(mesh);
  SmoothMesh smooth{mesh, normals_of(mesh, creases)};
  while (4 * smooth.mesh.triangle.size() <= most_triangles && largest_rise(smooth, creases) > tolerance) {
    const Division division(smooth, creases);
    creases = division.creases();
    smooth = {division.mesh(), normals_of(division.mesh(), creases)};
  }
  return smooth;
}

}  // namespace unbruised

#include "core/scenario/mesh_fault.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <unordered_map>

#include "core/scenario/product_mesh.hpp"
#include "core/scenario/triangle_tree.hpp"
#include "core/scenario/vectors.hpp"
#include "core/scenario/words.hpp"

namespace unbruised {
namespace {

using Place = std::array<double, 3>;

double longest_extent(const TriangleMesh& mesh) {
  const Bounds box = bounds_of(mesh.place);
  const Place extents = between(box.low, box.high);
  return *std::max_element(extents.begin(), extents.end());
}

/// Numbers for places, of which those within a tolerance of an earlier one have its number.
class Joined {
 public:
  explicit Joined(double tolerance) : tolerance_(tolerance) {}

  int number_of(const Place& place) {
    Cell cell{};
    for (std::size_t d = 0; d < 3; ++d) {
      cell[d] = tolerance_ > 0.0 ? static_cast<std::int64_t>(std::floor(place[d] / tolerance_)) : 0;
    }
    for (int i = 0; i < 27; ++i) {
      const Cell near = {cell[0] + i % 3 - 1, cell[1] + i / 3 % 3 - 1, cell[2] + i / 9 - 1};
      const auto found = in_cell_.find(near);
      if (found == in_cell_.end()) continue;
      for (const int number : found->second) {
        if (length(between(place, places_[static_cast<std::size_t>(number)])) <= tolerance_) return number;
      }
    }
    places_.push_back(place);
    in_cell_[cell].push_back(static_cast<int>(places_.size()) - 1);
    return static_cast<int>(places_.size()) - 1;
  }
  [[nodiscard]] std::vector<Place> take() { return std::move(places_); }

 private:
  using Cell = std::array<std::int64_t, 3>;
  struct Hash {
    std::size_t operator()(const Cell& cell) const {
      std::uint64_t hash = 0;
      for (const std::int64_t c : cell) hash = (hash ^ static_cast<std::uint64_t>(c)) * 0x9E3779B97F4A7C15U;
      return hash ^ (hash >> 32);
    }
  };

  double tolerance_;
  std::vector<Place> places_;
  std::unordered_map<Cell, std::vector<int>, Hash> in_cell_;
};

std::string at(const Place& place) {
  return "(" + for_people(place[0]) + ", " + for_people(place[1]) + ", " + for_people(place[2]) + ")";
}
std::string middle_of(const TriangleMesh& mesh, int a, int b) {
  return at(times(0.5, sum(mesh.place[static_cast<std::size_t>(a)], mesh.place[static_cast<std::size_t>(b)])));
}
std::string counted(std::size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

/// How often triangles pass an edge from its lower number to its higher one, and back.
struct Passes {
  int a = 0, b = 0;
  std::array<int, 2> count{};
  std::size_t triangle = 0;  ///< the first
};

std::vector<Passes> edges_of(const TriangleMesh& mesh) {
  std::vector<Passes> edges;
  std::unordered_map<std::uint64_t, std::size_t> number;
  for (std::size_t t = 0; t < mesh.triangle.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const int from = mesh.triangle[t][k], to = mesh.triangle[t][(k + 1) % 3];
      const auto [a, b] = std::minmax(from, to);
      const std::uint64_t key = (static_cast<std::uint64_t>(a) << 32) | static_cast<std::uint64_t>(b);
      const auto [found, is_new] = number.try_emplace(key, edges.size());
      if (is_new) edges.push_back({a, b, {}, t});
      ++edges[found->second].count[from < to ? 0 : 1];
    }
  }
  return edges;
}

std::optional<std::string> edge_fault(const TriangleMesh& mesh, const std::vector<Passes>& edges) {
  const Passes *crowded = nullptr, *open = nullptr, *turned = nullptr;
  std::size_t opens = 0;
  for (const Passes& edge : edges) {
    const int total = edge.count[0] + edge.count[1];
    if (total > 2 && crowded == nullptr) crowded = &edge;
    if (total == 1 && opens++ == 0) open = &edge;
    if (total == 2 && edge.count[0] != 1 && turned == nullptr) turned = &edge;
  }
  if (crowded != nullptr) {
    return "more than two triangles meet at the edge near " + middle_of(mesh, crowded->a, crowded->b) +
           ": it is no surface of one body there";
  }
  if (open != nullptr) {
    return "has a hole at " + middle_of(mesh, open->a, open->b) + ": " +
           counted(opens, "edge belongs", "edges belong") +
           " to one triangle only; close it in the program that made it";
  }
  if (turned != nullptr) {
    return "has faces that look inward beside faces that look outward, at " +
           middle_of(mesh, turned->a, turned->b) + "; let the program that made it turn them alike";
  }
  return std::nullopt;
}

/// Of a mesh whose edges are sound.
std::optional<std::string> bodies_fault(const TriangleMesh& mesh) {
  std::vector<int> root(mesh.place.size());
  std::iota(root.begin(), root.end(), 0);
  const auto root_of = [&](int i) {
    while (root[static_cast<std::size_t>(i)] != i) {
      root[static_cast<std::size_t>(i)] = root[static_cast<std::size_t>(root[static_cast<std::size_t>(i)])];
      i = root[static_cast<std::size_t>(i)];
    }
    return i;
  };
  for (const auto& triangle : mesh.triangle) {
    for (const std::size_t k : {1U, 2U})
      root[static_cast<std::size_t>(root_of(triangle[k]))] = root_of(triangle[0]);
  }
  std::unordered_map<int, std::size_t> bodies;  // with the first triangle of each
  std::size_t last = 0;
  for (std::size_t t = 0; t < mesh.triangle.size(); ++t) {
    if (bodies.try_emplace(root_of(mesh.triangle[t][0]), t).second) last = t;
  }
  if (bodies.size() == 1) return std::nullopt;
  return "has " + std::to_string(bodies.size()) + " surfaces that do not hang together, one of them at " +
         at(mesh.corner(last, 0)) + ": a product is one body without hollows inside";
}

double six_volumes(const TriangleMesh& mesh) {
  double total = 0.0;
  for (std::size_t t = 0; t < mesh.triangle.size(); ++t) {
    const Place a = between(mesh.place[0], mesh.corner(t, 0)), b = between(mesh.place[0], mesh.corner(t, 1)),
                c = between(mesh.place[0], mesh.corner(t, 2));
    total += dot(a, cross(b, c));
  }
  return total;
}

/// Does a stretch pass through a triangle, its edges included?
bool passes_through(const TriangleMesh& mesh, std::size_t t, const Place& from, const Place& to,
                    double tolerance) {
  const Place &a = mesh.corner(t, 0), ab = between(a, mesh.corner(t, 1)), ac = between(a, mesh.corner(t, 2));
  const Place normal = cross(ab, ac);
  const double square = dot(normal, normal);
  if (square == 0.0) return false;
  const double above = dot(between(a, from), normal) / std::sqrt(square),
               below = dot(between(a, to), normal) / std::sqrt(square);
  if ((above > 0.0) == (below > 0.0) || std::min(std::abs(above), std::abs(below)) < tolerance) return false;
  const Place way = between(a, sum(from, times(above / (above - below), between(from, to))));
  constexpr double kRounding = 1e-9;  // of the triangle
  const double u = dot(cross(way, ac), normal) / square, v = dot(cross(ab, way), normal) / square;
  return u > -kRounding && v > -kRounding && u + v < 1.0 + kRounding;
}

/// Does an edge of one triangle that does not end at a corner of the other pass through that?
bool edge_passes(const TriangleMesh& mesh, std::size_t one, std::size_t other, double tolerance) {
  const auto shares = [&](int corner) {
    return std::ranges::find(mesh.triangle[other], corner) != mesh.triangle[other].end();
  };
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    if (shares(mesh.triangle[one][k]) || shares(mesh.triangle[one][next])) continue;
    if (passes_through(mesh, other, mesh.corner(one, k), mesh.corner(one, next), tolerance)) return true;
  }
  return false;
}

std::optional<std::string> crossing_fault(const TriangleMesh& mesh) {
  const TriangleTree tree(mesh);
  const double tolerance = kSamePlace * longest_extent(mesh);
  for (std::size_t t = 0; t < mesh.triangle.size(); ++t) {
    const Bounds own = bounds_of({mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)});
    const auto meets = [&](const Bounds& box) {
      for (std::size_t d = 0; d < 3; ++d) {
        if (box.low[d] > own.high[d] || box.high[d] < own.low[d]) return false;
      }
      return true;
    };
    bool passes = false;
    tree.visit([&](const Bounds& box) { return !passes && meets(box); },
               [&](int number) {
                 const auto other = static_cast<std::size_t>(number);
                 if (other <= t || passes) return;
                 passes = edge_passes(mesh, t, other, tolerance) || edge_passes(mesh, other, t, tolerance);
               });
    if (passes) {
      return "passes through itself near " + at(mesh.corner(t, 0)) + "; let the program that made it mend that";
    }
  }
  return std::nullopt;
}

}  // namespace

TriangleMesh welded(const TriangleMesh& mesh) {
  if (mesh.place.empty()) return {};
  Joined joined(kSamePlace * longest_extent(mesh));
  std::vector<int> number;
  number.reserve(mesh.place.size());
  for (const Place& place : mesh.place) number.push_back(joined.number_of(place));
  const std::vector<Place> places = joined.take();
  std::vector<int> kept(places.size(), -1);  // places without a triangle stay behind
  TriangleMesh welded;
  for (const auto& triangle : mesh.triangle) {
    std::array<int, 3> corner{};
    for (std::size_t k = 0; k < 3; ++k) corner[k] = number[static_cast<std::size_t>(triangle[k])];
    if (corner[0] == corner[1] || corner[1] == corner[2] || corner[2] == corner[0]) continue;
    for (int& c : corner) {
      int& place = kept[static_cast<std::size_t>(c)];
      if (place < 0) {
        place = static_cast<int>(welded.place.size());
        welded.place.push_back(places[static_cast<std::size_t>(c)]);
      }
      c = place;
    }
    welded.triangle.push_back(corner);
  }
  return welded;
}

std::optional<std::string> mesh_fault(const TriangleMesh& mesh) {
  if (mesh.triangle.empty()) return "has no triangles";
  if (mesh.triangle.size() > kMostTriangles) {
    return "has " + std::to_string(mesh.triangle.size()) + " triangles, more than " +
           std::to_string(kMostTriangles) +
           "; let the program that made it leave out what is smaller than the product's cells";
  }
  for (const Place& place : mesh.place) {
    if (!std::isfinite(place[0]) || !std::isfinite(place[1]) || !std::isfinite(place[2]))
      return "has a corner that is no place: " + at(place);
  }
  const std::vector<Passes> edges = edges_of(mesh);
  if (auto fault = edge_fault(mesh, edges)) return fault;
  if (auto fault = bodies_fault(mesh)) return fault;
  const double six = six_volumes(mesh);
  if (!(std::abs(six) > 1e-9 * std::pow(longest_extent(mesh), 3))) return "encloses no volume";
  if (six < 0.0) return "is inside out: all its faces look inward; turn them over in the program that made it";
  return crossing_fault(mesh);
}

}  // namespace unbruised

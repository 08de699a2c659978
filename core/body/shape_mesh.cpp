#include "core/body/shape_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <utility>

#include "core/scenario/product.hpp"
#include "core/scenario/product_mesh.hpp"

namespace unbruised {
namespace {

/// Pieces along the side of a cube that becomes an ellipsoid, and along the longest side of a box.
constexpr int kCubeSide = 14, kBoxSide = 13;
/// Pieces around a cylinder, and from the middle of its ends to their rims.
constexpr int kAround = 56, kRings = 7;

using Place = std::array<double, 3>;

void add_square(std::vector<std::array<int, 3>>& triangle, const std::array<int, 4>& corner) {
  triangle.push_back({corner[0], corner[1], corner[2]});
  triangle.push_back({corner[0], corner[2], corner[3]});
}

/// Calls back with the four corners of every piece of every side of a cube, counter-clockwise from outside:
/// whole numbers from 0 to `count` along each axis.
template <class Take>
void walk_sides(const std::array<int, 3>& count, const Take& take) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t a = (axis + 1) % 3, b = (axis + 2) % 3;
    for (const bool high : {false, true}) {
      for (int i = 0; i < count[a]; ++i) {
        for (int j = 0; j < count[b]; ++j) {
          std::array<std::array<int, 3>, 4> corner{};
          for (std::size_t c = 0; c < 4; ++c) {
            const bool far_a = c == 1 || c == 2, far_b = c >= 2;
            corner[c][axis] = high ? count[axis] : 0;
            corner[c][a] = i + ((high ? far_a : far_b) ? 1 : 0);
            corner[c][b] = j + ((high ? far_b : far_a) ? 1 : 0);
          }
          take(2 * axis + (high ? 1 : 0), corner);
        }
      }
    }
  }
}

ShapeMesh ellipsoid_mesh(const std::array<double, 3>& size_m) {
  ShapeMesh mesh;
  std::map<std::array<int, 3>, int> number;
  const auto number_of = [&](const std::array<int, 3>& at) {
    const auto [found, is_new] = number.try_emplace(at, static_cast<int>(mesh.place_m.size()));
    if (is_new) {
      Place place{};
      for (std::size_t i = 0; i < 3; ++i) {
        place[i] = std::tan(std::numbers::pi / 4.0 * (2.0 * at[i] / kCubeSide - 1.0));
      }
      const double length = std::hypot(place[0], place[1], place[2]);
      for (std::size_t i = 0; i < 3; ++i) place[i] *= 0.5 * size_m[i] / length;
      mesh.place_m.push_back(place);
    }
    return found->second;
  };
  walk_sides({kCubeSide, kCubeSide, kCubeSide}, [&](std::size_t, const std::array<std::array<int, 3>, 4>& corner) {
    add_square(mesh.triangle,
               {number_of(corner[0]), number_of(corner[1]), number_of(corner[2]), number_of(corner[3])});
  });
  return mesh;
}

ShapeMesh box_mesh(const std::array<double, 3>& size_m) {
  ShapeMesh mesh;
  const double longest_m = std::max({size_m[0], size_m[1], size_m[2]});
  std::array<int, 3> count{};
  for (std::size_t i = 0; i < 3; ++i) {
    count[i] = std::max(4, static_cast<int>(std::lround(kBoxSide * size_m[i] / longest_m)));
  }
  std::map<std::pair<std::size_t, std::array<int, 3>>, int> number;
  walk_sides(count, [&](std::size_t side, const std::array<std::array<int, 3>, 4>& corner) {
    std::array<int, 4> found{};
    for (std::size_t c = 0; c < 4; ++c) {
      const auto [at, is_new] =
          number.try_emplace(std::pair(side, corner[c]), static_cast<int>(mesh.place_m.size()));
      found[c] = at->second;
      if (!is_new) continue;
      Place place{};
      for (std::size_t i = 0; i < 3; ++i)
        place[i] = (static_cast<double>(corner[c][i]) / count[i] - 0.5) * size_m[i];
      mesh.place_m.push_back(place);
    }
    add_square(mesh.triangle, found);
  });
  return mesh;
}

/// A grid of places closed around `axis`: at ring r and angle a `place(r, a)`.
template <class At>
void add_rings(int rings, const At& place, ShapeMesh& mesh) {
  const int first = static_cast<int>(mesh.place_m.size());
  for (int r = 0; r <= rings; ++r) {
    for (int a = 0; a < kAround; ++a) mesh.place_m.push_back(place(r, 2.0 * std::numbers::pi * a / kAround));
  }
  for (int r = 0; r < rings; ++r) {
    for (int a = 0; a < kAround; ++a) {
      const int next = (a + 1) % kAround, here = first + r * kAround;
      add_square(mesh.triangle, {here + a, here + next, here + kAround + next, here + kAround + a});
    }
  }
}

ShapeMesh cylinder_mesh(std::size_t axis, const std::array<double, 3>& size_m) {
  ShapeMesh mesh;
  const std::size_t a = (axis + 1) % 3, b = (axis + 2) % 3;
  const auto place = [&](double along, double out, double angle) {
    Place at{};
    at[axis] = along * size_m[axis];
    at[a] = 0.5 * out * size_m[a] * std::cos(angle);
    at[b] = 0.5 * out * size_m[b] * std::sin(angle);
    return at;
  };
  constexpr int kHigh = 2 * kRings;
  add_rings(
      kHigh, [&](int r, double angle) { return place(static_cast<double>(r) / kHigh - 0.5, 1.0, angle); }, mesh);
  add_rings(
      kRings, [&](int r, double angle) { return place(0.5, 1.0 - static_cast<double>(r) / kRings, angle); }, mesh);
  add_rings(
      kRings, [&](int r, double angle) { return place(-0.5, static_cast<double>(r) / kRings, angle); }, mesh);
  return mesh;
}

/// Rings around the axis of a solid of revolution, from end to end; a flat end is a disc of its own.
ShapeMesh revolution_mesh(std::size_t axis, const TrueShape& shape, const std::array<double, 3>& size_m) {
  ShapeMesh mesh;
  const std::size_t a = (axis + 1) % 3, b = (axis + 2) % 3;
  const auto place = [&](double along, double radius, double angle) {
    Place at{};
    at[axis] = along;
    at[a] = radius * std::cos(angle);
    at[b] = radius * std::sin(angle);
    return at;
  };
  constexpr int kAlong = 18;
  const auto radius_at = [&](double along) {
    return shape.column_m(2 * a + 1, place(along, 0.0, 0.0)).value_or(0.0);
  };
  // Close together at the ends, where a round one falls away.
  const auto along_at = [&](int r) { return -0.5 * size_m[axis] * std::cos(std::numbers::pi * r / kAlong); };
  add_rings(
      kAlong, [&](int r, double angle) { return place(along_at(r), radius_at(along_at(r)), angle); }, mesh);
  for (const int end : {0, kAlong}) {
    const double rim = radius_at(along_at(end));
    if (rim < 1e-6 * size_m[a]) continue;
    const auto disc = [&](int r, double angle) {
      const double share = end == 0 ? r : kRings - r;
      return place(along_at(end), rim * share / kRings, angle);
    };
    add_rings(kRings, disc, mesh);
  }
  return mesh;
}

/// Each place moved along its ray from the middle onto the surface.
void draw_to_surface(const TrueShape& shape, ShapeMesh& mesh) {
  for (Place& place : mesh.place_m) {
    double inside = 0.0, outside = 4.0;
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (inside + outside);
      (shape.contains({middle * place[0], middle * place[1], middle * place[2]}) ? inside : outside) = middle;
    }
    for (double& component : place) component *= inside;
  }
}

/// Which places become one.
struct Boxes {
  std::vector<int> of;  ///< each place
  std::size_t count = 0;
};

Boxes boxes_of_grid(const TriangleMesh& surface, const Bounds& bounds, int side) {
  double longest = 0.0;
  for (std::size_t d = 0; d < 3; ++d) longest = std::max(longest, bounds.high[d] - bounds.low[d]);
  std::map<std::array<int, 3>, int> number;
  Boxes boxes;
  boxes.of.reserve(surface.place.size());
  for (const Place& place : surface.place) {
    std::array<int, 3> box{};
    for (std::size_t d = 0; d < 3; ++d) {
      box[d] = static_cast<int>(std::floor((place[d] - bounds.low[d]) / longest * side));
    }
    boxes.of.push_back(number.try_emplace(box, static_cast<int>(number.size())).first->second);
  }
  boxes.count = number.size();
  return boxes;
}

/// Those of the finest grid that leaves few enough; of a mesh with few places each has its own.
Boxes boxes_of(const TriangleMesh& surface) {
  constexpr std::size_t kMostPlaces = 1500;
  constexpr int kCoarsest = 12, kFinest = 40;
  if (surface.place.size() <= kMostPlaces) {
    Boxes own{std::vector<int>(surface.place.size()), surface.place.size()};
    std::iota(own.of.begin(), own.of.end(), 0);
    return own;
  }
  const Bounds bounds = bounds_of(surface.place);
  Boxes boxes = boxes_of_grid(surface, bounds, kCoarsest);
  for (int side = kCoarsest + 1; side <= kFinest; ++side) {
    Boxes finer = boxes_of_grid(surface, bounds, side);
    if (finer.count > kMostPlaces) break;
    boxes = std::move(finer);
  }
  return boxes;
}

/// Places of one box become their mean.
ShapeMesh drawn_mesh(const TriangleMesh& surface, const std::array<double, 3>& stretch_m) {
  const Boxes boxes = boxes_of(surface);
  ShapeMesh mesh{std::vector<Place>(boxes.count, Place{}), {}};
  std::vector<int> count(boxes.count, 0);
  for (std::size_t p = 0; p < surface.place.size(); ++p) {
    const auto box = static_cast<std::size_t>(boxes.of[p]);
    ++count[box];
    for (std::size_t d = 0; d < 3; ++d) mesh.place_m[box][d] += surface.place[p][d] * stretch_m[d];
  }
  for (std::size_t b = 0; b < boxes.count; ++b) {
    for (double& component : mesh.place_m[b]) component /= count[b];
  }
  for (const auto& triangle : surface.triangle) {
    std::array<int, 3> corner{};
    for (std::size_t k = 0; k < 3; ++k) corner[k] = boxes.of[static_cast<std::size_t>(triangle[k])];
    if (corner[0] != corner[1] && corner[1] != corner[2] && corner[2] != corner[0])
      mesh.triangle.push_back(corner);
  }
  return mesh;
}

}  // namespace

std::optional<ShapeMesh> shape_mesh(const ProductParameters& product) {
  const std::optional<TrueShape> shape = true_shape(product);
  if (!shape) return std::nullopt;
  const std::array<double, 3> size_m = shape_extents_m(product).value();
  const auto* lattice = std::get_if<LatticeParameters>(&product);
  if (lattice != nullptr && lattice->shape == Shape::mesh && lattice->mesh) {
    std::array<double, 3> stretch_m{};
    for (std::size_t d = 0; d < 3; ++d) stretch_m[d] = size_m[d] / lattice->mesh->extents()[d];
    return drawn_mesh(lattice->mesh->given_in_middle(), stretch_m);
  }
  if (shape->solid() != nullptr) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (!shape->is_mirrored(axis)) return revolution_mesh(axis, *shape, size_m);
    }
    ShapeMesh mesh = ellipsoid_mesh(size_m);
    draw_to_surface(*shape, mesh);
    return mesh;
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!shape->is_round(axis) && shape->is_round((axis + 1) % 3)) return cylinder_mesh(axis, size_m);
  }
  return shape->is_round(0) ? ellipsoid_mesh(size_m) : box_mesh(size_m);
}

}  // namespace unbruised

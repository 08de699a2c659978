#include "core/scenario/product_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/door/eigen.hpp"
#include "core/scenario/solid.hpp"
#include "core/scenario/vectors.hpp"

namespace unbruised {
namespace {

using Place = std::array<double, 3>;

/// No smooth edge bends over its middle by more, of the least extent: a tenth of the approach at which Hertz's
/// patch is the smallest that a lattice resolves.
constexpr double kSmoothTo = 1e-4;
/// Columns along both directions in which the area of a shadow is counted: 0.2 % for a circle.
constexpr int kShadowColumns = 160;
/// A side ends in a plane where triangles within kFlatWithin of the extent of its end, that lean by less than
/// kFlatLean_rad, make up kFlatShare of its shadow: the wall of a cylinder has 1 % that lean so little.
constexpr double kFlatWithin = 1e-3, kFlatLean_rad = 0.01, kFlatShare = 0.03;
/// A pole's curvature is that of the quadric that fits the surface best within this part of the least extent
/// across around it, and farther for as long as fewer corners of triangles lie there.
constexpr double kFitWithin = 0.1, kFitGrowth = 1.5;
constexpr std::size_t kFitCorners = 60;
/// Corners are as high as the pole within this part of the extent.
constexpr double kAsHigh = 1e-6;
/// Of a curvature times half the least extent across: less is straight, as of a solid of revolution.
constexpr double kStraight = 0.02;

void move_to_middle(TriangleMesh& mesh) {
  const Bounds box = bounds_of(mesh.place);
  for (Place& place : mesh.place) {
    for (std::size_t d = 0; d < 3; ++d) place[d] -= 0.5 * (box.low[d] + box.high[d]);
  }
}

Place extents_of(const TriangleMesh& mesh) {
  return between(bounds_of(mesh.place).low, bounds_of(mesh.place).high);
}

/// On which side of the edge from a to b a column passes, seen along its axis; opposite for the edge from b to a
/// to the last bit, and never neither: a column through an edge passes it on the side on which a column beside it
/// by an infinitesimal step, and a smaller one across, does ("simulation of simplicity", Edelsbrunner and Mücke
/// 1990). So a column comes in as often as it goes out.
struct EdgeSide {
  std::size_t u, v;  ///< axes across the column
  const TriangleMesh& mesh;
  const Place& through;

  [[nodiscard]] double of(int a, int b) const { return a < b ? ordered(a, b) : -ordered(b, a); }

 private:
  [[nodiscard]] double ordered(int a, int b) const {
    const Place &from = mesh.place[static_cast<std::size_t>(a)], &to = mesh.place[static_cast<std::size_t>(b)];
    const double side =
        (from[u] - through[u]) * (to[v] - through[v]) - (from[v] - through[v]) * (to[u] - through[u]);
    if (side != 0.0) return side;
    constexpr double kInfinitesimal = 1e-300;
    if (to[v] != from[v]) return to[v] < from[v] ? kInfinitesimal : -kInfinitesimal;
    return to[u] > from[u] ? kInfinitesimal : -kInfinitesimal;
  }
};

/// Calls back with the places at which a column along an axis meets the surface.
template <class Take>
void walk_column(const TriangleMesh& mesh, const TriangleTree& tree, std::size_t axis, const Place& through,
                 const Take& take) {
  const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
  const EdgeSide side{u, v, mesh, through};
  const auto is_near = [&](const Bounds& box) {
    return through[u] >= box.low[u] && through[u] <= box.high[u] && through[v] >= box.low[v] &&
           through[v] <= box.high[v];
  };
  tree.visit(is_near, [&](int number) {
    const auto t = static_cast<std::size_t>(number);
    const auto [a, b, c] = mesh.triangle[t];
    const Place across = {side.of(b, c), side.of(c, a), side.of(a, b)};
    const bool left = across[0] > 0.0, meets = left == (across[1] > 0.0) && left == (across[2] > 0.0);
    if (!meets) return;
    const double total = across[0] + across[1] + across[2];
    ProductMesh::Column column{0.0, {t, times(1.0 / total, across)}};
    for (std::size_t k = 0; k < 3; ++k) column.height += column.on.share[k] * mesh.corner(t, k)[axis];
    take(column);
  });
}

}  // namespace

ProductMesh::ProductMesh(TriangleMesh mesh, MeshSource source)
    : source_(std::move(source)),
      given_(std::move(mesh)),
      smooth_([this] {
        const Place extents = extents_of(given_);
        SmoothMesh smooth =
            smooth_mesh(given_, kSmoothTo * *std::min_element(extents.begin(), extents.end()), kMostTriangles);
        move_to_middle(smooth.mesh);
        return smooth;
      }()),
      extents_(extents_of(smooth_.mesh)),
      tree_(smooth_.mesh) {
  set_mass_properties();
  for (std::size_t axis = 0; axis < 3; ++axis) section_[axis] = shadow(axis);
  for (std::size_t side = 0; side < 6; ++side) pole_[side] = pole_of(side);
}

/// Smoothing keeps the places it is given, in their order.
TriangleMesh ProductMesh::given_in_middle() const {
  TriangleMesh given = given_;
  std::copy_n(smooth_.mesh.place.begin(), given.place.size(), given.place.begin());
  return given;
}

/// Of the tetrahedra between the triangles and the middle, by their signs.
void ProductMesh::set_mass_properties() {
  const TriangleMesh& mesh = smooth_.mesh;
  for (std::size_t t = 0; t < mesh.triangle.size(); ++t) {
    const std::array<Place, 3> corner = {mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)};
    const double six = dot(corner[0], cross(corner[1], corner[2]));
    const Place all = sum(corner[0], sum(corner[1], corner[2]));
    volume_ += six / 6.0;
    for (std::size_t a = 0; a < 3; ++a) {
      center_of_mass_[a] += six / 24.0 * all[a];
      for (std::size_t b = 0; b < 3; ++b) {
        double product = all[a] * all[b];
        for (const Place& place : corner) product += place[a] * place[b];
        mean_product_[a][b] += six / 120.0 * product;
      }
    }
  }
  for (std::size_t a = 0; a < 3; ++a) {
    center_of_mass_[a] /= volume_;
    for (double& product : mean_product_[a]) product /= volume_;
  }
}

double ProductMesh::shadow(std::size_t axis) const {
  const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
  int count = 0;
  for (int i = 0; i < kShadowColumns * kShadowColumns; ++i) {
    Place place{};
    place[u] = ((i % kShadowColumns + 0.5) / kShadowColumns - 0.5) * extents_[u];
    place[v] = ((i / kShadowColumns + 0.5) / kShadowColumns - 0.5) * extents_[v];
    count += column(2 * axis, place) ? 1 : 0;
  }
  return extents_[u] * extents_[v] * count / (static_cast<double>(kShadowColumns) * kShadowColumns);
}

std::optional<ProductMesh::Column> ProductMesh::column(std::size_t side, const Place& place) const {
  std::optional<Column> outermost;
  const double sign = side_sign(side);
  walk_column(smooth_.mesh, tree_, side_axis(side), place, [&](const Column& column) {
    // Of equal ones that of the first triangle, whatever the order of the tree.
    if (outermost && sign * column.height < sign * outermost->height) return;
    if (outermost && column.height == outermost->height && column.on.triangle > outermost->on.triangle) return;
    outermost = column;
  });
  return outermost;
}

bool ProductMesh::contains(const Place& place) const {
  bool inside = false;
  walk_column(smooth_.mesh, tree_, 2, place, [&](const Column& column) {
    if (column.height > place[2]) inside = !inside;
  });
  return inside;
}

Place ProductMesh::normal(const On& on) const {
  Place normal{};
  for (std::size_t k = 0; k < 3; ++k) normal = sum(normal, times(on.share[k], smooth_.normal[on.triangle][k]));
  const double size = length(normal);
  return size > 0.0 ? times(1.0 / size, normal) : smooth_.normal[on.triangle][0];
}

namespace {

/// One side of a mesh, whose end is looked at.
struct End {
  const TriangleMesh& mesh;
  std::size_t axis, u, v;
  double sign;
  Place extents;

  [[nodiscard]] double height(const Place& place) const { return sign * place[axis]; }
  [[nodiscard]] double top() const { return 0.5 * extents[axis]; }
  [[nodiscard]] double across() const { return std::min(extents[u], extents[v]); }

  /// Areas of the triangles, seen along the axis, that lie in the plane of the end, and their middle.
  struct Flat {
    double area = 0.0;
    Place middle{};
  };
  [[nodiscard]] Flat flat() const {
    Flat flat;
    for (std::size_t t = 0; t < mesh.triangle.size(); ++t) {
      const Place twice =
          cross(between(mesh.corner(t, 0), mesh.corner(t, 1)), between(mesh.corner(t, 0), mesh.corner(t, 2)));
      const Place middle = times(1.0 / 3.0, sum(mesh.corner(t, 0), sum(mesh.corner(t, 1), mesh.corner(t, 2))));
      if (sign * twice[axis] < std::cos(kFlatLean_rad) * length(twice)) continue;
      if (height(middle) < top() - kFlatWithin * extents[axis]) continue;
      const double area = 0.5 * sign * twice[axis];
      flat.area += area;
      flat.middle = sum(flat.middle, times(area, middle));
    }
    if (flat.area > 0.0) flat.middle = times(1.0 / flat.area, flat.middle);
    return flat;
  }

  /// Of several corners that are as high, as on a cylinder's wall, the one in their middle.
  [[nodiscard]] Place highest() const {
    double most = -top();
    for (const Place& place : mesh.place) most = std::max(most, height(place));
    std::vector<Place> as_high;
    Place middle{};
    for (const Place& place : mesh.place) {
      if (height(place) < most - kAsHigh * extents[axis]) continue;
      as_high.push_back(place);
      middle = sum(middle, place);
    }
    middle = times(1.0 / static_cast<double>(as_high.size()), middle);
    return *std::min_element(as_high.begin(), as_high.end(), [&](const Place& a, const Place& b) {
      return length(between(middle, a)) < length(between(middle, b));
    });
  }
};

/// Corners of triangles around a pole, from it and over the reach within which they lie; z downward.
struct Around {
  std::vector<Place> place;
  std::vector<double> area;

  Around(const End& end, const Place& pole, double reach) {
    for (std::size_t t = 0; t < end.mesh.triangle.size(); ++t) {
      const Place twice = cross(between(end.mesh.corner(t, 0), end.mesh.corner(t, 1)),
                                between(end.mesh.corner(t, 0), end.mesh.corner(t, 2)));
      if (end.sign * twice[end.axis] <= 0.0) continue;  // looks away
      for (std::size_t k = 0; k < 3; ++k) {
        const Place way = times(1.0 / reach, between(pole, end.mesh.corner(t, k)));
        const Place at = {way[end.u], way[end.v], -end.sign * way[end.axis]};
        if (at[0] * at[0] + at[1] * at[1] > 1.0 || at[2] > 1.0) continue;
        place.push_back(at);
        area.push_back(length(twice));
      }
    }
  }

  /// Are there several along both directions?
  [[nodiscard]] bool is_enough() const {
    constexpr double kSpread = 0.08;  // of the mean square; a disc has 0.25
    std::array<double, 2> square{};
    double total = 0.0;
    for (std::size_t i = 0; i < place.size(); ++i) {
      total += area[i];
      for (std::size_t d = 0; d < 2; ++d) square[d] += area[i] * place[i][d] * place[i][d];
    }
    return place.size() >= kFitCorners && std::min(square[0], square[1]) > kSpread * total;
  }
};

/// Curvatures along both directions of the quadric z = c0 + c1 x + c2 y + (c3 x^2 + 2 c4 x y + c5 y^2) / 2 that
/// fits best. A sphere falls away by more than its parabola, z - k z^2 / 2 = k r^2 / 2: with the curvature k
/// towards each corner, by Euler's formula, taken from the round before, it is met exactly.
std::array<double, 2> fitted_curvature(const Around& around) {
  constexpr int kRounds = 5;
  std::array<double, 2> curvature{};
  for (int round = 0; round < kRounds; ++round) {
    Eigen::Matrix<double, 6, 6> products = Eigen::Matrix<double, 6, 6>::Zero();
    Eigen::Matrix<double, 6, 1> heights = Eigen::Matrix<double, 6, 1>::Zero();
    for (std::size_t i = 0; i < around.place.size(); ++i) {
      const auto [x, y, z] = around.place[i];
      const double square = x * x + y * y;
      const double towards = square > 0.0 ? (curvature[0] * x * x + curvature[1] * y * y) / square : 0.0;
      Eigen::Matrix<double, 6, 1> row;
      row << 1.0, x, y, 0.5 * x * x, x * y, 0.5 * y * y;
      products += around.area[i] * row * row.transpose();
      heights += around.area[i] * (z - 0.5 * towards * z * z) * row;
    }
    const Eigen::Matrix<double, 6, 1> c = products.completeOrthogonalDecomposition().solve(heights);
    curvature = {c[3], c[5]};
  }
  return curvature;
}

}  // namespace

MeshPole ProductMesh::pole_of(std::size_t side) const {
  const std::size_t axis = side_axis(side);
  const End end{smooth_.mesh, axis, (axis + 1) % 3, (axis + 2) % 3, side_sign(side), extents_};
  const End::Flat flat = end.flat();
  MeshPole pole;
  if (flat.area > kFlatShare * section_[axis]) {
    pole.place = flat.middle;
    pole.place[axis] = end.sign * end.top();
    pole.flat_area = flat.area;
    return pole;
  }
  pole.place = end.highest();
  std::array<double, 2> curvature{};
  for (double share = kFitWithin; share < 2.0; share *= kFitGrowth) {
    const double reach = share * end.across();
    const Around around(end, pole.place, reach);
    if (!around.is_enough()) continue;
    curvature = fitted_curvature(around);
    for (double& c : curvature) c /= reach;
    break;
  }
  const double straight = 2.0 * kStraight / end.across();
  pole.curvature[end.u] = curvature[0] < straight ? 0.0 : curvature[0];
  pole.curvature[end.v] = curvature[1] < straight ? 0.0 : curvature[1];
  // A round end that is not flat has a patch that grows: the faintest curvature counts.
  if (curvature[0] < straight && curvature[1] < straight) pole.curvature[end.u] = pole.curvature[end.v] = straight;
  return pole;
}

}  // namespace unbruised

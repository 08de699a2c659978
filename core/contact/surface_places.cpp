#include "core/contact/surface_places.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "core/contact/tributary_face.hpp"
#include "core/door/require.hpp"
#include "core/scenario/pad_meeting.hpp"
#include "core/scenario/true_shape.hpp"

namespace unbruised {
namespace {

/// Parts along each edge of a place's piece, by which its area is summed.
constexpr int kParts = 7;
/// Two directions that the surface faces as much as this, relatively, are faced alike.
constexpr double kAlike = 1e-9;
/// Spaces between places across a curved side's smallest extent, at least: a sphere on a stiff layer then rolls
/// within 1 % as if it were round (docs/validation.md).
constexpr int kLeastSpaces = 30;
/// Along the edge of a cell where only the outline of a side is round.
constexpr int kSpacesOfOutline = 3;

/// Spaces between places along the edge of a cell, in a direction of a side's plane: odd, so that no place lies
/// midway between two particles. Along a straight direction the particles' own places do.
int spaces_per_cell(const TrueShape& shape, const Lattice& lattice, std::size_t axis, std::size_t tangent) {
  if (!shape.is_round(tangent)) return 1;
  if (!shape.is_round(axis)) return kSpacesOfOutline;
  const int cells = *std::min_element(lattice.cell_count.begin(), lattice.cell_count.end());
  int spaces = 1;
  while (spaces * cells < kLeastSpaces) spaces += 2;
  return spaces;
}

/// One side of the product and the columns of particles below it.
class Side {
 public:
  Side(const LatticeParameters& parameters, const Lattice& lattice, std::size_t side)
      : lattice_(lattice),
        size_m_(parameters.size_m),
        shape_(parameters),
        side_(side),
        plane_(lattice, side / 2, {static_cast<int>((side / 2 + 1) % 3), static_cast<int>((side / 2 + 2) % 3)}),
        sign_(side_sign(side)) {
    for (std::size_t t = 0; t < 2; ++t) {
      per_cell_[t] = spaces_per_cell(shape_, lattice, plane_.axis, plane_.tangent[t]);
    }
    for (const SurfacePoint& point : lattice.side[side]) {
      node_[plane_.grid_place(lattice.position_m[static_cast<std::size_t>(point.node)])] = point.node;
    }
    require(!node_.empty(), "surface_places: a side without particles");
  }

  void append_to(std::vector<SurfacePlace>& places, ContactSet set) const {
    const std::size_t first = places.size();
    for (int i = 0; i <= steps(0); ++i) {
      for (int j = 0; j <= steps(1); ++j) append_place({i, j}, set, places);
    }
    if (!shape_.is_plane(plane_.axis)) return;
    double sum = 0.0;
    for (std::size_t p = first; p < places.size(); ++p) sum += places[p].area_m2;
    const double scale = shape_.face_area_m2(plane_.axis) / sum;
    for (std::size_t p = first; p < places.size(); ++p) places[p].area_m2 *= scale;
  }

 private:
  [[nodiscard]] int steps(std::size_t t) const { return per_cell_[t] * plane_.cell_count[t]; }

  void append_place(const std::array<int, 2>& step, ContactSet set, std::vector<SurfacePlace>& places) const {
    std::array<double, 3> from_center = in_plane(step, {0.0, 0.0});
    const auto column = shape_.column_m(side_, from_center);
    const double pole = 0.5 * size_m_[plane_.axis];
    if (!column) return;
    if (set == ContactSet::six_sides && pole - *column > kDeepestMeeting * size_m_[plane_.axis]) return;
    SurfacePlace place;
    place.area_m2 = area_m2(step);
    if (!(place.area_m2 > 0.0)) return;
    from_center[plane_.axis] = sign_ * *column;
    place.outward = shape_.outward(side_, from_center);
    place.curved = !shape_.is_plane(plane_.axis);
    place.node = nearest_node(step);
    for (std::size_t d = 0; d < 3; ++d) place.place_m[d] = lattice_.center_m[d] + from_center[d];
    places.push_back(place);
  }

  /// A place in the plane of the side, from the centre. @param offset from the step, in spaces
  [[nodiscard]] std::array<double, 3> in_plane(const std::array<int, 2>& step,
                                               const std::array<double, 2>& offset) const {
    std::array<double, 3> from_center{};
    for (std::size_t t = 0; t < 2; ++t) {
      from_center[plane_.tangent[t]] = (step[t] - 0.5 * steps(t) + offset[t]) * space_m(t);
    }
    return from_center;
  }
  [[nodiscard]] double space_m(std::size_t t) const { return plane_.extent_m[t] / per_cell_[t]; }

  /// Of the piece of this side's surface that a place stands for: half a space to each side of it, where the side
  /// goes on.
  [[nodiscard]] double area_m2(const std::array<int, 2>& step) const {
    std::array<double, 2> low{}, width{};
    for (std::size_t t = 0; t < 2; ++t) {
      low[t] = step[t] == 0 ? 0.0 : -0.5;
      width[t] = (step[t] == steps(t) ? 0.0 : 0.5) - low[t];
    }
    const double part_m2 = width[0] * space_m(0) * width[1] * space_m(1) / (kParts * kParts);
    double sum = 0.0;
    for (int i = 0; i < kParts * kParts; ++i) {
      std::array<double, 3> there = in_plane(step, {low[0] + width[0] * (i % kParts + 0.5) / kParts,
                                                    low[1] + width[1] * (i / kParts + 0.5) / kParts});
      const auto column = shape_.column_m(side_, there);
      if (!column) continue;
      there[plane_.axis] = sign_ * *column;
      const std::array<double, 3> normal = shape_.outward(side_, there);
      sum += share_of_side(normal) * part_m2 / std::abs(normal[plane_.axis]);
    }
    return sum;
  }

  /// 1: the place is this side's alone; between sides that it faces alike it is shared.
  [[nodiscard]] double share_of_side(const std::array<double, 3>& normal) const {
    const double faced = std::abs(normal[plane_.axis]);
    int alike = 1;
    for (std::size_t d = 0; d < 3; ++d) {
      if (d == plane_.axis) continue;
      const double other = std::abs(normal[d]);
      if (other > faced * (1.0 + kAlike)) return 0.0;
      if (other >= faced * (1.0 - kAlike)) ++alike;
    }
    return 1.0 / alike;
  }

  /// Of the particles on this side; where the lattice does not reach, the nearest one.
  [[nodiscard]] int nearest_node(const std::array<int, 2>& step) const {
    std::array<int, 2> grid{};
    for (std::size_t t = 0; t < 2; ++t) grid[t] = (step[t] + per_cell_[t] / 2) / per_cell_[t];
    if (const auto found = node_.find(grid); found != node_.end()) return found->second;
    double least = std::numeric_limits<double>::infinity();
    int nearest = -1;
    for (const auto& [place, node] : node_) {
      double square = 0.0;
      for (std::size_t t = 0; t < 2; ++t) {
        const double way = (static_cast<double>(step[t]) / per_cell_[t] - place[t]) * plane_.extent_m[t];
        square += way * way;
      }
      if (square >= least * (1.0 - kAlike)) continue;
      least = square;
      nearest = node;
    }
    return nearest;
  }

  const Lattice& lattice_;
  std::array<double, 3> size_m_;
  TrueShape shape_;
  std::size_t side_;
  FacePlane plane_;
  double sign_;
  std::array<int, 2> per_cell_{};           ///< spaces between places along the edge of a cell
  std::map<std::array<int, 2>, int> node_;  ///< by its place in the grid
};

}  // namespace

std::vector<SurfacePlace> surface_places(const LatticeParameters& parameters, const Lattice& lattice,
                                         ContactSet set) {
  std::vector<SurfacePlace> places;
  for (std::size_t side = 0; side < lattice.side.size(); ++side) {
    Side(parameters, lattice, side).append_to(places, set);
  }
  return places;
}

}  // namespace unbruised

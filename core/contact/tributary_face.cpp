#include "core/contact/tributary_face.hpp"

#include <cmath>
#include <numeric>

namespace unbruised {
namespace {

/// Strips of a cell in which the chord of a face counts as constant; the sum is scaled to the face's exact area.
constexpr int kStrips = 32;

}  // namespace

FacePlane::FacePlane(const Lattice& lattice, std::size_t normal_axis, const std::array<int, 2>& tangent_axes)
    : axis(normal_axis) {
  for (std::size_t t = 0; t < 2; ++t) {
    const std::size_t along = tangent[t] = static_cast<std::size_t>(tangent_axes[t]);
    cell_count[t] = lattice.cell_count[along];
    extent_m[t] = lattice.cell_extent_m[along];
    center_m[t] = lattice.center_m[along];
    low_m[t] = center_m[t] - 0.5 * extent_m[t] * cell_count[t];
  }
}

std::array<int, 2> FacePlane::grid_place(const std::array<double, 3>& position_m) const {
  std::array<int, 2> place{};
  for (std::size_t t = 0; t < 2; ++t) {
    place[t] = static_cast<int>(std::lround((position_m[tangent[t]] - low_m[t]) / extent_m[t]));
  }
  return place;
}

TributaryFace::TributaryFace(const TrueShape& shape, const Lattice& lattice, const FacePlane& plane,
                             const std::vector<SurfacePoint>& points)
    : shape_(shape), plane_(plane), has_particle_(plane.size(), 0), has_cell_(plane.size(), 0) {
  const bool flat = shape.is_plane(plane.axis);
  for (std::size_t t = 0; t < 2; ++t) curved_[t] = !flat && shape.is_round(plane.tangent[t]);
  for (const SurfacePoint& point : points) {
    has_particle_[plane.index(plane.grid_place(lattice.position_m[static_cast<std::size_t>(point.node)]))] = 1;
  }
  for (const auto& corners : lattice.cell) {
    has_cell_[plane_.index(plane_.grid_place(lattice.position_m[static_cast<std::size_t>(corners[0])]))] = 1;
  }
  if (flat) fill_flat_areas();
}

bool TributaryFace::has_cell(const std::array<int, 2>& cell) const {
  for (std::size_t t = 0; t < 2; ++t) {
    if (cell[t] < 0 || cell[t] >= plane_.cell_count[t]) return false;
  }
  return has_cell_[plane_.index(cell)] != 0;
}

Tributary TributaryFace::piece(const std::array<double, 3>& position_m, std::size_t tangent) const {
  Tributary piece{position_m[plane_.tangent[tangent]], plane_.extent_m[tangent], curved_[tangent], {2, 2}};
  if (piece.curved) return piece;
  const std::array<int, 2> place = plane_.grid_place(position_m);
  for (const int side : {0, 1}) {
    int& count = piece.cells[static_cast<std::size_t>(side)] = 0;
    while (count < 2) {
      std::array<int, 2> cell = place;  // that begins at the particle along both tangents
      cell[tangent] += side == 1 ? count : -1 - count;
      std::array<int, 2> beside = cell;
      --beside[1 - tangent];
      if (!has_cell(cell) && !has_cell(beside)) break;
      ++count;
    }
  }
  return piece;
}

double TributaryFace::area_m2(const std::array<double, 3>& position_m) const {
  if (!area_m2_.empty()) return area_m2_[plane_.index(plane_.grid_place(position_m))];
  return full_weight_m(piece(position_m, 0)) * full_weight_m(piece(position_m, 1));
}

/// The corner of a rim cell that stands for a corner without a particle: the one nearest to the middle; of two as
/// near, that on the same side.
std::array<int, 2> TributaryFace::inner_corner(const std::array<int, 2>& cell,
                                               const std::array<int, 2>& corner) const {
  std::array<int, 2> inner{};
  for (std::size_t t = 0; t < 2; ++t) {
    const int beyond = 2 * cell[t] + 1 - plane_.cell_count[t];  // the middle of the cell, from that of the face
    inner[t] = cell[t] + (beyond == 0 ? corner[t] : beyond < 0 ? 1 : 0);
  }
  return inner;
}

/// Adds a strip across one column of cells to the areas of the particles beside it.
/// @param cell along the first tangent @param share_above hat function of the particles at its upper end
void TributaryFace::add_strip(int cell, double width_m, double share_above, double half_chord_m) {
  const double extent = plane_.extent_m[1], middle = plane_.center_m[1] - plane_.low_m[1];
  for (int j = 0; j < plane_.cell_count[1]; ++j) {
    const double from = std::max(0.0, (middle - half_chord_m) / extent - j);
    const double to = std::min(1.0, (middle + half_chord_m) / extent - j);
    if (!(to > from)) continue;
    const double upper = 0.5 * (to * to - from * from), whole = to - from;
    for (const int a : {0, 1}) {
      for (const int b : {0, 1}) {
        const std::array<int, 2> corner = {cell + a, j + b};
        const double share = (a == 1 ? share_above : 1.0 - share_above) * (b == 1 ? upper : whole - upper);
        area_m2_[plane_.index(has_particle_[plane_.index(corner)] != 0 ? corner
                                                                       : inner_corner({cell, j}, {a, b}))] +=
            share * width_m * extent;
      }
    }
  }
}

void TributaryFace::fill_flat_areas() {
  area_m2_.assign(plane_.size(), 0.0);
  const double width = plane_.extent_m[0] / kStrips;
  for (int i = 0; i < plane_.cell_count[0]; ++i) {
    for (int k = 0; k < kStrips; ++k) {
      std::array<double, 3> place{};
      const double share = (k + 0.5) / kStrips;
      place[plane_.tangent[0]] = plane_.low_m[0] + (i + share) * plane_.extent_m[0] - plane_.center_m[0];
      add_strip(i, width, share, shape_.column_m(2 * plane_.tangent[1], place).value_or(-1.0));
    }
  }
  const double sum = std::accumulate(area_m2_.begin(), area_m2_.end(), 0.0);
  for (double& area : area_m2_) area *= shape_.face_area_m2(plane_.axis) / sum;
}

}  // namespace unbruised

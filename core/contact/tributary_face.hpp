#pragma once

/// @file
/// The faces of a lattice product as grids of particles: which piece of the true face each stands for.

#include <array>
#include <cstddef>
#include <vector>

#include "core/body/lattice.hpp"
#include "core/contact/tributary.hpp"
#include "core/scenario/true_shape.hpp"

namespace unbruised {

/// The plane of the particles that face one surface.
struct FacePlane {
  std::size_t axis;  ///< normal to it
  std::array<std::size_t, 2> tangent;
  std::array<int, 2> cell_count{};
  std::array<double, 2> extent_m{};  ///< of a cell
  std::array<double, 2> low_m{};     ///< of the bounding box, along the tangents
  std::array<double, 2> center_m{};  ///< of the true shape

  FacePlane(const Lattice& lattice, std::size_t normal_axis, const std::array<int, 2>& tangent_axes);
  /// Grid places of a particle.
  [[nodiscard]] std::array<int, 2> grid_place(const std::array<double, 3>& position_m) const;
  /// In the order of a grid of all particles of the plane.
  [[nodiscard]] std::size_t index(const std::array<int, 2>& place) const {
    return static_cast<std::size_t>(place[0]) * static_cast<std::size_t>(cell_count[1] + 1) +
           static_cast<std::size_t>(place[1]);
  }
  [[nodiscard]] std::size_t size() const { return index({cell_count[0], cell_count[1]}) + 1; }
};

/// What the particles of one side of the product stand for.
class TributaryFace {
 public:
  /// @param points surface particles of that side
  TributaryFace(const TrueShape& shape, const Lattice& lattice, const FacePlane& plane,
                const std::vector<SurfacePoint>& points);

  /// The piece of a particle along one of the tangents.
  [[nodiscard]] Tributary piece(const std::array<double, 3>& position_m, std::size_t tangent) const;
  /// Area of the true face that a particle stands for; on a flat face they add up to the face.
  [[nodiscard]] double area_m2(const std::array<double, 3>& position_m) const;

 private:
  [[nodiscard]] bool has_cell(const std::array<int, 2>& cell) const;
  /// Integrals of the hat functions over a flat face.
  void fill_flat_areas();
  [[nodiscard]] std::array<int, 2> inner_corner(const std::array<int, 2>& cell,
                                                const std::array<int, 2>& corner) const;
  void add_strip(int cell, double width_m, double share_above, double half_chord_m);

  const TrueShape& shape_;
  FacePlane plane_;
  std::array<bool, 2> curved_{};
  std::vector<char> has_particle_;  ///< by plane index
  std::vector<char> has_cell_;      ///< by plane index of its lowest corner
  std::vector<double> area_m2_;     ///< by plane index; of flat faces
};

}  // namespace unbruised

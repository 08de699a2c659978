#pragma once

/// @file
/// A closed mesh, stretched to a product's extents.

#include <memory>

#include "core/scenario/product_mesh.hpp"
#include "core/scenario/solid.hpp"

namespace unbruised {

class MeshSolid final : public Solid {
 public:
  /// @param parameters with a mesh and extents above 0
  explicit MeshSolid(const LatticeParameters& parameters);

  [[nodiscard]] double volume_m3() const override;
  [[nodiscard]] std::array<double, 3> center_of_mass_m() const override;
  [[nodiscard]] double mean_square_m2(std::size_t axis) const override { return mean_product_m2(axis, axis); }
  [[nodiscard]] double mean_product_m2(std::size_t a, std::size_t b) const override;
  [[nodiscard]] double section_m2(std::size_t axis) const override;
  [[nodiscard]] bool contains(const std::array<double, 3>& place_m) const override;
  [[nodiscard]] std::optional<double> column_m(std::size_t side,
                                               const std::array<double, 3>& place_m) const override;
  [[nodiscard]] std::array<double, 3> outward(std::size_t side,
                                              const std::array<double, 3>& place_m) const override;
  [[nodiscard]] std::array<double, 3> pole_m(std::size_t side) const override;
  [[nodiscard]] double pole_curvature_1_m(std::size_t side, std::size_t along) const override;
  [[nodiscard]] double flat_end_m2(std::size_t side) const override;
  [[nodiscard]] bool is_mirrored(std::size_t) const override { return false; }
  [[nodiscard]] double reach_m(const std::array<double, 3>& direction) const override;
  [[nodiscard]] NearestSurface nearest(const std::array<double, 3>& place_m) const override;
  [[nodiscard]] std::optional<ShapeHit> first_hit(const std::array<double, 3>& place_m,
                                                  const std::array<double, 3>& direction) const override;

 private:
  /// Into the mesh's coordinates and back.
  [[nodiscard]] std::array<double, 3> in_mesh(const std::array<double, 3>& place_m) const;
  [[nodiscard]] std::array<double, 3> in_m(const std::array<double, 3>& place) const;
  [[nodiscard]] std::array<double, 3> normal_m(const ProductMesh::On& on) const;

  std::shared_ptr<const ProductMesh> mesh_;
  std::array<double, 3> stretch_m_{};  ///< metres of a unit of the mesh along each axis
};

}  // namespace unbruised

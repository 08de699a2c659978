#pragma once

/// @file
/// A product's surface as a closed mesh, ready to be asked: smoothed (smooth_mesh), with a tree over its
/// triangles, its mass properties and its six poles. It has the coordinates of its file about the middle of its
/// bounding box; `MeshSolid` stretches it to a product's extents. Immutable, and shared by all scenarios that have
/// it.

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "core/scenario/smooth_mesh.hpp"
#include "core/scenario/triangle_tree.hpp"

namespace unbruised {

/// More are refused, and no smoothing makes more.
inline constexpr std::size_t kMostTriangles = 200'000;

/// Where a mesh comes from.
struct MeshSource {
  std::uint64_t hash = 0;  ///< of what it was read from; meshes with one hash are one mesh
  std::string file;
  std::string unit;  ///< of the file's coordinates: "mm"
};

/// What is known of the end of one side, in the mesh's coordinates.
struct MeshPole {
  std::array<double, 3> place{};
  std::array<double, 3> curvature{};  ///< along each axis across the side; 0: straight or flat there
  double flat_area = 0.0;             ///< 0: it does not end in a plane
};

class ProductMesh {
 public:
  /// A place of the surface: shares of the corners of one of its triangles.
  struct On {
    std::size_t triangle = 0;
    std::array<double, 3> share{};
  };
  struct Column {
    double height = 0.0;  ///< along the axis
    On on;
  };

  /// @param mesh closed and sound (mesh_fault), of kMostTriangles at most
  ProductMesh(TriangleMesh mesh, MeshSource source);

  [[nodiscard]] const MeshSource& source() const { return source_; }
  /// As it was given.
  [[nodiscard]] const TriangleMesh& given() const { return given_; }
  /// Before it was smoothed, in the coordinates of `surface`.
  [[nodiscard]] TriangleMesh given_in_middle() const;
  /// Smoothed, about the middle of its bounding box.
  [[nodiscard]] const TriangleMesh& surface() const { return smooth_.mesh; }
  [[nodiscard]] const TriangleTree& tree() const { return tree_; }
  [[nodiscard]] const std::array<double, 3>& extents() const { return extents_; }

  [[nodiscard]] double volume() const { return volume_; }
  [[nodiscard]] const std::array<double, 3>& center_of_mass() const { return center_of_mass_; }
  /// Mean over the volume of the product of two coordinates.
  [[nodiscard]] double mean_product(std::size_t a, std::size_t b) const { return mean_product_[a][b]; }
  /// Of its shadow along an axis.
  [[nodiscard]] double section(std::size_t axis) const { return section_[axis]; }
  [[nodiscard]] const MeshPole& pole(std::size_t side) const { return pole_[side]; }

  /// Where the column along an axis through a place leaves the surface towards a side; none: it passes beside it.
  [[nodiscard]] std::optional<Column> column(std::size_t side, const std::array<double, 3>& place) const;
  [[nodiscard]] bool contains(const std::array<double, 3>& place) const;
  [[nodiscard]] std::array<double, 3> normal(const On& on) const;

 private:
  void set_mass_properties();
  [[nodiscard]] double shadow(std::size_t axis) const;
  [[nodiscard]] MeshPole pole_of(std::size_t side) const;

  MeshSource source_;
  TriangleMesh given_;
  SmoothMesh smooth_;
  std::array<double, 3> extents_{};
  TriangleTree tree_;
  double volume_ = 0.0;
  std::array<double, 3> center_of_mass_{};
  std::array<std::array<double, 3>, 3> mean_product_{};
  std::array<double, 3> section_{};
  std::array<MeshPole, 6> pole_;
};

}  // namespace unbruised

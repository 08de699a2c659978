#pragma once

/// @file
/// The smooth surface through the corners of a mesh: triangles are divided until they follow it, and each corner
/// has the surface's normal. Edges at which the mesh turns by more than kCrease_rad stay
/// sharp, and are smooth along themselves.

#include <array>
#include <vector>

#include "core/scenario/triangle_mesh.hpp"

namespace unbruised {

/// An icosahedron's edges, of 42 degrees, are the coarsest that could mean a sphere; a chamfer has 45.
inline constexpr double kCrease_rad = 0.7;

struct SmoothMesh {
  TriangleMesh mesh;
  std::vector<std::array<std::array<double, 3>, 3>> normal;  ///< at the corners of each triangle, of length 1
};

/// @param mesh closed and sound (mesh_fault)
/// @param tolerance the middle of no smooth edge is moved by more in the last division
/// @param most_triangles no division makes more
SmoothMesh smooth_mesh(const TriangleMesh& mesh, double tolerance, std::size_t most_triangles);

}  // namespace unbruised

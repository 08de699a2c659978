#pragma once

/// @file
/// From the triangles of a file to a closed mesh, and what is wrong with those that are none.

#include <optional>
#include <string>

#include "core/scenario/triangle_mesh.hpp"

namespace unbruised {

/// With places that are the same joined (within kSamePlace of the longest extent) and triangles left out that have
/// no three of them: STL files write every corner again.
/// @param mesh with finite places
TriangleMesh welded(const TriangleMesh& mesh);
inline constexpr double kSamePlace = 1e-6;

/// What is wrong with a welded mesh, in one sentence that says where; none: it encloses one body, looks outward
/// and does not pass through itself.
std::optional<std::string> mesh_fault(const TriangleMesh& mesh);

}  // namespace unbruised

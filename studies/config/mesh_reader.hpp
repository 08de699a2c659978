#pragma once

/// @file
/// Triangles out of STL, OBJ and PLY files, read by Assimp in a child process: what breaks the reader ends in a
/// sentence.

#include <string>
#include <string_view>

#include "core/scenario/triangle_mesh.hpp"
#include "studies/text/value_or.hpp"

namespace unbruised::studies {

/// The triangles of a file as they stand there, polygons divided; or why there are none, a predicate ("cannot be
/// read: ...").
/// @param ending of the file's name, "stl", "obj" or "ply" in any case: what the content is taken for
ValueOr<TriangleMesh, std::string> read_triangles(std::string_view content, const std::string& ending);

}  // namespace unbruised::studies

#pragma once

/// @file
/// The mesh of a product from its file: what the file holds, in which unit, whether it is the one that was meant.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/scenario/product_mesh.hpp"
#include "studies/config/document.hpp"
#include "studies/config/problems.hpp"

namespace unbruised::studies {

inline constexpr std::string_view kMeshFileKey = "product.mesh_file", kMeshUnitKey = "product.mesh_unit",
                                  kMeshHashKey = "product.mesh_hash", kMeshKeys = "product.mesh_";

/// What a study says of a mesh, beside the content of its file.
struct MeshText {
  std::string_view content;
  Entry file;               ///< the entry that names it
  const Entry* unit;        ///< null: not given
  const Entry* hash;        ///< null: not given
  std::string ending;       ///< of its name, "stl"
  std::string found_again;  ///< by which name a resolved config finds it
};

/// The mesh, sound and of a product's size in its unit; null: a problem was said.
std::shared_ptr<const ProductMesh> mesh_of_text(const MeshText& text, Problems& problems);

/// Its extents in metres, an entry of product.size_m.
Entry mesh_size_entry(const ProductMesh& mesh, const Origin& origin);

}  // namespace unbruised::studies

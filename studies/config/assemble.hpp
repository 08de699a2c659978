#pragma once

/// @file
/// From entries to one scenario: types, ranges, unknown and unused keys, what is missing, what excludes what.

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "studies/config/document.hpp"
#include "studies/config/problems.hpp"
#include "studies/config/schema.hpp"

namespace unbruised::studies {

/// Entries of a higher layer override those of a lower one, key by key.
enum class Layer { library, study, command_line };

struct LayeredEntry {
  Layer layer;
  const Entry* entry;
};

/// One scenario with the places its values come from.
struct Assembly {
  Scenario scenario;
  StudySettings settings;
  std::unordered_map<std::string, Origin> given;

  /// Where `key` was given; else where the study's table starts.
  [[nodiscard]] Origin origin_of(const std::string& key) const;
  Origin fallback;
  std::unordered_map<std::string, Origin> tables;
};

/// Meshes that were read, by the name of the file as it was written and its unit.
using Meshes = std::map<std::pair<std::string, std::string>, std::shared_ptr<const ProductMesh>>;

struct AssemblyInput {
  std::vector<LayeredEntry> entries;     ///< in layer order
  std::vector<std::string> varied_keys;  ///< count as given
  std::unordered_map<std::string, Origin> tables;
  Origin fallback;                 ///< where a missing key is reported when its table is missing too
  const Meshes* meshes = nullptr;  ///< null: none
  bool has_gripper = false;
  bool is_complete = true;  ///< false: something could not be read, so nothing is reported as missing
};

/// Builds a scenario. With problems, the result is not to be used.
Assembly assemble(const AssemblyInput& input, Problems& problems);

}  // namespace unbruised::studies

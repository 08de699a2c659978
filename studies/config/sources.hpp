#pragma once

/// @file
/// Where the values of product, gripper and limits come from: the [source] tables of library files and studies, as
/// far as they speak of the values that are used.

#include <string>
#include <string_view>
#include <vector>

#include "studies/config/document.hpp"

namespace unbruised::studies {

/// Is it an entry of [product.source] or [gripper.source]?
bool is_source(std::string_view path);

/// The sources that still speak of what is used: those of the files (`library`) whose key neither the study nor
/// the command line sets itself, and those of the study (`own`) whose key the command line does not set.
/// @param study, command_line what they set, by path
/// @return paths as "product.source.mass_kg", one each, sorted
std::vector<Entry> sources_in_use(const std::vector<Entry>& library, const std::vector<Entry>& own,
                                  const std::vector<Entry>& study, const std::vector<Entry>& command_line);

enum class Standing {
  assumed,    ///< its source says that it is assumed
  unsourced,  ///< set without a source
  cited,
};
/// "assumed", "unsourced", "cited"
std::string_view standing_word(Standing standing);

/// One number (or list of numbers) a study uses, and who says so.
struct ValueSource {
  std::string key;  ///< "product.mass_kg"
  Value value;
  std::string source;  ///< empty where there is none
  Standing standing = Standing::unsourced;
};

/// What the numbers of a resolved config rest on.
struct ConfigSources {
  /// Every number of product, gripper and limits, in the config's order. What has no number (a shape, a coupling),
  /// a zero without a source (what is switched off) and the particles of a network are left out.
  std::vector<ValueSource> values;
  /// The keys that vary whole library files, e.g. "product.use": their values and sources stand in those files.
  std::vector<std::string> varied_files;
};

/// Reads a resolved config once; one that cannot be read has no values.
ConfigSources config_sources(std::string_view resolved_toml);

}  // namespace unbruised::studies

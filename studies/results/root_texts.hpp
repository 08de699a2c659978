#pragma once

/// @file
/// The texts at the root of results.h5, once for its writer, its reader and the process that reads suspect files.

#include <array>
#include <string>

#include "studies/results/rows.hpp"

namespace unbruised::studies {

/// A text of the study as attribute of the file's root.
struct RootText {
  const char* attribute;
  std::string ResultsMeta::*text;
};

inline constexpr std::array<RootText, 10> kRootTexts{{{"unbruised_version", &ResultsMeta::unbruised_version},
                                                      {"config", &ResultsMeta::config_toml},
                                                      {"config_sha256", &ResultsMeta::config_sha256},
                                                      {"study_name", &ResultsMeta::study_name},
                                                      {"study_kind", &ResultsMeta::study_kind},
                                                      {"created_utc", &ResultsMeta::created_utc},
                                                      {"instruction_set", &ResultsMeta::instruction_set},
                                                      {"compiler", &ResultsMeta::compiler},
                                                      {"damage", &ResultsMeta::damage},
                                                      {"damage_note", &ResultsMeta::damage_note}}};

}  // namespace unbruised::studies

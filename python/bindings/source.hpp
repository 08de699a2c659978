#pragma once

/// @file
/// Where a study comes from: a file, or a text.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "studies/config/study.hpp"

namespace unbruised::python {

struct Source {
  std::filesystem::path file;       ///< or what stands for it in messages
  std::optional<std::string> text;  ///< instead of what stands in the file
  std::filesystem::path root;       ///< the library of products and grippers

  /// @param file empty: the text has none
  static Source of(const std::string& file, const std::optional<std::string>& text);

  [[nodiscard]] studies::StudyOrError read(const std::vector<std::string>& sets) const;
  /// What it says about a single scenario (studies/config/study_part.hpp).
  [[nodiscard]] studies::StudyOrError read_single(const std::vector<std::string>& sets) const;
  /// The whole, or ConfigError is thrown.
  [[nodiscard]] studies::Study study(const std::vector<std::string>& sets) const;
  /// Where what the study names is looked for first.
  [[nodiscard]] std::filesystem::path folder() const;
};

}  // namespace unbruised::python

#pragma once

/// @file
/// Collects everything that is wrong with a study, to be shown at once.

#include <string>
#include <string_view>
#include <vector>

#include "studies/config/document.hpp"

namespace unbruised::studies {

class Problems {
 public:
  /// `place: key: rule`
  void add(const Origin& origin, std::string_view key, std::string_view rule);
  /// `place: key = value: rule`; a long value is shortened.
  void add(const Origin& origin, std::string_view key, const std::string& value, std::string_view rule);
  void add(const Problem& problem) { all_.push_back(problem); }

  [[nodiscard]] std::size_t count() const { return all_.size(); }
  [[nodiscard]] bool empty() const { return all_.empty(); }
  /// One line each, without repetitions, in the order of files and lines.
  [[nodiscard]] std::vector<std::string> lines() const;

 private:
  std::vector<Problem> all_;
};

/// "unknown key; did you mean 'strategy.grip_force_N'?"
std::string unknown_key_rule(const std::string& path);
/// "[[product.particle]]" for "product.particle[]".
std::string table_header(std::string table);
/// The same for a table.
std::string unknown_table_rule(const std::string& path);

}  // namespace unbruised::studies

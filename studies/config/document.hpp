#pragma once

/// @file
/// A TOML text as a flat list of `path = value` entries that know where they stand. The rest of studies/config
/// works on these and never sees the parser.

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/scenario/words.hpp"

namespace unbruised::studies {

/// Where a value was written. Without a file: on the command line.
struct Origin {
  std::shared_ptr<const std::string> file;
  int rank = 1 << 20;  ///< order of the file among those read; messages are sorted by (rank, line)
  int line = 0;

  /// "file:line", or "--set".
  [[nodiscard]] std::string text() const;
};

/// A TOML value.
struct Value {
  enum class Kind { number, integer, boolean, text, array, other };
  Kind kind = Kind::other;
  double number = 0.0;  ///< also of an integer
  std::int64_t integer = 0;
  bool boolean = false;
  std::string text;  ///< also what an `other` is, in words
  std::vector<Value> items;

  [[nodiscard]] bool is_number() const { return kind == Kind::number || kind == Kind::integer; }
};

Value number_value(double number);
Value text_value(std::string text);

using unbruised::spelled;
/// Six digits, where the bits do not count.
std::string rounded(double value);
/// A string in TOML's basic quotes.
std::string toml_string(std::string_view text);
/// A value as TOML.
std::string spelled(const Value& value);

/// One `path = value`; the path has an index for each table of an array of tables ("product.particle[2].mass_kg").
struct Entry {
  std::string path;
  Value value;
  Origin origin;
};

/// A message about one place.
struct Problem {
  Origin origin;
  std::string text;  ///< without the place
};

struct Document {
  std::vector<Entry> entries;  ///< in the order of their lines
  std::vector<Entry> tables;   ///< every table, by its path; `value` is empty
  std::vector<Problem> problems;
};

/// Reads a TOML text. Refuses more than 4 MiB, NUL bytes, text that is not UTF-8, and characters outside ASCII
/// anywhere but in strings and comments, before the parser sees it; a syntax error is a problem too.
Document parse_document(std::string_view text, const std::shared_ptr<const std::string>& file, int rank);

/// Reads one TOML literal, e.g. the right side of `--set`. Empty when it is none.
std::vector<Value> parse_literal(const std::string& literal);

}  // namespace unbruised::studies

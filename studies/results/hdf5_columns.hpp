#pragma once

/// @file
/// Columns of a table in HDF5: datasets with units, a long name and the scale of their table's rows; and their way
/// back. For use inside studies/results only.

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "studies/results/hdf5_file.hpp"
#include "studies/results/rows.hpp"
#include "studies/text/joined.hpp"

namespace unbruised::studies {

inline std::vector<std::int64_t> indices(std::size_t count) {
  std::vector<std::int64_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), std::int64_t{0});
  return numbers;
}

inline void describe(Hdf5File& file, const std::string& name, const std::string& units,
                     const std::string& long_name) {
  if (!units.empty()) file.set_attribute(name, "units", units);
  if (!long_name.empty()) file.set_attribute(name, "long_name", long_name);
}

/// The codes of a column and their words, as CF has them.
struct Flags {
  std::vector<std::int8_t> values;
  std::string meanings;  ///< a blank between words
};

/// Words of the codes `first`, `first` + 1, ...
inline Flags flags_of(std::span<const std::string_view> words, std::int8_t first = 0) {
  Flags flags;
  for (const std::string_view word : words) {
    flags.meanings += joined({flags.values.empty() ? "" : " ", word});
    flags.values.push_back(static_cast<std::int8_t>(first + static_cast<std::int8_t>(flags.values.size())));
  }
  return flags;
}

inline void describe_flags(Hdf5File& file, const std::string& name, const Flags& flags,
                           const std::string& long_name) {
  file.set_attribute(name, "flag_values", std::span<const std::int8_t>(flags.values));
  file.set_attribute(name, "flag_meanings", flags.meanings);
  file.set_attribute(name, "long_name", long_name);
}

/// A table's dimension: its scale, and the number of its rows.
struct Dimension {
  std::string scale;
  std::size_t count;
};

inline void write_scale(Hdf5File& file, const Dimension& dimension, const std::string& long_name) {
  file.write(dimension.scale, indices(dimension.count), {dimension.count});
  file.set_attribute(dimension.scale, "long_name", long_name);
  file.make_scale(dimension.scale);
}

inline void write_column(Hdf5File& file, const std::string& name, const Dimension& dimension,
                         std::span<const double> values, const std::string& units, const std::string& long_name) {
  file.write(name, values, {dimension.count});
  file.set_attribute(name, "_FillValue", kAbsent);
  describe(file, name, units, long_name);
  file.attach_scale(name, dimension.scale, 0);
}

inline void write_text_column(Hdf5File& file, const std::string& name, const Dimension& dimension,
                              const std::vector<std::string>& texts, const std::string& long_name) {
  file.write(name, texts);
  describe(file, name, "", long_name);
  file.attach_scale(name, dimension.scale, 0);
}

template <class Row, class Field>
auto column_of(const std::vector<Row>& rows, Field field) {
  std::vector<std::decay_t<decltype(field(rows.front()))>> values;
  values.reserve(rows.size());
  for (const Row& row : rows) values.push_back(field(row));
  return values;
}

/// Throws Hdf5Failure where a column has another length than its table.
inline void require_length(const std::string& name, std::size_t length, std::size_t expected) {
  if (length == expected) return;
  throw Hdf5Failure(
      joined({name, " has ", std::to_string(length), " rows where ", std::to_string(expected), " are due"}));
}

// Whole columns, which must be as long as their table, and parts of them.

inline std::vector<double> read_column(const Hdf5File& file, const std::string& name, std::size_t count) {
  auto values = file.read_doubles(name);
  require_length(name, values.size(), count);
  return values;
}
inline std::vector<double> read_column(const Hdf5File& file, const std::string& name, const Hdf5Part& part) {
  auto values = file.read_doubles(name, part);
  require_length(name, values.size(), part.count);
  return values;
}

inline std::vector<std::string> read_text_column(const Hdf5File& file, const std::string& name,
                                                 std::size_t count) {
  auto texts = file.read_texts(name);
  require_length(name, texts.size(), count);
  return texts;
}
inline std::vector<std::string> read_text_column(const Hdf5File& file, const std::string& name,
                                                 const Hdf5Part& part) {
  auto texts = file.read_texts(name, part);
  require_length(name, texts.size(), part.count);
  return texts;
}

inline std::vector<std::int64_t> read_integer_column(const Hdf5File& file, const std::string& name,
                                                     std::size_t count) {
  auto values = file.read_integers(name);
  require_length(name, values.size(), count);
  return values;
}
inline std::vector<std::int64_t> read_integer_column(const Hdf5File& file, const std::string& name,
                                                     const Hdf5Part& part) {
  auto values = file.read_integers(name, part);
  require_length(name, values.size(), part.count);
  return values;
}

}  // namespace unbruised::studies

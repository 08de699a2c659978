#pragma once

/// @file
/// Varied keys by their role, and their values as columns of a table.

#include <cstddef>
#include <string>
#include <vector>

#include "studies/results/rows.hpp"

namespace unbruised::studies {

/// Positions of the keys that the answer has to hold over (`given`), and of all others.
struct KeyPlaces {
  std::vector<std::size_t> given;
  std::vector<std::size_t> others;
};
KeyPlaces key_places(const std::vector<ColumnInfo>& columns);

/// The elements at these places.
template <class T>
std::vector<T> picked(const std::vector<T>& values, const std::vector<std::size_t>& places) {
  std::vector<T> result;
  for (const std::size_t i : places) result.push_back(values[i]);
  return result;
}

/// One value per row: numbers, or texts where not all are numbers.
ResultColumn key_column(const ColumnInfo& key, const std::vector<InputValue>& values);

/// "youngs_modulus_Pa, friction"
std::string leaves_text(const std::vector<ColumnInfo>& keys);

}  // namespace unbruised::studies

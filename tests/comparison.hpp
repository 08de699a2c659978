#pragma once

/// @file
/// Compares the program with something independent, and prints what it found for the tables of docs/validation.md
/// (scripts/validation_tables).

#include <cstdio>
#include <string>

#include <gtest/gtest.h>

namespace unbruised::testing {

/// One row of a table of docs/validation.md.
struct Comparison {
  std::string table;     ///< as the page marks it
  std::string quantity;  ///< with its unit
  double program, independent;
};

/// Prints the row, and expects both to agree.
/// @param tolerance of their ratio
inline void expect_agreement(const Comparison& row, double tolerance) {
  std::printf("compared|%s|%s|%.6g|%.6g\n", row.table.c_str(), row.quantity.c_str(), row.program, row.independent);
  EXPECT_NEAR(row.program / row.independent, 1.0, tolerance) << row.quantity;
}

/// Prints a row of which only its documentation is expected: a known miss.
inline void note_miss(const Comparison& row) { expect_agreement(row, 1e3); }

}  // namespace unbruised::testing

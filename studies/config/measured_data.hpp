#pragma once

/// @file
/// What was measured, from CSV texts: columns that are drawn from, and curves that are fitted.

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "studies/config/problems.hpp"
#include "studies/config/schema.hpp"

namespace unbruised::studies {

/// Rows of a file: each is one product, or one point of a curve.
inline constexpr std::size_t kFewestDataRows = 3;
inline constexpr std::size_t kMaxDataRows = 10'000;

/// The numbers of one column, kFewestDataRows to kMaxDataRows of them; none where there is a problem.
/// @param key of the study, for messages. @param file, rank of the text
std::vector<double> column_numbers(std::string_view content, const std::string& column, const std::string& key,
                                   const std::shared_ptr<const std::string>& file, int rank, Problems& problems);

/// The column that a test measures over, and the one that it measures.
std::string_view column_over(CurveTest test);
std::string_view column_measured(CurveTest test);

/// One block for each specimen of the text: the word of its column `specimen`, or the name of the file without
/// one. Its origin is its first row. None where there is a problem.
std::vector<SpecimenBlock> measured_curves(std::string_view content, const CalibrateTable& settings,
                                           const std::shared_ptr<const std::string>& file, int rank,
                                           Problems& problems);

}  // namespace unbruised::studies

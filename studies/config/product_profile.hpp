#pragma once

/// @file
/// The profile of a solid of revolution from a CSV file.

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "studies/config/document.hpp"
#include "studies/config/problems.hpp"

namespace unbruised::studies {

/// The key that names the file.
inline constexpr std::string_view kProductProfileKey = "product.profile_file";

/// Entries of product.profile_height and product.profile_radius, from the columns height and radius.
/// @param file, rank of the text, for messages
std::vector<Entry> product_profile_entries(std::string_view content,
                                           const std::shared_ptr<const std::string>& file, int rank,
                                           Problems& problems);

}  // namespace unbruised::studies

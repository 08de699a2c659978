#pragma once

/// @file
/// On how many values an answer rests, and who says them.

#include <cstddef>
#include <string>
#include <string_view>

namespace unbruised::studies {

/// The values of product, gripper and limits by their standing (studies/config/sources.hpp).
struct ValueCounts {
  std::size_t assumed = 0;
  std::size_t unsourced = 0;
  std::size_t cited = 0;
  std::string files{};  ///< "product.use, gripper.use": varied, so their values stand in their files
  [[nodiscard]] std::size_t all() const { return assumed + unsourced + cited; }
};
/// @param resolved_toml a config that cannot be read gives none
ValueCounts value_counts(std::string_view resolved_toml);

/// "rests on 24 values of product, gripper and limits: 6 assumed, 15 without a source, 3 from a source";
/// empty where there is nothing to say.
std::string rests_on_line(const ValueCounts& counts);

}  // namespace unbruised::studies

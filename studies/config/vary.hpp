#pragma once

/// @file
/// [[vary]] blocks: which keys take which values, and how the blocks combine into scenarios.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "studies/config/document.hpp"
#include "studies/config/problems.hpp"
#include "studies/config/schema.hpp"

namespace unbruised::studies {

constexpr std::uint64_t kMaxScenarios = 10'000'000;

/// A varied key, ready to be written into a scenario.
struct VaryColumn {
  InputColumn input;
  KeyAddress address;
  std::vector<Value> words;  ///< of a text column
  std::size_t axis = 0;
  /// product.use and gripper.use choose among whole tables: their entries, one list per value, when they are
  /// written out in the block ([[vary.variant]]).
  std::vector<std::vector<Entry>> variants;
  Origin origin;

  [[nodiscard]] bool is_use() const { return address.spec != nullptr && address.spec->field == nullptr; }
};

/// One dimension of the product: a block, or the blocks of one `zip`.
struct VaryAxis {
  std::size_t count = 1;
  std::size_t stride = 1;
  std::string zip;
};

struct VaryPlan {
  std::vector<VaryBlock> blocks;
  std::vector<VaryColumn> columns;
  std::vector<VaryAxis> axes;
  std::size_t scenario_count = 1;

  [[nodiscard]] std::size_t index(std::size_t scenario, std::size_t column) const {
    const VaryAxis& axis = axes[columns[column].axis];
    return scenario / axis.stride % axis.count;
  }
};

/// Reads the blocks from entries "vary[i]..." (later entries override), checks every value against its key.
VaryPlan plan_vary(const std::vector<Entry>& entries, const std::vector<Entry>& tables, const Origin& fallback,
                   Problems& problems);

}  // namespace unbruised::studies

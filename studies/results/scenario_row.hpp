#pragma once

/// @file
/// One scenario of a study as plain data, and what its ids are.

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/outcome/outcome.hpp"

namespace unbruised::studies {

inline constexpr double kAbsent = std::numeric_limits<double>::quiet_NaN();

/// The value of a varied key: a number, or a text such as a product file.
using InputValue = std::variant<double, std::string>;

/// A varied key. Its column holds texts as soon as one of its values is a text.
struct ColumnInfo {
  std::string key;        ///< dotted, e.g. "strategy.grip_force_N"
  std::string units;      ///< UDUNITS spelling; may stay empty
  std::string long_name;  ///< may stay empty
};

/// Which question of a search a scenario answered; of a window study which force of which round at which
/// combination. Its numbers depend on the study alone, never on when it was asked.
struct SearchPlace {
  std::uint64_t search = 0;      ///< < 2^23; of a window study the round
  std::uint64_t generation = 0;  ///< < 2^24; questions asked together belong to one; the combination
  std::uint64_t index = 0;       ///< < 2^16; inside the generation; of the force in its round and combination
  friend bool operator==(const SearchPlace&, const SearchPlace&) = default;
};
inline constexpr std::uint64_t kGenerationsMost = 1ULL << 24U;
inline constexpr std::uint64_t kIndicesMost = 1ULL << 16U;

/// The place as one number that sorts as (search, generation, index): the id of its row in the journal.
constexpr std::uint64_t journal_id(const SearchPlace& place) {
  return (place.search << 40U) | (place.generation << 16U) | place.index;
}
constexpr SearchPlace search_place(std::uint64_t journal_id) {
  return {journal_id >> 40U, (journal_id >> 16U) & (kGenerationsMost - 1), journal_id & (kIndicesMost - 1)};
}

/// One scenario of a study.
struct ScenarioRow {
  std::uint64_t id = 0;  ///< in the study's order; of rows with a place in the journal: journal_id of the place
  ScenarioResult result;
  std::vector<InputValue> inputs;      ///< as long as, and in the order of, the study's input columns
  std::optional<SearchPlace> place{};  ///< of what was asked for, once the rows are numbered
};

/// What the ids of rows in the journal are.
enum class RowPlaces {
  none,       ///< those of the study
  questions,  ///< places of a search's questions
  forces,     ///< places of a window study's forces
};

/// Numbers rows with places, sorted by their journal ids, 0, 1, 2 ...; their places stay known.
void number_placed_rows(std::vector<ScenarioRow>& rows);
/// The same of the row that is the `number`th of them.
void number_placed_row(ScenarioRow& row, std::uint64_t number);
/// The row's id in the journal.
std::uint64_t journal_id(const ScenarioRow& row);

}  // namespace unbruised::studies

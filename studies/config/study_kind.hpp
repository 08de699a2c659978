#pragma once

/// @file
/// The kinds of studies: one row each, with what is known of a kind before anything runs. Code asks for a property
/// of the row, never for a kind by name. How each kind runs stands in kinds/kind_table.hpp.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace unbruised::studies {

/// In the order of the table.
enum class StudyKind {
  simulate,
  sweep,
  window,
  sample,
  optimize,
  robust,
  pareto,
  compare,
  sensitivity,
  calibrate
};

/// Where the scenarios of a study come from.
enum class ScenarioSource {
  grid,       ///< the points of the [[vary]] blocks
  forces,     ///< grip forces that are asked for at every point of that grid
  products,   ///< random products
  pairs,      ///< every candidate with every random product
  design,     ///< a design over the random keys
  questions,  ///< what searches over the [[variable]] keys ask
  curves,     ///< what the fits of the [[parameter]] keys to measured curves ask
};

/// May a study have blocks of a list?
enum class Blocks { refused, optional, required };

enum class Objectives { none, one, several };

/// What `unbruised` says of damage in the answer of a kind.
enum class DamageAnswer { none, undamaged };

struct StudyKindRow {
  StudyKind kind;
  std::string_view word;  ///< as in `study.kind`
  std::string_view asks;  ///< what a study of the kind wants to know
  ScenarioSource scenarios;
  Blocks vary = Blocks::refused;
  Blocks variable = Blocks::refused;
  Blocks parameter = Blocks::refused;
  Blocks random = Blocks::refused;
  Blocks candidate = Blocks::refused;
  Objectives objectives = Objectives::none;
  DamageAnswer damage = DamageAnswer::none;
};

/// All kinds, in the order of the reference.
std::span<const StudyKindRow> study_kind_table();
const StudyKindRow& row_of(StudyKind kind);
/// The word of a kind, as in `study.kind`.
inline std::string_view study_kind_word(StudyKind kind) { return row_of(kind).word; }

/// The kind of a word; nothing for the word of another version.
std::optional<StudyKind> study_kind_named(std::string_view word);

/// Kinds in which NLopt searches a box of variables.
inline bool is_search(StudyKind kind) { return row_of(kind).scenarios == ScenarioSource::questions; }
/// Kinds that draw random products.
inline bool is_random(StudyKind kind) { return row_of(kind).random != Blocks::refused; }
/// Searches that judge a strategy by statistics over random products.
inline bool is_sampled_search(StudyKind kind) { return is_search(kind) && is_random(kind); }
/// Kinds that fit keys to measured curves.
inline bool fits_curves(StudyKind kind) { return row_of(kind).scenarios == ScenarioSource::curves; }
/// Kinds that search for the grip force themselves.
inline bool searches_force(StudyKind kind) { return row_of(kind).scenarios == ScenarioSource::forces; }
/// Kinds of one run, which leaves its trace.
inline bool leaves_trace(StudyKind kind) {
  const StudyKindRow& row = row_of(kind);
  return row.scenarios == ScenarioSource::grid && row.vary == Blocks::refused;
}
/// Searches for a front instead of a best strategy.
inline bool has_several_objectives(StudyKind kind) { return row_of(kind).objectives == Objectives::several; }
/// Kinds whose answer says that a product stays undamaged.
inline bool judges_damage(StudyKind kind) { return row_of(kind).damage == DamageAnswer::undamaged; }

/// The words of the kinds for which `is_meant` holds.
template <class IsMeant>
std::vector<std::string> kinds_where(IsMeant is_meant) {
  std::vector<std::string> words;
  for (const StudyKindRow& row : study_kind_table()) {
    if (is_meant(row)) words.emplace_back(row.word);
  }
  return words;
}

}  // namespace unbruised::studies

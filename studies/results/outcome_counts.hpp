#pragma once

/// @file
/// How many runs ended in which way.

#include <array>
#include <cstddef>
#include <string>

#include "core/outcome/outcome.hpp"

namespace unbruised::studies {

struct OutcomeCounts {
  std::array<std::size_t, kOutcomeWords.size()> of{};  ///< by the code of the outcome
  std::size_t not_run = 0;

  void add(Outcome outcome) { ++(outcome == Outcome::not_run ? not_run : of[static_cast<std::size_t>(outcome)]); }
};

/// Calls `visit(outcome, count)` for every outcome, `not_run` last.
template <class Visit>
void for_each_outcome(const OutcomeCounts& counts, Visit visit) {
  for (std::size_t code = 0; code < counts.of.size(); ++code) visit(static_cast<Outcome>(code), counts.of[code]);
  visit(Outcome::not_run, counts.not_run);
}

/// "held 1,500, dropped 10": those that happened; empty where none did.
std::string counts_text(const OutcomeCounts& counts);

}  // namespace unbruised::studies

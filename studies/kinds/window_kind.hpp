#pragma once

/// @file
/// window as a row of the table of kinds: rounds of evaluations, each answered from the journal where it can be.

#include "studies/kinds/kind_table.hpp"

namespace unbruised::studies {

KindAnswer run_window(const KindInput& input);

/// Parts of it are combinations, each with all forces of its search. What the answer asks beside them, at half the
/// time step, is asked when all are there.
bool run_combinations(const KindInput& input, const std::vector<std::uint64_t>& numbers);
std::vector<std::uint64_t> missing_combinations(const Study& study, const RunJournal& journal);

}  // namespace unbruised::studies

#pragma once

/// @file
/// The kinds whose scenarios are all known beforehand: every one that is not recorded is run, then the rows are
/// looked at.

#include "studies/kinds/kind_table.hpp"

namespace unbruised::studies {

/// One scenario with its trace. The trace is not in the journal, so a resumed run makes it again.
KindAnswer run_simulate(const KindInput& input);
KindAnswer run_sweep(const KindInput& input);
KindAnswer run_sample(const KindInput& input);
KindAnswer run_compare(const KindInput& input);
KindAnswer run_sensitivity(const KindInput& input);

/// Parts of them are scenarios.
bool run_scenarios(const KindInput& input, const std::vector<std::uint64_t>& ids);
std::vector<std::uint64_t> missing_scenarios(const Study& study, const RunJournal& journal);

}  // namespace unbruised::studies

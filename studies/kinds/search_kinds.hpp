#pragma once

/// @file
/// optimize, robust and pareto as rows of the table of kinds: recorded answers are not computed again.

#include "studies/kinds/kind_table.hpp"

namespace unbruised::studies {

KindAnswer run_search(const KindInput& input);

}  // namespace unbruised::studies

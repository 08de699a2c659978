#pragma once

/// @file
/// window as a row of the table of kinds: rounds of evaluations, each answered from the journal where it can be.

#include "studies/kinds/kind_table.hpp"

namespace unbruised::studies {

KindAnswer run_window(const KindInput& input);

}  // namespace unbruised::studies

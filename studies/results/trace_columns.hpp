#pragma once

/// @file
/// /trace and /contact_events of a results file. For use inside studies/results only; throws Hdf5Failure.

#include <string>
#include <vector>

#include "core/outcome/trace.hpp"
#include "studies/results/hdf5_file.hpp"

namespace unbruised::studies {

void write_trace(Hdf5File& file, const Trace& trace);
/// Everything that `write_trace` wrote; each array whole.
Trace read_trace(const Hdf5File& file);
/// Datasets of /trace that run over time and are not the motion itself.
std::vector<std::string> signal_names(const Hdf5File& file);

}  // namespace unbruised::studies

#pragma once

/// @file
/// Forces that were measured elsewhere, to stand beside what was simulated.

#include <filesystem>

#include "studies/report/report_data.hpp"
#include "studies/results/expected.hpp"

namespace unbruised::studies {

/// The column `rupture_force_N` of a CSV file. Errors: io; foreign, with the line that is wrong.
Expected<MeasuredForces> read_measured_forces(const std::filesystem::path& path);

}  // namespace unbruised::studies

#pragma once

/// @file
/// Reads results files that may be damaged. The HDF5 library itself crashes on some damaged files, so it works in
/// a child process here, and its crash is an error like any other. Every file that comes from outside the running
/// study is read through this door; `results_file.hpp` reads in the same process.

#include <filesystem>

#include "studies/results/expected.hpp"
#include "studies/results/results_file.hpp"

namespace unbruised::studies {

/// `read_results_summary` in a child process; of many rows some at a time, as they are gone through, each time by
/// another child. Errors: as there; damaged when the library crashes or hangs.
Expected<ResultsSummary> read_suspect_summary(const std::filesystem::path& path);

/// Compares a file with the hash in `<path>.sha256`: damaged when they differ; nothing also where there is no
/// hash. A running study that replaces both meanwhile does no harm.
MaybeError check_file_hash(const std::filesystem::path& path);

/// The same after the hash of the whole file, where `<path>.sha256` stands beside it; damaged when it does not
/// match.
Expected<ResultsSummary> read_hashed_summary(const std::filesystem::path& path);

/// `read_trace` in a child process. Errors as above.
Expected<Trace> read_suspect_trace(const std::filesystem::path& path);

}  // namespace unbruised::studies

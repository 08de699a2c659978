#pragma once

/// @file
/// results.h5: columns over scenarios, the window table and traces, in HDF5 that h5py and xarray open
/// without tricks (docs/results.md is the layout).

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "studies/results/expected.hpp"
#include "studies/results/rows.hpp"

namespace unbruised::studies {

/// Root attribute format_version of files this program writes.
inline constexpr int kResultsFormatVersion = 1;

/// The bytes of a results file. Errors: io, with `path` in the sentence.
Expected<std::string> results_image(const std::filesystem::path& path, const ResultsContent& content);

/// Writes them to `path` atomically and durably. Replaces an existing file; a failure leaves that one untouched.
/// Errors: io.
MaybeError write_results_file(const std::filesystem::path& path, const ResultsContent& content);

/// What a results file says, without traces.
struct ResultsSummary {
  int format_version = 0;
  ResultsMeta meta;
  std::vector<ColumnInfo> inputs;
  std::vector<ScenarioRow> rows;       ///< in file order, which is id order
  std::vector<std::uint64_t> digests;  ///< as stored, one per row
  std::optional<WindowTable> window;
  std::vector<ResultTable> tables;  ///< what the study kind found beside, in alphabetical order
  bool has_trace = false;
  std::vector<std::string> trace_signals;  ///< dataset names below /trace

  /// Digest of digests, 16 hex digits.
  [[nodiscard]] std::string digest() const;
  /// Number of rows with this outcome.
  [[nodiscard]] std::size_t count(Outcome outcome) const;
};

/// Reads everything but traces. Errors: io (cannot be opened), foreign (no results file, or a later
/// format), damaged (a checksum or a table does not hold).
Expected<ResultsSummary> read_results_summary(const std::filesystem::path& path);

/// Reads /trace and /contact_events back. Errors as above; foreign when the file holds no trace.
Expected<Trace> read_trace(const std::filesystem::path& path);

}  // namespace unbruised::studies

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
#include "studies/results/paged_file.hpp"
#include "studies/results/rows.hpp"

namespace unbruised::studies {

/// Root attribute format_version of files this program writes.
inline constexpr int kResultsFormatVersion = 1;

/// Rows in the order of their ids.
std::vector<ScenarioRow> by_id(std::vector<ScenarioRow> rows);

/// The bytes of a results file, all in memory. Errors: io, with `path` in the sentence; those of the rows.
Expected<std::string> results_image(const std::filesystem::path& path, const ResultsContent& content);

/// Writes them to `path` atomically and durably, with rows and bytes in memory as they are needed. Replaces an
/// existing file; a failure leaves that one untouched. Errors as above.
MaybeError write_results_file(const std::filesystem::path& path, const ResultsContent& content,
                              std::size_t pages_in_memory = PagedFile::kPagesInMemory);

/// The same with the hash of the file beside it.
MaybeError write_hashed_results(const std::filesystem::path& path, const ResultsContent& content);

/// What a results file says, without traces.
struct ResultsSummary {
  int format_version = 0;
  ResultsMeta meta;
  std::vector<ColumnInfo> inputs;
  StudyRows rows;                      ///< in file order, which is id order
  std::vector<std::uint64_t> digests;  ///< as stored, one per row
  std::uint64_t rows_run = 0;          ///< rows that are not not_run
  std::optional<WindowTable> window;
  std::vector<ResultTable> tables;  ///< what the study kind found beside, in alphabetical order
  bool has_trace = false;
  std::vector<std::string> trace_signals;  ///< dataset names below /trace

  /// Digest of digests, 16 hex digits.
  [[nodiscard]] std::string digest() const;
  /// Number of rows, also of those that were not read.
  [[nodiscard]] std::size_t row_count() const { return digests.size(); }
};

/// Reads everything but traces; rows only where they are no more than `rows_most`. Errors: io (cannot be opened),
/// foreign (no results file, or a later format), damaged (a checksum or a table does not hold).
Expected<ResultsSummary> read_results_summary(const std::filesystem::path& path,
                                              std::size_t rows_most = ~std::size_t{0});

/// Rows `first` to `first` + `count`, or to the end. Errors as above.
Expected<std::vector<ScenarioRow>> read_results_rows(const std::filesystem::path& path, std::uint64_t first,
                                                     std::uint64_t count);

/// Reads /trace and /contact_events back. Errors as above; foreign when the file holds no trace.
Expected<Trace> read_trace(const std::filesystem::path& path);

}  // namespace unbruised::studies

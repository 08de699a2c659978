#pragma once

/// @file
/// A study's tables as the page takes them: one JSON document, and the bytes of its long columns.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "studies/results/rows.hpp"

namespace unbruised::studies {

/// What the page says beside the study's own tables.
struct ReportContext {
  std::string replay_command;           ///< without the id; empty where there is no run directory to replay from
  std::optional<std::uint64_t> wanted;  ///< scenarios of the whole study, where it is known
  std::string source;                   ///< the file or directory that was read, as the user wrote it
  std::string digest;                   ///< digest of digests, 16 hex digits; may stay empty
  std::vector<std::string> summary;     ///< the lines `info` prints
};

struct ReportData {
  std::string json;     ///< ASCII; safe inside a script element: no '<', '>' or '&' in it
  std::string columns;  ///< bytes, see PackedColumns
};

/// Numbers that are not finite become null (NaN in the bytes). Texts that are no UTF-8 get U+FFFD.
ReportData report_data(const ResultsContent& content, const ReportContext& context);

/// `text` with every '<', '>' and '&' written as a JSON escape. They occur in the strings of JSON only.
std::string inert_json(const std::string& text);

/// Most rows of a trace that go into a page.
inline constexpr std::size_t kTraceRowsMost = 4000;

/// For curves with more than kTraceRowsMost rows: which pairs of rows stand for the others. Rows are cut into
/// kTraceRowsMost / 2 equal parts; each part becomes two rows, the lesser and the greater value of every curve in
/// the order in which they occur, so that no peak is lost.
std::vector<double> thinned_keeping_peaks(const std::vector<double>& values);
/// The times that go with them: first and middle row of each part.
std::vector<double> thinned_times(const std::vector<double>& time_s);

}  // namespace unbruised::studies

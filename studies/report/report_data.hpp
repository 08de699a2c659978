#pragma once

/// @file
/// A study's tables as the page takes them: one JSON document, and the bytes of its long columns.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "studies/report/report_replay.hpp"
#include "studies/results/rows.hpp"

namespace unbruised::studies {

/// What the page says beside the study's own tables.
struct ReportContext {
  std::string replay_command;             ///< without the id; empty where there is no run directory to replay from
  std::optional<std::uint64_t> wanted;    ///< scenarios of the whole study, where it is known
  std::string source;                     ///< the file or directory that was read, as the user wrote it
  std::string digest;                     ///< digest of digests, 16 hex digits; may stay empty
  std::vector<std::string> summary;       ///< the lines `info` prints
  std::vector<ScenarioReplay> replays{};  ///< what there is to see
};

struct ReportData {
  std::string json;     ///< ASCII; safe inside a script element: no '<', '>' or '&' in it
  std::string columns;  ///< bytes, see PackedColumns
};

/// Numbers that are not finite become null (NaN in the bytes). Texts that are no UTF-8 get U+FFFD.
ReportData report_data(const ResultsContent& content, const ReportContext& context);

}  // namespace unbruised::studies

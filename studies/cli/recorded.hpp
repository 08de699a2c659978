#pragma once

/// @file
/// What a run directory or a results file holds, read without taking the directory's lock.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "studies/config/study.hpp"
#include "studies/findings/summary.hpp"
#include "studies/results/expected.hpp"
#include "studies/results/rows.hpp"

namespace unbruised::studies {

struct RecordedStudy {
  ResultsMeta meta;
  StudyTables tables;
  bool has_trace = false;
  std::filesystem::path source;  ///< the results file, or the run directory when read from its journal
  bool from_journal = false;
  std::vector<std::string> notes;       ///< of the journals: what a kill left unfinished, results.h5 written anew
  std::vector<std::string> damage;      ///< of the journals: what cannot be believed and is left out
  std::optional<std::uint64_t> wanted;  ///< scenarios of the whole study, where it is known
};

/// Of more rows results.h5 waits for the end of the study, and a page for who asks for it: both take minutes.
inline constexpr std::size_t kRowsCompactedMost = 500000;

/// Reads a results file, or a run directory: its complete results.h5, else its config and journals. Where no
/// process holds the directory and the journals know more than results.h5, that one is brought up to date.
Expected<RecordedStudy> read_recorded(const std::filesystem::path& path);

/// Prints the notes and the damage of the journals; the exit status they ask for.
int print_journal_state(const RecordedStudy& recorded);

/// The run directory it was read from, as the user wrote it; "." where that is the working directory.
std::filesystem::path directory_of(const RecordedStudy& recorded);
/// The command that replays a scenario of a run directory, without the id; empty where there is no config to
/// replay from.
std::string replay_command(const RecordedStudy& recorded, const std::string& program);

/// The row of an id; nothing: there is none.
std::optional<ScenarioRow> recorded_row(const RecordedStudy& recorded, std::uint64_t id);
/// The recorded row of an id in the run directory of this very study; nothing when there is none.
std::optional<ScenarioRow> recorded_row(const std::filesystem::path& directory, const Study& study,
                                        std::uint64_t id);

}  // namespace unbruised::studies

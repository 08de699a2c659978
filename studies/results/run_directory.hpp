#pragma once

/// @file
/// `results/<study name>/`: config.toml, lock, journal/, results.h5, log.txt, and who may write there.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "studies/results/expected.hpp"
#include "studies/results/journal.hpp"
#include "studies/results/journal_index.hpp"
#include "studies/results/rows.hpp"
#include "studies/results/run_lock.hpp"

namespace unbruised::studies {

/// A run directory that this process holds alone. Use:
///   auto opened = RunDirectory::open({...});          // an error, or the directory, new or continued
///   RunDirectory& run = **opened;
///   for (id of the study) if (!run.is_done(id)) ... run.append(row);      // any thread, any order
///   run.finish({.meta = ..., .inputs = ..., .window = &table});           // writes results.h5 atomically
/// Rows found in the journals count as done: a resumed study ends with the digest of an uninterrupted one.
class RunDirectory {
 public:
  struct Request {
    std::filesystem::path directory;
    std::string config_toml;  ///< resolved config; its SHA-256 decides "the same study"
    std::string build;        ///< version and numeric build, one line; another one does not continue a study
    bool fresh = false;       ///< move what is there aside to `<name>.old-<n>` and start anew
    bool part = false;        ///< others may run other parts of the study in it meanwhile; goes without `fresh`
  };

  /// New when nothing is there, continued when the same config was interrupted. Errors: busy (names host
  /// and pid), finished, other_config (names the keys), other_build, foreign (something else is in the directory),
  /// io.
  static Expected<std::unique_ptr<RunDirectory>> open(const Request& request);
  /// A directory that no process holds, with the config it has, to write results.h5 from its journals while no
  /// study runs; a run that starts meanwhile waits. Errors: busy, io.
  static Expected<std::unique_ptr<RunDirectory>> open_for_compaction(const std::filesystem::path& directory);
  ~RunDirectory();
  RunDirectory(const RunDirectory&) = delete;
  RunDirectory& operator=(const RunDirectory&) = delete;

  [[nodiscard]] bool continued() const { return continued_; }
  /// Plain sentences for the user: what was moved aside, continued, torn or damaged.
  [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }
  [[nodiscard]] const std::filesystem::path& directory() const { return directory_; }
  [[nodiscard]] std::filesystem::path results_path() const { return directory_ / "results.h5"; }
  [[nodiscard]] const std::string& config_sha256() const { return config_sha256_; }

  /// Is a row of this id recovered or appended? Thread-safe.
  [[nodiscard]] bool is_done(std::uint64_t id) const;
  /// All rows recovered or appended, by ascending id, as they stand in the journals. Thread-safe.
  /// @param places numbers rows that have some
  [[nodiscard]] StudyRows rows(RowPlaces places = RowPlaces::none) const;
  [[nodiscard]] std::size_t row_count() const;

  /// Appends a scenario row to the journal. Thread-safe. A row whose id is done already is refused (io).
  MaybeError append(const ScenarioRow& row);
  /// Makes every row appended so far durable (call it before the program says how to resume).
  MaybeError commit();
  /// Rows that survive a power loss: recovered ones and acknowledged ones.
  [[nodiscard]] std::uint64_t acknowledged() const;

  /// One line into log.txt; a failure to log is not an error.
  void log(std::string_view line);

  /// Commits the journal and writes results.h5 (tmp, fsync, rename) and results.h5.sha256 from rows(): the end of
  /// a study, and with `meta.complete` false any time before. Thread-safe; does not keep `append` waiting.
  /// @param content meta, inputs, window and trace as wanted; `rows` or `stored` may hold the not_run rows of
  ///   an interrupted study (journalled rows of the same id win). config texts are filled in when empty.
  /// Errors: io; damaged where a journal changed meanwhile.
  MaybeError finish(ResultsContent content);
  /// `strategy.toml`: the study's answer as a file, written anew, or gone where there is no answer.
  MaybeError write_strategy(std::string_view toml);
  MaybeError remove_strategy();
  /// `calibrated.toml`: a product file that the study has made, likewise.
  MaybeError write_product(std::string_view toml);
  MaybeError remove_product();

 private:
  RunDirectory() = default;
  MaybeError prepare(const Request& request);
  MaybeError take_lock(LockPurpose purpose);
  MaybeError move_aside();
  MaybeError begin_new();
  MaybeError begin_part();
  MaybeError continue_old();
  /// Refuses another config; one that differs in its description alone is the same study, under its old text.
  MaybeError take_old_config();
  MaybeError refuse_finished();
  MaybeError refuse_other_build() const;
  MaybeError recover_journals();
  void note_findings(const JournalFindings& findings);
  Expected<JournalWriter*> journal();
  /// The rows that results.h5 is made from.
  StudyRows rows_and(StudyRows others, RowPlaces places) const;

  std::filesystem::path directory_;
  std::string config_toml_;
  std::string config_sha256_;
  std::string build_;
  std::string other_build_;  ///< of the journals, where it is not this one
  bool part_ = false;        ///< others may be writing
  bool continued_ = false;
  std::vector<std::string> notes_;
  RunLock lock_;
  std::mutex results_mutex_;  ///< one writer of results.h5 at a time
  mutable std::mutex mutex_;
  std::unique_ptr<JournalWriter> journal_;
  std::uint64_t recovered_count_ = 0;
  mutable JournalIndex index_;
};

/// What `verify` found. Damage: results or journals cannot be believed (exit 6).
struct VerifyReport {
  std::vector<std::string> damage;
  std::vector<std::string> notes;  ///< checks made, torn tails (a kill leaves them, nothing is lost)
  std::uint64_t journal_rows = 0;
  std::uint64_t results_rows = 0;
  std::string digest;  ///< of results.h5, else of the journal; 16 hex digits
};

/// Checks every checksum of a run directory: journals, config, results.h5 (file hash, fletcher32, digests
/// recomputed from the metrics) and results.h5 against the journals, row by row. Takes no lock.
Expected<VerifyReport> verify_run_directory(const std::filesystem::path& directory);

}  // namespace unbruised::studies

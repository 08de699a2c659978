#pragma once

/// @file
/// The append-only journal: the truth that results.h5 is made from. One file per process; every record
/// carries its own checksums, so a reader knows what it may believe (docs/results.md, "Journal").

#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "studies/results/expected.hpp"
#include "studies/results/rows.hpp"

namespace unbruised::studies {

class FileWindow;

/// What a record holds. The numbers are part of the format.
enum class RecordKind : std::uint16_t {
  scenario = 1,  ///< a ScenarioRow
  session = 2,   ///< text: version and numeric build of the process that writes this file
};

/// One record, checksums already verified when it comes from a reader.
struct JournalRecord {
  RecordKind kind = RecordKind::scenario;
  std::uint64_t id = 0;       ///< scenario id, or the numbering of its kind
  std::uint32_t attempt = 0;  ///< 0 for the first
  std::string payload;
};

/// Payload of a RecordKind::scenario record.
std::string encode_scenario_row(const ScenarioRow& row);
/// The row in a payload; damaged when it does not have the shape of one.
Expected<ScenarioRow> decode_scenario_row(std::uint64_t id, std::string_view payload);

/// Bytes of a journal that hold no believable record although believable records follow them.
struct JournalDamage {
  std::uint64_t offset = 0;
  std::uint64_t bytes = 0;
};

/// What a walk through one journal file found beside its records.
struct JournalState {
  std::uint64_t torn_tail_bytes = 0;       ///< after the last whole record; what a killed process leaves
  std::vector<JournalDamage> damage;       ///< in the middle: never left by a kill
  std::uint64_t other_config_records = 0;  ///< whole records that carry another config's hash
};

/// A record and where it stands; the payload is valid during the visit.
struct SeenRecord {
  RecordKind kind = RecordKind::scenario;
  std::uint64_t id = 0;
  std::uint32_t attempt = 0;
  std::string_view payload;
  std::uint64_t offset = 0;
};
using RecordVisitor = std::function<void(const SeenRecord&)>;

/// Shows every believable record of `path` that carries `config_prefix`, in the order of the file, with some
/// megabytes of it in memory at a time; io when it cannot be read.
Expected<JournalState> walk_journal(const std::filesystem::path& path, std::uint64_t config_prefix,
                                    const RecordVisitor& visit);

/// The same with what it showed.
struct JournalScan : JournalState {
  std::vector<JournalRecord> records;
};

/// Reads every believable record of `path` that carries `config_prefix`; io when it cannot be read.
Expected<JournalScan> scan_journal(const std::filesystem::path& path, std::uint64_t config_prefix);

/// Scans a journal held in memory.
JournalScan scan_journal_bytes(std::string_view bytes, std::uint64_t config_prefix);

/// The first 8 bytes of a SHA-256 given as hex digits.
std::uint64_t config_hash_prefix(std::string_view sha256_hex_digits);

/// Appends records to a new file, one write() each. A record counts as acknowledged after fdatasync, which
/// follows every `kGroupCommitRecords` records or one second after the first unacknowledged one, whichever
/// comes first. After an error the file ends behind its last whole record and every later append fails.
/// Thread-safe.
class JournalWriter {
 public:
  static constexpr std::uint64_t kGroupCommitRecords = 32;

  /// Creates `<directory>/<host>-<pid>-<boot id prefix>.jrnl`; never reuses a file.
  static Expected<std::unique_ptr<JournalWriter>> create(const std::filesystem::path& directory,
                                                         std::uint64_t config_prefix);
  ~JournalWriter();
  JournalWriter(const JournalWriter&) = delete;
  JournalWriter& operator=(const JournalWriter&) = delete;

  /// @param offset where it stands then; may be null
  MaybeError append(const JournalRecord& record, std::uint64_t* offset = nullptr);
  /// Makes every appended record durable, also those from before a failed append; says so when one failed.
  MaybeError commit();
  [[nodiscard]] std::uint64_t appended() const;
  [[nodiscard]] std::uint64_t acknowledged() const;  ///< records that survive a power loss
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  JournalWriter(std::filesystem::path path, int descriptor, std::uint64_t config_prefix);
  MaybeError write_whole(std::string_view bytes);
  MaybeError fail(std::string message);
  void commit_when_due(const std::stop_token& stop);

  std::filesystem::path path_;
  int descriptor_ = -1;
  std::uint64_t config_prefix_ = 0;
  mutable std::mutex mutex_;
  std::mutex sync_mutex_;
  std::condition_variable_any due_;
  std::uint64_t appended_ = 0;
  std::uint64_t acknowledged_ = 0;
  std::uint64_t size_bytes_ = 0;
  MaybeError failure_;
  bool sync_failed_ = false;
  std::jthread committer_;
};

/// Rows that stand at known places of a journal, read one by one, best in the order of the file.
class JournalRowReader {
 public:
  explicit JournalRowReader(std::filesystem::path path);
  ~JournalRowReader();
  JournalRowReader(const JournalRowReader&) = delete;
  JournalRowReader& operator=(const JournalRowReader&) = delete;
  /// @param ahead bytes that will be wanted from there on: they are read together
  /// Errors: io; damaged where no scenario row of this id stands there whole.
  Expected<ScenarioRow> read(std::uint64_t id, std::uint64_t offset, std::uint64_t ahead);

 private:
  std::filesystem::path path_;
  std::unique_ptr<FileWindow> window_;
};

/// The bytes of one record as they stand in a journal: 40 bytes of header, then the payload.
std::string encode_record(const JournalRecord& record, std::uint64_t config_prefix);

}  // namespace unbruised::studies

#include "studies/results/journal.hpp"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <optional>

#include <fcntl.h>
#include <unistd.h>

#include "studies/results/bytes.hpp"
#include "studies/results/checksum.hpp"
#include "studies/results/durable_files.hpp"
#include "studies/text/joined.hpp"

namespace unbruised::studies {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kMagic = "UBJ\n";
constexpr std::uint16_t kVersion = 1;
constexpr std::size_t kHeaderBytes = 40;
constexpr std::size_t kHeaderCheckedBytes = 36;
// Far above any record (a row is under a kilobyte); keeps a damaged length from being believed.
constexpr std::uint32_t kMaxPayloadBytes = 1U << 30;
constexpr std::chrono::seconds kGroupCommitTime{1};

struct Header {
  std::uint16_t version = 0;
  std::uint16_t kind = 0;
  std::uint32_t payload_bytes = 0;
  std::uint32_t payload_crc = 0;
  std::uint64_t id = 0;
  std::uint64_t config_prefix = 0;
  std::uint32_t attempt = 0;
};

std::string encode_header(const Header& header) {
  ByteWriter bytes;
  for (const char c : kMagic) bytes.put(c);
  bytes.put(header.version);
  bytes.put(header.kind);
  bytes.put(header.payload_bytes);
  bytes.put(header.payload_crc);
  bytes.put(header.id);
  bytes.put(header.config_prefix);
  bytes.put(header.attempt);
  bytes.put(crc32c(bytes.text()));
  return bytes.text();
}

std::optional<Header> decode_header(std::string_view bytes) {
  if (bytes.size() < kHeaderBytes || !bytes.starts_with(kMagic)) return std::nullopt;
  ByteReader checked(bytes.substr(kHeaderCheckedBytes, kHeaderBytes - kHeaderCheckedBytes));
  if (checked.get<std::uint32_t>() != crc32c(bytes.substr(0, kHeaderCheckedBytes))) return std::nullopt;
  ByteReader reader(bytes.substr(kMagic.size()));
  Header header;
  header.version = reader.get<std::uint16_t>();
  header.kind = reader.get<std::uint16_t>();
  header.payload_bytes = reader.get<std::uint32_t>();
  header.payload_crc = reader.get<std::uint32_t>();
  header.id = reader.get<std::uint64_t>();
  header.config_prefix = reader.get<std::uint64_t>();
  header.attempt = reader.get<std::uint32_t>();
  if (header.version != kVersion || header.payload_bytes > kMaxPayloadBytes) return std::nullopt;
  return header;
}

}  // namespace

/// A file that is read from front to back, some of it in memory at a time.
class FileWindow {
 public:
  explicit FileWindow(fs::path path) : path_(std::move(path)) {
    descriptor_ = ::open(path_.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor_ < 0) fail("open");
  }
  ~FileWindow() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  FileWindow(const FileWindow&) = delete;
  FileWindow& operator=(const FileWindow&) = delete;

  /// Bytes from `offset` on: `least` of them, fewer where the file ends or cannot be read. Valid until the next
  /// call; what lies in front of `offset` is given up.
  /// @param ahead so many are read where more have to be
  std::string_view at(std::uint64_t offset, std::size_t least, std::size_t ahead = kAhead) {
    if (offset < base_ || offset + least > base_ + bytes_.size()) load(offset, std::max(least, ahead));
    return std::string_view(bytes_).substr(offset - base_);
  }
  [[nodiscard]] const MaybeError& failure() const { return failure_; }

 private:
  static constexpr std::size_t kAhead = std::size_t{4} << 20;

  void fail(std::string_view action) { failure_ = system_error(action, path_, errno); }

  void load(std::uint64_t offset, std::size_t wanted) {
    if (offset >= base_ && offset <= base_ + bytes_.size()) {
      bytes_.erase(0, offset - base_);
    } else {
      bytes_.clear();
    }
    base_ = offset;
    std::size_t have = bytes_.size();
    if (failure_ || have >= wanted) return;
    bytes_.resize(wanted);
    while (have < wanted) {
      const ssize_t length =
          ::pread(descriptor_, bytes_.data() + have, wanted - have, static_cast<off_t>(base_ + have));
      if (length < 0 && errno == EINTR) continue;
      if (length < 0) fail("read");
      if (length <= 0) break;
      have += static_cast<std::size_t>(length);
    }
    bytes_.resize(have);
  }

  fs::path path_;
  int descriptor_ = -1;
  std::uint64_t base_ = 0;
  std::string bytes_;
  MaybeError failure_;
};

namespace {

/// Bytes that are all in memory, asked like a FileWindow.
class MemoryWindow {
 public:
  explicit MemoryWindow(std::string_view bytes) : bytes_(bytes) {}
  std::string_view at(std::uint64_t offset, std::size_t /*least*/) {
    return bytes_.substr(std::min<std::uint64_t>(offset, bytes_.size()));
  }

 private:
  std::string_view bytes_;
};

// The whole record at `offset`, or nothing when header or payload cannot be believed.
template <class Window>
std::optional<std::pair<Header, std::string_view>> record_at(Window& window, std::uint64_t offset) {
  const auto header = decode_header(window.at(offset, kHeaderBytes));
  if (!header) return std::nullopt;
  const std::string_view bytes = window.at(offset, kHeaderBytes + header->payload_bytes);
  if (bytes.size() - kHeaderBytes < header->payload_bytes) return std::nullopt;
  const std::string_view payload = bytes.substr(kHeaderBytes, header->payload_bytes);
  if (crc32c(payload) != header->payload_crc) return std::nullopt;
  return std::pair{*header, payload};
}

// Offset of the next whole record from `from` on; nothing where there is none.
template <class Window>
std::optional<std::uint64_t> next_record(Window& window, std::uint64_t from) {
  constexpr std::size_t kLookedAtOnce = std::size_t{64} << 10;
  for (;;) {
    const std::string_view bytes = window.at(from, kLookedAtOnce);
    const std::size_t found = bytes.find(kMagic);
    if (found != std::string_view::npos) {
      from += found;
      if (record_at(window, from)) return from;
      ++from;
    } else if (bytes.size() < kLookedAtOnce) {
      return std::nullopt;
    } else {
      from += bytes.size() - kMagic.size() + 1;
    }
  }
}

template <class Window>
std::uint64_t rest_bytes(Window& window, std::uint64_t from) {
  std::uint64_t count = 0;
  for (std::string_view rest = window.at(from, 1); !rest.empty(); rest = window.at(from + count, 1)) {
    count += rest.size();
  }
  return count;
}

template <class Window>
JournalState walk(Window& window, std::uint64_t config_prefix, const RecordVisitor& visit) {
  JournalState state;
  std::uint64_t at = 0;
  while (!window.at(at, 1).empty()) {
    const auto record = record_at(window, at);
    if (!record) {
      const auto next = next_record(window, at + 1);
      if (!next) break;
      state.damage.push_back({at, *next - at});
      at = *next;
      continue;
    }
    const auto& [header, payload] = *record;
    const std::size_t length = kHeaderBytes + payload.size();
    if (header.config_prefix == config_prefix) {
      visit({static_cast<RecordKind>(header.kind), header.id, header.attempt, payload, at});
    } else {
      ++state.other_config_records;
    }
    at += length;
  }
  state.torn_tail_bytes = rest_bytes(window, at);
  return state;
}

void put_input(ByteWriter& bytes, const InputValue& value) {
  bytes.put(static_cast<std::uint8_t>(value.index()));
  if (const auto* number = std::get_if<double>(&value)) bytes.put(*number);
  if (const auto* text = std::get_if<std::string>(&value)) bytes.put_text(*text);
}

InputValue get_input(ByteReader& reader) {
  if (reader.get<std::uint8_t>() == 0) return reader.get<double>();
  return reader.get_text();
}

void put_inputs(ByteWriter& bytes, const std::vector<InputValue>& inputs) {
  bytes.put(static_cast<std::uint32_t>(inputs.size()));
  for (const InputValue& value : inputs) put_input(bytes, value);
}

std::vector<InputValue> get_inputs(ByteReader& reader) {
  const auto count = reader.get<std::uint32_t>();
  std::vector<InputValue> inputs;
  for (std::uint32_t i = 0; i < count && reader.ok(); ++i) inputs.push_back(get_input(reader));
  return inputs;
}

ResultsError misshapen_row() {
  return {ResultsErrorKind::damaged, "a journal record is not a scenario row of this version", {}};
}

}  // namespace

std::string encode_scenario_row(const ScenarioRow& row) {
  ByteWriter bytes;
  bytes.put(static_cast<std::int8_t>(row.result.outcome));
  bytes.put(row.result.outcome_time_s);
  bytes.put(static_cast<std::uint32_t>(kMetricCount));
  for (const double value : row.result.metrics.values()) bytes.put(value);
  bytes.put_text(row.result.cause);
  put_inputs(bytes, row.inputs);
  return bytes.text();
}

Expected<ScenarioRow> decode_scenario_row(std::uint64_t id, std::string_view payload) {
  ByteReader reader(payload);
  ScenarioRow row;
  row.id = id;
  const auto outcome = reader.get<std::int8_t>();
  row.result.outcome_time_s = reader.get<double>();
  const auto metric_count = reader.get<std::uint32_t>();
  const bool known_outcome = outcome >= -1 && outcome < static_cast<int>(kOutcomeWords.size());
  if (!reader.ok() || !known_outcome || metric_count != kMetricCount) return misshapen_row();
  row.result.outcome = static_cast<Outcome>(outcome);
  for (double& value : row.result.metrics.values()) value = reader.get<double>();
  row.result.cause = reader.get_text();
  row.inputs = get_inputs(reader);
  if (!reader.at_end()) return misshapen_row();
  return row;
}

std::string encode_record(const JournalRecord& record, std::uint64_t config_prefix) {
  Header header;
  header.version = kVersion;
  header.kind = static_cast<std::uint16_t>(record.kind);
  header.payload_bytes = static_cast<std::uint32_t>(record.payload.size());
  header.payload_crc = crc32c(record.payload);
  header.id = record.id;
  header.config_prefix = config_prefix;
  header.attempt = record.attempt;
  return encode_header(header) + record.payload;
}

std::uint64_t config_hash_prefix(std::string_view sha256_hex_digits) {
  std::uint64_t prefix = 0;
  const std::string_view digits = sha256_hex_digits.substr(0, 16);
  std::from_chars(digits.data(), digits.data() + digits.size(), prefix, 16);
  return prefix;
}

namespace {

/// Puts what is shown into a scan.
RecordVisitor into(JournalScan& scan) {
  return [&scan](const SeenRecord& record) {
    scan.records.push_back({record.kind, record.id, record.attempt, std::string(record.payload)});
  };
}

}  // namespace

JournalScan scan_journal_bytes(std::string_view bytes, std::uint64_t config_prefix) {
  JournalScan scan;
  MemoryWindow window(bytes);
  static_cast<JournalState&>(scan) = walk(window, config_prefix, into(scan));
  return scan;
}

Expected<JournalState> walk_journal(const fs::path& path, std::uint64_t config_prefix,
                                    const RecordVisitor& visit) {
  FileWindow window(path);
  JournalState state = walk(window, config_prefix, visit);
  if (window.failure()) return *window.failure();
  return state;
}

Expected<JournalScan> scan_journal(const fs::path& path, std::uint64_t config_prefix) {
  JournalScan scan;
  auto state = walk_journal(path, config_prefix, into(scan));
  if (!state) return state.error();
  static_cast<JournalState&>(scan) = *std::move(state);
  return scan;
}

JournalRowReader::JournalRowReader(fs::path path)
    : path_(std::move(path)), window_(std::make_unique<FileWindow>(path_)) {}

JournalRowReader::~JournalRowReader() = default;

Expected<ScenarioRow> JournalRowReader::read(std::uint64_t id, std::uint64_t offset, std::uint64_t ahead) {
  (void)window_->at(offset, kHeaderBytes, ahead);
  const auto record = record_at(*window_, offset);
  if (window_->failure()) return *window_->failure();
  const bool is_row =
      record && record->first.id == id && record->first.kind == static_cast<std::uint16_t>(RecordKind::scenario);
  if (is_row) return decode_scenario_row(id, record->second);
  return ResultsError{ResultsErrorKind::damaged,
                      joined({path_.string(), " changed while it was read: scenario ", std::to_string(id),
                              " is no longer at offset ", std::to_string(offset)}),
                      {}};
}

namespace {

// Opens a file that did not exist: a process id may come again within one boot (containers).
Expected<std::pair<fs::path, int>> create_journal_file(const fs::path& directory) {
  const std::string stem = joined({host_name(), "-", std::to_string(::getpid()), "-", boot_id().substr(0, 8)});
  for (int attempt = 1; attempt <= 10000; ++attempt) {
    const std::string suffix = attempt == 1 ? std::string() : joined({"-", std::to_string(attempt)});
    const fs::path path = directory / (stem + suffix + ".jrnl");
    const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, 0644);
    if (descriptor >= 0) return std::pair{path, descriptor};
    if (errno != EEXIST) return system_error("create", path, errno);
  }
  return system_error("create", directory / (stem + ".jrnl"), EEXIST);
}

}  // namespace

Expected<std::unique_ptr<JournalWriter>> JournalWriter::create(const fs::path& directory,
                                                               std::uint64_t config_prefix) {
  auto file = create_journal_file(directory);
  if (!file) return file.error();
  auto& [path, descriptor] = *file;
  if (auto error = sync_directory(directory)) {
    ::close(descriptor);
    return *error;
  }
  return std::unique_ptr<JournalWriter>(new JournalWriter(path, descriptor, config_prefix));
}

JournalWriter::JournalWriter(fs::path path, int descriptor, std::uint64_t config_prefix)
    : path_(std::move(path)), descriptor_(descriptor), config_prefix_(config_prefix) {
  committer_ = std::jthread([this](const std::stop_token& stop) { commit_when_due(stop); });
}

JournalWriter::~JournalWriter() {
  committer_.request_stop();
  committer_.join();
  (void)commit();
  ::close(descriptor_);
}

MaybeError JournalWriter::fail(std::string message) {
  failure_ = ResultsError{ResultsErrorKind::io, std::move(message), {}};
  return failure_;
}

// One write(). A short one is cut off again, so that the file always ends behind a whole record.
MaybeError JournalWriter::write_whole(std::string_view bytes) {
  ssize_t written = -1;
  do {
    written = ::write(descriptor_, bytes.data(), bytes.size());
  } while (written < 0 && errno == EINTR);
  if (written == static_cast<ssize_t>(bytes.size())) {
    size_bytes_ += bytes.size();
    return {};
  }
  const int reason = written < 0 ? errno : ENOSPC;
  if (written > 0 && ::ftruncate(descriptor_, static_cast<off_t>(size_bytes_)) != 0) {
    return fail(system_error("truncate", path_, errno).message);
  }
  return fail(system_error("write", path_, reason).message);
}

MaybeError JournalWriter::append(const JournalRecord& record, std::uint64_t* offset) {
  const std::string bytes = encode_record(record, config_prefix_);
  bool group_is_full = false;
  {
    const std::lock_guard lock(mutex_);
    if (failure_) return failure_;
    if (offset != nullptr) *offset = size_bytes_;
    if (auto error = write_whole(bytes)) return error;
    ++appended_;
    group_is_full = appended_ - acknowledged_ >= kGroupCommitRecords;
    if (appended_ - acknowledged_ == 1) due_.notify_all();
  }
  return group_is_full ? commit() : MaybeError{};
}

MaybeError JournalWriter::commit() {
  const std::lock_guard one_at_a_time(sync_mutex_);
  std::uint64_t reached = 0;
  {
    const std::lock_guard lock(mutex_);
    if (sync_failed_ || acknowledged_ == appended_) return failure_;
    reached = appended_;
  }
  const int outcome = ::fdatasync(descriptor_);
  const int reason = errno;
  const std::lock_guard lock(mutex_);
  // After a failed sync the kernel may have dropped the pages: nothing later can be trusted either.
  if (outcome != 0) {
    sync_failed_ = true;
    return fail(system_error("sync", path_, reason).message);
  }
  acknowledged_ = reached;
  return failure_;
}

void JournalWriter::commit_when_due(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (!stop.stop_requested()) {
    due_.wait(lock, stop, [this] { return appended_ > acknowledged_ && !sync_failed_; });
    due_.wait_for(lock, stop, kGroupCommitTime, [] { return false; });
    if (stop.stop_requested()) return;
    lock.unlock();
    (void)commit();
    lock.lock();
  }
}

std::uint64_t JournalWriter::appended() const {
  const std::lock_guard lock(mutex_);
  return appended_;
}

std::uint64_t JournalWriter::acknowledged() const {
  const std::lock_guard lock(mutex_);
  return acknowledged_;
}

}  // namespace unbruised::studies

#include "studies/results/journal.hpp"

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

// The whole record at the start of `bytes`, or nothing when header or payload cannot be believed.
std::optional<std::pair<Header, std::string_view>> record_at(std::string_view bytes) {
  const auto header = decode_header(bytes);
  if (!header || bytes.size() - kHeaderBytes < header->payload_bytes) return std::nullopt;
  const std::string_view payload = bytes.substr(kHeaderBytes, header->payload_bytes);
  if (crc32c(payload) != header->payload_crc) return std::nullopt;
  return std::pair{*header, payload};
}

// Offset of the next whole record behind `from`, or npos.
std::size_t next_record(std::string_view bytes, std::size_t from) {
  for (std::size_t at = bytes.find(kMagic, from); at != std::string_view::npos; at = bytes.find(kMagic, at + 1)) {
    if (record_at(bytes.substr(at))) return at;
  }
  return std::string_view::npos;
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

JournalScan scan_journal_bytes(std::string_view bytes, std::uint64_t config_prefix) {
  JournalScan scan;
  std::size_t at = 0;
  while (at < bytes.size()) {
    const auto record = record_at(bytes.substr(at));
    if (!record) {
      const std::size_t next = next_record(bytes, at + 1);
      if (next == std::string_view::npos) break;
      scan.damage.push_back({at, next - at});
      at = next;
      continue;
    }
    const auto& [header, payload] = *record;
    if (header.config_prefix == config_prefix) {
      scan.records.push_back(
          {static_cast<RecordKind>(header.kind), header.id, header.attempt, std::string(payload)});
    } else {
      ++scan.other_config_records;
    }
    at += kHeaderBytes + payload.size();
  }
  scan.torn_tail_bytes = bytes.size() - at;
  return scan;
}

Expected<JournalScan> scan_journal(const fs::path& path, std::uint64_t config_prefix) {
  const auto bytes = read_text_file(path);
  if (!bytes) return bytes.error();
  return scan_journal_bytes(*bytes, config_prefix);
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

MaybeError JournalWriter::append(const JournalRecord& record) {
  const std::string bytes = encode_record(record, config_prefix_);
  bool group_is_full = false;
  {
    const std::lock_guard lock(mutex_);
    if (failure_) return failure_;
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

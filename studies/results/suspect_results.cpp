#include "studies/results/suspect_results.hpp"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <string_view>
#include <type_traits>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "studies/results/durable_files.hpp"
#include "studies/results/root_texts.hpp"
#include "studies/results/run_layout.hpp"
#include "studies/results/window_columns.hpp"
#include "studies/text/joined.hpp"

namespace unbruised::studies {

namespace fs = std::filesystem;

namespace {

// -- The child. --------------------------------------------------------------------------------------------

/// Processor time after which a reader is believed to hang: a gigabyte takes a few seconds.
constexpr rlim_t kChildSecondsMost = 600;

/// Ends the child's answer: without it the answer is not whole.
constexpr std::string_view kEndMark = "the answer is whole";

void limit(int resource, rlim_t most) {
  const rlimit wanted{most, most};
  ::setrlimit(static_cast<__rlimit_resource>(resource), &wanted);
}

[[noreturn]] void answer_and_end(int descriptor, const std::function<std::string()>& body) {
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU, kChildSecondsMost);
  if (const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC); nowhere >= 0) ::dup2(nowhere, STDERR_FILENO);
  std::string answer;
  try {
    answer = body();
  } catch (...) {
    ::_exit(1);
  }
  answer.append(kEndMark);
  for (std::string_view rest = answer; !rest.empty();) {
    const ssize_t written = ::write(descriptor, rest.data(), rest.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) ::_exit(1);
    rest.remove_prefix(static_cast<std::size_t>(written));
  }
  ::_exit(0);
}

std::string text_until_end(int descriptor) {
  std::string text;
  std::vector<char> buffer(std::size_t{1} << 16);
  for (;;) {
    const ssize_t length = ::read(descriptor, buffer.data(), buffer.size());
    if (length < 0 && errno == EINTR) continue;
    if (length <= 0) return text;
    text.append(buffer.data(), static_cast<std::size_t>(length));
  }
}

int status_of(pid_t child) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

std::string how_it_ended(int status) {
  if (!WIFSIGNALED(status)) return "gave up on it";
  if (WTERMSIG(status) == SIGXCPU) return "did not come to an end with it";
  return joined({"crashed on it (", ::strsignal(WTERMSIG(status)), ")"});
}

// -- What the child says: the same lines write and read. -----------------------------------------------------

class Sender {
 public:
  template <class T>
  void plain(T& value) {
    text_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void bytes(std::string& value) {
    std::uint64_t length = value.size();
    plain(length);
    text_.append(value);
  }
  template <class T>
  void plains(std::vector<T>& values) {
    std::uint64_t length = values.size();
    plain(length);
    text_.append(reinterpret_cast<const char*>(values.data()), length * sizeof(T));
  }
  template <class T>
  std::uint64_t resize(std::vector<T>& values) {
    std::uint64_t length = values.size();
    plain(length);
    return length;
  }
  template <class T>
  bool has(std::optional<T>& value) {
    bool there = value.has_value();
    plain(there);
    return there;
  }
  template <class... T>
  void pick(std::variant<T...>& value) {
    auto index = static_cast<std::uint8_t>(value.index());
    plain(index);
  }
  std::string text_;
};

class Receiver {
 public:
  explicit Receiver(std::string_view text) : rest_(text) {}
  template <class T>
  void plain(T& value) {
    take(&value, sizeof value);
  }
  void bytes(std::string& value) {
    value.resize(length(1));
    take(value.data(), value.size());
  }
  template <class T>
  void plains(std::vector<T>& values) {
    values.resize(length(sizeof(T)));
    take(values.data(), values.size() * sizeof(T));
  }
  template <class T>
  std::uint64_t resize(std::vector<T>& values) {
    values.resize(length(1));
    return values.size();
  }
  template <class T>
  bool has(std::optional<T>& value) {
    bool there = false;
    plain(there);
    if (there) value.emplace();
    return there;
  }
  template <class A, class B>
  void pick(std::variant<A, B>& value) {
    std::uint8_t index = 0;
    plain(index);
    if (index == 1) {
      value = B{};
    } else {
      value = A{};
    }
  }
  [[nodiscard]] bool all_taken() const { return ok_ && rest_.empty(); }

 private:
  void take(void* target, std::size_t size) {
    ok_ = ok_ && size <= rest_.size();
    if (!ok_ || size == 0) return;
    std::memcpy(target, rest_.data(), size);
    rest_.remove_prefix(size);
  }
  std::uint64_t length(std::uint64_t element_bytes) {
    std::uint64_t count = 0;
    plain(count);
    ok_ = ok_ && count <= rest_.size() / element_bytes;
    return ok_ ? count : 0;
  }
  std::string_view rest_;
  bool ok_ = true;
};

template <class Way>
void pass(Way& way, std::string& text) {
  way.bytes(text);
}

template <class Way>
void pass(Way& way, double& number) {
  way.plain(number);
}

template <class Way>
void pass(Way& way, std::vector<double>& numbers) {
  way.plains(numbers);
}

template <class Way, class T>
void pass(Way& way, std::vector<T>& values) {
  way.resize(values);
  for (T& value : values) pass(way, value);
}

template <class Way, class A, class B>
void pass(Way& way, std::variant<A, B>& value) {
  way.pick(value);
  std::visit([&way](auto& held) { pass(way, held); }, value);
}

template <class Way>
void pass(Way& way, ColumnInfo& column) {
  for (std::string* text : {&column.key, &column.units, &column.long_name}) way.bytes(*text);
}

template <class Way>
void pass(Way& way, ResultsMeta& meta) {
  for (const RootText& root : kRootTexts) way.bytes(meta.*root.text);
  way.plain(meta.complete);
  pass(way, meta.warnings);
}

template <class Way>
void pass(Way& way, ScenarioRow& row) {
  way.plain(row.id);
  way.plain(row.result.outcome);
  way.plain(row.result.outcome_time_s);
  for (double& value : row.result.metrics.values()) way.plain(value);
  way.bytes(row.result.cause);
  pass(way, row.inputs);
  if (way.has(row.place)) way.plain(*row.place);
}

template <class Way>
void pass(Way& way, WindowRow& row) {
  pass(way, row.inputs);
  for (const WindowNumber& column : kWindowNumbers) way.plain(row.*column.value);
  for (const WindowFlag& flag : kWindowFlags) way.plain(row.*flag.value);
  for (const WindowText& text : kWindowTexts) way.bytes(row.*text.value);
}

template <class Way>
void pass(Way& way, ResultColumn& column) {
  for (std::string* text : {&column.name, &column.units, &column.long_name}) way.bytes(*text);
  pass(way, column.values);
}

template <class Way>
void pass(Way& way, std::pair<std::string, std::variant<double, std::string>>& attribute) {
  way.bytes(attribute.first);
  pass(way, attribute.second);
}

template <class Way>
void pass(Way& way, ResultTable& table) {
  way.bytes(table.name);
  way.bytes(table.row);
  pass(way, table.columns);
  pass(way, table.attributes);
}

template <class Way>
void pass(Way& way, ResultsSummary& summary) {
  way.plain(summary.format_version);
  pass(way, summary.meta);
  pass(way, summary.inputs);
  pass(way, summary.rows);
  way.plains(summary.digests);
  if (way.has(summary.window)) {
    pass(way, summary.window->inputs);
    pass(way, summary.window->rows);
  }
  pass(way, summary.tables);
  way.plain(summary.has_trace);
  pass(way, summary.trace_signals);
}

template <class Way>
void pass(Way& way, TraceSignal& signal) {
  for (std::string* text : {&signal.name, &signal.units, &signal.long_name}) way.bytes(*text);
  pass(way, signal.dimensions);
  way.plains(signal.extents);
  way.plains(signal.values);
}

template <class Way>
void pass(Way& way, Trace& trace) {
  way.plain(trace.particle_count);
  for (std::vector<double>* values : {&trace.rest_position_m, &trace.time_s, &trace.displacement_m,
                                      &trace.velocity_m_s, &trace.acceleration_m_s2}) {
    way.plains(*values);
  }
  pass(way, trace.signals);
  way.plains(trace.events);
}

template <class Way>
void pass(Way& way, ResultsError& error) {
  way.plain(error.kind);
  way.bytes(error.message);
  pass(way, error.keys);
}

template <class T>
std::string packed(Expected<T> answer) {
  Sender sender;
  bool has_value = answer.has_value();
  sender.plain(has_value);
  if (has_value) {
    pass(sender, *answer);
  } else {
    ResultsError error = answer.error();
    pass(sender, error);
  }
  return std::move(sender.text_);
}

template <class T>
Expected<T> unpacked(std::string_view text) {
  Receiver receiver(text);
  bool has_value = false;
  receiver.plain(has_value);
  T value{};
  ResultsError error;
  if (has_value) {
    pass(receiver, value);
  } else {
    pass(receiver, error);
  }
  if (!receiver.all_taken())
    return ResultsError{ResultsErrorKind::io, "the reading process was misunderstood", {}};
  if (!has_value) return error;
  return value;
}

/// Busy where another program has the file open for writing: HDF5 locks what it writes.
MaybeError refuse_if_in_use(const fs::path& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return {};  // what reads the file says so
  const bool in_use = ::flock(file, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  ::close(file);
  if (!in_use) return {};
  return ResultsError{
      ResultsErrorKind::busy,
      joined({path.string(), " is in use: another program has it open for writing; close it there and try again"}),
      {}};
}

template <class T>
Expected<T> read_in_child(const fs::path& path, Expected<T> (*read)(const fs::path&)) {
  if (auto error = refuse_if_in_use(path)) return *error;
  const auto text = in_child_process(path, [&] { return packed(read(path)); });
  if (!text) return text.error();
  return unpacked<T>(*text);
}

/// A running study may replace the file between the reading of hash and file, so a mismatch is looked at again.
constexpr int kLooksAtTheHash = 5;

}  // namespace

Expected<std::string> in_child_process(const fs::path& path, const std::function<std::string()>& body) {
  int ends[2] = {-1, -1};
  if (::pipe2(ends, O_CLOEXEC) != 0) return system_error("start a process to read", path, errno);
  const pid_t child = ::fork();
  const int reason = errno;
  if (child == 0) {
    ::close(ends[0]);  // else a child whose parent was killed would wait for a reader for ever
    answer_and_end(ends[1], body);
  }
  ::close(ends[1]);
  if (child < 0) {
    ::close(ends[0]);
    return system_error("start a process to read", path, reason);
  }
  std::string text = text_until_end(ends[0]);
  ::close(ends[0]);
  const int status = status_of(child);
  if (status == 0 && text.ends_with(kEndMark)) {
    text.resize(text.size() - kEndMark.size());
    return text;
  }
  return ResultsError{ResultsErrorKind::damaged,
                      joined({path.string(), " is damaged: the process that read it with the HDF5 library ",
                              how_it_ended(status)}),
                      {}};
}

Expected<ResultsSummary> read_suspect_summary(const fs::path& path) {
  return read_in_child<ResultsSummary>(path, read_results_summary);
}

MaybeError check_file_hash(const fs::path& path) {
  for (int look = 1; look <= kLooksAtTheHash; ++look) {
    const auto before = read_text_file(hash_path(path));
    const auto bytes = before ? read_text_file(path) : before;
    if (!before || !bytes) return {};  // no hash, or nothing to read: what reads the file says so
    if (*before == hash_line(*bytes)) return {};
    const auto after = read_text_file(hash_path(path));
    if (after && *after == *before && look > 1) {
      return ResultsError{ResultsErrorKind::damaged,
                          joined({path.string(), " is damaged: it does not match ", hash_path(path).string()}),
                          {}};
    }
    ::usleep(20000);
  }
  return {};
}

Expected<ResultsSummary> read_hashed_summary(const fs::path& path) {
  if (auto error = refuse_if_in_use(path)) return *error;
  if (auto error = check_file_hash(path)) return *error;
  return read_suspect_summary(path);
}

Expected<Trace> read_suspect_trace(const fs::path& path) { return read_in_child<Trace>(path, read_trace); }

}  // namespace unbruised::studies

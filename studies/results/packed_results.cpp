// The same lines write and read: `pass` moves a value along a way, a Sender or a Receiver.

#include "studies/results/packed_results.hpp"

#include <cstdint>
#include <cstring>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "studies/results/journal.hpp"
#include "studies/results/root_texts.hpp"
#include "studies/results/window_columns.hpp"

namespace unbruised::studies {
namespace {

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
  /// As in the journal.
  void row(ScenarioRow& row) {
    std::string payload = encode_scenario_row(row);
    bytes(payload);
  }
  void rows(const StudyRows& rows);
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
  void row(ScenarioRow& row) {
    std::string payload;
    bytes(payload);
    auto decoded = decode_scenario_row(row.id, payload);
    ok_ = ok_ && decoded.has_value();
    if (ok_) row = std::move(*decoded);
  }
  void rows(StudyRows& rows);
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
  way.row(row);
  if (way.has(row.place)) way.plain(*row.place);
}

void Sender::rows(const StudyRows& rows) {
  std::uint64_t count = rows.size();
  plain(count);
  for (ScenarioRow row : rows) pass(*this, row);
}

void Receiver::rows(StudyRows& rows) {
  std::vector<ScenarioRow> received(length(1));
  for (ScenarioRow& row : received) pass(*this, row);
  rows = std::move(received);
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
  way.rows(summary.rows);
  way.plains(summary.digests);
  way.plain(summary.rows_run);
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
std::string pack(Expected<T> answer) {
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

}  // namespace

std::string packed(Expected<ResultsSummary> answer) { return pack(std::move(answer)); }
std::string packed(Expected<Trace> answer) { return pack(std::move(answer)); }
std::string packed(Expected<std::vector<ScenarioRow>> answer) { return pack(std::move(answer)); }

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

template Expected<ResultsSummary> unpacked(std::string_view bytes);
template Expected<Trace> unpacked(std::string_view bytes);
template Expected<std::vector<ScenarioRow>> unpacked(std::string_view bytes);

}  // namespace unbruised::studies

#include "studies/findings/trace_curves.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/surface/surfaces.hpp"
#include "studies/text/joined.hpp"

namespace unbruised::studies {

namespace {

/// "friction" of entry 3 in "energy lost since the start: 0 product damping, 1 plastic flow, ..."; empty where the
/// text has no such list.
std::string coded_word(const std::string& text, std::size_t code) {
  const std::string begin = joined({code == 0 ? ": " : ", ", std::to_string(code), " "});
  const std::size_t at = text.find(begin);
  if (at == std::string::npos) return {};
  const std::size_t from = at + begin.size();
  return text.substr(from, text.find(',', from) - from);
}

}  // namespace

std::size_t width_of(const TraceSignal& signal) {
  std::size_t width = 1;
  for (const int extent : signal.extents) width *= static_cast<std::size_t>(std::max(extent, 0));
  return width;
}

bool is_whole(const Trace& trace, const TraceSignal& signal) {
  const std::size_t width = width_of(signal);
  return signal.dimensions.size() == signal.extents.size() && width > 0 && width <= kSignalColumnsMost &&
         signal.values.size() == trace.time_s.size() * width;
}

std::string curve_name(const TraceSignal& signal, std::size_t entry) {
  static constexpr const char* kAxes[] = {"x", "y", "z"};
  std::string text;
  std::size_t rest = entry;
  for (std::size_t i = signal.extents.size(); i-- > 0;) {
    const auto extent = static_cast<std::size_t>(signal.extents[i]);
    const std::size_t at = rest % extent;
    rest /= extent;
    const std::string& dimension = signal.dimensions[i];
    std::string part = dimension + " " + std::to_string(at + 1);
    if (dimension == "component" && extent == 3) part = kAxes[at];
    if (dimension == "surface") part = surface_name(static_cast<int>(at));
    if (dimension == "cause" || dimension == "source" || dimension == "surface") {
      if (std::string word = coded_word(signal.long_name, at); !word.empty()) part = std::move(word);
    }
    text = text.empty() ? part : part + ", " + text;
  }
  return text;
}

std::string surface_word(const Trace& trace, int number) {
  const auto counts = std::find_if(trace.signals.begin(), trace.signals.end(),
                                   [](const TraceSignal& signal) { return signal.name == "contact_count"; });
  std::string word;
  if (counts != trace.signals.end()) word = coded_word(counts->long_name, static_cast<std::size_t>(number));
  return word.empty() ? surface_name(number) : word;
}

ResultTable trace_as_table(const Trace& trace) {
  ResultTable table{.name = "trace", .row = "time", .columns = {}, .attributes = {}};
  table.columns.push_back(
      {.name = "time_s", .units = "s", .long_name = "since the start of the scenario", .values = trace.time_s});
  for (const TraceSignal& signal : trace.signals) {
    if (!is_whole(trace, signal)) continue;
    const std::size_t width = width_of(signal);
    for (std::size_t entry = 0; entry < width; ++entry) {
      std::vector<double> values;
      values.reserve(trace.time_s.size());
      for (std::size_t row = entry; row < signal.values.size(); row += width) values.push_back(signal.values[row]);
      const std::string name = curve_name(signal, entry);
      table.columns.push_back({.name = name.empty() ? signal.name : joined({signal.name, " [", name, "]"}),
                               .units = signal.units,
                               .long_name = signal.long_name,
                               .values = std::move(values)});
    }
  }
  return table;
}

bool is_counted(const TraceSignal& signal) { return signal.name == "phase" || signal.name.ends_with("_count"); }

std::optional<TraceInstant> trace_at(const Trace& trace, double time_s) {
  const std::vector<double>& times = trace.time_s;
  if (times.empty()) return std::nullopt;
  // As near to a row as this it is that row: times of rows are multiples of a step, rounded.
  const double near_s = 1e-9 * std::max(1.0, times.back());
  if (!(time_s >= times.front() - near_s) || !(time_s <= times.back() + near_s)) return std::nullopt;
  const auto next = std::lower_bound(times.begin(), times.end(), time_s - near_s);
  const auto after = static_cast<std::size_t>(next - times.begin());
  const std::size_t before = *next > time_s + near_s ? after - 1 : after;
  const double span_s = times[after] - times[before];
  const double part = span_s > 0.0 ? (time_s - times[before]) / span_s : 0.0;
  TraceInstant instant{time_s, times[before], times[after], {}};
  for (const TraceSignal& signal : trace.signals) {
    if (!is_whole(trace, signal)) continue;
    TraceSignal& now = instant.signals.emplace_back(
        TraceSignal{signal.name, signal.units, signal.long_name, signal.dimensions, signal.extents, {}});
    const std::size_t width = width_of(signal);
    const double* from = signal.values.data() + before * width;
    const double* to = signal.values.data() + after * width;
    const bool turns = signal.dimensions.size() == 1 && signal.dimensions.front() == "quaternion";
    // -q is the same rotation as q: the nearer of the two.
    const double sign = turns && std::inner_product(from, from + width, to, 0.0) < 0.0 ? -1.0 : 1.0;
    for (std::size_t i = 0; i < width; ++i) {
      now.values.push_back(is_counted(signal) || before == after ? from[i]
                                                                 : from[i] + part * (sign * to[i] - from[i]));
    }
    if (!turns) continue;
    const auto& q = now.values;
    const double length = std::sqrt(std::inner_product(q.begin(), q.end(), q.begin(), 0.0));
    for (double& value : now.values) value /= length;
  }
  return instant;
}

}  // namespace unbruised::studies

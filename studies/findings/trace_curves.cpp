#include "studies/findings/trace_curves.hpp"

#include <algorithm>
#include <utility>

#include "core/surface/surfaces.hpp"
#include "studies/text/joined.hpp"

namespace unbruised::studies {

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
    text = text.empty() ? part : part + ", " + text;
  }
  return text;
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

}  // namespace unbruised::studies

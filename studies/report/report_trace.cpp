#include "studies/report/report_trace.hpp"

#include <algorithm>
#include <string>

#include <nlohmann/json.hpp>

#include "studies/findings/trace_curves.hpp"

namespace unbruised::studies {
namespace {

using nlohmann::json;
using Digits = PackedColumns::Digits;

/// Of more contact events than this an even pick is in a page.
constexpr std::size_t kEventsMost = 6000;

std::size_t part_start(std::size_t part, std::size_t rows) { return part * rows / (kTraceRowsMost / 2); }

/// What the contact state register saw: when, of which surface, and what.
json contacts_json(PackedColumns& packed, const Trace& trace) {
  const std::size_t count = trace.events.size();
  const std::size_t kept = std::min(count, kEventsMost);
  std::vector<double> times;
  std::vector<std::string> surfaces, kinds;
  for (std::size_t i = 0; i < kept; ++i) {
    const ContactEvent& event = trace.events[i * count / kept];
    times.push_back(event.time_s);
    surfaces.push_back(surface_word(trace, event.surface));
    kinds.emplace_back(kContactEventWords[static_cast<std::size_t>(event.kind)]);
  }
  return {{"rows", kept},
          {"time_s", packed.numbers(times, Digits::seven)},
          {"surface", packed.texts(surfaces)},
          {"kind", packed.texts(kinds)}};
}

}  // namespace

json trace_json(PackedColumns& packed, const Trace& trace) {
  const bool thin = trace.time_s.size() > kTraceRowsMost;
  const auto pack = [&](const std::vector<double>& values) {
    return packed.numbers(thin ? thinned_keeping_peaks(values) : values, Digits::seven);
  };
  json signals = json::array();
  for (const TraceSignal& signal : trace.signals) {
    if (!is_whole(trace, signal)) continue;
    const std::size_t width = width_of(signal);
    json curves = json::array();
    for (std::size_t entry = 0; entry < width; ++entry) {
      std::vector<double> values;
      for (std::size_t row = entry; row < signal.values.size(); row += width) values.push_back(signal.values[row]);
      curves.push_back({{"name", curve_name(signal, entry)}, {"values", pack(values)}});
    }
    signals.push_back({{"name", signal.name},
                       {"units", signal.units},
                       {"long_name", signal.long_name},
                       {"curves", std::move(curves)}});
  }
  return {{"rows", trace.time_s.size()},
          {"thinned", thin},
          {"particles", trace.particle_count},
          {"events", trace.events.size()},
          {"contacts", contacts_json(packed, trace)},
          {"time_s", packed.numbers(thin ? thinned_times(trace.time_s) : trace.time_s)},
          {"signals", std::move(signals)}};
}

std::vector<double> thinned_keeping_peaks(const std::vector<double>& values) {
  std::vector<double> kept;
  kept.reserve(kTraceRowsMost);
  for (std::size_t part = 0; part < kTraceRowsMost / 2; ++part) {
    const auto begin = values.begin() + static_cast<std::ptrdiff_t>(part_start(part, values.size()));
    const auto end = values.begin() + static_cast<std::ptrdiff_t>(part_start(part + 1, values.size()));
    const auto [least, greatest] = std::minmax_element(begin, end);
    kept.push_back(least < greatest ? *least : *greatest);
    kept.push_back(least < greatest ? *greatest : *least);
  }
  return kept;
}

std::vector<double> thinned_times(const std::vector<double>& time_s) {
  std::vector<double> kept;
  kept.reserve(kTraceRowsMost);
  for (std::size_t part = 0; part < kTraceRowsMost / 2; ++part) {
    const std::size_t begin = part_start(part, time_s.size());
    const std::size_t end = part_start(part + 1, time_s.size());
    kept.push_back(time_s[begin]);
    kept.push_back(time_s[begin + (end - begin) / 2]);
  }
  return kept;
}

}  // namespace unbruised::studies

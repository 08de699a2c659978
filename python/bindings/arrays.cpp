#include "python/bindings/arrays.hpp"

#include <cstdint>

#include <pybind11/stl.h>

#include "studies/results/digest.hpp"

namespace unbruised::python {
namespace {

namespace py = pybind11;

template <class T, class Get>
py::array_t<T> column(const std::vector<ScenarioResult>& results, Get get) {
  std::vector<T> values;
  values.reserve(results.size());
  for (const ScenarioResult& result : results) values.push_back(get(result));
  return array_of(std::move(values), {static_cast<py::ssize_t>(results.size())});
}

py::tuple entry(const std::vector<std::string>& dimensions, const py::object& values, const std::string& units,
                const std::string& long_name) {
  return py::make_tuple(dimensions, values, units, long_name);
}

template <class T, class Get>
py::tuple event_column(const std::vector<ContactEvent>& events, const std::string& units, Get get) {
  std::vector<T> values;
  for (const ContactEvent& event : events) values.push_back(get(event));
  return entry({"event"}, array_of(std::move(values), {static_cast<py::ssize_t>(events.size())}), units, "");
}

py::dict events_of(const std::vector<ContactEvent>& events) {
  py::dict columns;
  columns["time_s"] = event_column<double>(events, "s", [](const ContactEvent& e) { return e.time_s; });
  columns["node"] = event_column<int>(events, "", [](const ContactEvent& e) { return e.node; });
  columns["surface"] = event_column<int>(events, "", [](const ContactEvent& e) { return e.surface; });
  columns["contact"] = event_column<int>(events, "", [](const ContactEvent& e) { return e.contact; });
  std::vector<std::string> words;
  for (const ContactEvent& event : events) {
    words.emplace_back(kContactEventWords[static_cast<std::size_t>(event.kind)]);
  }
  columns["kind"] = entry({"event"}, py::cast(words), "", "change of the contact");
  return columns;
}

}  // namespace

py::dict columns_of(const std::vector<ScenarioResult>& results) {
  py::dict columns;
  columns["outcome"] =
      column<std::int8_t>(results, [](const ScenarioResult& r) { return static_cast<std::int8_t>(r.outcome); });
  py::list words, causes;
  for (const ScenarioResult& result : results) {
    words.append(std::string(outcome_word(result.outcome)));
    causes.append(result.cause);
  }
  columns["outcome_word"] = words;
  columns["cause"] = causes;
  columns["outcome_time_s"] = column<double>(results, [](const ScenarioResult& r) { return r.outcome_time_s; });
  columns["digest"] =
      column<std::uint64_t>(results, [](const ScenarioResult& r) { return studies::result_digest(r); });
  py::dict metrics;
  for (const MetricInfo& info : kMetricTable) {
    metrics[py::str(std::string(info.name))] =
        column<double>(results, [&](const ScenarioResult& r) { return r.metrics[info.metric]; });
  }
  columns["metrics"] = metrics;
  return columns;
}

py::dict signals_of(Trace trace) {
  const auto times = static_cast<py::ssize_t>(trace.time_s.size());
  const py::ssize_t particles = trace.particle_count;
  py::dict signals;
  signals["time_s"] =
      entry({"time_s"}, array_of(std::move(trace.time_s), {times}), "s", "time since the start of the scenario");
  if (trace.keeps_motion) {
    signals["rest_position_m"] =
        entry({"particle", "component"}, array_of(std::move(trace.rest_position_m), {particles, 3}), "m",
              "rest position");
    const auto motion = [&](const char* name, std::vector<double>& values, const char* units, const char* words) {
      signals[name] = entry({"time_s", "particle", "component"},
                            array_of(std::move(values), {times, particles, 3}), units, words);
    };
    motion("displacement_m", trace.displacement_m, "m", "displacement from rest");
    motion("velocity_m_s", trace.velocity_m_s, "m s-1", "velocity");
    motion("acceleration_m_s2", trace.acceleration_m_s2, "m s-2", "acceleration");
  }
  for (TraceSignal& signal : trace.signals) {
    std::vector<std::string> dimensions{"time_s"};
    std::vector<py::ssize_t> extents{times};
    for (std::size_t k = 0; k < signal.extents.size(); ++k) {
      dimensions.push_back(k < signal.dimensions.size() ? signal.dimensions[k] : "axis_" + std::to_string(k));
      extents.push_back(signal.extents[k]);
    }
    signals[py::str(signal.name)] =
        entry(dimensions, array_of(std::move(signal.values), extents), signal.units, signal.long_name);
  }
  signals["contact_events"] = events_of(trace.events);
  return signals;
}

py::list metric_table() {
  py::list rows;
  for (const MetricInfo& info : kMetricTable) {
    rows.append(py::make_tuple(std::string(info.name), std::string(info.units), std::string(info.long_name)));
  }
  return rows;
}

}  // namespace unbruised::python

#include <cstdint>

#include "studies/results/hdf5_columns.hpp"
#include "studies/results/trace_columns.hpp"
#include "studies/text/joined.hpp"

namespace unbruised::studies {
namespace {

TraceSignal read_signal(const Hdf5File& file, const std::string& name) {
  const std::string full_name = joined({"/trace/", name});
  TraceSignal signal;
  signal.name = name;
  signal.units = file.text_attribute(full_name, "units").value_or("");
  signal.long_name = file.text_attribute(full_name, "long_name").value_or("");
  const auto extents = file.extents(full_name);
  for (std::size_t axis = 1; axis < extents.size(); ++axis)
    signal.extents.push_back(static_cast<int>(extents[axis]));
  signal.dimensions = file.dimension_names(full_name);
  if (!signal.dimensions.empty()) signal.dimensions.erase(signal.dimensions.begin());
  signal.values = file.read_doubles(full_name);
  return signal;
}

// Every time has a value per freedom, and per element of every signal.
void require_whole(const Trace& trace) {
  const std::size_t times = trace.time_s.size();
  const std::size_t freedoms = 3 * static_cast<std::size_t>(trace.particle_count);
  require_length("/trace/rest_position_m", trace.rest_position_m.size(), freedoms);
  require_length("/trace/displacement_m", trace.displacement_m.size(), times * freedoms);
  require_length("/trace/velocity_m_s", trace.velocity_m_s.size(), times * freedoms);
  require_length("/trace/acceleration_m_s2", trace.acceleration_m_s2.size(), times * freedoms);
  for (const TraceSignal& signal : trace.signals) {
    std::size_t width = 1;
    for (const int extent : signal.extents) width *= static_cast<std::size_t>(extent);
    require_length(joined({"/trace/", signal.name}), signal.values.size(), times * width);
  }
}

/// Files of earlier versions know neither which contact, where nor how hard.
void read_later_columns(const Hdf5File& file, std::vector<ContactEvent>& events) {
  if (const std::string name = "/contact_events/contact"; file.exists(name)) {
    const auto contacts = read_integer_column(file, name, events.size());
    for (std::size_t i = 0; i < events.size(); ++i) events[i].contact = static_cast<int>(contacts[i]);
  }
  for (const EventVector& vector : kEventVectors) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const bool there = file.exists(vector.name(axis));
      const auto values = there ? read_column(file, vector.name(axis), events.size())
                                : std::vector<double>(events.size(), kAbsent);
      for (std::size_t i = 0; i < events.size(); ++i) (events[i].*vector.field)[axis] = values[i];
    }
  }
}

std::vector<ContactEvent> read_events(const Hdf5File& file) {
  const auto times = file.read_doubles("/contact_events/time_s");
  const auto nodes = read_integer_column(file, "/contact_events/node", times.size());
  const auto surfaces = read_integer_column(file, "/contact_events/surface", times.size());
  const auto kinds = read_integer_column(file, "/contact_events/kind", times.size());
  std::vector<ContactEvent> events(times.size());
  for (std::size_t i = 0; i < events.size(); ++i) {
    if (kinds[i] < 0 || kinds[i] > static_cast<std::int64_t>(ContactEvent::Kind::slip)) {
      throw Hdf5Failure(joined({"/contact_events/kind holds the unknown kind ", std::to_string(kinds[i])}));
    }
    events[i] = {times[i], static_cast<int>(nodes[i]), static_cast<int>(surfaces[i]),
                 static_cast<ContactEvent::Kind>(kinds[i])};
    events[i].contact = events[i].node;
  }
  read_later_columns(file, events);
  return events;
}

}  // namespace

std::vector<std::string> signal_names(const Hdf5File& file) {
  const auto is_motion = [](const std::string& name) {
    return name == "displacement_m" || name == "velocity_m_s" || name == "acceleration_m_s2" || name == "time_s";
  };
  std::vector<std::string> names;
  for (const std::string& name : file.datasets("/trace")) {
    const auto dimensions = file.dimension_names(joined({"/trace/", name}));
    if (!is_motion(name) && !dimensions.empty() && dimensions.front() == "time_s") names.push_back(name);
  }
  return names;
}

Trace read_trace(const Hdf5File& file) {
  Trace trace;
  trace.rest_position_m = file.read_doubles("/trace/rest_position_m");
  trace.particle_count = static_cast<int>(trace.rest_position_m.size() / 3);
  trace.time_s = file.read_doubles("/trace/time_s");
  trace.displacement_m = file.read_doubles("/trace/displacement_m");
  trace.velocity_m_s = file.read_doubles("/trace/velocity_m_s");
  trace.acceleration_m_s2 = file.read_doubles("/trace/acceleration_m_s2");
  for (const std::string& name : signal_names(file)) trace.signals.push_back(read_signal(file, name));
  trace.events = read_events(file);
  require_whole(trace);
  return trace;
}

}  // namespace unbruised::studies

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>

#include "core/surface/surfaces.hpp"
#include "studies/results/hdf5_columns.hpp"
#include "studies/results/trace_columns.hpp"
#include "studies/text/joined.hpp"

namespace unbruised::studies {
namespace {

/// Writes /trace: knows which dimension scales exist already.
class TraceWriter {
 public:
  TraceWriter(Hdf5File& file, const Trace& trace) : file_(file), trace_(trace) {}

  void write() {
    const std::size_t times = trace_.time_s.size();
    const auto particles = static_cast<std::size_t>(trace_.particle_count);
    file_.write("/trace/time_s", trace_.time_s, {times});
    describe(file_, "/trace/time_s", "s", "time since the start of the scenario");
    file_.make_scale("/trace/time_s");
    const std::vector<std::string> motion = {scale("particle", particles), scale("component", 3)};
    write_array("rest_position_m", "m", "rest position", trace_.rest_position_m, {particles, 3}, motion);
    write_over_time("displacement_m", "m", "displacement from rest", trace_.displacement_m, {particles, 3},
                    motion);
    write_over_time("velocity_m_s", "m s-1", "velocity", trace_.velocity_m_s, {particles, 3}, motion);
    write_over_time("acceleration_m_s2", "m s-2", "acceleration", trace_.acceleration_m_s2, {particles, 3},
                    motion);
    for (const TraceSignal& signal : trace_.signals) write_signal(signal);
  }

 private:
  // The scale of a dimension; one whose name is taken by another extent is called <name>_<extent>.
  std::string scale(const std::string& dimension, std::size_t extent) {
    const auto known = extents_.find(dimension);
    if (known != extents_.end() && known->second != extent) {
      return scale(joined({dimension, "_", std::to_string(extent)}), extent);
    }
    const std::string name = joined({"/trace/", dimension});
    if (known == extents_.end()) {
      write_scale(file_, {name, extent}, joined({"index of the ", dimension}));
      extents_[dimension] = extent;
    }
    return name;
  }

  void write_array(const std::string& name, const std::string& units, const std::string& long_name,
                   const std::vector<double>& values, const Hdf5Extents& extents,
                   const std::vector<std::string>& scales) {
    const std::string full_name = joined({"/trace/", name});
    std::uint64_t expected = 1;
    for (const std::uint64_t extent : extents) expected *= extent;
    if (expected != values.size()) {
      throw Hdf5Failure(joined({"the trace's ", name, " has ", std::to_string(values.size()), " values where ",
                                std::to_string(expected), " are due"}));
    }
    file_.write(full_name, values, extents);
    describe(file_, full_name, units, long_name);
    for (std::size_t axis = 0; axis < scales.size(); ++axis) {
      file_.attach_scale(full_name, scales[axis], static_cast<unsigned>(axis));
    }
  }

  void write_over_time(const std::string& name, const std::string& units, const std::string& long_name,
                       const std::vector<double>& values, const Hdf5Extents& row_extents,
                       const std::vector<std::string>& row_scales) {
    Hdf5Extents extents{trace_.time_s.size()};
    std::vector<std::string> scales{"/trace/time_s"};
    extents.insert(extents.end(), row_extents.begin(), row_extents.end());
    scales.insert(scales.end(), row_scales.begin(), row_scales.end());
    write_array(name, units, long_name, values, extents, scales);
  }

  void write_signal(const TraceSignal& signal) {
    Hdf5Extents extents(signal.extents.begin(), signal.extents.end());
    std::vector<std::string> scales;
    for (std::size_t k = 0; k < extents.size(); ++k) {
      const bool named = k < signal.dimensions.size();
      scales.push_back(scale(named ? signal.dimensions[k] : joined({"axis_", std::to_string(k)}), extents[k]));
    }
    write_over_time(signal.name, signal.units, signal.long_name, signal.values, extents, scales);
  }

  Hdf5File& file_;
  const Trace& trace_;
  std::map<std::string, std::size_t> extents_;
};

/// The numbers and names of the surfaces of a trace.
std::string surface_codes_in(const Trace& trace) {
  for (const TraceSignal& signal : trace.signals) {
    const std::size_t codes = signal.long_name.find(": ");
    if (signal.name == "contact_count" && codes != std::string::npos) return signal.long_name.substr(codes + 2);
  }
  return surface_codes({kLeftPad, kRightPad, kSupport});
}

void write_events(Hdf5File& file, const Trace& trace) {
  const std::vector<ContactEvent>& events = trace.events;
  const Dimension dimension{"/contact_events/event", events.size()};
  write_scale(file, dimension, "number of the event in the order of time");
  write_column(file, "/contact_events/time_s", dimension,
               column_of(events, [](const ContactEvent& e) { return e.time_s; }), "s",
               "time of the event, interpolated inside the step");
  for (const EventVector& vector : kEventVectors) {
    for (std::size_t i = 0; i < 3; ++i) {
      write_column(file, vector.name(i), dimension,
                   column_of(events, [&](const ContactEvent& e) { return (e.*vector.field)[i]; }),
                   std::string(vector.units), joined({vector.long_name, ", along ", kAxisLetters.substr(i, 1)}));
    }
  }
  const auto write_index = [&](const std::string& name, int ContactEvent::*field, const std::string& long_name) {
    file.write(name, column_of(events, [&](const ContactEvent& e) { return std::int32_t{e.*field}; }),
               {events.size()});
    describe(file, name, "", long_name);
    file.attach_scale(name, dimension.scale, 0);
  };
  write_index("/contact_events/node", &ContactEvent::node, "index of the particle");
  write_index("/contact_events/contact", &ContactEvent::contact,
              "number of the contact: a particle, or a place of the true surface, before one surface");
  write_index("/contact_events/surface", &ContactEvent::surface, surface_codes_in(trace));
  file.write("/contact_events/kind",
             column_of(events, [](const ContactEvent& e) { return static_cast<std::int8_t>(e.kind); }),
             {events.size()}, 0);
  describe_flags(file, "/contact_events/kind", flags_of(kContactEventWords), "change of the contact");
  file.attach_scale("/contact_events/kind", dimension.scale, 0);
}

}  // namespace

void write_trace(Hdf5File& file, const Trace& trace) {
  file.make_group("/trace");
  TraceWriter(file, trace).write();
  write_events(file, trace);
}

}  // namespace unbruised::studies

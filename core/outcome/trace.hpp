#pragma once

/// @file
/// The full record of one scenario: motion, signals and contact events.

#include <string>
#include <vector>

#include "core/contact/contact_event.hpp"

namespace unbruised {

/// One recorded signal, shape [time, columns...] in row-major order.
struct TraceSignal {
  std::string name;   ///< e.g. "finger_force_N"
  std::string units;  ///< UDUNITS spelling
  std::string long_name;
  std::vector<std::string> dimensions;  ///< after time, e.g. {"finger", "component"}
  std::vector<int> extents;             ///< as long as dimensions
  std::vector<double> values;
};

/// The record of one scenario; rows 0..N, row 0 is the initial state.
struct Trace {
  bool keeps_motion = true;  ///< of the particles; set before the run. Else the three tables below stay empty.
  int particle_count = 0;
  std::vector<double> rest_position_m;    ///< [particle, 3]
  std::vector<double> time_s;             ///< [time]
  std::vector<double> displacement_m;     ///< [time, particle, 3]
  std::vector<double> velocity_m_s;       ///< [time, particle, 3]
  std::vector<double> acceleration_m_s2;  ///< [time, particle, 3]
  std::vector<TraceSignal> signals;
  std::vector<ContactEvent> events;
};

}  // namespace unbruised

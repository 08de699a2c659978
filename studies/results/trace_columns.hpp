#pragma once

/// @file
/// /trace and /contact_events of a results file. For use inside studies/results only; throws Hdf5Failure.

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/outcome/trace.hpp"
#include "studies/results/hdf5_file.hpp"
#include "studies/results/rows.hpp"
#include "studies/text/joined.hpp"

namespace unbruised::studies {

inline constexpr std::string_view kAxisLetters = "xyz";
/// A vector of a contact event: a column for each component.
struct EventVector {
  std::string_view quantity;
  std::string_view units;
  std::string_view long_name;
  std::array<double, 3> ContactEvent::*field;

  /// "/contact_events/place_x_m".
  [[nodiscard]] std::string name(std::size_t axis) const {
    return joined({"/contact_events/", quantity, "_", kAxisLetters.substr(axis, 1), "_", units});
  }
};
inline constexpr std::array<EventVector, 2> kEventVectors = {{
    {"place", "m", "place of the contact in the cell", &ContactEvent::place_m},
    {"force", "N", "force of the contact on the product", &ContactEvent::force_N},
}};

void write_trace(Hdf5File& file, const Trace& trace);
/// Everything that `write_trace` wrote; each array whole.
Trace read_trace(const Hdf5File& file);
/// Datasets of /trace that run over time and are not the motion itself.
std::vector<std::string> signal_names(const Hdf5File& file);

}  // namespace unbruised::studies

#pragma once

/// @file
/// The signals of a trace as curves over time with names for people: what charts and tables show of them.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/outcome/trace.hpp"
#include "studies/results/rows.hpp"

namespace unbruised::studies {

/// Signals with more columns than this are no curves to look at.
inline constexpr std::size_t kSignalColumnsMost = 64;

/// Columns of a signal.
std::size_t width_of(const TraceSignal& signal);
/// Has the signal a value for every time, and few enough columns?
bool is_whole(const Trace& trace, const TraceSignal& signal);
/// "finger 1, x" for an entry of a signal with the dimensions finger and component; empty for a single curve.
std::string curve_name(const TraceSignal& signal, std::size_t entry);

/// Of the surface that a trace gives this number: "left pad", "gripper.finger.2".
std::string surface_word(const Trace& trace, int number);

/// A row per recorded time: time_s and every curve, e.g. "finger_force_N [finger 1, x]". The particles' motion
/// stays in the results file.
ResultTable trace_as_table(const Trace& trace);

/// A phase or a count: it holds until the next row and has no values between.
bool is_counted(const TraceSignal& signal);
/// The signals of a trace at one time: straight lines between two neighbouring rows; a rotation stays a rotation;
/// what is counted is that of the row before.
struct TraceInstant {
  double time_s = 0, before_s = 0, after_s = 0;  ///< of the rows; equal where the time is that of a row
  std::vector<TraceSignal> signals;              ///< with the values of that time only
};
/// Nothing where the trace does not reach that time. @param trace its times ascend
std::optional<TraceInstant> trace_at(const Trace& trace, double time_s);

}  // namespace unbruised::studies

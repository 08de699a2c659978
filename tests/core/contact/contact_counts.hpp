#pragma once

/// @file
/// The contact counts of a trace, worked out again from its events.

#include <map>
#include <vector>

#include "core/surface/surfaces.hpp"
#include "tests/core/simulation/scenes.hpp"

namespace unbruised::testing {

/// How often a recount and the trace disagree, and what was looked at.
struct Recount {
  std::size_t rows = 0, events = 0;
  std::size_t closed_differs = 0, sliding_differs = 0;  ///< rows and surfaces with another count
  std::size_t impossible = 0;  ///< events that no contact in that state can have, or that go back in time
};

/// Plays the events over the contacts, each of which is open, sticks or slides, and compares their numbers with
/// the counts of every row: those are of the register, which looks (theta - 1) dt ahead of the row.
inline Recount recount(const Trace& trace, double theta, double time_step_s) {
  using Kind = ContactEvent::Kind;
  enum class State { open, sticks, slides };
  const TraceSignal& closed = signal(trace, "contact_count");
  const TraceSignal& sliding = signal(trace, "sliding_count");
  const std::size_t surfaces = width(closed);
  std::map<int, State> contact;
  std::vector<double> now_closed(surfaces), now_sliding(surfaces);
  Recount found;
  found.events = trace.events.size();
  std::size_t next = 0;
  double last_s = 0.0;
  for (std::size_t row = 0; row < trace.time_s.size(); ++row) {
    const double until_s = row == 0 ? 0.0 : trace.time_s[row] + (theta - 1.0) * time_step_s;
    for (; next < trace.events.size() && trace.events[next].time_s <= until_s + 1e-9 * time_step_s; ++next) {
      const ContactEvent& event = trace.events[next];
      const auto s = static_cast<std::size_t>(event.surface);
      State& state = contact.try_emplace(event.contact, State::open).first->second;
      const bool fits = event.kind == Kind::make    ? state == State::open
                        : event.kind == Kind::slip  ? state == State::sticks
                        : event.kind == Kind::stick ? state == State::slides
                                                    : state != State::open;
      if (!fits || event.time_s < last_s - 1e-9 * time_step_s) ++found.impossible;
      last_s = event.time_s;
      if (event.kind == Kind::make) now_closed[s] += 1.0;
      if (event.kind == Kind::break_) now_closed[s] -= 1.0;
      now_sliding[s] += (event.kind == Kind::slip ? 1.0 : 0.0) - (state == State::slides ? 1.0 : 0.0);
      state = event.kind == Kind::break_ ? State::open : event.kind == Kind::slip ? State::slides : State::sticks;
    }
    for (std::size_t s = 0; s < surfaces; ++s) {
      found.closed_differs += closed.values[row * surfaces + s] == now_closed[s] ? 0 : 1;
      found.sliding_differs += sliding.values[row * surfaces + s] == now_sliding[s] ? 0 : 1;
    }
    ++found.rows;
  }
  return found;
}

}  // namespace unbruised::testing

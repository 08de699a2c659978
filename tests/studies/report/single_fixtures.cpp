#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "tests/studies/report/fixture_parts.hpp"

namespace unbruised::studies::testing {
namespace {

/// The phase at a time of the two seconds, as a code.
double phase_at(double t) {
  const std::array<double, 7> ends_s = {0.2, 0.35, 0.8, 0.9, 1.4, 1.8, 1.85};
  return static_cast<double>(std::upper_bound(ends_s.begin(), ends_s.end(), t) - ends_s.begin());
}

ReportFixture simulate(const std::string& name, std::size_t steps, const Handling& at) {
  ReportFixture fixture = begin(name, "simulate");
  add_row(fixture, at, {});
  const double yield = fixture.content.rows.front().result.metrics[Metric::contact_yield_ratio_max];
  fixture.trace = std::make_shared<Trace>();
  Trace& trace = *fixture.trace;
  trace.particle_count = 512;
  TraceSignal finger{"finger_force_N",        "N",    "force of each finger on the product",
                     {"finger", "component"}, {2, 3}, {}};
  TraceSignal palm{"palm_position_m", "m", "motion of the palm", {"component"}, {3}, {}};
  TraceSignal strain{"plastic_strain_max", "1", "largest plastic strain", {}, {}, {}};
  TraceSignal ratio{"contact_yield_ratio", "1", "pressure over that at first yield", {"finger"}, {2}, {}};
  TraceSignal phase{
      "phase",
      "1",
      "phase of the cycle: 0 approach, 1 grip, 2 lift, 3 hold, 4 transfer, 5 lower, 6 release, 7 recover",
      {},
      {},
      {}};
  for (std::size_t i = 0; i <= steps; ++i) {
    const double t = 2.0 * static_cast<double>(i) / static_cast<double>(steps);
    trace.time_s.push_back(t);
    const double closed = 1.0 / (1.0 + std::exp(-40.0 * (t - 0.2))) / (1.0 + std::exp(40.0 * (t - 1.8)));
    const double grip = at.grip_force_N * closed;
    for (const double side : {1.0, -1.0}) {
      finger.values.insert(finger.values.end(), {side * grip, 0.02 * std::sin(9.0 * t), 0.47 * grip / 2.0});
    }
    palm.values.insert(palm.values.end(),
                       {0.0, 0.15 * (1.0 - std::cos(kPi * t / 2.0)), 0.1 * std::sin(kPi * t / 2.0)});
    strain.values.push_back(1e-3 * std::max(0.0, t - 0.3));
    ratio.values.insert(ratio.values.end(), {yield * closed, 0.98 * yield * closed});
    phase.values.push_back(phase_at(t));
  }
  trace.signals = {finger, palm, strain, ratio, phase};
  trace.events.push_back({.time_s = 0.2, .node = 3, .surface = 0, .kind = ContactEvent::Kind::make});
  return fixture;
}

}  // namespace

std::vector<ReportFixture> single_fixtures() {
  return {simulate("hold", 2000, {}), simulate("long_hold", 60000, {}),
          simulate("damaged_run", 2000, {.grip_force_N = 9.35})};
}

}  // namespace unbruised::studies::testing

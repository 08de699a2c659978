#include "studies/report/report_replay.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>

#include <nlohmann/json.hpp>

#include "core/motion/handling_cycle.hpp"
#include "core/scenario/product.hpp"
#include "studies/findings/trace_curves.hpp"
#include "studies/report/delta_coder.hpp"
#include "studies/report/report_trace.hpp"

namespace unbruised::studies {
namespace {

using nlohmann::json;
using Digits = PackedColumns::Digits;

/// Steps of the largest value of a table; half of one is the error.
constexpr int kPlaceSteps = 1500, kFieldSteps = 250;

/// Signals of a trace that the panel beside the scene and the charts below it show.
constexpr std::array<std::string_view, 22> kSignals = {"phase",
                                                       "finger_force_N",
                                                       "support_force_N",
                                                       "sensor_wrench",
                                                       "range_m",
                                                       "friction_margin",
                                                       "slip_m",
                                                       "slip_rad",
                                                       "kinetic_energy_J",
                                                       "elastic_energy_J",
                                                       "plastic_work_J",
                                                       "contact_energy_J",
                                                       "dissipated_energy_J",
                                                       "finger_energy_J",
                                                       "plastic_strain_max",
                                                       "contact_yield_ratio",
                                                       "patch_pressure_Pa",
                                                       "absorbed_energy_J",
                                                       "palm_position_m",
                                                       "finger_way_m",
                                                       "contact_count",
                                                       "support_yield_ratio"};

json numbers(PackedColumns& packed, const std::vector<double>& values) {
  return packed.numbers(values, Digits::seven);
}

/// With -O3 GCC 12 sees null pointers where nlohmann's header takes an array by itself.
json list(std::span<const double> values) {
  json all = json::array();
  for (const double value : values) all.push_back(value);
  return all;
}

template <class Places>
std::vector<double> flat(const Places& places) {
  std::vector<double> values;
  for (const auto& place : places) values.insert(values.end(), place.begin(), place.end());
  return values;
}

json coded_json(PackedColumns& packed, const std::vector<float>& values, std::size_t width, int steps) {
  const CodedTable table = coded(values, width, steps);
  const float least = values.empty() ? 0.0F : *std::min_element(values.begin(), values.end());
  const float most = values.empty() ? 0.0F : *std::max_element(values.begin(), values.end());
  return {{"step", table.step},
          {"width", width},
          {"least", least},
          {"most", most},
          {"coded", packed.raw(table.bytes)}};
}

json surfaces_json(const Replay& replay) {
  constexpr std::array<const char*, 4> kKinds = {"pad", "support", "listed", "absent"};
  json all = json::array();
  for (const ReplaySurface& surface : replay.surface) {
    all.push_back({{"name", surface.name},
                   {"kind", kKinds[static_cast<std::size_t>(surface.kind)]},
                   {"finger", surface.finger},
                   {"origin", list(surface.origin_m)},
                   {"axes", json::array({list(surface.axes[0]), list(surface.axes[1]), list(surface.axes[2])})},
                   {"size", list(surface.size_m)},
                   {"thickness", surface.thickness_m},
                   {"heights", list(surface.height_m)}});
  }
  return all;
}

json events_json(const ScenarioReplay& seen) {
  json all = json::array();
  for (const ReplayEvent& event : replay_events(seen)) {
    all.push_back({{"time_s", event.time_s}, {"kind", event.kind}, {"where", event.where}});
  }
  return all;
}

/// Counts of one surface as its contacts come and go.
struct SurfaceCount {
  int closed = 0, sliding = 0;
};

void add_contact_events(const ScenarioReplay& seen, std::vector<ReplayEvent>& events) {
  const std::vector<ReplaySurface>& surfaces = seen.replay.surface;
  std::vector<SurfaceCount> counts(surfaces.size());
  std::vector<bool> slides(surfaces.size());
  std::vector<std::vector<bool>> sliding_now(surfaces.size());
  for (const ContactEvent& event : seen.trace.events) {
    const auto s = static_cast<std::size_t>(event.surface);
    if (s >= counts.size()) continue;
    const auto contact = static_cast<std::size_t>(event.contact);
    if (sliding_now[s].size() <= contact) sliding_now[s].resize(contact + 1);
    SurfaceCount& count = counts[s];
    const auto slide = [&](bool is) {
      if (sliding_now[s][contact] != is) count.sliding += is ? 1 : -1;
      sliding_now[s][contact] = is;
    };
    switch (event.kind) {
      case ContactEvent::Kind::make:
        if (count.closed++ == 0) events.push_back({event.time_s, "touch", surfaces[s].name});
        break;
      case ContactEvent::Kind::break_:
        slide(false);
        if (--count.closed == 0) events.push_back({event.time_s, "part", surfaces[s].name});
        break;
      case ContactEvent::Kind::slip:
        slide(true);
        break;
      case ContactEvent::Kind::stick:
        slide(false);
        break;
    }
    const bool is_pad = surfaces[s].kind == ReplaySurface::Kind::pad;
    const bool all_slide = is_pad && count.closed > 0 && count.sliding >= count.closed;
    if (all_slide && !slides[s]) events.push_back({event.time_s, "slip", surfaces[s].name});
    slides[s] = all_slide;
  }
}

/// Keeps the first of events of one kind and place that follow each other closely.
void thin(std::vector<ReplayEvent>& events) {
  std::stable_sort(events.begin(), events.end(),
                   [](const ReplayEvent& a, const ReplayEvent& b) { return a.time_s < b.time_s; });
  std::vector<ReplayEvent> kept;
  std::vector<ReplayEvent> last;  // of each kind and place
  for (const ReplayEvent& event : events) {
    const auto same = std::find_if(last.begin(), last.end(), [&](const ReplayEvent& each) {
      return each.kind == event.kind && each.where == event.where;
    });
    const bool again = same != last.end() && event.time_s - same->time_s < kSameEvent_s;
    if (same == last.end()) {
      last.push_back(event);
    } else {
      same->time_s = event.time_s;
    }
    if (!again) kept.push_back(event);
  }
  events = std::move(kept);
}

}  // namespace

ReplayStage replay_stage(const Scenario& scenario) {
  ReplayStage stage;
  stage.support = scenario.cell.support;
  stage.belt =
      scenario.cell.conveyor.speed_m_s > 0.0 || scenario.cell.conveyor.initial_speed_m_s.value_or(0.0) > 0.0;
  if (has_gripper(scenario) && scenario.cell.target_plane && !scenario.strategy.stop_time_s) {
    stage.target_m = {scenario.cell.transfer_m[0], scenario.cell.transfer_m[1], scenario.cell.place_height_m};
  }
  if (const auto size_m = shape_extents_m(scenario.product)) {
    stage.smallest_extent_m = *std::min_element(size_m->begin(), size_m->end());
  }
  return stage;
}

bool palm_turns(const Replay& replay) {
  constexpr double kUpright = 1.0 - 1e-9;
  for (std::size_t i = 0; i < replay.palm_attitude.size(); i += 4) {
    if (std::abs(replay.palm_attitude[i]) < kUpright) return true;
  }
  return false;
}

std::vector<ReplayEvent> replay_events(const ScenarioReplay& seen) {
  std::vector<ReplayEvent> events;
  add_contact_events(seen, events);
  for (const TraceSignal& signal : seen.trace.signals) {
    if (signal.name != "phase") continue;
    const auto stopped =
        std::find(signal.values.begin(), signal.values.end(), static_cast<double>(CyclePhase::stop));
    if (stopped == signal.values.end()) continue;
    events.push_back({seen.trace.time_s[static_cast<std::size_t>(stopped - signal.values.begin())], "stop", {}});
  }
  thin(events);
  const double decided_s = seen.result.outcome_time_s;
  if (std::isfinite(decided_s) && seen.result.outcome != Outcome::held) {
    const ReplayEvent decided{decided_s, "decided", std::string(outcome_word(seen.result.outcome))};
    const auto later = std::find_if(events.begin(), events.end(),
                                    [&](const ReplayEvent& each) { return each.time_s > decided_s; });
    events.insert(later, decided);
  }
  return events;
}

json replay_json(PackedColumns& packed, const ScenarioReplay& seen, std::optional<std::size_t> row) {
  const Replay& replay = seen.replay;
  const std::size_t vertices = replay.vertex_m.size();
  Trace shown = seen.trace;
  std::erase_if(shown.signals, [](const TraceSignal& signal) {
    return std::find(kSignals.begin(), kSignals.end(), signal.name) == kSignals.end();
  });
  const double set_m = seen.result.metrics[Metric::permanent_set_max_m];
  json page = {{"id", seen.id},
               {"why", seen.why},
               {"outcome", outcome_word(seen.result.outcome)},
               {"cause", seen.result.cause},
               {"row", row ? json(*row) : json(nullptr)},
               {"frames", replay.frame_count()},
               {"vertices", vertices},
               {"smallest_extent_m", seen.stage.smallest_extent_m},
               {"permanent_set_m", std::isfinite(set_m) ? json(set_m) : json(nullptr)},
               {"support", seen.stage.support},
               {"target_m", seen.stage.target_m ? list(*seen.stage.target_m) : json(nullptr)},
               {"belt", seen.stage.belt},
               {"turns", palm_turns(replay)},
               {"grip_m", list(replay.grip_m)},
               {"surfaces", surfaces_json(replay)},
               {"events", events_json(seen)}};
  page["vertex_m"] = numbers(packed, flat(replay.vertex_m));
  page["triangle"] = numbers(packed, flat(replay.triangle));
  page["line"] = numbers(packed, flat(replay.line));
  page["permanent_m"] = numbers(packed, replay.permanent_m);
  page["time_s"] = numbers(packed, replay.time_s);
  page["product_m"] = numbers(packed, replay.product_m);
  page["attitude"] = numbers(packed, replay.attitude);
  page["palm_m"] = numbers(packed, replay.palm_m);
  page["palm_attitude"] = numbers(packed, replay.palm_attitude);
  page["finger_way_m"] = numbers(packed, replay.finger_way_m);
  page["support_m"] = numbers(packed, replay.support_m);
  page["listed_m"] = numbers(packed, replay.listed_m);
  page["force_N"] = numbers(packed, replay.force_N);
  page["force_place_m"] = numbers(packed, replay.force_place_m);
  page["wrist_wrench"] = numbers(packed, replay.wrist_wrench);
  page["arm_m"] = numbers(packed, seen.arm_m);
  page["deformation_m"] = coded_json(packed, replay.deformation_m, 3 * vertices, kPlaceSteps);
  page["fields"] = {{"plastic_strain", coded_json(packed, replay.plastic_strain, vertices, kFieldSteps)},
                    {"von_mises_Pa", coded_json(packed, replay.von_mises_Pa, vertices, kFieldSteps)},
                    {"pressure_Pa", coded_json(packed, replay.pressure_Pa, vertices, kFieldSteps)}};
  page["trace"] = trace_json(packed, shown);
  return page;
}

}  // namespace unbruised::studies

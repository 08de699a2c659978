#include "core/simulation/trace_recorder.hpp"

#include <algorithm>
#include <cmath>

#include "core/scenario/product.hpp"

namespace unbruised {

void TraceRecorder::start(const LaneStep& loaded) {
  const double dt = loaded.view.model.clock.tick_s;
  const double every_s = loaded.scenario.simulation.trace_interval_s.value_or(dt);
  stride_ = std::max<std::int64_t>(1, std::llround(every_s / dt));
  start_trace(loaded.view.model.body.position_m, loaded.scenario, trace_);
  record_events(loaded);
  record(loaded);
}

bool TraceRecorder::observe(const LaneStep& step) {
  record_events(step);
  for (std::size_t s = 0; s < kSurfaceCount; ++s) patches_.raise(s, step.seen.patch[s]);
  if ((step.ticks_before + step.tick) / stride_ > rows_) record(step);
  return true;
}

void TraceRecorder::record_events(const LaneStep& step) {
  const LaneView& view = step.view;
  view.contact.append_events(step.lane,
                             {step.before_s + step.start_s, step.before_s + step.time_s, view.body, view.carriers},
                             trace_.events);
}

void TraceRecorder::record(const LaneStep& step) {
  rows_ = (step.ticks_before + step.tick) / stride_;
  TraceRow row = step.view.trace_row(step.lane, step.scenario, step.time_s);
  row.dissipated = Balances::dissipated(step.lane, step.view, step.scenario);
  row.work = step.balances.work_done(step.lane, step.view, step.scenario);
  const double friction = product_friction(step.scenario.product);
  for (std::size_t f = 0; f < step.seen.finger_count; ++f) {
    FingerObservation finger = step.seen.finger[f];
    row.yield_ratio[f] = finger.yield_ratio;
    row.range_m[f] = finger.range_m;
    if (!step.cycle.lift_started() || finger.closed_contacts == 0) finger.slip_m = finger.slip_rad = 0.0;
    row.slip_m[f] = finger.slip_m;
    row.slip_rad[f] = finger.slip_rad;
    row.friction_margin[f] = friction_margin(finger, friction, step.scenario.limits).value_or(std::nan(""));
  }
  if (step.six_axis != nullptr) row.sensor = SensorRow{step.six_axis->reading(), step.six_axis->compensated()};
  row.phase = step.cycle.phase(step.time_s);
  row.time_s = step.before_s + step.time_s;
  row.support_yield_ratio = step.seen.support_yield_ratio;
  row.patch_pressure_Pa = step.seen.patch_pressure_Pa;
  const PatchDamage patches = patches_.together();
  row.plastic_strain = std::max(row.plastic_strain, patches.plastic_strain);
  row.absorbed_energy_J = std::max(step.seen.absorbed_energy_J, patches.absorbed_energy_J);
  append_row(row, trace_.keeps_motion ? step.view.body.state(step.lane) : BodyState{}, trace_);
}

}  // namespace unbruised

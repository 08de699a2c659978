#include "core/simulation/outcome_observer.hpp"

#include <cmath>
#include <optional>
#include <string>

#include "core/scenario/layer_reach.hpp"
#include "core/scenario/pad_meeting.hpp"
#include "core/scenario/palm_stops.hpp"
#include "core/scenario/words.hpp"

namespace unbruised {

namespace {

bool is_finite(const LaneStep& step) {
  double size = step.view.material.largest_strain()[step.lane];
  for (const auto* sums : {&step.view.body.mass_u(), &step.view.body.mass_a()}) {
    for (const Lane& sum : *sums) size += sum[step.lane];
  }
  return std::isfinite(size);
}

/// Has the belt carried the product beyond its end before anything lifted it?
bool belt_has_ended(const LaneStep& step) {
  const ConveyorParameters& conveyor = step.scenario.cell.conveyor;
  if (!conveyor.length_m || step.time_s > step.cycle.plan().lift_start_s()) return false;
  const Horizontal& along = step.cycle.plan().belt().direction();
  const auto& place = step.seen.center_motion_m;
  return place[0] * along[0] + place[1] * along[1] > *conveyor.length_m;
}

static_assert(kLargestLayerStrain == kFollowedLayerStrain);

std::string pressed_too_deep(const Scenario& scenario) {
  const auto* jaw = parallel_jaw(scenario);
  const bool by_points = jaw != nullptr && !jaw->pad.law_depth_m.empty();
  return std::string(by_points
                         ? "a pad is pressed in deeper than its law was measured, or the support or a surface "
                           "of the cell"
                         : "a pad, the support or a surface of the cell is pressed in") +
         " by more than " + in_per_cent(kLargestLayerStrain) + " of its thickness";
}

/// What of a state the model does not describe; nothing where it describes it.
std::optional<std::string> beyond_model(const LaneStep& step) {
  const LaneView& view = step.view;
  const SimulationParameters& bounds = step.scenario.simulation;
  if (view.material.largest_strain()[step.lane] > bounds.max_strain) {
    return "a cell's strain > simulation.max_strain";
  }
  const bool follows_small_turns_only = view.model.body.is_solid && view.body.frame() == nullptr;
  if (follows_small_turns_only && step.seen.rotation_rad > bounds.max_rotation_rad) {
    return "the product's rotation > simulation.max_rotation_rad";
  }
  if (view.material.largest_cell_rotation()[step.lane] > bounds.max_rotation_rad) {
    return "a cell's rotation against the product > simulation.max_rotation_rad";
  }
  const bool is_let_go = has_gripper(step.scenario) && step.time_s > step.cycle.plan().release_end_s();
  if (!is_let_go && view.lean_in_grip_rad(step.lane, step.scenario) > bounds.max_rotation_rad) {
    return "the lean of the product against the pads > simulation.max_rotation_rad";
  }
  if (view.body.frame() != nullptr && view.body.frame()->turn_rad(step.lane) > kLargestStepTurn_rad) {
    return "the product turns by more than 0.1 rad within a step; use a smaller simulation.time_step_s";
  }
  if (belt_has_ended(step)) return "the belt carries the product beyond cell.conveyor.length_m before the lift";
  if (step.seen.layer_strain > kLargestLayerStrain) {
    return pressed_too_deep(step.scenario);
  }
  if (view.contact.meets_rim()[step.lane]) {
    return "the product meets the rim of a [[cell.surface]], which is touched on its face only";
  }
  if (view.sinks_through(step.lane, step.scenario)) {
    return "the product meets the cell with places that simulation.contact_set = \"six sides\" leaves out";
  }
  return std::nullopt;
}

/// Is the product let go of, with nothing below that it could meet?
bool falls_for_ever(const LaneStep& step) {
  const CellParameters& cell = step.scenario.cell;
  return !cell.support && cell.surface.empty() && step.time_s > step.cycle.plan().release_end_s();
}

}  // namespace

void OutcomeObserver::start(const LaneStep& loaded) {
  const auto meeting = pad_meeting(loaded.scenario);
  if (!meeting || meeting->depth_share <= kDeepestMeeting) return;
  record_.abort(Outcome::out_of_range, "the pads meet the product too far behind its outermost place",
                loaded.time_s);
}

bool OutcomeObserver::observe(const LaneStep& step) {
  contact_sweeps_ += step.contact_sweeps;
  plastic_rounds_ += step.plastic_rounds;
  const bool goes_on = record_.observe(step.seen, step.cycle);
  if (!is_finite(step)) {
    record_.abort(Outcome::diverged, "the motion is not finite", step.time_s);
  } else if (const auto cause = beyond_model(step)) {
    if (falls_for_ever(step)) return false;
    record_.abort(Outcome::out_of_range, *cause, step.time_s);
  }
  return goes_on && !record_.aborted();
}

bool OutcomeObserver::end_handling(const LaneStep& last) {
  Metrics& metrics = record_.metrics;
  metrics[Metric::step_count] = static_cast<double>(last.count);
  metrics[Metric::contact_iterations] = contact_sweeps_;
  metrics[Metric::plasticity_iterations] = plastic_rounds_;
  if (const auto& modes = last.view.model.mode_summary)
    metrics[Metric::modes_left_out_share] = modes->left_out_share;
  if (const SixAxisInstrument* sensor = last.six_axis) {
    metrics[Metric::peak_sensor_force_N] = sensor->peak_force_N();
    metrics[Metric::peak_sensor_torque_N_m] = sensor->peak_torque_N_m();
    metrics[Metric::peak_sensor_force_time_s] = sensor->peak_force_time_s();
    if (sensor->overload()) metrics[Metric::sensor_overload] = *sensor->overload();
  }
  if (!record_.aborted()) last.view.measure_permanent_set(last.lane, last.scenario.limits, metrics);
  if (!record_.diverged()) last.balances.measure(last.lane, last.time_s, last.view, last.scenario, metrics);
  handlings_.add(record_.finish(last.cycle, last.time_s), last.time_s);
  return handlings_.go_on();
}

void OutcomeObserver::next_handling(const LaneStep& loaded) {
  record_ = record_.next(loaded.scenario);
  contact_sweeps_ = plastic_rounds_ = 0.0;
}

}  // namespace unbruised

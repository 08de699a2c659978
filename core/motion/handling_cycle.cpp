#include "core/motion/handling_cycle.hpp"

#include <algorithm>

#include "core/scenario/gripper.hpp"

namespace unbruised {

HandlingCycle::HandlingCycle(const Scenario& scenario)
    : scenario_(scenario), plan_(scenario, scenario.strategy.ramp_from_start ? 0.0 : kNever) {
  const auto stroke = finger_stroke_m(scenario.gripper);
  if (!stroke) return;
  // Twice the time the whole stroke takes at the wanted speed, and a second for a slow start.
  approach_deadline_s_ = 2.0 * *stroke / scenario.strategy.approach_speed_m_s + 1.0;
}

CycleEvent HandlingCycle::observe(double time_s, std::optional<double> touch_s) {
  if (touch_s && !has_contact()) {
    first_contact_s_ = *touch_s;
    if (!scenario_.strategy.ramp_from_start) plan_ = MotionPlan(scenario_, *touch_s);
  }
  if (lift_started_ || time_s < plan_.lift_start_s()) return CycleEvent::none;
  lift_started_ = true;
  return CycleEvent::lift_started;
}

CyclePhase HandlingCycle::phase(double time_s) const {
  if (!plan_.is_stopped(time_s) && time_s < std::min(first_contact_s_, plan_.lift_start_s())) {
    return CyclePhase::approach;
  }
  return plan_.phase_after_contact(time_s);
}

}  // namespace unbruised

#include "core/motion/handling_cycle.hpp"

#include <algorithm>
#include <utility>

#include "core/scenario/gripper.hpp"

namespace unbruised {

HandlingCycle::HandlingCycle(const Scenario& scenario, std::shared_ptr<const PalmCarrier> carrier)
    : scenario_(scenario),
      carrier_(std::move(carrier)),
      plan_(plan_from(scenario.strategy.ramp_from_start ? 0.0 : kNever)),
      grip_started_(scenario.strategy.ramp_from_start) {
  const auto stroke = finger_stroke_m(scenario.gripper);
  if (!stroke) return;
  const StrategyParameters& s = scenario.strategy;
  const double slowest_m_s = s.guard == GuardKind::range ? s.guard_speed_m_s : s.approach_speed_m_s;
  // Twice the time the whole stroke takes at the wanted speed, and a second for a slow start.
  approach_deadline_s_ = 2.0 * *stroke / slowest_m_s + 1.0;
}

MotionPlan HandlingCycle::plan_from(double ramp_start_s) const {
  const MotionPlan plan(scenario_, ramp_start_s, guard_s_, carrier_.get());
  return carrier_ ? plan.tracked(carrier_->track(plan)) : plan;
}

CycleEvent HandlingCycle::observe(double time_s, std::optional<double> touch_s, std::optional<double> guard_s) {
  if (touch_s && !has_contact()) first_contact_s_ = *touch_s;
  if (guard_s && !(guard_s_ < kNever)) follow_guard(*guard_s);
  if (!grip_started_ && has_contact()) start_grip();
  if (lift_started_ || time_s < plan_.lift_start_s()) return CycleEvent::none;
  lift_started_ = true;
  return CycleEvent::lift_started;
}

/// What is seen after the grip has begun has nothing left to slow down.
void HandlingCycle::follow_guard(double guard_s) {
  const bool by_force = scenario_.strategy.guard == GuardKind::force;
  if (grip_started_ || (!by_force && guard_s >= first_contact_s_)) return;
  guard_s_ = guard_s;
  if (!by_force && !has_contact()) plan_ = plan_from(kNever);
}

void HandlingCycle::start_grip() {
  // The force of the step in which the contact comes begins with the step.
  const bool by_force = scenario_.strategy.guard == GuardKind::force;
  const double start_s = by_force ? std::max(guard_s_, first_contact_s_) : first_contact_s_;
  if (!(start_s < kNever)) return;
  grip_started_ = true;
  plan_ = plan_from(start_s);
}

CyclePhase HandlingCycle::phase(double time_s) const {
  if (!plan_.is_stopped(time_s) && time_s < std::min(first_contact_s_, plan_.lift_start_s())) {
    return CyclePhase::approach;
  }
  return plan_.phase_after_contact(time_s);
}

}  // namespace unbruised

#include "core/motion/handling_cycle.hpp"

#include <algorithm>
#include <cmath>

#include "core/scenario/opening.hpp"

namespace unbruised {

HandlingCycle::HandlingCycle(const Scenario& scenario) : scenario_(scenario) {
  const SimulationParameters& simulation = scenario.simulation;
  if (!scenario.gripper) {
    end_s_ = *simulation.duration_s;
    return;
  }
  const StrategyParameters& s = scenario.strategy;
  const CellParameters& cell = scenario.cell;
  lift_ = MotionProfile::plan(s.profile, cell.lift_height_m, s.lift_acceleration_m_s2, s.speed_m_s);
  const double way = std::hypot(cell.transfer_m[0], cell.transfer_m[1]);
  if (way > 0.0) transfer_direction_ = {cell.transfer_m[0] / way, cell.transfer_m[1] / way};
  transfer_ = MotionProfile::plan(s.profile, way, s.transfer_acceleration_m_s2.value_or(s.lift_acceleration_m_s2),
                                  s.speed_m_s);
  lower_ = MotionProfile::plan(s.profile, cell.place_height_m + s.release_height_m - cell.lift_height_m,
                               s.lower_acceleration_m_s2.value_or(s.lift_acceleration_m_s2), s.speed_m_s);
  // Twice the time the whole stroke takes at the wanted speed, and a second for a slow start.
  approach_deadline_s_ = 2.0 * scenario.gripper->stroke_m / s.approach_speed_m_s + 1.0;
  if (s.ramp_from_start) schedule(0.0);
  if (simulation.duration_s) end_s_ = std::min(end_s_, *simulation.duration_s);
}

void HandlingCycle::contact_made(double time_s) {
  if (has_contact()) return;
  first_contact_s_ = time_s;
  if (ramp_start_s_ == kNever) schedule(time_s);
}

void HandlingCycle::schedule(double ramp_start_s) {
  const StrategyParameters& s = scenario_.strategy;
  ramp_start_s_ = ramp_start_s;
  lift_start_s_ = ramp_start_s + s.grip_ramp_s + s.settle_s;
  lift_end_s_ = lift_start_s_ + lift_.duration_s();
  hold_end_s_ = lift_end_s_ + s.hold_s;
  transfer_end_s_ = hold_end_s_ + transfer_.duration_s();
  lower_end_s_ = transfer_end_s_ + lower_.duration_s();
  release_start_s_ = lower_end_s_ + s.place_settle_s;
  release_end_s_ = release_start_s_ + approach_gap_m(scenario_) / s.release_speed_m_s;
  end_s_ = release_end_s_ + s.recover_s;
  if (scenario_.simulation.duration_s) end_s_ = std::min(end_s_, *scenario_.simulation.duration_s);
}

CyclePhase HandlingCycle::phase(double time_s) const {
  if (time_s < std::min(first_contact_s_, lift_start_s_)) return CyclePhase::approach;
  const std::array<double, 6> ends_s = {lift_start_s_,   lift_end_s_,      hold_end_s_,
                                        transfer_end_s_, release_start_s_, release_end_s_};
  const auto end = std::upper_bound(ends_s.begin(), ends_s.end(), time_s);
  return static_cast<CyclePhase>(1 + (end - ends_s.begin()));
}

PalmState HandlingCycle::palm(double time_s) const {
  PalmState palm;
  if (time_s <= lift_start_s_) return palm;
  const auto up = lift_.at(time_s - lift_start_s_);
  const auto across = transfer_.at(time_s - hold_end_s_);
  const auto down = lower_.at(time_s - transfer_end_s_);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    palm.position_m[axis] = transfer_direction_[axis] * across.position_m;
    palm.velocity_m_s[axis] = transfer_direction_[axis] * across.velocity_m_s;
    palm.acceleration_m_s2[axis] = transfer_direction_[axis] * across.acceleration_m_s2;
  }
  palm.position_m[2] = up.position_m + down.position_m;
  palm.velocity_m_s[2] = up.velocity_m_s + down.velocity_m_s;
  palm.acceleration_m_s2[2] = up.acceleration_m_s2 + down.acceleration_m_s2;
  return palm;
}

double HandlingCycle::force_limit_N(double time_s) const {
  const StrategyParameters& s = scenario_.strategy;
  if (time_s < ramp_start_s_) return s.contact_force_N;
  const double share = s.grip_ramp_s > 0.0 ? std::min(1.0, (time_s - ramp_start_s_) / s.grip_ramp_s) : 1.0;
  return s.contact_force_N + share * (s.grip_force_N - s.contact_force_N);
}

double HandlingCycle::set_speed_m_s(double time_s) const {
  const StrategyParameters& s = scenario_.strategy;
  if (time_s >= release_start_s_) return -s.release_speed_m_s;
  // Pressing at rest the drive must be able to reach its limit: gain x set speed well above it.
  if (time_s >= ramp_start_s_) {
    return std::max(s.approach_speed_m_s, 2.0 * s.grip_force_N / scenario_.gripper->drive_gain_N_s_m);
  }
  return s.approach_speed_m_s;
}

double HandlingCycle::support_height_m(double time_s) const {
  return time_s >= lift_end_s_ ? scenario_.cell.place_height_m : 0.0;
}

}  // namespace unbruised

#include "core/motion/motion_plan.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/door/require.hpp"
#include "core/scenario/conveyor.hpp"
#include "core/scenario/gripper.hpp"
#include "core/scenario/guard.hpp"
#include "core/scenario/opening.hpp"
#include "core/scenario/vectors.hpp"

namespace unbruised {
namespace {

/// An emergency stop is watched for so long after the palm has come to rest.
constexpr double kStopWatch_s = 0.3;

/// Brakes place and rate along their rate, to rest and no further.
void brake(double time_s, double deceleration, std::array<double, 3>& place, std::array<double, 3>& rate,
           std::array<double, 3>& change) {
  change = {};
  const double speed = length(rate);
  if (!(speed > 0.0)) return;
  const double braking_s = std::min(time_s, speed / deceleration);
  const double way = braking_s * (speed - 0.5 * deceleration * braking_s);
  const bool brakes = time_s < speed / deceleration;
  for (std::size_t i = 0; i < 3; ++i) {
    const double along = rate[i] / speed;
    place[i] += along * way;
    rate[i] = brakes ? along * (speed - deceleration * braking_s) : 0.0;
    change[i] = brakes ? -along * deceleration : 0.0;
  }
}

/// Along a horizontal unit vector.
PalmState horizontal(const Horizontal& direction, const MotionProfile::State& along) {
  PalmState state;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    state.position_m[axis] = direction[axis] * along.position_m;
    state.velocity_m_s[axis] = direction[axis] * along.velocity_m_s;
    state.acceleration_m_s2[axis] = direction[axis] * along.acceleration_m_s2;
  }
  return state;
}

PalmState at_place(const MovingTransfer::State& flat) {
  PalmState state;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    state.position_m[axis] = flat.place_m[axis];
    state.velocity_m_s[axis] = flat.velocity_m_s[axis];
    state.acceleration_m_s2[axis] = flat.acceleration_m_s2[axis];
  }
  return state;
}

double transfer_acceleration_m_s2(const StrategyParameters& s) {
  return s.transfer_acceleration_m_s2.value_or(s.lift_acceleration_m_s2);
}

bool target_moves(const CellParameters& cell) {
  return cell.place_velocity_m_s[0] != 0.0 || cell.place_velocity_m_s[1] != 0.0;
}

bool goes_with_belt(const Scenario& scenario) {
  return scenario.strategy.pick == PickKind::tracking && has_belt(scenario.cell);
}

/// Does the palm come to rest over its first waypoint, from a belt that it went with?
bool leaves_belt(const Scenario& scenario) {
  return goes_with_belt(scenario) && !scenario.strategy.waypoint.empty();
}

/// Is the way from the hold to the target more than one profile from rest to rest?
bool crosses_in_motion(const Scenario& scenario) {
  const bool rests = leaves_belt(scenario);
  return target_moves(scenario.cell) ||
         (!rests && (scenario.strategy.pick_offset_m != 0.0 || goes_with_belt(scenario)));
}

}  // namespace

MotionPlan::MotionPlan(const Scenario& scenario, double ramp_start_s, double guard_s, const PalmCarrier* carrier)
    : strategy_(scenario.strategy),
      guard_s_(guard_s),
      command_step_s_(scenario.simulation.time_step_s),
      command_lag_s_(scenario.simulation.theta * scenario.simulation.time_step_s),
      place_height_m_(scenario.cell.place_height_m),
      transfer_m_(scenario.cell.transfer_m),
      place_velocity_m_s_(scenario.cell.place_velocity_m_s),
      belt_(scenario.cell.conveyor),
      tracks_(unbruised::goes_with_belt(scenario)),
      target_differs_(place_height_m_ != 0.0 || has_belt(scenario.cell) || target_moves(scenario.cell) ||
                      !scenario.cell.target_plane),
      ramp_start_s_(ramp_start_s) {
  require(!std::isnan(ramp_start_s), "MotionPlan: the grip is ramped up at no time");
  if (has_gripper(scenario)) {
    const StrategyParameters& s = strategy_;
    if (leaves_belt(scenario)) leave_.emplace();
    plan_speeds(scenario);
    plan_ways(scenario);
    if (crosses_in_motion(scenario)) moving_transfer_.emplace();
    if (ramp_start_s < kNever) schedule(scenario);
    if (s.stop_time_s && *s.stop_time_s < release_start_s_) stop(scenario, carrier);
  }
  if (scenario.simulation.duration_s) end_s_ = std::min(end_s_, *scenario.simulation.duration_s);
  find_jumps();
}

void MotionPlan::find_jumps() {
  const auto add = [&](double start_s, const std::vector<double>& jumps_s) {
    for (const double jump_s : jumps_s) {
      if (start_s < kNever) jump_s_.push_back(start_s + jump_s);
    }
  };
  add(lift_start_s_, lift_.jumps_s());
  if (leave_) add(lift_end_s_, leave_->jumps_s());
  add(leave_end_s_, path_.jumps_s());
  add(hold_end_s_, moving_transfer_ ? moving_transfer_->jumps_s() : transfer_.jumps_s());
  add(level_start_s_, level_.jumps_s());
  add(transfer_end_s_, lower_.jumps_s());
  if (law_) {
    add(stop_s_, {0.0, law_->duration_s()});
  } else if (stop_s_ < kNever) {
    add(stop_s_, {0.0, length(stopped_.velocity_m_s) / stop_deceleration_m_s2_,
                  length(stopped_.spin_rad_s) / strategy_.tilt_acceleration_rad_s2});
  }
  std::ranges::sort(jump_s_);
}

bool MotionPlan::jumps_between(double from_s, double to_s) const {
  const auto next = std::ranges::lower_bound(jump_s_, from_s);
  return next != jump_s_.end() && *next <= to_s;
}

void MotionPlan::plan_speeds(const Scenario& scenario) {
  pressing_speed_m_s_ = strategy_.approach_speed_m_s;
  if (guard_s_ < kNever) {
    const bool by_force = strategy_.guard == GuardKind::force;
    pressing_speed_m_s_ = by_force ? strategy_.guard_speed_m_s : guarded_speed_m_s(ramp_start_s_ + command_lag_s_);
  }
  // Pressing at rest the drive must be able to reach its limit: gain x set speed well above it.
  if (const auto gain = drive_gain_N_s_m(scenario.gripper)) {
    pressing_speed_m_s_ = std::max(pressing_speed_m_s_, 2.0 * strategy_.grip_force_N / *gain);
  }
}

void MotionPlan::plan_ways(const Scenario& scenario) {
  const StrategyParameters& s = strategy_;
  const CellParameters& cell = scenario.cell;
  const double jerk = s.jerk_m_s3.value_or(kNever);
  lift_ = MotionProfile::plan(s.profile, cell.lift_height_m, s.lift_acceleration_m_s2, s.speed_m_s, jerk);
  const PalmPath::Limits m{s.speed_m_s, transfer_acceleration_m_s2(s), jerk};
  const PalmPath::Limits rad{s.tilt_speed_rad_s, s.tilt_acceleration_rad_s2, s.tilt_jerk_rad_s3.value_or(kNever)};
  const PalmStop placing = placing_stop(scenario);
  const std::vector<PalmStop> stops = palm_stops(scenario);
  PalmStop lifted = lifted_stop(scenario);
  if (leave_) std::copy_n(stops.front().place_m.begin(), 2, lifted.place_m.begin());
  path_ = PalmPath(lifted, stops, s.profile, m, rad);
  if (!stops.empty()) {
    PalmStop level = stops.back();
    level.attitude = placing.attitude;
    level.wait_s = 0.0;
    level.via_m.reset();
    level.speed_m_s.reset();
    level.duration_s.reset();
    level_ = PalmPath(stops.back(), {level}, s.profile, m, rad);
  }
  const Horizontal across_m = {cell.transfer_m[0] - placing.place_m[0], cell.transfer_m[1] - placing.place_m[1]};
  const double way_m = std::hypot(across_m[0], across_m[1]);
  if (way_m > 0.0) transfer_direction_ = {across_m[0] / way_m, across_m[1] / way_m};
  transfer_ = MotionProfile::plan(s.profile, way_m, m.acceleration, m.speed, jerk);
  const double end_m = cell.place_height_m + s.release_height_m - lowest_place_m(scenario, placing.attitude);
  lower_ = MotionProfile::plan(s.profile, end_m - placing.place_m[2],
                               s.lower_acceleration_m_s2.value_or(s.lift_acceleration_m_s2), s.speed_m_s, jerk);
}

void MotionPlan::schedule(const Scenario& scenario) {
  const StrategyParameters& s = strategy_;
  lift_start_s_ = ramp_start_s_ + s.grip_ramp_s + s.settle_s;
  lift_end_s_ = lift_start_s_ + lift_.duration_s();
  const auto transfer = [&](double start_s, const MovingPlace& to) {
    const PalmState from = planned_palm(start_s);
    return MovingTransfer::plan(
        s.profile, {{from.position_m[0], from.position_m[1]}, {from.velocity_m_s[0], from.velocity_m_s[1]}}, to,
        {s.speed_m_s, transfer_acceleration_m_s2(s), s.jerk_m_s3.value_or(kNever)});
  };
  leave_end_s_ = lift_end_s_;
  if (leave_) {
    const PalmState first = path_.at(0.0);
    leave_ = transfer(lift_end_s_, {{first.position_m[0], first.position_m[1]}, {}});
    leave_end_s_ += leave_->duration_s();
  }
  hold_start_s_ = leave_end_s_ + path_.duration_s();
  hold_end_s_ = hold_start_s_ + s.hold_s;
  if (moving_transfer_) moving_transfer_ = transfer(hold_end_s_, {target_m(hold_end_s_), place_velocity_m_s_});
  level_start_s_ = hold_end_s_ + (moving_transfer_ ? moving_transfer_->duration_s() : transfer_.duration_s());
  transfer_end_s_ = level_start_s_ + level_.duration_s();
  lower_end_s_ = transfer_end_s_ + lower_.duration_s();
  release_start_s_ = lower_end_s_ + s.place_settle_s;
  release_end_s_ = release_start_s_ + approach_gap_m(scenario) / s.release_speed_m_s;
  end_s_ = release_end_s_ + s.recover_s;
}

/// Nothing that is planned for later comes.
void MotionPlan::stop(const Scenario& scenario, const PalmCarrier* carrier) {
  const double time_s = *strategy_.stop_time_s;
  if (carrier != nullptr) law_ = carrier->stop(*this, time_s);
  if (law_) unstopped_ = std::make_shared<const MotionPlan>(*this);
  stop_s_ = time_s;
  stop_deceleration_m_s2_ = scenario.cell.stop_deceleration_m_s2;
  stopped_ = planned_palm(time_s);
  for (double* event_s : {&lift_start_s_, &lift_end_s_, &hold_start_s_, &hold_end_s_, &level_start_s_,
                          &transfer_end_s_, &lower_end_s_, &release_start_s_, &release_end_s_}) {
    if (*event_s > time_s) *event_s = kNever;
  }
  const double braking_s = std::max(length(stopped_.velocity_m_s) / stop_deceleration_m_s2_,
                                    length(stopped_.spin_rad_s) / strategy_.tilt_acceleration_rad_s2);
  end_s_ = time_s + (law_ ? law_->duration_s() : braking_s) + kStopWatch_s;
}

MotionPlan MotionPlan::tracked(std::shared_ptr<const PalmTrack> track) const {
  MotionPlan plan = *this;
  plan.track_ = std::move(track);
  return plan;
}

CyclePhase MotionPlan::phase_after_contact(double time_s) const {
  if (is_stopped(time_s)) return CyclePhase::stop;
  struct PhaseEnd {
    double time_s;
    CyclePhase phase;
  };
  const std::array<PhaseEnd, 8> ends = {{{lift_start_s_, CyclePhase::grip},
                                         {lift_end_s_, CyclePhase::lift},
                                         {hold_start_s_, CyclePhase::turn},
                                         {hold_end_s_, CyclePhase::hold},
                                         {level_start_s_, CyclePhase::transfer},
                                         {transfer_end_s_, CyclePhase::turn},
                                         {release_start_s_, CyclePhase::lower},
                                         {release_end_s_, CyclePhase::release}}};
  const auto end = std::ranges::find_if(ends, [time_s](const PhaseEnd& each) { return time_s < each.time_s; });
  return end == ends.end() ? CyclePhase::recover : end->phase;
}

PalmState MotionPlan::palm(double time_s) const {
  return track_ && time_s > track_->start_s() ? track_->at(time_s) : told_palm(time_s);
}

PalmState MotionPlan::told_palm(double time_s) const {
  return is_stopped(time_s) ? braking_palm(time_s) : planned_palm(time_s);
}

PalmState MotionPlan::braking_palm(double time_s) const {
  if (law_) {
    const StopLaw::State s = law_->at(time_s - stop_s_);
    return StopLaw::slowed(unstopped_->planned_palm(s.plan_s), s);
  }
  PalmState palm = stopped_;
  brake(time_s - stop_s_, stop_deceleration_m_s2_, palm.position_m, palm.velocity_m_s, palm.acceleration_m_s2);
  std::array<double, 3> turn_rad{};
  brake(time_s - stop_s_, strategy_.tilt_acceleration_rad_s2, turn_rad, palm.spin_rad_s,
        palm.spin_acceleration_rad_s2);
  palm.rotation_rad = rotation_to(attitude_of(turn_rad) * attitude_of(stopped_.rotation_rad));
  return palm;
}

PalmState MotionPlan::planned_palm(double time_s) const {
  PalmState palm = path_.at(time_s - leave_end_s_);
  if (time_s > level_start_s_) {
    const PalmState level = level_.at(time_s - level_start_s_);
    palm.rotation_rad = level.rotation_rad;
    palm.spin_rad_s = level.spin_rad_s;
    palm.spin_acceleration_rad_s2 = level.spin_acceleration_rad_s2;
  }
  go_across(time_s, palm);
  const auto up = lift_.at(time_s - lift_start_s_), down = lower_.at(time_s - transfer_end_s_);
  palm.position_m[2] = time_s < lift_end_s_ ? up.position_m : palm.position_m[2] + down.position_m;
  palm.velocity_m_s[2] += up.velocity_m_s + down.velocity_m_s;
  palm.acceleration_m_s2[2] += up.acceleration_m_s2 + down.acceleration_m_s2;
  return palm;
}

void MotionPlan::go_across(double time_s, PalmState& palm) const {
  PalmState flat;
  bool knows_its_place = true;  // else it goes on from where the stops are
  if (tracks_ && time_s <= (leave_ ? lift_end_s_ : hold_end_s_)) {
    MotionProfile::State along = belt_.at(time_s - strategy_.tracking_lag_s);
    along.position_m += strategy_.pick_offset_m;
    flat = horizontal(belt_.direction(), along);
  } else if (leave_ && time_s <= leave_end_s_) {
    flat = at_place(leave_->at(time_s - lift_end_s_));
  } else if (moving_transfer_ && time_s > hold_end_s_) {
    flat = at_place(moving_transfer_->at(time_s - hold_end_s_));
  } else {
    if (!moving_transfer_) flat = horizontal(transfer_direction_, transfer_.at(time_s - hold_end_s_));
    knows_its_place = false;
  }
  for (std::size_t axis = 0; axis < 2; ++axis) {
    palm.position_m[axis] = (knows_its_place ? 0.0 : palm.position_m[axis]) + flat.position_m[axis];
    palm.velocity_m_s[axis] += flat.velocity_m_s[axis];
    palm.acceleration_m_s2[axis] += flat.acceleration_m_s2[axis];
  }
}

double MotionPlan::force_limit_N(double time_s) const {
  const StrategyParameters& s = strategy_;
  time_s = std::min(time_s, stop_s_);
  if (time_s < ramp_start_s_) return s.contact_force_N;
  return s.contact_force_N + ramped(time_s) * (s.grip_force_N - s.contact_force_N);
}

double MotionPlan::ramped(double time_s) const {
  const double ramp_s = strategy_.grip_ramp_s;
  return ramp_s > 0.0 ? std::min(1.0, (time_s - ramp_start_s_) / ramp_s) : 1.0;
}

/// What an instrument shows within a step is known at its end. The drives hear of it as late in the step after, so
/// that the motion is as continuous in the time of the guard as in any other.
double MotionPlan::told(double time_s) const {
  if (!(guard_s_ < kNever) || time_s < guard_s_) return 1.0;
  return std::clamp((time_s - command_lag_s_ - guard_s_) / command_step_s_, 0.0, 1.0);
}

double MotionPlan::locked(double time_s, double end_s, double step_s) const {
  if (time_s >= release_start_s_) return 0.0;
  return std::clamp((end_s - lift_start_s_) / step_s, 0.0, 1.0);
}

double MotionPlan::guarded_speed_m_s(double time_s) const {
  if (time_s < guard_s_) return strategy_.approach_speed_m_s;
  const double slow = strategy_.guard_speed_m_s;
  // A grip that the guard has begun presses with a speed that rises as the force's limit does.
  const bool presses = strategy_.guard == GuardKind::force && time_s >= ramp_start_s_;
  return presses ? slow + ramped(time_s) * (pressing_speed_m_s_ - slow) : slow;
}

double MotionPlan::set_speed_m_s(double time_s) const {
  if (is_stopped(time_s) && ramp_start_s_ >= stop_s_) return 0.0;
  if (time_s >= release_start_s_) return -strategy_.release_speed_m_s;
  const bool is_begun_by_guard = strategy_.guard == GuardKind::force && guard_s_ < kNever;
  if (time_s < ramp_start_s_ || is_begun_by_guard) return guarded_speed_m_s(time_s);
  return pressing_speed_m_s_;
}

SupportPlane MotionPlan::support_plane(double time_s) const {
  return target_differs_ && time_s >= lift_end_s_ ? SupportPlane::target : SupportPlane::start;
}

PalmState MotionPlan::support(SupportPlane plane, double time_s) const {
  if (plane == SupportPlane::start) return horizontal(belt_.direction(), belt_.at(time_s));
  PalmState state;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    state.position_m[axis] = place_velocity_m_s_[axis] * time_s;
    state.velocity_m_s[axis] = place_velocity_m_s_[axis];
  }
  state.position_m[2] = place_height_m_;
  return state;
}

Horizontal MotionPlan::target_m(double time_s) const {
  return {transfer_m_[0] + place_velocity_m_s_[0] * time_s, transfer_m_[1] + place_velocity_m_s_[1] * time_s};
}

MotionPlan planned_motion(const Scenario& scenario, const PalmCarrier* carrier) {
  const double contact_s = scenario.strategy.ramp_from_start ? 0.0 : planned_approach(scenario).time_s;
  return MotionPlan(scenario, contact_s, kNever, carrier);
}

double planned_end_s(const Scenario& scenario) {
  const double once_s =
      has_gripper(scenario) ? planned_motion(scenario).end_s() : scenario.simulation.duration_s.value_or(0.0);
  return scenario.strategy.repeat * once_s;
}

}  // namespace unbruised

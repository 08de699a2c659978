#include "core/outcome/handling_record.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "core/outcome/damage_limits.hpp"
#include "core/scenario/conveyor.hpp"
#include "core/scenario/gripper.hpp"
#include "core/scenario/palm_stops.hpp"
#include "core/scenario/product.hpp"
#include "core/scenario/vectors.hpp"
#include "core/scenario/words.hpp"

namespace unbruised {
namespace {

/// Tangential forces below this share of the normal force say nothing about the friction margin.
constexpr double kLeastTangentialShare = 1e-6;

bool touches(const FingerObservation& finger) { return finger.closed_contacts > 0; }

double norm(const std::array<double, 3>& x) { return std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]); }

/// Numbers that overflow while the motion itself is finite: a squared speed of 1e200 m/s. None of them may look
/// like a measurement; NaN is "does not exist".
void refuse_infinite_metrics(ScenarioResult& result, double end_time_s) {
  for (std::size_t i = 0; i < kMetricCount; ++i) {
    double& value = result.metrics.values()[i];
    if (!std::isinf(value)) continue;
    value = std::numeric_limits<double>::quiet_NaN();
    if (result.outcome == Outcome::diverged) continue;
    result.outcome = Outcome::diverged;
    result.cause = std::string(kMetricTable[i].name) + " is not finite";
    result.outcome_time_s = end_time_s;
  }
}

}  // namespace

std::optional<double> friction_margin(const FingerObservation& finger, double friction,
                                      const LimitParameters& limits) {
  if (!touches(finger)) return std::nullopt;
  if (finger.sliding_contacts >= finger.closed_contacts) {
    return -std::max(finger.slip_m / limits.slip_m, finger.slip_rad / limits.slip_rad);
  }
  const double tangential = std::hypot(finger.tangent_N[0], finger.tangent_N[1]);
  if (tangential <= kLeastTangentialShare * finger.normal_N) return std::nullopt;
  return friction * finger.normal_N / tangential - 1.0;
}

HandlingRecord::HandlingRecord(const Scenario& scenario)
    : limits_(scenario.limits),
      friction_(product_friction(scenario.product)),
      hold_s_(scenario.strategy.hold_s),
      placing_attitude_(placing_stop(scenario).attitude),
      has_gripper_(has_gripper(scenario)),
      lists_fingers_(lists_fingers(scenario)),
      has_belt_(has_belt(scenario.cell)),
      has_product_yield_(yield_stress_Pa(scenario.product).has_value()) {
  if (has_gripper_) {
    const auto shift_m = centre_shift_m(scenario, placing_attitude_);
    placing_shift_m_ = {shift_m[0], shift_m[1]};
    for (Metric metric :
         {Metric::peak_finger_force_N, Metric::peak_pressure_Pa, Metric::compression_max_m, Metric::slip_max_m,
          Metric::slip_max_rad, Metric::peak_sensor_force_N, Metric::peak_sensor_torque_N_m,
          Metric::peak_acceleration_m_s2, Metric::grip_impulse_N_s}) {
      metrics[metric] = 0.0;
    }
  }
  const bool touches_something = has_gripper_ || scenario.cell.support;
  if (has_product_yield_ && touches_something) metrics[Metric::contact_yield_ratio_max] = 0.0;
  if (has_belt_) metrics[Metric::belt_slip_m] = 0.0;
  if (arm_sways(scenario)) metrics[Metric::robot_sway_max_m] = 0.0;
}

HandlingRecord HandlingRecord::next(const Scenario& scenario) const {
  HandlingRecord next(scenario);
  next.patches_ = patches_;
  next.absorbed_before_J_ = next.absorbed_J_ = absorbed_J_;
  return next;
}

void HandlingRecord::raise(Metric metric, double value) { metrics[metric] = std::max(metrics[metric], value); }

void HandlingRecord::check_limits(std::initializer_list<Metric> changed, double time_s, std::string_view where) {
  for (const Metric metric : changed) {
    const auto limit = std::find_if(kDamageLimits.begin(), kDamageLimits.end(),
                                    [&](const DamageLimit& each) { return each.metric == metric; });
    if (exceeds(metrics, *limit, limits_)) damaged_.at(time_s, std::string(limit->cause).append(where));
  }
}

bool HandlingRecord::observe(const StepObservation& now, const HandlingCycle& cycle) {
  for (std::size_t s = 0; s < kSurfaceCount; ++s) patches_.raise(s, now.patch[s]);
  const PatchDamage patches = patches_.together();
  metrics[Metric::plastic_strain_max] = std::max(now.plastic_strain, patches.plastic_strain);
  absorbed_J_ = absorbed_before_J_ + now.absorbed_energy_J;
  metrics[Metric::absorbed_energy_J] = std::max(absorbed_J_, patches.absorbed_energy_J);
  check_limits({Metric::plastic_strain_max, Metric::absorbed_energy_J}, now.time_s);
  observe_belt(now, cycle);
  if (!has_gripper_) {
    observe_support(now);
    return true;
  }
  observe_places(now, cycle);
  observe_grip(now);
  observe_support(now);
  observe_impulse(now, cycle);
  observe_transition(now, cycle);
  if (!cycle.has_contact() || !cycle.grip_started()) {
    observe_approach(now, cycle);
    return !not_grasped_.happened();
  }
  const bool both = std::ranges::count_if(now.fingers(), touches) >= 2;
  // The last contacts that still belong to the grip phase: later ones may have seen the release begin.
  if (now.register_time_s <= cycle.plan().lift_start_s()) both_touched_ = both;
  if (now.time_s < cycle.plan().lift_start_s()) return true;
  if (!grasp_checked_) {
    grasp_checked_ = true;
    if (!both_touched_) {
      not_grasped_.at(cycle.plan().lift_start_s(),
                      lists_fingers_ ? "fewer than two fingers touch at the end of the grip phase"
                                     : "not both fingers touch at the end of the grip phase");
    }
  }
  // From the first step that looks past the start of the release on, an open contact is no drop.
  if (now.register_time_s < cycle.plan().release_start_s()) {
    if (std::ranges::none_of(now.fingers(), touches))
      dropped_.at(now.time_s, "no finger contact between lift and release");
    observe_carrying(now, cycle);
  }
  return !dropped_.happened() && !not_grasped_.happened();
}

void HandlingRecord::observe_approach(const StepObservation& now, const HandlingCycle& cycle) {
  const bool has_contact = cycle.has_contact();
  if (now.end_of_stroke) {
    not_grasped_.at(now.time_s, has_contact
                                    ? "the fingers reached the end of their stroke before the guard felt a contact"
                                    : "the fingers reached the end of their stroke without a contact");
  }
  if (now.time_s > cycle.approach_deadline_s()) {
    not_grasped_.at(now.time_s, has_contact ? "the guard felt no contact in twice the time of the stroke"
                                            : "no contact in twice the time of the stroke");
  }
}

void HandlingRecord::observe_transition(const StepObservation& now, const HandlingCycle& cycle) {
  std::array<TouchObservation, kMostFingers> finger;
  for (std::size_t f = 0; f < now.finger_count; ++f) {
    const FingerObservation& seen = now.finger[f];
    finger[f] = {touches(seen), seen.touched_s, seen.left_s, seen.normal_N};
  }
  transition_.observe(now.time_s, std::span(finger).first(now.finger_count), cycle);
}

void HandlingRecord::observe_grip(const StepObservation& now) {
  for (const FingerObservation& finger : now.fingers()) {
    raise(Metric::peak_finger_force_N, finger.normal_N);
    if (has_product_yield_) raise(Metric::contact_yield_ratio_max, finger.yield_ratio);
    finger_yield_ratio_ = std::max(finger_yield_ratio_, finger.yield_ratio);
  }
  for (std::size_t f = 0; f < now.finger_count; ++f) finger_rise_[f].observe(now.finger[f].normal_N);
  raise(Metric::peak_pressure_Pa, now.patch_pressure_Pa);
  raise(Metric::compression_max_m, now.compression_m);
  raise(Metric::peak_sensor_force_N, norm(now.force_N));
  raise(Metric::peak_sensor_torque_N_m, norm(now.torque_N_m));
  check_limits({Metric::peak_finger_force_N, Metric::peak_pressure_Pa, Metric::contact_yield_ratio_max},
               now.time_s);
}

void HandlingRecord::observe_support(const StepObservation& now) {
  support_rise_.observe(now.support_N);
  if (!has_product_yield_) return;
  support_yield_ratio_ = std::max(support_yield_ratio_, now.support_yield_ratio);
  raise(Metric::contact_yield_ratio_max, now.support_yield_ratio);
  check_limits({Metric::contact_yield_ratio_max}, now.time_s, " at the support");
}

/// Until the lift starts; a belt that nobody picks from is looked at to the end.
void HandlingRecord::observe_belt(const StepObservation& now, const HandlingCycle& cycle) {
  if (!has_belt_ || now.time_s > cycle.plan().lift_start_s()) return;
  const PalmState belt = cycle.plan().support(SupportPlane::start, now.time_s);
  raise(Metric::belt_slip_m,
        std::hypot(now.center_motion_m[0] - belt.position_m[0], now.center_motion_m[1] - belt.position_m[1]));
}

void HandlingRecord::observe_places(const StepObservation& now, const HandlingCycle& cycle) {
  if (cycle.plan().has_track()) {
    const std::array<double, 3> told_m = cycle.plan().told_palm(now.time_s).position_m;
    raise(Metric::robot_sway_max_m, norm(between(told_m, now.palm_m)));
  }
  const auto& [x, y, z] = now.center_motion_m;
  if (cycle.has_contact() && now.time_s <= cycle.plan().lift_start_s()) {
    metrics[Metric::pick_error_m] = std::hypot(x - now.palm_m[0], y - now.palm_m[1]);
  }
  if (now.time_s < cycle.plan().release_end_s()) return;
  const Horizontal target = cycle.plan().target_m(now.time_s);
  metrics[Metric::place_error_m] =
      std::hypot(x - target[0] - placing_shift_m_[0], y - target[1] - placing_shift_m_[1]);
  metrics[Metric::place_attitude_rad] =
      now.attitude ? angle_between_rad(*now.attitude, placing_attitude_) : now.rotation_rad;
}

/// Of the finger that presses hardest; of the support where it comes nearer to yield than they.
double HandlingRecord::peak_rise_steps() const {
  if (!has_gripper_ || support_yield_ratio_ > finger_yield_ratio_) return support_rise_.steps();
  const auto hardest =
      std::max_element(finger_rise_.begin(), finger_rise_.end(),
                       [](const PeakRise& a, const PeakRise& b) { return a.peak_N() < b.peak_N(); });
  return hardest->steps();
}

/// Trapezoid rule; the step in which the fingers open counts up to that moment, so that the integral is as
/// continuous in the strategy as the force is.
void HandlingRecord::observe_impulse(const StepObservation& now, const HandlingCycle& cycle) {
  double normal_N = 0.0;
  for (const FingerObservation& finger : now.fingers()) normal_N += finger.normal_N;
  normal_N /= static_cast<double>(now.finger_count);
  const double step_s = now.time_s - impulse_time_s_;
  const double counted_s = std::clamp(cycle.plan().release_start_s() - impulse_time_s_, 0.0, step_s);
  if (counted_s > 0.0) {
    const double end_N = impulse_normal_N_ + (normal_N - impulse_normal_N_) * counted_s / step_s;
    metrics[Metric::grip_impulse_N_s] += 0.5 * (impulse_normal_N_ + end_N) * counted_s;
  }
  impulse_time_s_ = now.time_s;
  impulse_normal_N_ = normal_N;
}

void HandlingRecord::observe_carrying(const StepObservation& now, const HandlingCycle& cycle) {
  for (const FingerObservation& finger : now.fingers()) {
    if (!touches(finger)) continue;
    raise(Metric::slip_max_m, finger.slip_m);
    raise(Metric::slip_max_rad, finger.slip_rad);
  }
  for (const SlipLimit& limit : kSlipLimits) {
    if (exceeds(metrics, limit, limits_)) slipped_.at(now.time_s, limit.cause);
  }
  observe_leaving(now);
  if (now.time_s <= cycle.plan().lower_end_s()) {
    raise(Metric::peak_acceleration_m_s2, norm(now.center_acceleration_m_s2));
    double& least = metrics[Metric::friction_margin_min];
    for (const FingerObservation& finger : now.fingers()) {
      const std::optional<double> margin = friction_margin(finger, friction_, limits_);
      if (margin) least = std::isnan(least) ? *margin : std::min(least, *margin);
    }
  }
  observe_hold(now, cycle);
}

/// A product that is turned across pushes the finger below it back where its weight is more than both drives
/// press.
void HandlingRecord::observe_leaving(const StepObservation& now) {
  if (std::ranges::all_of(now.fingers(), touches)) {
    pressed_m_ = now.compression_m;
  } else if (pressed_m_ - now.compression_m > static_cast<double>(now.finger_count) * limits_.slip_m) {
    slipped_.at(now.time_s, "the product leaves a pad by more than limits.slip_m");
  }
}

void HandlingRecord::observe_hold(const StepObservation& now, const HandlingCycle& cycle) {
  if (hold_s_ <= 0.0 || now.time_s < cycle.plan().hold_start_s() + 0.75 * hold_s_ ||
      now.time_s > cycle.plan().hold_end_s())
    return;
  std::array<double, 3> place{};
  for (std::size_t i = 0; i < 3; ++i) place[i] = now.center_motion_m[i] - now.palm_m[i];
  if (!drift_started_) {
    drift_started_ = true;
    drift_from_s_ = now.time_s;
    drift_from_m_ = place;
  }
  drift_to_s_ = now.time_s;
  drift_to_m_ = place;
}

void HandlingRecord::abort(Outcome outcome, std::string cause, double time_s) {
  if (aborted_) return;
  aborted_ = true;
  abort_outcome_ = outcome;
  abort_ = {time_s, std::move(cause)};
}

ScenarioResult HandlingRecord::finish(const HandlingCycle& cycle, double end_time_s) const {
  HandlingRecord record = *this;
  const PatchDamage patches = patches_.together();
  record.raise(Metric::permanent_set_max_m, patches.set_m);
  record.raise(Metric::bruised_volume_m3, patches.bruised_volume_m3);
  record.raise(Metric::bruised_area_m2, patches.bruised_area_m2);
  record.raise(Metric::bruised_depth_m, patches.bruised_depth_m);
  record.check_limits({Metric::permanent_set_max_m, Metric::bruised_volume_m3}, end_time_s);
  for (const PlaceLimit& limit : kPlaceLimits) {
    if (exceeds(record.metrics, limit, limits_)) record.misplaced_.at(end_time_s, limit.cause);
  }
  ScenarioResult result;
  result.metrics = record.metrics;
  if (drift_to_s_ > drift_from_s_) {
    std::array<double, 3> way{};
    for (std::size_t i = 0; i < 3; ++i) way[i] = drift_to_m_[i] - drift_from_m_[i];
    result.metrics[Metric::hold_drift_m_s] = norm(way) / (drift_to_s_ - drift_from_s_);
  }
  result.metrics[Metric::peak_rise_steps] = peak_rise_steps();
  if (has_gripper_) transition_.measure(result.metrics);
  if (cycle.has_contact()) result.metrics[Metric::first_contact_time_s] = cycle.first_contact_s();
  if (has_gripper_ && cycle.plan().lift_start_s() < kNever) {
    result.metrics[Metric::lift_time_s] = cycle.plan().lift_start_s();
    if (cycle.plan().release_end_s() < kNever) {
      result.metrics[Metric::cycle_time_s] = cycle.plan().release_end_s();
    }
  }
  const auto set = [&](Outcome outcome, const Crossing& crossing) {
    result.outcome = outcome;
    result.cause = crossing.cause;
    result.outcome_time_s = crossing.time_s;
  };
  if (aborted_) {
    set(abort_outcome_, abort_);
  } else if (std::abs(record.metrics[Metric::energy_balance_error]) > kEnergyErrorMost) {
    set(Outcome::out_of_range,
        {end_time_s, "more than " + in_per_cent(kEnergyErrorMost) + " of the energy put in is unaccounted for"});
  } else if (record.not_grasped_.happened()) {
    set(Outcome::not_grasped, record.not_grasped_);
  } else if (record.dropped_.happened()) {
    set(Outcome::dropped, record.dropped_);
  } else if (record.slipped_.happened()) {
    set(Outcome::slipped, record.slipped_);
  } else if (record.damaged_.happened()) {
    set(Outcome::damaged, record.damaged_);
  } else if (record.misplaced_.happened()) {
    set(Outcome::misplaced, record.misplaced_);
  } else {
    result.outcome = Outcome::held;
  }
  refuse_infinite_metrics(result, end_time_s);
  return result;
}

}  // namespace unbruised

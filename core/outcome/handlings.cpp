#include "core/outcome/handlings.hpp"

#include <algorithm>
#include <cmath>

namespace unbruised {
namespace {

double both(OverHandlings rule, double before, double now) {
  if (std::isnan(before) || rule == OverHandlings::last) return now;
  if (std::isnan(now)) return before;
  switch (rule) {
    case OverHandlings::largest:
      return std::max(before, now);
    case OverHandlings::smallest:
      return std::min(before, now);
    case OverHandlings::sum:
      return before + now;
    case OverHandlings::farthest:
      return std::abs(now) > std::abs(before) ? now : before;
    case OverHandlings::last:
      break;
  }
  return now;
}

}  // namespace

OverHandlings over_handlings(Metric metric) {
  switch (metric) {
    // What the product keeps, or has taken so far.
    case Metric::permanent_set_max_m:
    case Metric::permanent_set_rms_m:
    case Metric::plastic_strain_max:
    case Metric::bruised_volume_m3:
    case Metric::bruised_area_m2:
    case Metric::bruised_depth_m:
    case Metric::absorbed_energy_J:
    // Times of one handling.
    case Metric::cycle_time_s:
    case Metric::first_contact_time_s:
    case Metric::lift_time_s:
    case Metric::peak_sensor_force_time_s:
    case Metric::robot_cycle_time_s:
    case Metric::robot_joint_travel_rad:
    // The same in all.
    case Metric::modes_left_out_share:
      return OverHandlings::last;
    case Metric::friction_margin_min:
    case Metric::peak_rise_steps:
    case Metric::robot_least_manipulability:
      return OverHandlings::smallest;
    case Metric::energy_input_J:
    case Metric::step_count:
    case Metric::contact_iterations:
    case Metric::plasticity_iterations:
    case Metric::grip_impulse_N_s:
    case Metric::contact_rebounds:
    case Metric::contact_loss_s:
      return OverHandlings::sum;
    case Metric::energy_balance_error:
    case Metric::impulse_balance_error:
    case Metric::angular_impulse_balance_error:
      return OverHandlings::farthest;
    case Metric::contact_yield_ratio_max:
    case Metric::peak_finger_force_N:
    case Metric::peak_pressure_Pa:
    case Metric::compression_max_m:
    case Metric::slip_max_m:
    case Metric::slip_max_rad:
    case Metric::hold_drift_m_s:
    case Metric::peak_sensor_force_N:
    case Metric::peak_sensor_torque_N_m:
    case Metric::sensor_overload:
    case Metric::peak_acceleration_m_s2:
    case Metric::belt_slip_m:
    case Metric::pick_error_m:
    case Metric::place_error_m:
    case Metric::place_attitude_rad:
    case Metric::time_to_steady_force_s:
    case Metric::robot_speed_use:
    case Metric::robot_acceleration_use:
    case Metric::robot_torque_use:
    case Metric::robot_position_use:
    case Metric::robot_jerk_use:
    case Metric::robot_sway_max_m:
    case Metric::count_:
      break;
  }
  return OverHandlings::largest;
}

void Handlings::add(const ScenarioResult& handling, double duration_s) {
  const ScenarioResult before = together_;
  together_ = handling;
  together_.outcome_time_s += before_s_;
  before_s_ += duration_s;
  ++done_;
  if (count_ > 1 && handling.outcome != Outcome::held) {
    together_.cause =
        "handling " + std::to_string(done_) + " of " + std::to_string(count_) + ": " + together_.cause;
  }
  if (done_ == 1) return;
  for (const MetricInfo& info : kMetricTable) {
    double& value = together_.metrics[info.metric];
    value = both(over_handlings(info.metric), before.metrics[info.metric], value);
  }
}

}  // namespace unbruised

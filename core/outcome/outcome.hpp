#pragma once

/// @file
/// The closed list of outcomes and the metrics of a scenario: what a run says about itself.
/// Definitions follow docs/metrics.md; that page and `kMetricTable` are held together by a test.

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

namespace unbruised {

/// How a scenario ended. The codes are part of the results format and never change.
enum class Outcome : std::int8_t {
  not_run = -1,
  held = 0,
  slipped = 1,
  dropped = 2,
  damaged = 3,
  not_grasped = 4,
  diverged = 5,
  out_of_range = 6,
  misplaced = 7,
};

inline constexpr std::array<std::string_view, 8> kOutcomeWords = {
    "held", "slipped", "dropped", "damaged", "not_grasped", "diverged", "out_of_range", "misplaced"};

/// The word of an outcome ("not_run" for -1).
constexpr std::string_view outcome_word(Outcome outcome) {
  return outcome == Outcome::not_run ? std::string_view("not_run")
                                     : kOutcomeWords[static_cast<std::size_t>(outcome)];
}

/// Index of a metric in `Metrics` and in `kMetricTable`.
enum class Metric : std::uint8_t {
  permanent_set_max_m,
  permanent_set_rms_m,
  plastic_strain_max,
  bruised_volume_m3,
  absorbed_energy_J,
  contact_yield_ratio_max,
  peak_finger_force_N,
  peak_pressure_Pa,
  compression_max_m,
  slip_max_m,
  friction_margin_min,
  hold_drift_m_s,
  peak_sensor_force_N,
  peak_sensor_torque_N_m,
  peak_acceleration_m_s2,
  cycle_time_s,
  first_contact_time_s,
  lift_time_s,
  energy_input_J,
  energy_balance_error,
  impulse_balance_error,
  step_count,
  contact_iterations,
  plasticity_iterations,
  grip_impulse_N_s,
  slip_max_rad,
  peak_rise_steps,
  belt_slip_m,
  pick_error_m,
  place_error_m,
  place_attitude_rad,
  angular_impulse_balance_error,
  peak_sensor_force_time_s,
  sensor_overload,
  contact_rebounds,
  contact_loss_s,
  time_to_steady_force_s,
  robot_speed_use,
  robot_acceleration_use,
  robot_torque_use,
  robot_position_use,
  robot_least_manipulability,
  robot_joint_travel_rad,
  robot_cycle_time_s,
  bruised_area_m2,
  bruised_depth_m,
  modes_left_out_share,
  robot_jerk_use,
  robot_sway_max_m,
  count_  // not a metric: the number of them
};

inline constexpr std::size_t kMetricCount = static_cast<std::size_t>(Metric::count_);

/// One row of the metric table.
struct MetricInfo {
  Metric metric;
  std::string_view name;       ///< column name, unit included
  std::string_view words;      ///< what people call it: lower case, without a unit
  std::string_view units;      ///< UDUNITS spelling, "1" for dimensionless
  std::string_view long_name;  ///< one line for plots and reports
};

inline constexpr std::array<MetricInfo, kMetricCount> kMetricTable = {{
    {Metric::permanent_set_max_m, "permanent_set_max_m", "permanent set", "m",
     "largest particle displacement of the shape the plastic strain alone leaves, rigid motion removed"},
    {Metric::permanent_set_rms_m, "permanent_set_rms_m", "permanent set, r.m.s.", "m",
     "root mean square over all particles of the permanent set"},
    {Metric::plastic_strain_max, "plastic_strain_max", "plastic strain", "1",
     "largest accumulated equivalent plastic strain of any cell (network: plastic elongation over rest length)"},
    {Metric::bruised_volume_m3, "bruised_volume_m3", "bruised volume", "m3",
     "volume of the cells whose accumulated plastic strain exceeds limits.plastic_strain"},
    {Metric::absorbed_energy_J, "absorbed_energy_J", "absorbed energy", "J", "plastic work done in the product"},
    {Metric::contact_yield_ratio_max, "contact_yield_ratio_max", "contact yield ratio", "1",
     "largest mean pressure of a contact patch, of a finger or the support, over the one at first yield"},
    {Metric::peak_finger_force_N, "peak_finger_force_N", "peak finger force", "N",
     "largest normal force between one finger and the product"},
    {Metric::peak_pressure_Pa, "peak_pressure_Pa", "peak pressure", "Pa",
     "largest contact pressure averaged over a square patch of fixed size"},
    {Metric::compression_max_m, "compression_max_m", "compression", "m",
     "largest approach of the two pad faces past the product's undeformed width"},
    {Metric::slip_max_m, "slip_max_m", "slip", "m",
     "largest way over fingers that the product has slipped past a pad since the end of grip"},
    {Metric::friction_margin_min, "friction_margin_min", "friction margin", "1",
     "smallest friction_coefficient x normal force / tangential force - 1 of a finger from lift to lower"},
    {Metric::hold_drift_m_s, "hold_drift_m_s", "hold drift", "m s-1",
     "speed of the product relative to the palm, averaged over the last quarter of the hold"},
    {Metric::peak_sensor_force_N, "peak_sensor_force_N", "peak sensor force", "N",
     "largest force that the six-axis sensor reads; without one what an ideal wrist sensor reads from the "
     "product"},
    {Metric::peak_sensor_torque_N_m, "peak_sensor_torque_N_m", "peak sensor torque", "N m",
     "largest torque that the six-axis sensor reads; without one what an ideal wrist sensor reads about the palm "
     "centre"},
    {Metric::peak_acceleration_m_s2, "peak_acceleration_m_s2", "peak acceleration", "m s-2",
     "largest acceleration of the product's centre of mass while it is carried"},
    {Metric::cycle_time_s, "cycle_time_s", "cycle time", "s", "start of approach to end of release"},
    {Metric::first_contact_time_s, "first_contact_time_s", "time of first contact", "s",
     "first contact of a finger with the product"},
    {Metric::lift_time_s, "lift_time_s", "start of the lift", "s", "start of the lift"},
    {Metric::energy_input_J, "energy_input_J", "energy put in", "J",
     "work put in: positive work of drives, palm, gravity, loads and initial motion"},
    {Metric::energy_balance_error, "energy_balance_error", "energy balance error", "1",
     "(stored + dissipated - work done) / work put in; positive: energy appeared"},
    {Metric::impulse_balance_error, "impulse_balance_error", "impulse balance error", "1",
     "|change of momentum - sum of force x dt| / (m g T)"},
    {Metric::step_count, "step_count", "time steps", "1", "time steps taken"},
    {Metric::contact_iterations, "contact_iterations", "contact iterations", "1",
     "Gauss-Seidel sweeps over the contacts, all steps"},
    {Metric::plasticity_iterations, "plasticity_iterations", "plasticity iterations", "1",
     "extra solves that plastic flow needed, all steps"},
    {Metric::grip_impulse_N_s, "grip_impulse_N_s", "grip impulse", "N s",
     "time integral of a finger's normal force, mean of both, up to the release; creep set x dashpot constant"},
    {Metric::slip_max_rad, "slip_max_rad", "angle of slip", "rad",
     "largest angle over fingers that the product has turned against a pad since the end of grip"},
    {Metric::peak_rise_steps, "peak_rise_steps", "steps of the peak's rise", "1",
     "fewest time steps in which the force that decides rose by half of its peak, 8 where they are as many or "
     "more"},
    {Metric::belt_slip_m, "belt_slip_m", "slip on the belt", "m",
     "largest way of the product's centre of mass against the belt until the lift starts"},
    {Metric::pick_error_m, "pick_error_m", "pick error", "m",
     "horizontal way of the product's centre of mass against the palm from the start of the run to that of the "
     "lift"},
    {Metric::place_error_m, "place_error_m", "place error", "m",
     "horizontal distance of the product's centre of mass from its place on the target, at the end of the run"},
    {Metric::place_attitude_rad, "place_attitude_rad", "attitude when placed", "rad",
     "angle between how the product stands at the end of the run and how it was to stand: turned by the last "
     "waypoint"},
    {Metric::angular_impulse_balance_error, "angular_impulse_balance_error", "angular impulse balance error", "1",
     "|change of angular momentum - sum of moment x dt| / (its size at the start + sum of |moment| x dt), about "
     "the centre of mass of a product that may turn"},
    {Metric::peak_sensor_force_time_s, "peak_sensor_force_time_s", "time of the peak sensor force", "s",
     "when the six-axis sensor read its largest force"},
    {Metric::sensor_overload, "sensor_overload", "sensor overload", "1",
     "largest component that the six-axis sensor had to read over its range; beyond 1 it was cut off"},
    {Metric::contact_rebounds, "contact_rebounds", "rebounds", "1",
     "how often a finger lost the product between its first touch and the lift, both fingers together"},
    {Metric::contact_loss_s, "contact_loss_s", "time without contact", "s",
     "time between its first touch and the lift in which a finger did not touch the product, both fingers "
     "together"},
    {Metric::time_to_steady_force_s, "time_to_steady_force_s", "time to a steady force", "s",
     "from a finger's first touch until its force stays within 5 % of what it is as the lift starts, the later "
     "finger"},
    {Metric::robot_speed_use, "robot_speed_use", "use of joint speed", "1",
     "largest speed of an arm's joint over its limit"},
    {Metric::robot_acceleration_use, "robot_acceleration_use", "use of joint acceleration", "1",
     "largest acceleration of an arm's joint over its limit"},
    {Metric::robot_torque_use, "robot_torque_use", "use of joint torque", "1",
     "largest torque of an arm's joint over its limit"},
    {Metric::robot_position_use, "robot_position_use", "use of joint range", "1",
     "largest distance of a joint from the middle of its range over half of that range"},
    {Metric::robot_least_manipulability, "robot_least_manipulability", "manipulability of the arm", "1",
     "smallest over largest singular value of the arm's Jacobian, lengths in m, least along the way; 0: singular"},
    {Metric::robot_joint_travel_rad, "robot_joint_travel_rad", "joint travel", "rad",
     "way that the joints of the arm turn, all together"},
    {Metric::robot_cycle_time_s, "robot_cycle_time_s", "cycle time of the arm", "s",
     "time in which the arm moves, from the start of the lift to the end of the lowering"},
    {Metric::bruised_area_m2, "bruised_area_m2", "bruised area", "m2",
     "how wide flesh below contact patches is strained by more than limits.plastic_strain, all patches together"},
    {Metric::bruised_depth_m, "bruised_depth_m", "bruised depth", "m",
     "how deep flesh below a contact patch is strained by more than limits.plastic_strain"},
    {Metric::modes_left_out_share, "modes_left_out_share", "share left out by modes", "1",
     "of the product's static give under an even push near the poles that the pads meet, the part which its modes "
     "leave out; it answers at once"},
    {Metric::robot_jerk_use, "robot_jerk_use", "use of joint jerk", "1",
     "largest jerk of an arm's joint over its limit"},
    {Metric::robot_sway_max_m, "robot_sway_max_m", "sway of the palm", "m",
     "largest distance of the palm from where its arm was told to have it at that time, by lag and sway"},
}};

constexpr const MetricInfo& info_of(Metric metric) { return kMetricTable[static_cast<std::size_t>(metric)]; }

/// Largest size of `energy_balance_error` with which a run is an answer; beyond it its forces and damage are not
/// to be trusted, and the outcome is out_of_range.
inline constexpr double kEnergyErrorMost = 0.05;

/// Largest compression of a pad's or the support's layer over its thickness: rubber that is pressed flat is no
/// longer the linear layer of the model. Beyond it the outcome is out_of_range.
inline constexpr double kLargestLayerStrain = 0.8;

/// The metrics of one scenario; NaN where a metric does not exist for it.
class Metrics {
 public:
  Metrics() { values_.fill(std::numeric_limits<double>::quiet_NaN()); }
  double& operator[](Metric metric) { return values_[static_cast<std::size_t>(metric)]; }
  double operator[](Metric metric) const { return values_[static_cast<std::size_t>(metric)]; }
  [[nodiscard]] const std::array<double, kMetricCount>& values() const { return values_; }
  [[nodiscard]] std::array<double, kMetricCount>& values() { return values_; }

 private:
  std::array<double, kMetricCount> values_;
};

/// What a scenario leaves behind.
struct ScenarioResult {
  Outcome outcome = Outcome::not_run;
  std::string cause;  ///< one short phrase, e.g. "permanent_set_max_m > limits.permanent_set_m"; empty when held
  double outcome_time_s = std::numeric_limits<double>::quiet_NaN();  ///< first crossing; NaN when held
  Metrics metrics;
};

}  // namespace unbruised

#pragma once

/// @file
/// One fully specified run: product + gripper + cell + strategy + limits + numerics. Plain data in SI;
/// the inequality a value takes part in stands above it. What is checked: ranges in fields.hpp, rules
/// between values in rules.hpp, for `validate` and the config reader alike.

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/scenario/cell_surface.hpp"
#include "core/scenario/finger.hpp"
#include "core/scenario/pad.hpp"
#include "core/scenario/product_parameters.hpp"
#include "core/scenario/range_sensor.hpp"
#include "core/scenario/robot.hpp"
#include "core/scenario/sensor.hpp"

namespace unbruised {

/// May a pressed layer of rubber move along the face of the product?
enum class PadBulge {
  free,  ///< it slides along it
  held,  ///< it sticks to it
};

enum class FingerCoupling {
  centric,      ///< rack and pinion: both fingers stay at equal distance from the palm centre
  independent,  ///< each finger is driven alone
};

/// The product moves freely for simulation.duration_s.
struct NoGripper {};

/// A parallel jaw: two driven fingers with flat pads that face each other along x.
struct ParallelJawParameters {
  /// > 0, each finger
  double finger_mass_kg = 0.1;
  /// > 0, > the way to the product; how far each finger can travel inwards from its starting place.
  double stroke_m = 0.04;
  /// > 0; extents of a pad along y and z.
  std::array<double, 2> pad_size_m{0.03, 0.03};
  /// > 0; thickness of the compliant layer
  double pad_thickness_m = 0.003;
  /// > 0; Young's modulus of the layer. Stiffness per area: E / thickness, of rubber more; tangential E / (3
  /// thickness).
  double pad_modulus_Pa = 0.4e6;
  /// >= 0, <= 0.5; of rubber bonded to the finger 0.49 or so, by which it is stiffer than that. 0: springs, as
  /// foam.
  double pad_poisson_ratio = 0.0;
  PadBulge pad_bulge = PadBulge::free;
  /// >= 0; radius of the edges of a pad's face
  double pad_edge_radius_m = 0.0;
  /// >= 0; Kelvin-Voigt relaxation time of the layer
  double pad_relaxation_time_s = 0.0;
  /// > 0; drive force = clamp(gain x (v_set - v), +-limit)
  double drive_gain_N_s_m = 500.0;
  /// >= 0; viscous friction of the finger guide
  double drive_viscous_N_s_m = 1.0;
  /// > 0; the largest force the drive can give
  double max_force_N = 100.0;
  /// > 0; the largest finger speed the drive can give
  double max_speed_m_s = 0.5;
  FingerCoupling coupling = FingerCoupling::centric;
  /// >= 0, <= max_force_N; the least force the drive holds. Smaller grip forces cannot be set on this gripper.
  double min_force_N = 0.0;
  /// >= 0, < 1; the force that acts lies within +-force_accuracy x the force that is set.
  double force_accuracy = 0.0;
  /// >= 0, <= max_force_N; forces that can be set are multiples of it; 0: any force
  double force_step_N = 0.0;
  /// > 0, > the product's extent along x; distance of the pad faces when the gripper is open; none: as wide as the
  /// approach needs
  std::optional<double> opening_m;
  /// > 0, <= 1 / time_step_s; how often the force of a finger is measured. None: at all times.
  std::optional<double> force_rate_Hz;
  HoldMode hold = HoldMode::force;
  /// > 0; of a lock, each finger; none: it does not give way
  std::optional<double> lock_stiffness_N_m;
  /// Speeds of a finger, ascending from 0, and the largest force that the drive gives at each, not rising; linear
  /// between them, the last beyond. None: max_force_N at every speed.
  std::vector<double> curve_speed_m_s;
  std::vector<double> curve_force_N;
  /// > 0; from a data sheet, for the sizing sheet: the largest mass it may carry by friction, the largest moment
  /// on a jaw, the distance of the pad's middle from the jaw, the maker's safety factor
  std::optional<double> payload_kg;
  std::optional<double> jaw_moment_N_m;
  std::optional<double> finger_length_m;
  std::optional<double> safety_factor;
  PadParameters pad;
  RangeSensorParameters range;
  /// None: two that face each other along x
  std::vector<FingerParameters> finger;
};

/// The kinds of gripper. Each is a struct of parameters with its fields in fields.hpp, and lanes that move it.
using GripperParameters = std::variant<NoGripper, ParallelJawParameters>;

/// A belt on the support: its points move in the plane, the plane does not. At rest where both speeds are 0.
struct ConveyorParameters {
  /// >= 0; the speed it runs at, or reaches
  double speed_m_s = 0.0;
  /// >= 0; at the start, when the product rides on it. None: 0 with an acceleration, else speed_m_s.
  std::optional<double> initial_speed_m_s{};
  /// > 0; with which it changes its speed
  std::optional<double> acceleration_m_s2{};
  /// >= 0; when it begins to
  double start_s = 0.0;
  /// Not zero; along x and y, of any length
  std::array<double, 2> direction{0.0, 1.0};
  /// > 0; from the product's starting place to the end of the belt. None: it does not end.
  std::optional<double> length_m{};
};

/// What stands around gripper and product.
struct CellParameters {
  std::array<double, 3> gravity_m_s2{0.0, 0.0, -9.80665};
  /// Is there a support plane z = 0?
  bool support = true;
  /// >= 0
  double support_friction = 0.5;
  /// > 0; Young's modulus of the support's compliant layer
  double support_modulus_Pa = 2e6;
  /// > 0
  double support_thickness_m = 0.005;
  /// >= 0, <= 0.5; as that of a pad
  double support_poisson_ratio = 0.0;
  /// >= 0
  double support_relaxation_time_s = 0.0;
  /// > 0; from each pad face to the nearest point of the undeformed product at the start. None: what the gripper's
  /// opening leaves (opening.hpp); given with an opening it must agree with it.
  std::optional<double> approach_gap_m;
  /// Height of the pad centres above the product's centre.
  double grip_height_m = 0.0;
  /// Offset of the pad centres from the product's centre along y.
  double grip_offset_m = 0.0;
  /// >= 0
  double lift_height_m = 0.1;
  /// Horizontal way (x along the grip axis, y across it).
  std::array<double, 2> transfer_m{0.0, 0.3};
  /// < lift_height_m when there is a lift, else <= 0; height of the target plane above the support
  double place_height_m = 0.0;
  /// Of the target plane, along x and y; the target was at transfer_m when the run began.
  std::array<double, 2> place_velocity_m_s{0.0, 0.0};
  /// Is there a plane at place_height_m once the product is lifted? Else only what `surface` lists is there then.
  bool target_plane = true;
  /// > 0; with which an emergency stop brings the palm to rest
  double stop_deceleration_m_s2 = 10.0;
  ConveyorParameters conveyor;
  std::vector<CellSurfaceParameters> surface;
};

enum class PickKind {
  still,     ///< the palm waits
  tracking,  ///< the palm goes with the belt until the hold ends
};

enum class ProfileKind {
  trapezoid,
  minimum_jerk,
  s_curve,  ///< trapezoids of acceleration: their slope is the jerk
};

/// What slows the fingers down before they press.
enum class GuardKind {
  none,
  range,  ///< a range sensor reads less than guard_range_m
  force,  ///< the measured force of a finger exceeds guard_force_N, which is taken for the contact
};

/// Where the palm goes after the lift, straight or on an arc, from rest to rest where nothing is blended. What is
/// not said is as at the waypoint before it, at the first as the lift ends.
struct Waypoint {
  /// Of the palm: x and y as transfer_m, z as lift_height_m
  std::optional<std::array<double, 3>> place_m{};
  /// Of the palm about its pads' centre, from upright, about the vector by its length, <= pi. At most one of
  /// rotation_rad and quaternion is given.
  std::optional<std::array<double, 3>> rotation_rad{};
  /// Of length 1 within 1e-6: w, x, y, z. Turned is by the shortest way.
  std::optional<std::array<double, 4>> quaternion{};
  /// It goes there on the arc through this place, which needs place_m. None: straight.
  std::optional<std::array<double, 3>> via_m{};
  /// >= 0; the palm does not stop there, and passes within so much of it. 0: it does.
  double blend_m = 0.0;
  /// > 0; speed limit of the way there beside that of the strategy
  std::optional<double> speed_m_s{};
  /// > 0; the way there takes so long at least
  std::optional<double> duration_s{};
  /// >= 0; rest there
  double wait_s = 0.0;
};

/// The decision variables.
struct StrategyParameters {
  /// > 0, per finger; the fingers start at this speed (at rest with ramp_from_start)
  double approach_speed_m_s = 0.05;
  GuardKind guard = GuardKind::none;
  /// Required with guard = "range", which needs range sensors; <= their maximum_m, between what they read at the
  /// start and at the first contact.
  std::optional<double> guard_range_m{};
  /// > 0, < contact_force_N; required with guard = "force"
  std::optional<double> guard_force_N{};
  /// >= 0, > 0 with guard = "range", < approach_speed_m_s; set for the fingers once the guard has seen its sign
  double guard_speed_m_s = 0.01;
  /// > 0; drive force limit of each finger, so its normal force at rest
  double grip_force_N = 1.0;
  /// >= 0, <= grip_force_N; drive force limit before the first contact
  double contact_force_N = 0.3;
  /// >= 0; the limit rises linearly in this time from the first contact (from the start with ramp_from_start)
  double grip_ramp_s = 0.1;
  /// The ramp starts at t = 0 instead of at the first contact.
  bool ramp_from_start = false;
  /// >= 0; rest after the ramp before the lift
  double settle_s = 0.05;
  PickKind pick = PickKind::still;
  /// How far along the belt from the product the palm stands at the start.
  double pick_offset_m = 0.0;
  /// >= 0; a tracking palm is where the belt was so long ago.
  double tracking_lag_s = 0.0;
  ProfileKind profile = ProfileKind::minimum_jerk;
  /// > 0; peak of the profile (transfer_ and lower_ default to the lift's)
  double lift_acceleration_m_s2 = 2.0;
  std::optional<double> transfer_acceleration_m_s2;
  std::optional<double> lower_acceleration_m_s2;
  /// > 0; speed limit of every phase
  double speed_m_s = 1.0;
  /// > 0; jerk limit of every phase, required with profile = "s_curve"
  std::optional<double> jerk_m_s3{};
  /// Rotation of the gripper about its pads' centre, taken after the lift and taken back before it is lowered:
  /// about the vector by its length, <= pi. Not zero: needs a lift and centric fingers.
  std::array<double, 3> tilt_rad{0.0, 0.0, 0.0};
  /// > 0; speed limit and peak acceleration of the tilt, and of turns between waypoints
  double tilt_speed_rad_s = 6.0;
  double tilt_acceleration_rad_s2 = 40.0;
  /// > 0; of turns, required with profile = "s_curve" where the palm turns
  std::optional<double> tilt_jerk_rad_s3{};
  /// >= 0; rest after the lift and the tilt or the waypoints
  double hold_s = 0.0;
  /// >= 0, <= lift_height_m - place_height_m; height above the target plane at which the fingers open
  double release_height_m = 0.0;
  /// >= 0; rest after lowering before the fingers open
  double place_settle_s = 0.05;
  /// > 0, per finger
  double release_speed_m_s = 0.1;
  /// >= 0; time without gripper contact before permanent set is measured
  double recover_s = 0.2;
  /// >= 0; an emergency stop ends the cycle there: the palm brakes along its path and the fingers hold what they
  /// have. None, or after the release has begun: no stop.
  std::optional<double> stop_time_s{};
  /// >= 1, <= 1000; handlings one after another, each of the product as the one before has left it. It is put back
  /// to where it began, and comes to rest there.
  int repeat = 1;
  /// At most 16, and not with a tilt. A palm that tracks comes to rest over the first before it turns. The product
  /// is put down as it was turned last.
  std::vector<Waypoint> waypoint;
};

enum class DamageJudging {
  judged,          ///< by the limits below
  not_considered,  ///< the limits below are not looked at, and no answer says anything about damage
};

/// What counts as damage, as slipping and as misplaced. An absent limit is not checked.
struct LimitParameters {
  DamageJudging damage = DamageJudging::judged;
  std::optional<double> permanent_set_m;
  std::optional<double> plastic_strain;
  std::optional<double> bruised_volume_m3;
  std::optional<double> peak_pressure_Pa;
  std::optional<double> absorbed_energy_J;
  std::optional<double> finger_force_N;
  std::optional<double> contact_yield_ratio;
  /// > 0
  double slip_m = 2e-3;
  /// > 0
  double slip_rad = 0.1;
  /// > 0
  std::optional<double> place_error_m;
  /// > 0
  std::optional<double> place_attitude_rad;
};

enum class InitialAcceleration { consistent, zero };

/// Which places of a product can touch which surface; the pads always meet the sides that face them.
enum class ContactSet {
  automatic,         ///< what the strategy and the cell need (contact_set.hpp)
  pads_and_support,  ///< the support meets the bottom of a product that stays upright
  six_sides,      ///< the cell's surfaces meet the six sides of one that turns by quarter turns, near their poles
  whole_surface,  ///< they meet any place
};

/// Which steps a run takes (step_levels.hpp).
enum class LevelUse {
  automatic,  ///< multiples of time_step_s where little happens
  off,        ///< time_step_s throughout
};

/// How the motion of a product is computed.
enum class ProductBody {
  full,   ///< every particle
  modes,  ///< its slowest modes; what they leave out answers at once (body_modes.hpp)
};

struct SimulationParameters {
  /// > 0
  double time_step_s = 1e-3;
  /// >= 1.37, <= 3: below (1 + sqrt 3) / 2 Wilson's method is not unconditionally stable
  double theta = 1.4;
  /// > 0; required where no gripper fixes the end of the run
  std::optional<double> duration_s;
  InitialAcceleration initial_acceleration = InitialAcceleration::consistent;
  /// >= time_step_s; thins the trace
  std::optional<double> trace_interval_s;
  /// > 0; side of the square patch over which peak_pressure_Pa averages
  double pressure_patch_m = 0.01;
  /// > 0; a larger strain, sqrt(e:e), of a cell ends the run as out_of_range
  double max_strain = 0.3;
  /// > 0; a larger rotation of the product ends the run as out_of_range
  double max_rotation_rad = 0.2;
  ContactSet contact_set = ContactSet::automatic;
  LevelUse levels = LevelUse::automatic;
  ProductBody body = ProductBody::full;
  /// >= 0; of the modes in which it deforms, with `body = modes`; 0: every particle moves
  int mode_count = 60;
};

/// One fully specified run.
struct Scenario {
  ProductParameters product = LatticeParameters{};
  GripperParameters gripper = NoGripper{};
  CellParameters cell;
  SixAxisSensorParameters sensor;
  StrategyParameters strategy;
  LimitParameters limits;
  SimulationParameters simulation;
  RobotParameters robot;
};

/// Does any kind of gripper hold the product?
inline bool has_gripper(const Scenario& scenario) { return !std::holds_alternative<NoGripper>(scenario.gripper); }

/// Does a six-axis sensor carry the gripper or the plate under the product?
inline bool has_sensor(const Scenario& scenario) { return scenario.sensor.at != SensorMount::none; }

/// Does an arm carry the gripper?
inline bool has_robot(const Scenario& scenario) { return !scenario.robot.joint.empty(); }
/// Does the arm give way, so that the palm sways, turns a little and lags behind its path?
inline bool arm_sways(const Scenario& scenario) {
  const RobotParameters& robot = scenario.robot;
  return has_robot(scenario) && !(robot.stiffness_N_m_rad.empty() && robot.bandwidth_Hz.empty());
}

/// The parallel jaw of a scenario; nullptr where the gripper is of another kind or there is none.
inline ParallelJawParameters* parallel_jaw(Scenario& scenario) {
  return std::get_if<ParallelJawParameters>(&scenario.gripper);
}
inline const ParallelJawParameters* parallel_jaw(const Scenario& scenario) {
  return std::get_if<ParallelJawParameters>(&scenario.gripper);
}
const ParallelJawParameters* parallel_jaw(const Scenario&& scenario) = delete;
/// The same where it is known to be there.
/// @throws std::bad_variant_access
inline ParallelJawParameters& jaw_of(Scenario& scenario) {
  return std::get<ParallelJawParameters>(scenario.gripper);
}
inline const ParallelJawParameters& jaw_of(const Scenario& scenario) {
  return std::get<ParallelJawParameters>(scenario.gripper);
}

}  // namespace unbruised

#include "core/robot/arm_ride.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/scenario/product.hpp"
#include "core/scenario/vectors.hpp"
#include "core/scenario/words.hpp"

namespace unbruised {
namespace {

constexpr double kSampleStep_s = 4e-3;
constexpr double kMostSamples = 4000.0;
constexpr double kRateResidual = 1e-6;
constexpr double kRounding = 1e-9;
constexpr int kHalvings = 14;  // of a sample's step, when a breach is looked for: 4 ms to 0.3 us

std::optional<ArmLeg> leg_of(CyclePhase phase) {
  switch (phase) {
    case CyclePhase::lift:
      return ArmLeg::lift;
    case CyclePhase::turn:
    case CyclePhase::hold:
    case CyclePhase::transfer:
      return ArmLeg::carry;
    case CyclePhase::lower:
      return ArmLeg::lower;
    default:
      return std::nullopt;
  }
}

/// Goes along a plan, sample by sample; the branch of the inverse kinematics is that of the sample before.
class Rider {
 public:
  Rider(const Scenario& scenario, const MotionPlan& plan)
      : scenario_(scenario), plan_(plan), arm_(scenario.robot), limit_(scenario.robot.use_most) {}

  [[nodiscard]] const Arm& arm() const { return arm_; }

  /// The posture at the start; none: it is out of reach.
  [[nodiscard]] std::optional<Joints> start() const {
    return posture_for(arm_, palm_pose(scenario_, plan_.palm(0.0)), arm_.seed_rad(), true);
  }

  struct Stop {
    std::optional<ArmSample> sample;  ///< none: out of reach or singular
    ArmBreach breach;                 ///< why there is none
    double manipulability = 0.0;
  };
  [[nodiscard]] Stop at(double time_s, const Joints& from) const {
    const PalmState palm = plan_.palm(time_s);
    Stop stop;
    stop.breach = {ArmLimit::reach, time_s};
    const auto angle = posture_for(arm_, palm_pose(scenario_, palm), from, false);
    if (!angle) return stop;
    const std::vector<Twist> J = arm_.jacobian(*angle);
    stop.manipulability = manipulability(J);
    stop.breach.limit = ArmLimit::singular;
    if (stop.manipulability < kLeastManipulability) return stop;
    const JointRates speed = rates_for(J, {palm.velocity_m_s, palm.spin_rad_s});
    Twist pull = arm_.bias(*angle, speed.rate);
    for (std::size_t d = 0; d < 3; ++d) {
      pull.linear[d] = palm.acceleration_m_s2[d] - pull.linear[d];
      pull.angular[d] = palm.spin_acceleration_rad_s2[d] - pull.angular[d];
    }
    const JointRates acceleration = rates_for(J, pull);
    if (speed.residual > kRateResidual || acceleration.residual > kRateResidual) return stop;
    ArmSample sample;
    sample.time_s = time_s;
    sample.phase = plan_.phase_after_contact(time_s);
    sample.motion = {*angle, speed.rate, acceleration.rate};
    sample.torque_N_m = joint_torques(arm_, sample.motion, loads_at(time_s), scenario_.cell.gravity_m_s2);
    stop.sample = std::move(sample);
    return stop;
  }

  [[nodiscard]] std::vector<PointLoad> loads_at(double time_s) const {
    return flange_loads(scenario_, is_loaded(time_s));
  }
  /// Does the product hang on it?
  [[nodiscard]] bool is_loaded(double time_s) const {
    return time_s >= plan_.lift_start_s() && time_s < plan_.release_start_s();
  }

  /// The first limit that a sample breaks.
  [[nodiscard]] std::optional<ArmBreach> breach_of(const ArmSample& sample) const {
    for (std::size_t j = 0; j < arm_.joint_count(); ++j) {
      const std::pair<ArmLimit, double> uses[] = {{ArmLimit::position, position_use(sample, j)},
                                                  {ArmLimit::speed, speed_use(sample, j) / limit_},
                                                  {ArmLimit::acceleration, acceleration_use(sample, j) / limit_},
                                                  {ArmLimit::torque, torque_use(sample, j) / limit_}};
      for (const auto& [limit, use] : uses) {
        if (use > 1.0 + kRounding)
          return ArmBreach{limit, sample.time_s, static_cast<int>(j),
                           use * (limit == ArmLimit::position ? 1.0 : limit_)};
      }
    }
    return std::nullopt;
  }

  /// The first joint that a sample takes out of its range.
  [[nodiscard]] std::optional<ArmBreach> range_breach_of(const ArmSample& sample) const {
    for (std::size_t j = 0; j < arm_.joint_count(); ++j) {
      const double use = position_use(sample, j);
      if (use > 1.0 + kRounding) return ArmBreach{ArmLimit::position, sample.time_s, static_cast<int>(j), use};
    }
    return std::nullopt;
  }

  [[nodiscard]] double position_use(const ArmSample& sample, std::size_t j) const {
    return arm_.position_use(j, sample.motion.angle_rad[j]);
  }
  [[nodiscard]] double speed_use(const ArmSample& sample, std::size_t j) const {
    return std::abs(sample.motion.speed_rad_s[j]) / arm_.robot().joint[j].speed_rad_s;
  }
  [[nodiscard]] double acceleration_use(const ArmSample& sample, std::size_t j) const {
    const std::vector<double>& most = arm_.robot().acceleration_rad_s2;
    return most.empty() ? 0.0 : std::abs(sample.motion.acceleration_rad_s2[j]) / most[j];
  }
  [[nodiscard]] double torque_use(const ArmSample& sample, std::size_t j) const {
    return std::abs(sample.torque_N_m[j]) / arm_.robot().joint[j].torque_N_m;
  }

  /// The least stretch with which a sample keeps every limit.
  [[nodiscard]] double stretch_of(const ArmSample& sample) const {
    Joints weight;  // of the arm at rest there, where it is asked for
    double stretch = 1.0;
    for (std::size_t j = 0; j < arm_.joint_count(); ++j) {
      stretch =
          std::max({stretch, speed_use(sample, j) / limit_, std::sqrt(acceleration_use(sample, j) / limit_)});
      const double most = limit_ * arm_.robot().joint[j].torque_N_m;
      if (std::abs(sample.torque_N_m[j]) <= most) continue;
      if (weight.empty()) weight = weight_at(sample);
      const double sign = sample.torque_N_m[j] > 0.0 ? 1.0 : -1.0;
      const double room = most - sign * weight[j];
      if (!(room > 0.0)) return kNever;
      stretch = std::max(stretch, std::sqrt(sign * (sample.torque_N_m[j] - weight[j]) / room));
    }
    return stretch;
  }

 private:
  [[nodiscard]] Joints weight_at(const ArmSample& sample) const {
    const Joints none(arm_.joint_count(), 0.0);
    return joint_torques(arm_, {sample.motion.angle_rad, none, none}, loads_at(sample.time_s),
                         scenario_.cell.gravity_m_s2);
  }

  const Scenario& scenario_;
  const MotionPlan& plan_;
  Arm arm_;
  double limit_;
};

/// From 0 to the end of the way of the palm, closely where it moves.
std::vector<double> sample_times(const MotionPlan& plan) {
  const double end_s = std::min(plan.release_end_s(), plan.end_s());
  const int count = static_cast<int>(std::min(kMostSamples, std::ceil(end_s / kSampleStep_s))) + 1;
  std::vector<double> times;
  for (int i = 0; i <= count; ++i) times.push_back(end_s * i / count);
  for (const double event_s : {plan.lift_start_s(), plan.lift_end_s(), plan.hold_start_s(), plan.hold_end_s(),
                               plan.lower_end_s(), plan.release_start_s()}) {
    if (event_s < end_s) times.push_back(event_s);
  }
  std::ranges::sort(times);
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

/// Where the arm will be about: near enough that the posture is found at once.
Joints foreseen(const ArmSample& last, double time_s) {
  Joints angle = last.motion.angle_rad;
  const double h = time_s - last.time_s;
  for (std::size_t j = 0; j < angle.size(); ++j) {
    angle[j] += h * (last.motion.speed_rad_s[j] + 0.5 * h * last.motion.acceleration_rad_s2[j]);
  }
  return angle;
}

void raise(ArmUse& most, double use, std::size_t joint, double time_s) {
  if (use > most.use) most = {use, static_cast<int>(joint), time_s};
}

void take_in(const Rider& rider, const ArmSample& sample, ArmRide& ride) {
  for (std::size_t j = 0; j < rider.arm().joint_count(); ++j) {
    raise(ride.position, rider.position_use(sample, j), j, sample.time_s);
    raise(ride.speed, rider.speed_use(sample, j), j, sample.time_s);
    raise(ride.acceleration, rider.acceleration_use(sample, j), j, sample.time_s);
    raise(ride.torque, rider.torque_use(sample, j), j, sample.time_s);
    if (ride.samples.empty()) continue;
    ride.joint_travel_rad += std::abs(sample.motion.angle_rad[j] - ride.samples.back().motion.angle_rad[j]);
  }
}

void take_need(const Rider& rider, const ArmSample& sample, const PalmState& palm, ArmRide& ride) {
  const auto leg = leg_of(sample.phase);
  if (!leg) return;
  LegNeed& need = ride.need[static_cast<std::size_t>(*leg)];
  need.stretch = std::max(need.stretch, rider.stretch_of(sample));
  need.peak_m_s2 = std::max(need.peak_m_s2, length(palm.acceleration_m_s2));
  need.peak_rad_s2 = std::max(need.peak_rad_s2, length(palm.spin_acceleration_rad_s2));
}

/// What a stop breaks, or of that what no slowing down mends.
enum class Broken { anything, for_good };
std::optional<ArmBreach> broken_at(const Rider& rider, const Rider::Stop& stop, Broken which) {
  if (!stop.sample) return stop.breach;
  return which == Broken::anything ? rider.breach_of(*stop.sample) : rider.range_breach_of(*stop.sample);
}

/// When between two times the first is broken: by halving.
double first_broken_s(const Rider& rider, const ArmSample& last, double broken_s, Broken which) {
  double good_s = last.time_s;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle_s = 0.5 * (good_s + broken_s);
    (broken_at(rider, rider.at(middle_s, last.motion.angle_rad), which) ? broken_s : good_s) = middle_s;
  }
  return broken_s;
}

/// Takes down the first of its kind. @param last what was sampled before; nullptr: nothing
void take_breach(const Rider& rider, const ArmSample* last, double time_s, const Rider::Stop& stop, Broken which,
                 std::optional<ArmBreach>& first) {
  if (first) return;
  first = broken_at(rider, stop, which);
  if (first && last != nullptr) first->time_s = first_broken_s(rider, *last, time_s, which);
}

}  // namespace

std::string words_of(const ArmBreach& breach) {
  constexpr std::array<std::string_view, 7> kWords = {"reach", "", "range", "speed", "acceleration", "torque", ""};
  if (breach.limit == ArmLimit::reach) return "the palm is out of the arm's reach";
  if (breach.limit == ArmLimit::singular) return "the arm is singular on the palm's way";
  const std::string use = spelled(std::round(breach.use * 1e3) / 1e3);
  if (breach.limit == ArmLimit::payload) return "gripper and product are " + use + " of robot.max_payload_kg";
  return "joint " + std::to_string(breach.joint) + " of the arm needs " + use + " of its " +
         std::string(kWords[static_cast<std::size_t>(breach.limit)]);
}

ArmBreach ArmRide::binding() const {
  const std::pair<ArmLimit, const ArmUse*> uses[] = {{ArmLimit::position, &position},
                                                     {ArmLimit::speed, &speed},
                                                     {ArmLimit::acceleration, &acceleration},
                                                     {ArmLimit::torque, &torque}};
  ArmBreach most{ArmLimit::position, 0.0, -1, -1.0};
  for (const auto& [limit, use] : uses) {
    if (use->use > most.use) most = {limit, use->time_s, use->joint, use->use};
  }
  return most;
}

Pose palm_pose(const Scenario& scenario, const PalmState& palm) {
  const auto extents = shape_extents_m(scenario.product);
  const std::array<double, 3> start = {0.0, scenario.cell.grip_offset_m,
                                       (extents ? 0.5 * (*extents)[2] : 0.0) + scenario.cell.grip_height_m};
  Pose pose = pose_of(palm.position_m, palm.rotation_rad);
  for (std::size_t d = 0; d < 3; ++d) pose.place_m[d] += start[d];
  return pose;
}

std::vector<PointLoad> flange_loads(const Scenario& scenario, bool carried) {
  const RobotParameters& robot = scenario.robot;
  std::vector<PointLoad> loads = {{robot.gripper_mass_kg, robot.gripper_center_of_mass_m}};
  if (!carried) return loads;
  const Pose tool = pose_of(robot.tool_place_m, robot.tool_rotation_rad);
  const Pose middle = tool * Pose{{0.0, -scenario.cell.grip_offset_m, -scenario.cell.grip_height_m}, {}};
  loads.push_back({product_mass_kg(scenario.product), middle.place_m});
  return loads;
}

ArmRide ride(const Scenario& scenario, const MotionPlan& plan) {
  const Rider rider(scenario, plan);
  ArmRide out;
  out.moving_s = plan.lower_end_s() < kNever ? plan.lower_end_s() - plan.lift_start_s() : 0.0;
  const double payload_kg = scenario.robot.gripper_mass_kg + product_mass_kg(scenario.product);
  const auto begin = rider.start();
  if (!begin) {
    out.breach = out.stuck = ArmBreach{ArmLimit::reach, 0.0};
    return out;
  }
  PalmState palm_before;
  for (const double time_s : sample_times(plan)) {
    const ArmSample* last = out.samples.empty() ? nullptr : &out.samples.back();
    const PalmState palm = plan.palm(time_s);
    if (last != nullptr && palm == palm_before && rider.is_loaded(time_s) == rider.is_loaded(last->time_s)) {
      ArmSample again = *last;
      again.time_s = time_s;
      again.phase = plan.phase_after_contact(time_s);
      out.samples.push_back(std::move(again));
      continue;
    }
    palm_before = palm;
    Rider::Stop stop = rider.at(time_s, last == nullptr ? *begin : foreseen(*last, time_s));
    take_breach(rider, last, time_s, stop, Broken::anything, out.breach);
    take_breach(rider, last, time_s, stop, Broken::for_good, out.stuck);
    if (!stop.sample) break;
    out.least_manipulability = std::min(out.least_manipulability, stop.manipulability);
    take_in(rider, *stop.sample, out);
    take_need(rider, *stop.sample, palm, out);
    out.samples.push_back(std::move(*stop.sample));
  }
  const double payload_use = payload_kg / scenario.robot.max_payload_kg.value_or(kNever);
  const double lift_s = plan.lift_start_s();
  if (payload_use > 1.0 && lift_s < kNever && (!out.breach || out.breach->time_s > lift_s))
    out.breach = ArmBreach{ArmLimit::payload, lift_s, -1, payload_use};
  return out;
}

std::vector<ArmSample> ride_at(const Scenario& scenario, const MotionPlan& plan,
                               const std::vector<double>& time_s) {
  const Rider rider(scenario, plan);
  std::vector<ArmSample> samples;
  auto from = rider.start();
  for (const double t : time_s) {
    if (!from) break;
    Rider::Stop stop = rider.at(t, *from);
    if (!stop.sample) return {};
    from = stop.sample->motion.angle_rad;
    samples.push_back(std::move(*stop.sample));
  }
  return samples;
}

}  // namespace unbruised

#include "core/robot/arm_ride.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/robot/arm_stop.hpp"
#include "core/scenario/product.hpp"
#include "core/scenario/vectors.hpp"
#include "core/scenario/words.hpp"

namespace unbruised {
namespace {

constexpr double kSampleStep_s = 4e-3;
constexpr double kMostSamples = 4000.0;
constexpr double kRounding = 1e-9, kStopRounding = 0.01;
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

/// What the samples of an arm use of its limits.
class Uses {
 public:
  explicit Uses(const ArmRider& rider) : rider_(rider), robot_(rider.arm().robot()) {}

  /// The first limit that a sample breaks.
  [[nodiscard]] std::optional<ArmBreach> breach_of(const ArmSample& sample) const {
    // An emergency stop takes all that there is, as nearly as it is planned.
    const bool stops = sample.phase == CyclePhase::stop;
    const double most = stops ? 1.0 : robot_.use_most, rounding = stops ? kStopRounding : kRounding;
    struct Use {
      ArmLimit limit;
      double use, most;
    };
    for (std::size_t j = 0; j < robot_.joint.size(); ++j) {
      const Use uses[] = {{ArmLimit::position, position(sample, j), 1.0},
                          {ArmLimit::speed, speed(sample, j), most},
                          {ArmLimit::acceleration, acceleration(sample, j), most},
                          {ArmLimit::jerk, jerk(sample, j), most},
                          {ArmLimit::torque, torque(sample, j), most}};
      for (const Use& each : uses) {
        if (each.use > each.most * (1.0 + rounding))
          return ArmBreach{each.limit, sample.time_s, static_cast<int>(j), each.use};
      }
    }
    return std::nullopt;
  }

  /// The first joint that a sample takes out of its range.
  [[nodiscard]] std::optional<ArmBreach> range_breach_of(const ArmSample& sample) const {
    for (std::size_t j = 0; j < robot_.joint.size(); ++j) {
      const double use = position(sample, j);
      if (use > 1.0 + kRounding) return ArmBreach{ArmLimit::position, sample.time_s, static_cast<int>(j), use};
    }
    return std::nullopt;
  }

  [[nodiscard]] double position(const ArmSample& sample, std::size_t j) const {
    return rider_.arm().position_use(j, sample.motion.angle_rad[j]);
  }
  [[nodiscard]] double speed(const ArmSample& sample, std::size_t j) const {
    return std::abs(sample.motion.speed_rad_s[j]) / robot_.joint[j].speed_rad_s;
  }
  [[nodiscard]] double acceleration(const ArmSample& sample, std::size_t j) const {
    const auto most = sample.phase == CyclePhase::stop ? stop_deceleration_rad_s2(robot_, j)
                                                       : of_joint(robot_.acceleration_rad_s2, j);
    return most ? std::abs(sample.motion.acceleration_rad_s2[j]) / *most : 0.0;
  }
  /// An emergency stop looks at none.
  [[nodiscard]] double jerk(const ArmSample& sample, std::size_t j) const {
    const auto most = of_joint(robot_.jerk_rad_s3, j);
    return most && sample.phase != CyclePhase::stop ? sample.jerk_rad_s3[j] / *most : 0.0;
  }
  [[nodiscard]] double torque(const ArmSample& sample, std::size_t j) const {
    return std::abs(sample.torque_N_m[j]) / robot_.joint[j].torque_N_m;
  }

  /// The least stretch with which a sample keeps every limit but that of the jerk.
  [[nodiscard]] double stretch_of(const ArmSample& sample) const {
    Joints weight;  // of the arm at rest there, where it is asked for
    double stretch = 1.0;
    const double limit = robot_.use_most;
    for (std::size_t j = 0; j < robot_.joint.size(); ++j) {
      stretch = std::max({stretch, speed(sample, j) / limit, std::sqrt(acceleration(sample, j) / limit)});
      const double most = limit * robot_.joint[j].torque_N_m;
      if (std::abs(sample.torque_N_m[j]) <= most) continue;
      if (weight.empty()) weight = rider_.weight_at(sample.motion.angle_rad, sample.time_s);
      const double sign = sample.torque_N_m[j] > 0.0 ? 1.0 : -1.0;
      const double room = most - sign * weight[j];
      if (!(room > 0.0)) return kNever;
      stretch = std::max(stretch, std::sqrt(sign * (sample.torque_N_m[j] - weight[j]) / room));
    }
    return stretch;
  }
  [[nodiscard]] double jerk_stretch_of(const ArmSample& sample) const {
    double stretch = 1.0;
    for (std::size_t j = 0; j < robot_.joint.size(); ++j)
      stretch = std::max(stretch, std::cbrt(jerk(sample, j) / robot_.use_most));
    return stretch;
  }

 private:
  const ArmRider& rider_;
  const RobotParameters& robot_;
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

void raise(ArmUse& most, double use, std::size_t joint, double time_s) {
  if (use > most.use) most = {use, static_cast<int>(joint), time_s};
}

void take_in(const Uses& uses, const ArmSample& sample, ArmRide& ride) {
  for (std::size_t j = 0; j < sample.motion.angle_rad.size(); ++j) {
    raise(ride.position, uses.position(sample, j), j, sample.time_s);
    raise(ride.speed, uses.speed(sample, j), j, sample.time_s);
    raise(ride.acceleration, uses.acceleration(sample, j), j, sample.time_s);
    raise(ride.jerk, uses.jerk(sample, j), j, sample.time_s);
    raise(ride.torque, uses.torque(sample, j), j, sample.time_s);
    if (ride.samples.empty()) continue;
    ride.joint_travel_rad += std::abs(sample.motion.angle_rad[j] - ride.samples.back().motion.angle_rad[j]);
  }
}

void take_need(const Uses& uses, const ArmSample& sample, const PalmState& palm, ArmRide& ride) {
  const auto leg = leg_of(sample.phase);
  if (!leg) return;
  LegNeed& need = ride.need[static_cast<std::size_t>(*leg)];
  need.stretch = std::max(need.stretch, uses.stretch_of(sample));
  need.jerk_stretch = std::max(need.jerk_stretch, uses.jerk_stretch_of(sample));
  need.peak_m_s2 = std::max(need.peak_m_s2, length(palm.acceleration_m_s2));
  need.peak_rad_s2 = std::max(need.peak_rad_s2, length(palm.spin_acceleration_rad_s2));
}

/// What a stop breaks, or of that what no slowing down mends.
enum class Broken { anything, for_good };
std::optional<ArmBreach> broken_at(const Uses& uses, double time_s, const ArmRider::Stop& stop, Broken which) {
  if (!stop.sample) return ArmBreach{stop.is_in_reach ? ArmLimit::singular : ArmLimit::reach, time_s};
  return which == Broken::anything ? uses.breach_of(*stop.sample) : uses.range_breach_of(*stop.sample);
}

/// When between two times the first is broken: by halving.
double first_broken_s(const ArmRider& rider, const ArmSample& last, double broken_s, Broken which) {
  double good_s = last.time_s;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle_s = 0.5 * (good_s + broken_s);
    const ArmRider::Stop middle = rider.at(middle_s, last.motion.angle_rad);
    (broken_at(Uses(rider), middle_s, middle, which) ? broken_s : good_s) = middle_s;
  }
  return broken_s;
}

/// Takes down the first of its kind. @param last what was sampled before; nullptr: nothing
void take_breach(const ArmRider& rider, const ArmSample* last, double time_s, const ArmRider::Stop& stop,
                 Broken which, std::optional<ArmBreach>& first) {
  if (first) return;
  first = broken_at(Uses(rider), time_s, stop, which);
  if (first && last != nullptr) first->time_s = first_broken_s(rider, *last, time_s, which);
}

}  // namespace

std::string words_of(const ArmBreach& breach) {
  constexpr std::array<std::string_view, 8> kWords = {"reach",        "",     "range",  "speed",
                                                      "acceleration", "jerk", "torque", ""};
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
                                                     {ArmLimit::jerk, &jerk},
                                                     {ArmLimit::torque, &torque}};
  ArmBreach most{ArmLimit::position, 0.0, -1, -1.0};
  for (const auto& [limit, use] : uses) {
    if (use->use > most.use) most = {limit, use->time_s, use->joint, use->use};
  }
  return most;
}

ArmRide ride(const Scenario& scenario, const MotionPlan& plan) {
  const ArmRider rider(scenario, plan);
  const Uses uses(rider);
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
    // At the start of a motion its jerk is looked for.
    const bool looks = !scenario.robot.jerk_rad_s3.empty();
    if (last != nullptr && !looks && palm == palm_before &&
        rider.is_loaded(time_s) == rider.is_loaded(last->time_s)) {
      ArmSample again = *last;
      again.time_s = time_s;
      again.phase = plan.phase_after_contact(time_s);
      out.samples.push_back(std::move(again));
      continue;
    }
    palm_before = palm;
    ArmRider::Stop stop = rider.at(time_s, last == nullptr ? *begin : foreseen(*last, time_s));
    take_breach(rider, last, time_s, stop, Broken::anything, out.breach);
    take_breach(rider, last, time_s, stop, Broken::for_good, out.stuck);
    if (!stop.sample) break;
    out.least_manipulability = std::min(out.least_manipulability, stop.manipulability);
    take_in(uses, *stop.sample, out);
    take_need(uses, *stop.sample, palm, out);
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
  const ArmRider rider(scenario, plan);
  std::vector<ArmSample> samples;
  auto from = rider.start();
  for (const double t : time_s) {
    if (!from) break;
    ArmRider::Stop stop = rider.at(t, *from);
    if (!stop.sample) return {};
    from = stop.sample->motion.angle_rad;
    samples.push_back(std::move(*stop.sample));
  }
  return samples;
}

}  // namespace unbruised

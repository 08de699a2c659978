#include "core/robot/arm_carrier.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/robot/arm_rider.hpp"
#include "core/robot/arm_stop.hpp"
#include "core/robot/arm_sway.hpp"
#include "core/scenario/guard.hpp"
#include "core/scenario/vectors.hpp"

namespace unbruised {
namespace {

constexpr double kTrackStep_s = 2e-3;

bool rests(const ArmMotion& motion) {
  const auto is_zero = [](double x) { return x == 0.0; };
  return std::ranges::all_of(motion.speed_rad_s, is_zero) &&
         std::ranges::all_of(motion.acceleration_rad_s2, is_zero);
}

class ArmCarrier final : public PalmCarrier {
 public:
  explicit ArmCarrier(const Scenario& scenario) : scenario_(scenario) {}

  [[nodiscard]] std::optional<StopLaw> stop(const MotionPlan& plan, double time_s) const override {
    const ArmRider rider(scenario_, plan);
    auto from = rider.start();
    if (!from) return std::nullopt;
    const ArmPath path = [&](double plan_s) -> std::optional<PathMotion> {
      const auto at = rider.motion_at(plan_s, *from);
      if (!at.sample) return std::nullopt;
      from = at.sample->motion.angle_rad;
      return PathMotion{at.sample->motion, rider.loads_at(plan_s)};
    };
    // The branch is that of the way until then.
    for (double plan_s = way_start_s(plan); plan_s < time_s; plan_s += kTrackStep_s) {
      if (!path(plan_s)) return std::nullopt;
    }
    return arm_stop(rider.arm(), path, time_s, scenario_.cell.gravity_m_s2);
  }

  [[nodiscard]] std::shared_ptr<const PalmTrack> track(const MotionPlan& plan) const override {
    const double start_s = way_start_s(plan);
    if (!arm_sways(scenario_) || !(start_s < kNever)) return nullptr;
    const ArmRider rider(scenario_, plan);
    const auto from = rider.start();
    if (!from) return nullptr;
    auto told = rider.motion_at(start_s, *from).sample;
    if (!told) return nullptr;
    ArmSway sway(rider.arm(), kTrackStep_s, told->motion, rider.loads_at(start_s));
    std::vector<PalmState> knots = {palm_of(rider.arm(), sway.links())};
    const double end_s = std::min(plan.end_s(), approach_end_s(plan));
    for (double time_s = start_s; time_s < end_s;) {
      time_s = start_s + static_cast<double>(knots.size()) * kTrackStep_s;
      if (plan.told_palm(time_s) == plan.told_palm(told->time_s) && rests(told->motion)) {
        told->time_s = time_s;
      } else {
        auto next = rider.motion_at(time_s, foreseen(*told, time_s)).sample;
        if (!next) break;
        told = std::move(next);
      }
      knots.push_back(palm_of(rider.arm(), sway.follow(told->motion, rider.loads_at(time_s))));
    }
    return std::make_shared<const PalmTrack>(start_s, kTrackStep_s, std::move(knots));
  }

 private:
  /// From when on the palm's way is looked at: with a belt it has gone on for long.
  [[nodiscard]] static double way_start_s(const MotionPlan& plan) {
    return plan.goes_with_belt() ? -kTrackStep_s : plan.lift_start_s();
  }
  /// Until the fingers have met the product nobody knows when a palm that goes with a belt leaves it: by then they
  /// have, at twice the time that is planned for it.
  [[nodiscard]] double approach_end_s(const MotionPlan& plan) const {
    if (plan.end_s() < kNever) return kNever;
    constexpr double kLate = 2.0, kLater_s = 0.1;
    return kLate * planned_approach(scenario_).time_s + kLater_s;
  }

  [[nodiscard]] PalmState palm_of(const Arm& arm, const ArmMotion& links) const {
    const Pose pose = arm.palm(links.angle_rad);
    const std::vector<Twist> J = arm.jacobian(links.angle_rad);
    const Twist bias = arm.bias(links.angle_rad, links.speed_rad_s);
    PalmState palm;
    palm.position_m = between(palm_start_m(scenario_), pose.place_m);
    palm.rotation_rad = rotation_to(pose.attitude);
    palm.acceleration_m_s2 = bias.linear;
    palm.spin_acceleration_rad_s2 = bias.angular;
    for (std::size_t j = 0; j < J.size(); ++j) {
      const double speed = links.speed_rad_s[j], change = links.acceleration_rad_s2[j];
      palm.velocity_m_s = sum(palm.velocity_m_s, times(speed, J[j].linear));
      palm.spin_rad_s = sum(palm.spin_rad_s, times(speed, J[j].angular));
      palm.acceleration_m_s2 = sum(palm.acceleration_m_s2, times(change, J[j].linear));
      palm.spin_acceleration_rad_s2 = sum(palm.spin_acceleration_rad_s2, times(change, J[j].angular));
    }
    return palm;
  }

  Scenario scenario_;
};

}  // namespace

std::shared_ptr<const PalmCarrier> arm_carrier(const Scenario& scenario) {
  return has_robot(scenario) ? std::make_shared<const ArmCarrier>(scenario) : nullptr;
}

}  // namespace unbruised

#include "core/body/mount_lanes.hpp"

#include "core/door/require.hpp"

namespace unbruised {

void LaneSixBySix::set_lane(int lane, const SixBySix& from) {
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t j = 0; j < 6; ++j) block[i / 3][j / 3](i % 3, j % 3).set(lane, from[6 * i + j]);
  }
}

void MountLanes::load(int lane, const std::optional<Mount>& mount, const Six& carried_wrench,
                      const Six& own_wrench, const WilsonTheta& w) {
  require(is_lane(lane), "MountLanes::load: there is no such lane");
  bool& mounted = mounted_[static_cast<std::size_t>(lane)];
  count_ += (mount ? 1 : 0) - (mounted ? 1 : 0);
  mounted = mount.has_value();
  const Mount values = mount.value_or(Mount{});
  SixBySix step{};
  for (std::size_t i = 0; i < 36; ++i) {
    step[i] = values.stiffness[i] + w.a0 * values.mass[i] + w.a1 * values.damping[i];
  }
  mass_.set_lane(lane, values.mass);
  damping_.set_lane(lane, values.damping);
  stiffness_.set_lane(lane, values.stiffness);
  inverse_.set_lane(lane, mounted ? inverse(step) : SixBySix{});
  const Six rest = mounted ? solve(values.stiffness, add(own_wrench, 1.0, carried_wrench)) : Six{};
  for (LaneSix* value : {&start_, &twist_}) set_lane(*value, lane, rest);
  for (LaneSix* value : {&velocity_, &acceleration_, &load_theta_, &free_}) set_lane(*value, lane, Six{});
  for (LaneSix* value : {&own_, &own_theta_, &own_next_}) set_lane(*value, lane, mounted ? own_wrench : Six{});
  set_lane(contact_, lane, mounted ? carried_wrench : Six{});
  for (std::size_t i = 0; i < 3; ++i) origin_m_[i].set(lane, values.origin_m[i]);
  carries_pads_.set(lane, values.carries_pads ? 1.0 : 0.0);
  carries_support_.set(lane, values.carries_support ? 1.0 : 0.0);
  for (Lane* sum : {&work_, &positive_work_, &dissipated_}) sum->set(lane, 0.0);
}

void MountLanes::archive(LaneArchive& lane) {
  for (LaneSix* value :
       {&start_, &twist_, &velocity_, &acceleration_, &own_, &own_theta_, &own_next_, &contact_}) {
    lane.members(*value);
  }
  lane(work_, positive_work_, dissipated_);
}

void MountLanes::set_own_wrench(int lane, const Six& at_theta, const Six& at_end) {
  set_lane(own_theta_, lane, at_theta);
  set_lane(own_next_, lane, at_end);
}

void MountLanes::begin_step(const WilsonTheta& w) {
  const LaneSix inertial = Lane(w.a0) * twist_ + Lane(w.a2) * velocity_ + Lane(2.0) * acceleration_;
  const LaneSix viscous = Lane(w.a1) * twist_ + Lane(2.0) * velocity_ + Lane(w.a3) * acceleration_;
  load_theta_ = mass_ * inertial + damping_ * viscous + own_theta_;
  free_ = inverse_ * load_theta_ - start_;
}

void MountLanes::advance(const WilsonTheta& w, const LaneSix& contact_theta, const Mask& running) {
  const LaneSix theta = inverse_ * (load_theta_ + contact_theta);
  LaneSix twist = twist_, velocity = velocity_, acceleration = acceleration_;
  for (std::size_t i = 0; i < 6; ++i) w.advance(theta[i], twist[i], velocity[i], acceleration[i]);
  const LaneSix mean_velocity = Lane(0.5) * (velocity_ + velocity);
  const Lane step_work = Lane(0.5) * dot(own_ + own_next_, twist - twist_);
  work_ += select(running, step_work, Lane(0.0));
  positive_work_ += select(running, max(step_work, Lane(0.0)), Lane(0.0));
  dissipated_ += select(running, Lane(w.dt) * dot(mean_velocity, damping_ * mean_velocity), Lane(0.0));
  twist_ = select(running, twist, twist_);
  velocity_ = select(running, velocity, velocity_);
  acceleration_ = select(running, acceleration, acceleration_);
  own_ = select(running, own_next_, own_);
  const LaneSix contact = contact_ + Lane(1.0 / w.theta) * (contact_theta - contact_);
  contact_ = select(running, contact, contact_);
}

Lane MountLanes::energy() const {
  return Lane(0.5) * (dot(velocity_, mass_ * velocity_) + dot(twist_, stiffness_ * twist_));
}

}  // namespace unbruised

#include "core/gripper/finger_lanes.hpp"

namespace unbruised {
void FingerLanes::load(int lane, const std::optional<GripperParameters>& gripper, double closing_speed_m_s) {
  const GripperParameters values = gripper.value_or(GripperParameters{});
  for (State& s : state_) {
    for (Lane* value : {&s.way, &s.speed, &s.acceleration, &s.drive, &s.free_force, &s.viscous})
      value->set(lane, 0.0);
  }
  for (State& s : state_) {
    s.speed.set(lane, gripper ? closing_speed_m_s : 0.0);
    // At constant speed the drive overcomes the guide's friction.
    s.drive.set(lane, values.drive_viscous_N_s_m * s.speed[lane]);
  }
  mass_.set(lane, values.finger_mass_kg);
  viscous_.set(lane, values.drive_viscous_N_s_m);
  gain_.set(lane, values.drive_gain_N_s_m);
  centric_.set(lane, values.coupling == FingerCoupling::centric);
  for (Lane* sum : {&work_, &positive_work_, &dissipated_}) sum->set(lane, 0.0);
}

void FingerLanes::begin_step(const WilsonTheta& w, const DriveCommand& command) {
  command_ = command;
  a1_ = Lane(w.a1);
  stiffness_ = Lane(w.a0) * mass_ + a1_ * viscous_;
  inverse_stiffness_ = Lane(1.0) / stiffness_;
  inverse_driven_ = Lane(1.0) / (stiffness_ + a1_ * gain_);
  compliance_ = select(centric_, Lane(0.5) * inverse_stiffness_, inverse_stiffness_);
  for (int finger = 0; finger < kFingerCount; ++finger) {
    State& s = state_[finger];
    s.viscous = w.viscous(s.way, s.speed, s.acceleration);
    // Rack and pinion: what the palm's acceleration does to one finger it undoes on the other.
    const Lane inertial =
        select(centric_, Lane(0.0), Lane(normal_sign(finger)) * mass_ * command.palm_acceleration_x_m_s2);
    s.free_force = mass_ * w.inertial(s.way, s.speed, s.acceleration) + viscous_ * s.viscous - inertial;
  }
}

Lane FingerLanes::contact_share(int finger, const std::array<Lane, kFingerCount>& force) const {
  return select(centric_, Lane(0.5) * (force[0] + force[1]), force[finger]);
}

Lane FingerLanes::drive_at_theta(int finger, const Lane& contact) const {
  const State& s = state_[finger];
  const Lane way = (s.free_force - contact + gain_ * (command_.set_speed_m_s + s.viscous)) * inverse_driven_;
  const Lane wanted = gain_ * (command_.set_speed_m_s - (a1_ * way - s.viscous));
  return max(-command_.force_limit_N, min(command_.force_limit_N, wanted));
}

Lane FingerLanes::way_at_theta(int finger, const std::array<Lane, kFingerCount>& force) const {
  // Solving with the linear drive first and clamping its force is exact: the balance is monotone in the way.
  const Lane contact = contact_share(finger, force);
  return (state_[finger].free_force - contact + drive_at_theta(finger, contact)) * inverse_stiffness_;
}

void FingerLanes::advance(const WilsonTheta& w, const std::array<Lane, kFingerCount>& force_theta,
                          const Mask& running) {
  for (int finger = 0; finger < kFingerCount; ++finger) {
    State& s = state_[finger];
    const Lane contact = contact_share(finger, force_theta);
    const Lane inertial =
        select(centric_, Lane(0.0), Lane(normal_sign(finger)) * mass_ * command_.palm_acceleration_x_m_s2);
    const Lane drive_theta = drive_at_theta(finger, contact) - inertial;
    const Lane drive = w.at_end(s.drive, drive_theta);
    Lane way = s.way, speed = s.speed, acceleration = s.acceleration;
    w.advance(way_at_theta(finger, force_theta), way, speed, acceleration);
    const Lane step_work = Lane(0.5) * (s.drive + drive) * (way - s.way);
    const Lane mean_speed = Lane(0.5) * (s.speed + speed);
    work_ += select(running, step_work, Lane(0.0));
    positive_work_ += select(running, max(step_work, Lane(0.0)), Lane(0.0));
    dissipated_ += select(running, viscous_ * mean_speed * mean_speed * Lane(w.dt), Lane(0.0));
    s.way = select(running, way, s.way);
    s.speed = select(running, speed, s.speed);
    s.acceleration = select(running, acceleration, s.acceleration);
    s.drive = select(running, drive, s.drive);
  }
}

Lane FingerLanes::furthest_way() const {
  Lane furthest = state_[0].way;
  for (const State& s : state_) furthest = max(furthest, s.way);
  return furthest;
}

Lane FingerLanes::kinetic_energy() const {
  return Lane(0.5) * mass_ * (state_[0].speed * state_[0].speed + state_[1].speed * state_[1].speed);
}

}  // namespace unbruised

#include "core/gripper/finger_lanes.hpp"

#include <cmath>

#include "core/door/require.hpp"

namespace unbruised {
namespace {

/// Stiffness of an end stop, [N/m]: steel on steel in a jaw's housing. 100 N press it in by 10 um.
constexpr double kStopStiffness_N_m = 1e7;

}  // namespace

void FingerLanes::load(int lane, const ParallelJawParameters* jaw, double closing_speed_m_s, double force_limit_N,
                       double opened_m) {
  require(is_lane(lane), "FingerLanes::load: there is no such lane");
  const ParallelJawParameters values = jaw != nullptr ? *jaw : ParallelJawParameters{};
  count_ = values.finger.empty() ? kJawFingers : static_cast<int>(values.finger.size());
  const double set_speed = jaw != nullptr ? closing_speed_m_s : 0.0;
  // Steady motion: the drive, gain (v_set - v), overcomes the guide's friction c v. Where its limit does not let
  // it, the fingers come with the speed that is set and are braked.
  const double steady =
      set_speed * values.drive_gain_N_s_m / (values.drive_gain_N_s_m + values.drive_viscous_N_s_m);
  const bool keeps_it_up = values.drive_viscous_N_s_m * steady <= force_limit_N;
  const double speed = keeps_it_up ? steady : set_speed;
  const double drive = keeps_it_up ? values.drive_viscous_N_s_m * steady : force_limit_N;
  for (State& s : state_) {
    for (Lane* value : {&s.way, &s.free_force, &s.viscous, &s.stop, &s.depth}) value->set(lane, 0.0);
    s.speed.set(lane, speed);
    s.drive.set(lane, drive);
    s.acceleration.set(lane, (drive - values.drive_viscous_N_s_m * speed) / values.finger_mass_kg);
  }
  opened_.set(lane, opened_m);
  stroke_.set(lane, values.stroke_m);
  stop_time_.set(lane, 2.0 * std::sqrt(values.finger_mass_kg / kStopStiffness_N_m));  // damped critically
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
  compliance_ = select(centric_, Lane(1.0 / count_) * inverse_stiffness_, inverse_stiffness_);
  for (int finger = 0; finger < count_; ++finger) {
    State& s = state_[finger];
    s.viscous = w.viscous(s.way, s.speed, s.acceleration);
    const Lane held = max(-command_.force_limit_N, min(command_.force_limit_N, s.drive));
    s.least = select(command_.told < Lane(1.0),
                     (Lane(1.0) - command_.told) * held - command_.told * command_.force_limit_N,
                     -command_.force_limit_N);
    s.free_force = mass_ * w.inertial(s.way, s.speed, s.acceleration) + viscous_ * s.viscous - palm_force(finger);
  }
}

Lane FingerLanes::palm_force(int finger) const {
  // Rack and pinion: what the palm's acceleration does to one finger of a jaw it undoes on the other.
  return mass_ * share(finger, command_.palm_acceleration_m_s2) +
         mass_ * share(finger, command_.centrifugal_1_s2) * (opened_ - state_[finger].way);
}

Lane FingerLanes::share(int finger, const FingerForces& each) const {
  Lane sum = each[0];
  for (int other = 1; other < count_; ++other) sum += each[static_cast<std::size_t>(other)];
  return select(centric_, Lane(1.0 / count_) * sum, each[static_cast<std::size_t>(finger)]);
}

Lane FingerLanes::drive_at_theta(int finger, const Lane& contact) const {
  const State& s = state_[finger];
  return drive_at_way(finger,
                      (s.free_force - contact + gain_ * (command_.set_speed_m_s + s.viscous)) * inverse_driven_);
}

Lane FingerLanes::drive_at_way(int finger, const Lane& way_theta) const {
  const Lane wanted = gain_ * (command_.set_speed_m_s - (a1_ * way_theta - state_[finger].viscous));
  return max(state_[finger].least, min(command_.force_limit_N, wanted));
}

Lane FingerLanes::free_way_at_theta(int finger, const Lane& contact) const {
  // Solving with the linear drive first and clamping its force is exact: the balance is monotone in the way.
  return (state_[finger].free_force - contact + drive_at_theta(finger, contact)) * inverse_stiffness_;
}

Lane FingerLanes::stopped_way_at_theta(int finger, const Lane& contact) const {
  // Drive and stop are clamps of straight lines that fall and rise with the way, so the balance is max and min of
  // straight lines, and its root is min and max of theirs.
  const State& s = state_[finger];
  const Lane k(kStopStiffness_N_m);
  const Lane push = s.free_force - contact;
  const auto way = [&](const Lane& stiffness, const Lane& force) {
    const Lane apart = force / stiffness;
    const Lane approaching = (force + Lane(2.0) * k * stroke_) / (stiffness + Lane(2.0) * k);
    const Lane viscoelastic =
        (force + k * stroke_ + k * stop_time_ * s.viscous) / (stiffness + k + k * stop_time_ * a1_);
    return min(apart, max(approaching, viscoelastic));
  };
  const Lane forwards = way(stiffness_, push + command_.force_limit_N);
  const Lane backwards = way(stiffness_, push + s.least);
  const Lane regulated = way(stiffness_ + a1_ * gain_, push + gain_ * (command_.set_speed_m_s + s.viscous));
  return min(forwards, max(backwards, regulated));
}

Lane FingerLanes::way_at_theta(int finger, const FingerForces& force) const {
  const Lane contact = share(finger, force);
  const Lane way = free_way_at_theta(finger, contact);
  const Mask stopped = way > stroke_;
  return none(stopped) ? way : select(stopped, stopped_way_at_theta(finger, contact), way);
}

void FingerLanes::advance(const WilsonTheta& w, const FingerForces& force_theta, const Mask& running) {
  for (int finger = 0; finger < count_; ++finger) {
    State& s = state_[finger];
    const Lane contact = share(finger, force_theta);
    const Lane inertial = palm_force(finger);
    const Lane way_theta = way_at_theta(finger, force_theta);
    const Mask stopped = way_theta > stroke_;
    const Lane drive_theta =
        select(stopped, drive_at_way(finger, way_theta), drive_at_theta(finger, contact)) - inertial;
    const Lane drive = w.at_end(s.drive, drive_theta);
    Lane way = s.way, speed = s.speed, acceleration = s.acceleration;
    w.advance(way_theta, way, speed, acceleration);
    const Lane step_work = Lane(0.5) * (s.drive + drive) * (way - s.way);
    const Lane mean_speed = Lane(0.5) * (s.speed + speed);
    work_ += select(running, step_work, Lane(0.0));
    positive_work_ += select(running, max(step_work, Lane(0.0)), Lane(0.0));
    dissipated_ += select(running, viscous_ * mean_speed * mean_speed * Lane(w.dt), Lane(0.0));
    const Lane stop_theta =
        select(stopped, s.free_force - contact + drive_theta + inertial - stiffness_ * way_theta, Lane(0.0));
    const Lane stop = w.at_end(s.stop, stop_theta);
    const Lane depth = w.at_end(s.depth, max(Lane(0.0), way_theta - stroke_));
    const Lane stored = Lane(0.5 * kStopStiffness_N_m) * (depth * depth - s.depth * s.depth);
    // By the mean speed: v changes by the mean of the forces, so that this is what the motion loses, however short
    // the impact is against the step.
    const Lane taken = Lane(0.5) * (s.stop + stop) * mean_speed * Lane(w.dt) - stored;
    dissipated_ += select(running, taken, Lane(0.0));
    s.stop = select(running, stop, s.stop);
    s.depth = select(running, depth, s.depth);
    s.way = select(running, way, s.way);
    s.speed = select(running, speed, s.speed);
    s.acceleration = select(running, acceleration, s.acceleration);
    s.drive = select(running, drive, s.drive);
  }
}

Lane FingerLanes::furthest_way() const {
  Lane furthest = state_[0].way;
  for (int finger = 1; finger < count_; ++finger) furthest = max(furthest, way(finger));
  return furthest;
}

Lane FingerLanes::closing() const {
  Lane sum = state_[0].way;
  for (int finger = 1; finger < count_; ++finger) sum += way(finger);
  return sum;
}

Lane FingerLanes::energy() const {
  Lane doubled(0.0);
  for (int finger = 0; finger < count_; ++finger) {
    const State& s = state_[static_cast<std::size_t>(finger)];
    doubled += mass_ * s.speed * s.speed + Lane(kStopStiffness_N_m) * s.depth * s.depth;
  }
  return Lane(0.5) * doubled;
}

}  // namespace unbruised

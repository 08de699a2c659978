#include "core/gripper/finger_lanes.hpp"

#include <algorithm>
#include <cmath>

#include "core/door/require.hpp"
#include "core/scenario/pad_lattice.hpp"

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
  curve_.load(lane, values.curve_speed_m_s, values.curve_force_N);
  lock_.load(lane, values.hold == HoldMode::position, values.lock_stiffness_N_m);
  const auto limit_at = [&](double speed) { return std::min(force_limit_N, curve_.force_N(Lane(speed))[lane]); };
  const bool keeps_it_up = values.drive_viscous_N_s_m * steady <= limit_at(steady);
  const double speed = keeps_it_up ? steady : set_speed;
  const double drive = keeps_it_up ? values.drive_viscous_N_s_m * steady : limit_at(set_speed);
  const double moved_kg = values.finger_mass_kg + pad_mass_kg(values);
  for (State& s : state_) {
    for (Lane* value : {&s.way, &s.free_force, &s.viscous, &s.stop, &s.depth, &s.lock, &s.lock_energy})
      value->set(lane, 0.0);
    s.speed.set(lane, speed);
    for (Lane* value : {&s.drive, &s.pressed}) value->set(lane, drive);
    s.acceleration.set(lane, (drive - values.drive_viscous_N_s_m * speed) / moved_kg);
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

void FingerLanes::archive(LaneArchive& lane) {
  for (State& finger : state_) lane.members(finger);
  lock_.archive(lane);
  lane(work_, positive_work_, dissipated_);
}

void FingerLanes::begin_step(const WilsonTheta& w, const DriveCommand& command, const CarriedPads* pads) {
  command_ = command;
  a1_ = Lane(w.a1);
  stiffness_ = Lane(w.a0) * mass_ + a1_ * viscous_;
  if (pads != nullptr) stiffness_ += Lane(w.a0) * pads->mass_kg;
  inverse_stiffness_ = Lane(1.0) / stiffness_;
  inverse_driven_ = Lane(1.0) / (stiffness_ + a1_ * gain_);
  lock_.begin_step(w, command.locked);
  Lane compliance = inverse_stiffness_;
  if (lock_.any_closed()) {
    const Lane locked = select(lock_.springs(), Lane(1.0) / (stiffness_ + lock_.slope()), Lane(0.0));
    compliance =
        select(lock_.closed() > Lane(0.0), compliance + lock_.closed() * (locked - compliance), compliance);
  }
  compliance_ = select(centric_, Lane(1.0 / count_) * compliance, compliance);
  for (int finger = 0; finger < count_; ++finger) {
    State& s = state_[finger];
    lock_.grasp(finger, s.way, s.pressed);
    s.viscous = w.viscous(s.way, s.speed, s.acceleration);
    const Lane held = max(-command_.force_limit_N, min(command_.force_limit_N, s.drive));
    s.least = select(command_.told < Lane(1.0),
                     (Lane(1.0) - command_.told) * held - command_.told * command_.force_limit_N,
                     -command_.force_limit_N);
    s.free_force = mass_ * w.inertial(s.way, s.speed, s.acceleration) + viscous_ * s.viscous - palm_force(finger);
    if (pads != nullptr) s.free_force -= share(finger, pads->force_N);
  }
}

Lane FingerLanes::palm_force(int finger) const {
  // Rack and pinion: what the palm's acceleration does to one finger of a jaw it undoes on the other.
  return mass_ * share(finger, command_.palm_acceleration_m_s2) +
         mass_ * share(finger, command_.centrifugal_1_s2) * (opened_ - state_[finger].way);
}

Lane FingerLanes::drive_on_curve(int finger, const Lane& speed, const Lane& wanted) const {
  const Lane least = max(state_[finger].least, -curve_.force_N(-speed));
  const Lane most = min(command_.force_limit_N, curve_.force_N(speed));
  return max(least, min(most, wanted));
}

Lane FingerLanes::way_against_stop(int finger, const Lane& stiffness, const Lane& force) const {
  const Lane k(kStopStiffness_N_m);
  const Lane apart = force / stiffness;
  const Mask stopped = apart > stroke_;
  if (none(stopped)) return apart;
  const Lane approaching = (force + Lane(2.0) * k * stroke_) / (stiffness + Lane(2.0) * k);
  const Lane viscoelastic =
      (force + k * stroke_ + k * stop_time_ * state_[finger].viscous) / (stiffness + k + k * stop_time_ * a1_);
  return select(stopped, min(apart, max(approaching, viscoelastic)), apart);
}

Lane FingerLanes::stopped_way_at_theta(int finger, const Lane& contact) const {
  // Drive and stop are clamps of straight lines that fall and rise with the way, so the balance is max and min of
  // straight lines, and its root is min and max of theirs.
  const State& s = state_[finger];
  const Lane push = s.free_force - contact;
  const Lane forwards = way_against_stop(finger, stiffness_, push + command_.force_limit_N);
  const Lane backwards = way_against_stop(finger, stiffness_, push + s.least);
  const Lane regulated =
      way_against_stop(finger, stiffness_ + a1_ * gain_, push + gain_ * (command_.set_speed_m_s + s.viscous));
  return min(forwards, max(backwards, regulated));
}

Lane FingerLanes::curved_way_at_theta(int finger, const Lane& contact) const {
  // The curve falls, so that the balance stays monotone: where the root of one of its pieces lies beyond the next
  // point, the root of the whole does too.
  const State& s = state_[finger];
  const Lane push = s.free_force - contact;
  const auto along = [&](const Lane& sign) {
    Lane way = way_against_stop(finger, stiffness_, push + sign * curve_.pieces().front().force_N);
    for (const ForceCurveLanes::Piece& piece : curve_.pieces()) {
      const Mask beyond = sign * (a1_ * way - s.viscous) > piece.speed_m_s;
      const Lane at_rest = piece.force_N - piece.slope_N_s_m * piece.speed_m_s;
      const Lane line = way_against_stop(finger, stiffness_ - a1_ * piece.slope_N_s_m,
                                         push + sign * at_rest - piece.slope_N_s_m * s.viscous);
      way = select(beyond, line, way);
    }
    return way;
  };
  const Lane forwards = min(way_against_stop(finger, stiffness_, push + command_.force_limit_N), along(Lane(1.0)));
  const Lane backwards = max(way_against_stop(finger, stiffness_, push + s.least), along(Lane(-1.0)));
  const Lane regulated =
      way_against_stop(finger, stiffness_ + a1_ * gain_, push + gain_ * (command_.set_speed_m_s + s.viscous));
  return min(forwards, max(backwards, regulated));
}

Lane FingerLanes::locked_way_at_theta(int finger, const Lane& contact) const {
  const State& s = state_[finger];
  const Lane push = s.free_force - contact + lock_.drive_N(finger) + lock_.force_at_zero(finger, s.viscous);
  return select(lock_.springs(), way_against_stop(finger, stiffness_ + lock_.slope(), push), s.way);
}

Lane FingerLanes::held_way_at_theta(int finger, const Lane& contact, const Lane& driven) const {
  // A share of the balance's forces is the same share of its way.
  const Lane closed = lock_.closed(), locked = locked_way_at_theta(finger, contact);
  return select(closed >= Lane(1.0), locked,
                select(closed > Lane(0.0), driven + closed * (locked - driven), driven));
}

/// What moves a finger at t + theta dt.
struct FingerLanes::Push {
  Lane contact, inertial;
  Lane drive;      ///< or what took its place
  Lane lock{0.0};  ///< of a lock's spring and damper
  Lane way;        ///< a lock that does not give way looked through
};

FingerLanes::Push FingerLanes::push_at_theta(int finger, const FingerForces& force_theta) const {
  Push push;
  push.contact = share(finger, force_theta);
  push.inertial = palm_force(finger);
  push.way = driven_way_at_theta(finger, push.contact);
  push.drive = select((push.way > stroke_) | curve_.given(), drive_at_way(finger, push.way),
                      drive_at_theta(finger, push.contact));
  if (!lock_.any_closed()) return push;
  const Mask springs = lock_.springs(), stands = lock_.stands();
  const Lane closed = lock_.closed(), open = Lane(1.0) - closed;
  const Lane spring = lock_.force_at_zero(finger, state_[finger].viscous) -
                      lock_.slope() * locked_way_at_theta(finger, push.contact);
  push.lock = select(springs, closed * spring, Lane(0.0));
  const Lane held = select(springs, lock_.drive_N(finger), push.contact + push.inertial);
  push.drive = select(springs | stands, open * push.drive + closed * held, push.drive);
  push.way = select(stands, push.way, way_at_theta(finger, force_theta));
  return push;
}

void FingerLanes::advance(const WilsonTheta& w, const FingerForces& force_theta, const Mask& running) {
  for (int finger = 0; finger < count_; ++finger) {
    State& s = state_[finger];
    const Push push = push_at_theta(finger, force_theta);
    const Lane drive_theta = push.drive - push.inertial;
    const Lane drive = w.at_end(s.drive, drive_theta), pressed = w.at_end(s.pressed, push.drive);
    Lane way = s.way, speed = s.speed, acceleration = s.acceleration;
    w.advance(push.way, way, speed, acceleration);
    Lane mean_speed = Lane(0.5) * (s.speed + speed);
    const Mask stands = lock_.stands();
    if (any(stands)) {
      // Of the step in which it closes, such a lock leaves the share in which it was open.
      const Lane open = Lane(1.0) - lock_.closed();
      const Lane taken = lock_.closed() * (s.speed * s.speed + open * speed * speed);
      dissipated_ += select(running & stands, Lane(0.5) * mass_ * taken, Lane(0.0));
      way = select(stands, s.way + open * (way - s.way), way);
      for (Lane* rate : {&speed, &acceleration, &mean_speed}) *rate = select(stands, open * *rate, *rate);
    }
    const Lane step_work = Lane(0.5) * (s.drive + drive) * (way - s.way);
    work_ += select(running, step_work, Lane(0.0));
    positive_work_ += select(running, max(step_work, Lane(0.0)), Lane(0.0));
    dissipated_ += select(running, viscous_ * mean_speed * mean_speed * Lane(w.dt), Lane(0.0));
    const Lane stop_theta = select(
        (push.way > stroke_) & !stands,
        s.free_force - push.contact + drive_theta + push.inertial + push.lock - stiffness_ * push.way, Lane(0.0));
    const Lane stop = select(stands, s.stop, w.at_end(s.stop, stop_theta));
    const Lane depth = select(stands, s.depth, w.at_end(s.depth, max(Lane(0.0), push.way - stroke_)));
    const Lane lock = w.at_end(s.lock, push.lock), lock_energy = lock_.stored(finger, way);
    const Lane stored =
        Lane(0.5 * kStopStiffness_N_m) * (depth * depth - s.depth * s.depth) + lock_energy - s.lock_energy;
    // By the mean speed: v changes by the mean of the forces, so that this is what the motion loses, however short
    // the impact is against the step.
    const Lane resisted = Lane(0.5) * (s.stop + stop - s.lock - lock);
    const Lane taken = resisted * mean_speed * Lane(w.dt) - stored;
    dissipated_ += select(running, taken, Lane(0.0));
    lock_.slide(finger, {s.way, way}, {s.pressed, pressed}, running);
    s.stop = select(running, stop, s.stop);
    s.depth = select(running, depth, s.depth);
    s.way = select(running, way, s.way);
    s.speed = select(running, speed, s.speed);
    s.acceleration = select(running, acceleration, s.acceleration);
    s.drive = select(running, drive, s.drive);
    s.pressed = select(running, pressed, s.pressed);
    s.lock = select(running, lock, s.lock);
    s.lock_energy = select(running, lock_energy, s.lock_energy);
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
    doubled += Lane(2.0) * s.lock_energy;
  }
  return Lane(0.5) * doubled;
}

}  // namespace unbruised

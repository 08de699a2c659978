#include "core/gripper/finger_lock.hpp"

namespace unbruised {

void FingerLock::load(int lane, bool is_there, const std::optional<double>& stiffness_N_m) {
  there_.set(lane, is_there);
  gives_way_.set(lane, stiffness_N_m.has_value());
  stiffness_.set(lane, stiffness_N_m.value_or(0.0));
  closed_.set(lane, 0.0);
  for (Held& held : held_) {
    held.place.set(lane, 0.0);
    held.drive.set(lane, 0.0);
  }
}

void FingerLock::begin_step(const WilsonTheta& w, const Lane& closed) {
  const Mask was_open = closed_ <= Lane(0.0);
  closed_ = select(there_, closed, Lane(0.0));
  closes_ = was_open & (closed_ > Lane(0.0));
  any_closed_ = any(closed_ > Lane(0.0));
  slope_ = stiffness_ * Lane(1.0 + kLockRelaxationTime_s * w.a1);
}

void FingerLock::grasp(int finger, const Lane& way_m, const Lane& drive_N) {
  Held& held = held_[static_cast<std::size_t>(finger)];
  held.place = select(closes_, way_m, held.place);
  held.drive = select(closes_, drive_N, held.drive);
}

void FingerLock::slide(int finger, const std::array<Lane, 2>& way_m, const std::array<Lane, 2>& drive_N,
                       const Mask& running) {
  Held& held = held_[static_cast<std::size_t>(finger)];
  const Mask slides = closes_ & running;
  const Lane open = Lane(1.0) - closed_;
  held.place = select(slides, way_m[0] + open * (way_m[1] - way_m[0]), held.place);
  held.drive = select(slides, drive_N[0] + open * (drive_N[1] - drive_N[0]), held.drive);
}

}  // namespace unbruised

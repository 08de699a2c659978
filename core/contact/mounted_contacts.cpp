#include "core/contact/mounted_contacts.hpp"

namespace unbruised {

MountedContacts::MountedContacts(const ContactModel& model)
    : model_(model), arm_(3 * model.candidate.size()), own_(3 * model.candidate.size()) {
  carried_.fill(Lane(0.0));
}

void MountedContacts::begin_step(const MountLanes& mount) {
  mount_ = &mount;
  for (int pad = 0; pad < kFingerCount; ++pad) carried_[static_cast<std::size_t>(pad)] = mount.carries_pads();
  carried_[kSupport] = mount.carries_support();
  restart(Mask(true));
}

void MountedContacts::restart(const Mask& lanes) {
  wrench_ = select(lanes, LaneSix{}, wrench_);
  twist_ = select(lanes, mount_->free(), twist_);
}

void MountedContacts::place(std::size_t candidate, const LaneVector& at_m) {
  const LaneVector arm = at_m - mount_->origin_m();
  put_vector(arm_, candidate, arm);
  const Lane& on = carried(surface_of(candidate));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    LaneVector unit;
    unit[axis] = on;
    const LaneSix push{unit, cross(arm, unit)};
    own_.put(3 * candidate + axis, dot(push, mount_->compliance() * push));
  }
}

}  // namespace unbruised

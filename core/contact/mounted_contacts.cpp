#include "core/contact/mounted_contacts.hpp"

namespace unbruised {

MountedContacts::MountedContacts(const ContactModel& model)
    : model_(model), arm_(3 * model.candidate.size()), own_(3 * model.candidate.size()) {
  carried_.fill(Lane(0.0));
}

void MountedContacts::begin_step(const MountLanes& mount) {
  mount_ = &mount;
  for (int pad = 0; pad < kJawFingers; ++pad) carried_[static_cast<std::size_t>(pad)] = mount.carries_pads();
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
  const LaneSixBySix& A = mount_->compliance();
  for (std::size_t i = 0; i < 3; ++i) {
    // A force of 1 along i turns by arm x e_i: arm_k about j and -arm_j about k.
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    const Lane &about_j = arm[k], &about_k = arm[j];
    const Lane turned = about_j * A.block[0][1](i, j) - about_k * A.block[0][1](i, k);
    const Lane turning = about_j * about_j * A.block[1][1](j, j) + about_k * about_k * A.block[1][1](k, k) -
                         Lane(2.0) * about_j * about_k * A.block[1][1](j, k);
    own_.put(3 * candidate + i, on * (A.block[0][0](i, i) + Lane(2.0) * turned + turning));
  }
}

}  // namespace unbruised

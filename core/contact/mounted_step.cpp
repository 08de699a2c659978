#include "core/contact/contact_lanes.hpp"

namespace unbruised {

// How surfaces that mounts carry go through a step.

void ContactLanes::begin_mounts(const MountLanes* mount) {
  mounted_now_ = mount != nullptr;
  if (mounted_now_) mounted_.begin_step(*mount);
}

/// Takes in that the surface moves with its mount. @param at_m the candidate's place, from where the carrier
/// stands
void ContactLanes::go_with_mount(std::size_t c, const LaneVector& at_m, const MountLanes& mount,
                                 Meeting& meeting) {
  const int surface = model_.candidate[c].surface;
  if (!mounted_.carries(surface)) return;
  const auto axis = static_cast<std::size_t>(normal_axis(surface));
  const Lane sign(normal_sign(surface));
  mounted_.place(c, at_m);
  meeting.gap_now -= sign * mounted_.along(c, axis, mount.displacement());
  meeting.gap_free -= sign * mounted_.along(c, axis, mount.free());
  meeting.rate += sign * mounted_.along(c, axis, mount.velocity());
  meeting.second_rate += sign * mounted_.along(c, axis, mount.acceleration());
}

/// The support moves by no more than this along its normal under any place of the product, as its mount moves
/// within the step without contact forces.
Lane ContactLanes::sway_m(const MountLanes& mount) const {
  const LaneVector arm = places_->center(kSupport) - mount.origin_m();
  const LaneSix& free = mount.free();
  const Lane across = abs(arm[0]) + abs(arm[1]) + Lane(reach_m_);
  return mount.carries_support() * (abs(free.linear[2]) + (abs(free.angular[0]) + abs(free.angular[1])) * across);
}

}  // namespace unbruised

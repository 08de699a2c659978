#pragma once

/// @file
/// Contacts with surfaces that mounts carry: what their forces do to the mount, and how the mount moves the
/// surface under each of them. In a lane without a mount all of it is 0.

#include <array>

#include "core/body/mount_lanes.hpp"
#include "core/contact/contact_model.hpp"
#include "core/surface/surfaces.hpp"

namespace unbruised {

class MountedContacts {
 public:
  /// The model has to outlive this.
  explicit MountedContacts(const ContactModel& model);

  /// Starts a step without contact forces. @param mount has to outlive the step
  void begin_step(const MountLanes& mount);
  /// Takes in where a candidate's place is, along the axes of its surface's carrier and from where that stands.
  void place(std::size_t candidate, const LaneVector& at_m);

  /// Motion of the surface at a candidate's place when its mount moves by a twist, or with its rate.
  [[nodiscard, gnu::always_inline]] LaneVector motion(std::size_t candidate, const LaneSix& twist) const {
    return carried(surface_of(candidate)) * (twist.linear + cross(twist.angular, get_vector(arm_, candidate)));
  }
  /// The same along one axis.
  [[nodiscard, gnu::always_inline]] Lane along(std::size_t candidate, std::size_t axis,
                                               const LaneSix& twist) const {
    const std::size_t j = (axis + 1) % 3, k = (axis + 2) % 3;
    const Lane turned =
        twist.angular[j] * arm_.get(3 * candidate + k) - twist.angular[k] * arm_.get(3 * candidate + j);
    return carried(surface_of(candidate)) * (twist.linear[axis] + turned);
  }
  /// At t + theta dt under the present forces.
  [[nodiscard, gnu::always_inline]] Lane along(std::size_t candidate, std::size_t axis) const {
    return along(candidate, axis, twist_);
  }
  /// How far the surface gives way at a candidate's place along an axis per force along it.
  [[nodiscard, gnu::always_inline]] Lane own_compliance(std::size_t candidate, std::size_t axis) const {
    return own_.get(3 * candidate + axis);
  }
  /// Is any candidate of this surface mounted, in any lane?
  [[nodiscard]] bool carries(int surface) const { return any(carried(surface) > Lane(0.0)); }

  /// Lanes in which a mount carries anything.
  [[nodiscard]] Mask lanes() const {
    Mask any_of(false);
    for (const Lane& on : carried_) any_of = any_of | (on > Lane(0.0));
    return any_of;
  }

  /// Forgets all forces in `lanes`.
  void restart(const Mask& lanes);
  /// Adds a force on the product, along the carrier's axes, to what acts on the mount.
  [[gnu::always_inline]] void push(std::size_t candidate, const LaneVector& force) {
    const Lane& on = carried(surface_of(candidate));
    const LaneVector reaction = -on * force;
    const LaneSix wrench{reaction, cross(get_vector(arm_, candidate), reaction)};
    wrench_ += wrench;
    twist_ += mount_->compliance() * wrench;
  }

  /// Of the contacts on the mount at t + theta dt.
  [[nodiscard]] const LaneSix& wrench() const { return wrench_; }
  /// Displacement of the mount from the start at t + theta dt.
  [[nodiscard]] const LaneSix& twist() const { return twist_; }

 private:
  [[nodiscard]] int surface_of(std::size_t candidate) const { return model_.candidate[candidate].surface; }
  /// 1 where the mount of a lane carries a surface.
  [[nodiscard]] const Lane& carried(int surface) const { return carried_[static_cast<std::size_t>(surface)]; }

  const ContactModel& model_;
  const MountLanes* mount_ = nullptr;
  std::array<Lane, kSurfaceCount> carried_;
  LaneArray arm_, own_;  ///< rows 3 x candidate + axis
  LaneSix wrench_, twist_;
};

}  // namespace unbruised

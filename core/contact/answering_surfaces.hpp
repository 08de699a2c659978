#pragma once

/// @file
/// How what carries a surface answers while a candidate that touches it is updated: a part of contact_sweep.cpp.

#include "core/contact/contact_sweep.hpp"

namespace unbruised {

/// Each force is the contact's own.
struct ContactSweep::OwnForces {
  OwnForces(ContactSweep& of, const GripperLanes&) : sweep(of) {}

  ContactSweep& sweep;

  [[nodiscard]] const PadForces& pad_forces() const { return sweep.pad_force_; }
  /// What of a change of a force is the contact's own.
  [[nodiscard]] const Lane& own_normal(std::size_t, const Lane& change) const { return change; }
  [[nodiscard]] const Lane& own_tangent(std::size_t, std::size_t, const Lane& change) const { return change; }
  void begin_tangents(std::size_t) const {}
  /// 1 / (1 + shear x compliance along the tangents). @param alone where nothing else answers
  [[nodiscard]] Lane relaxed(std::size_t, const Lane& alone, const std::array<Lane, 2>&) const { return alone; }
};

/// Where no surface is on a mount nothing asks for one.
struct ContactSweep::FixedSurfaces : OwnForces {
  using OwnForces::OwnForces;

  void begin(std::size_t) const {}
  void give_way(std::size_t, std::size_t, const Lane&, const Lane&) const {}
  [[nodiscard]] const Lane& place(std::size_t, const Lane& carrier) const { return carrier; }
  [[nodiscard]] Lane compliance_along(std::size_t, const LaneVector&) const { return Lane(0.0); }
  [[nodiscard]] Lane compliance_across(std::size_t) const { return Lane(0.0); }
  void push(std::size_t, const Lane&) const {}
  void end(std::size_t) const {}
};

/// How the mounts of surfaces answer while a candidate is updated.
struct ContactSweep::MountedSurfaces : OwnForces {
  MountedSurfaces(ContactSweep& of, const GripperLanes& with) : OwnForces(of, with), mounted(of.mounted_) {}

  MountedContacts* mounted;
  LaneVector moved{};   ///< the surface at the candidate, under the forces before its update
  LaneVector change{};  ///< of the force on the product so far

  [[gnu::always_inline]] void begin(std::size_t c) { moved = mounted->motion(c, mounted->twist()); }
  [[gnu::always_inline]] void give_way(std::size_t c, std::size_t axis, Lane& compliance, Lane& place_m) const {
    compliance += mounted->own_compliance(c, axis);
    place_m += moved[axis];
  }
  [[nodiscard, gnu::always_inline]] Lane place(std::size_t axis, const Lane& carrier) const {
    return carrier + moved[axis];
  }
  /// Not less than along any direction: of a compliance C, n' C n <= (sum |n_i| sqrt C_ii)^2.
  [[nodiscard]] Lane compliance_along(std::size_t c, const LaneVector& n) const {
    Lane root(0.0);
    for (std::size_t i = 0; i < 3; ++i) root += abs(n[i]) * sqrt(max0(mounted->own_compliance(c, i)));
    return root * root;
  }
  [[nodiscard]] Lane compliance_across(std::size_t c) const {
    return mounted->own_compliance(c, 0) + mounted->own_compliance(c, 1) + mounted->own_compliance(c, 2);
  }
  [[gnu::always_inline]] void push(std::size_t axis, const Lane& by) { change[axis] = by; }
  [[gnu::always_inline]] void end(std::size_t c) const { mounted->push(c, change); }
};

/// How pads that are bodies, and mounts beside them, answer. Their faces are planes.
struct ContactSweep::PaddedSurfaces : OwnForces {
  PaddedSurfaces(ContactSweep& of, const GripperLanes& with) : OwnForces(of, with), gripper(with) {}

  const GripperLanes& gripper;
  LaneVector moved{};   ///< the surface at the candidate, under the forces before its update
  LaneVector change{};  ///< of the force on the product so far

  [[nodiscard]] bool on_pad(std::size_t c) const { return sweep.pads_->has(c); }
  [[nodiscard]] bool on_mount(std::size_t c) const { return !on_pad(c) && sweep.mounted_ != nullptr; }
  void begin(std::size_t c) {
    if (on_pad(c)) {
      moved = sweep.pads_->motion(c, gripper.way_at_theta(sweep.model_.candidate[c].surface, sweep.pad_force_));
    } else if (on_mount(c)) {
      moved = sweep.mounted_->motion(c, sweep.mounted_->twist());
    }
  }
  void give_way(std::size_t c, std::size_t axis, Lane& compliance, Lane& place_m) const {
    if (on_pad(c)) {
      compliance += sweep.pads_->own_compliance(c, axis) + sweep.pads_->less_by_finger(c) * gripper.compliance();
    } else if (on_mount(c)) {
      compliance += sweep.mounted_->own_compliance(c, axis);
    }
    place_m += moved[axis];
  }
  [[nodiscard]] Lane place(std::size_t axis, const Lane& carrier) const { return carrier + moved[axis]; }
  [[nodiscard]] Lane compliance_along(std::size_t, const LaneVector&) const { return Lane(0.0); }
  [[nodiscard]] Lane compliance_across(std::size_t) const { return Lane(0.0); }
  void push(std::size_t axis, const Lane& by) { change[axis] = by; }
  void end(std::size_t c) const {
    if (on_pad(c)) {
      sweep.pad_force_[sweep.model_.candidate[c].surface] -= sweep.pads_->push(c, change);
    } else if (on_mount(c)) {
      sweep.mounted_->push(c, change);
    }
  }
};

}  // namespace unbruised

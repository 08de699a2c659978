#pragma once

/// @file
/// How the patches of contacts answer as wholes while a candidate that touches is updated: a part of
/// contact_sweep.cpp, for products that stay upright between planes on no mount.

#include "core/contact/contact_sweep.hpp"

namespace unbruised {

/// During a sweep nodes, pads and `own_force_` have the contacts' own forces; the register has a candidate's whole
/// forces as of its update.
struct ContactSweep::DeflatedSurfaces : FixedSurfaces {
  DeflatedSurfaces(ContactSweep& of, const GripperLanes& with) : FixedSurfaces(of, with), modes(*of.modes_) {}

  PatchModes& modes;
  std::size_t node = 0;

  [[gnu::always_inline]] void begin(std::size_t c) {
    node = static_cast<std::size_t>(sweep.model_.candidate[c].contact_node);
    sweep.contacts_.normal_theta.put(c, sweep.whole_force(c, 0));
  }
  [[nodiscard, gnu::always_inline]] PadForces pad_forces() const { return sweep.whole_pad_force(); }
  [[gnu::always_inline]] void give_way(std::size_t c, std::size_t axis, Lane& compliance, Lane& place_m) const {
    compliance = modes.felt(c, 0, compliance);
    place_m -= modes.displacement(node, axis);
  }
  [[gnu::always_inline]] Lane own_normal(std::size_t c, const Lane& change) { return own(c, 0, change); }
  [[gnu::always_inline]] void begin_tangents(std::size_t c) {
    for (std::size_t t = 0; t < 2; ++t) sweep.contacts_.tangent_theta[t].put(c, sweep.whole_force(c, 1 + t));
  }
  [[nodiscard, gnu::always_inline]] Lane place(std::size_t axis, const Lane& carrier) const {
    return carrier - modes.displacement(node, axis);
  }
  [[nodiscard, gnu::always_inline]] Lane relaxed(std::size_t c, const Lane& /*alone*/,
                                                 const std::array<Lane, 2>& compliance) const {
    const Lane felt = max(modes.felt(c, 1, compliance[0]), modes.felt(c, 2, compliance[1]));
    return Lane(1.0) / (Lane(1.0) + sweep.shear_.get(c) * felt);
  }
  [[gnu::always_inline]] Lane own_tangent(std::size_t c, std::size_t t, const Lane& change) {
    return own(c, 1 + t, change);
  }

 private:
  [[gnu::always_inline]] Lane own(std::size_t c, std::size_t of, const Lane& change) {
    const std::size_t row = PatchModes::kForces * c + of;
    const Lane by = change * modes.inverse_kept(c, of);
    sweep.own_force_.put(row, sweep.own_force_.get(row) + by);
    modes.answer(c, of, by);
    return by;
  }
};

}  // namespace unbruised

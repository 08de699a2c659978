#include "core/contact/contact_sweep.hpp"
#include "core/contact/surface_tally.hpp"

namespace unbruised {

// What the contact solve asks of the axes in which a candidate is seen.

/// T W_ii T', T into the axes of its surface's carrier or, before a shaped pad, its own.
void ContactSweep::prepare_turned(std::size_t c) {
  const ContactCandidate& candidate = model_.candidate[c];
  const double* own = candidate.place < 0
                          ? model_.compliance.data() + 9 * candidate.contact_node * (model_.node_count() + 1)
                          : model_.place[static_cast<std::size_t>(candidate.place)].compliance.data();
  LaneMatrix T = eyes_.frame == nullptr ? identity_lanes() : axes_of(candidate).turn;
  if (model_.is_shaped(c)) T = shaped_->axes(c) * T;
  LaneMatrix W;
  for (std::size_t i = 0; i < 9; ++i) W.at[i] = Lane(own[i]);
  const LaneMatrix turned = T * W * transposed(T);
  for (std::size_t i = 0; i < 9; ++i) own_.put(9 * c + i, turned.at[i]);
}

LaneVector ContactSweep::force_in_frame(std::size_t c) const {
  const LaneVector force = force_on_carrier(c);
  return eyes_.frame == nullptr ? force : transposed(axes_of(model_.candidate[c]).turn) * force;
}

LaneVector ContactSweep::force_on_carrier(std::size_t c) const {
  const LaneVector force{along_axes(model_.candidate[c].surface, contacts_.normal_theta.get(c),
                                    contacts_.tangent_theta[0].get(c), contacts_.tangent_theta[1].get(c))};
  return model_.is_shaped(c) ? shaped_->along_carrier(c, force) : force;
}

Lane ContactSweep::closing_force(std::size_t c) const {
  if (!model_.is_shaped(c)) return contacts_.normal_theta.get(c);
  return Lane(normal_sign(model_.candidate[c].surface)) * force_on_carrier(c)[0];
}

}  // namespace unbruised

#pragma once

/// @file
/// Contacts with pads that are bodies, all lanes at once: where their faces are under each candidate, and how they
/// answer to the contact forces. Along the axes of the palm, against the place of a face that does not deform.

#include <array>
#include <span>
#include <vector>

#include "core/algebra/lane_matrix.hpp"
#include "core/contact/contact_model.hpp"
#include "core/gripper/pad_lanes.hpp"

namespace unbruised {

class PadContacts {
 public:
  /// The model has to outlive this, and to have pads that are bodies.
  explicit PadContacts(const ContactModel& model);

  /// Does this candidate meet a pad?
  [[nodiscard]] bool has(std::size_t candidate) const { return faces_.place[candidate] >= 0; }

  /// Takes in where the faces are at the start of a step and where they come without contact forces.
  void begin_step(const PadLanes& pads, const GripperLanes& gripper);
  /// Along the normal axis of a candidate's pad, at the start of the step.
  [[nodiscard]] const Lane now_m(std::size_t candidate) const { return now_.get(candidate); }
  /// The same at t + theta dt without contact forces.
  [[nodiscard]] Lane free_m(std::size_t candidate) const;

  /// Lists those that are near, ascending.
  void list_near(std::span<const int> candidates);
  /// Forgets all forces in `lanes`.
  void restart(const Mask& lanes);
  /// Adds a force on the product to what acts on the pad. @return by how much less than its normal part the finger
  /// feels
  [[gnu::always_inline]] Lane push(std::size_t candidate, const LaneVector& force) {
    const Place at = place(candidate);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t row = 3 * at.number + i;
      push_[at.pad].put(row, push_[at.pad].get(row) - force[i]);
    }
    const double* lag = face(at).lag.data() + 3 * at.number;
    return Lane(lag[0]) * force[0] + Lane(lag[1]) * force[1] + Lane(lag[2]) * force[2];
  }
  /// Of the face at a candidate, at t + theta dt under the present forces. @param way of its finger
  [[nodiscard]] LaneVector motion(std::size_t candidate, const Lane& way) const;
  /// How far the face gives way at a candidate along an axis per force along it, the finger standing still.
  [[nodiscard]] Lane own_compliance(std::size_t candidate, std::size_t axis) const {
    const Place at = place(candidate);
    return Lane(face(at).compliance[9 * at.number * (face(at).candidate.size() + 1) + 4 * axis]);
  }
  /// By how much less the face goes with the finger and back, as a share of the finger's own compliance.
  [[nodiscard]] Lane less_by_finger(std::size_t candidate) const {
    const Place at = place(candidate);
    const double follows = 1.0 - normal_sign(static_cast<int>(at.pad)) * face(at).lag[3 * at.number];
    return Lane(follows * follows - 1.0);
  }
  /// Forces on the particles of a pad's face, rows as in PadLanes::free, in the axes of the pad; null: none.
  [[nodiscard]] const LaneArray* face_force(int pad);

  /// Takes in where the faces have come.
  void end_step(const PadLanes& pads);
  /// Of the face at a candidate, at t + theta dt and at t + dt.
  [[nodiscard]] Lane theta_m(std::size_t candidate, std::size_t axis) const {
    return theta_.get(3 * candidate + axis);
  }
  [[nodiscard]] Lane next_m(std::size_t candidate, std::size_t axis) const {
    return next_.get(3 * candidate + axis);
  }

 private:
  struct Place {
    std::size_t pad, number;
  };
  [[nodiscard]] Place place(std::size_t candidate) const {
    return {static_cast<std::size_t>(model_.candidate[candidate].surface),
            static_cast<std::size_t>(faces_.place[candidate])};
  }
  [[nodiscard]] const PadFaces::Face& face(const Place& at) const { return faces_.face[at.pad]; }

  const ContactModel& model_;
  const PadFaces& faces_;
  LaneArray now_;                                   ///< per candidate
  LaneArray free_, theta_, next_;                   ///< 3 per candidate
  std::array<LaneArray, kJawFingers> push_;         ///< on the pad, 3 per candidate of its face
  std::array<LaneArray, kJawFingers> node_force_;   ///< 3 per particle of its face
  std::array<std::vector<int>, kJawFingers> near_;  ///< numbers in the face, ascending
  std::array<Lane, kJawFingers> way_free_{Lane(0.0), Lane(0.0)};
  BusyPacks solving_{Mask(true)};  ///< those that restarted last
};

}  // namespace unbruised

#pragma once

/// @file
/// The contact nodes of a product that turns, as what carries the surfaces sees them: displaced along the axes of
/// the palm, which turns, and along those of the cell. There a pad or a support is where it is for a product that
/// stands upright, so that layers, anchors and slip know nothing of turning (docs/theory.md, "Contact that
/// turns").

#include <array>
#include <vector>

#include "core/contact/contact_model.hpp"
#include "core/frame/frame_lanes.hpp"
#include "core/surface/carrier_motion.hpp"

namespace unbruised {

/// From the axes of a product's frame into those of a carrier: a particle at y = X + u is displaced there by
/// turn y + origin - X.
struct CarrierAxes {
  LaneMatrix turn;
  LaneVector origin;

  [[nodiscard, gnu::always_inline]] LaneVector displacement(const LaneVector& X, const LaneVector& u) const {
    return turn * (X + u) + origin - X;
  }
};

/// Carriers by number.
inline constexpr std::size_t kPalm = 0, kCell = 1;
inline constexpr std::size_t kCarrierCount = 2;
constexpr std::size_t carrier_number(int surface) { return is_pad(surface) ? kPalm : kCell; }

/// The state of a product as one carrier sees it; rows 3 x particle + axis, those of contact nodes only.
struct SeenMotion {
  LaneArray u, v, a;
  LaneArray u_theta;
  LaneArray base;  ///< displacement at t + theta dt without contact forces, rows 3 x contact node + axis
};

/// The state of a product, rows 3 x particle + axis.
struct StateRows {
  const LaneArray& u;
  const LaneArray& v;
  const LaneArray& a;
};

class SeenNodes {
 public:
  /// The contact model has to outlive this.
  SeenNodes(const ContactModel& model, const BodyModel& body);

  /// @param grip_m centre of the pads where the palm has not moved
  void load(int lane, const std::array<double, 3>& grip_m);

  /// Looks at the state at the start of a step, which stands in the axes predicted for t + theta dt, and at where
  /// the product would be there without contact forces.
  void see_start(const FrameLanes& frame, const StateRows& state, const LaneArray& base, const CarrierMotion& now,
                 const CarrierMotion& theta);
  /// Looks at what the step has come to at t + theta dt.
  void see_theta(const FrameLanes& frame, const LaneArray& u_theta);
  /// Looks at a state in the frame that fits it through the eyes of the cell, at every contact node.
  void see_from_cell(const FrameLanes& frame, const LaneArray& u, const CarrierMotion& there);
  /// Looks at a state in the frame that fits it.
  void see_end(const FrameLanes& frame, const LaneArray& u, const CarrierMotion& there);

  [[nodiscard]] const SeenMotion& from(std::size_t carrier) const { return seen_[carrier]; }
  /// At t + theta dt.
  [[nodiscard]] const CarrierAxes& axes(std::size_t carrier) const { return axes_theta_[carrier]; }
  /// Place of a contact node at rest, from the centre of mass.
  [[nodiscard]] LaneVector rest_place_m(const FrameLanes& frame, std::size_t contact_node) const {
    return to_lanes(frame.rest_place_m(static_cast<std::size_t>(model_.node[contact_node])));
  }

 private:
  std::array<CarrierAxes, kCarrierCount> axes_of(const FrameLanes& frame, const CarrierMotion& there) const;
  void see_base(const FrameLanes& frame, const LaneArray& base);
  void see_rates(const FrameLanes& frame, const StateRows& state, const CarrierMotion& now,
                 const std::array<CarrierAxes, kCarrierCount>& axes);

  const ContactModel& model_;
  /// Contact nodes that meet a surface of each carrier with a side; places are seen by themselves.
  std::array<std::vector<std::size_t>, kCarrierCount> side_node_;
  std::array<double, 3> center_of_mass_m_;
  LaneVector lever_;  ///< from the centre of the pads to the centre of mass at rest
  std::array<SeenMotion, kCarrierCount> seen_;
  std::array<CarrierAxes, kCarrierCount> axes_theta_;
};

}  // namespace unbruised

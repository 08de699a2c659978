#pragma once

/// @file
/// The contact state register and the contact solve, all lanes at once (docs/theory.md, "Contact").
///
/// Every contact has a compliant layer. At t + theta dt, with penetration p and relative place r in the plane:
///   normal     N = sum_q k_q (d_q + clamp(tau p', -d_q, d_q)), d_q = p - relief_q > 0: the layer can only push
///   tangential T = -k_t (r - anchor), |T| <= mu N       the anchor is set where the contact closes and moves only
///   when it slips
/// and u = u_free + W J' (N, T). The register's closed contacts decide the equations; the factor never changes.

#include <array>
#include <vector>

#include "core/contact/contact_event.hpp"
#include "core/contact/contact_model.hpp"
#include "core/contact/static_rest.hpp"
#include "core/gripper/finger_lanes.hpp"
#include "core/integration/wilson_theta.hpp"
#include "core/lanes/lane.hpp"
#include "core/surface/carrier_motion.hpp"

namespace unbruised {

/// Resultants of one surface at the end of a step, per lane.
struct SurfaceTally {
  Lane normal{0.0};
  std::array<Lane, 2> tangent{Lane(0.0), Lane(0.0)};  ///< along tangent_axes(surface), on the product
  Lane closed{0.0};                                   ///< contacts that carry force
  Lane sliding{0.0};                                  ///< of these, at the friction cone
  Lane travel{0.0};                                   ///< net way of the anchors, summed over closed contacts
  std::array<Lane, 2> first{Lane(0.0), Lane(0.0)};    ///< moments of the normal force over the plane
  std::array<Lane, 3> second{Lane(0.0), Lane(0.0), Lane(0.0)};
  std::array<Lane, 3> torque{Lane(0.0), Lane(0.0), Lane(0.0)};  ///< about the palm centre, on the product
};

class ContactLanes {
 public:
  ContactLanes(const ContactModel& model, double smallest_extent_m);

  /// Opens all contacts of a lane and sets its layers, pads and friction.
  void load(int lane, const Scenario& scenario, const std::array<double, 3>& product_center_m);
  /// Puts the contacts of a product at rest on its support into a lane.
  void set_rest(int lane, const StaticRest& rest);
  void set_anchor_to_place(int lane, const LaneArray& u);
  /// Forgets the anchors' travel so far (start of the lift).
  void reset_travel(int lane);

  /// State of the product and pads at the start of the step, before the contact solve.
  /// @param base displacement at t + theta dt without contact forces, rows 3 x contact node + axis
  void begin_step(const WilsonTheta& wilson, const LaneArray& u, const LaneArray& v, const LaneArray& a,
                  const CarrierMotion& now, const CarrierMotion& theta, const FingerLanes& fingers,
                  const LaneArray& base, const Mask& running);
  /// Did begin_step find anything near a surface?
  [[nodiscard]] bool idle() const { return active_node_.empty(); }

  /// The displacement without contact forces has changed in `lanes` (plastic iteration); solve again from the
  /// present forces.
  void rebase(const LaneArray& base, const Mask& lanes);

  /// Projected Gauss-Seidel to convergence in every lane of `solving`; lanes stop one by one.
  /// @return sweeps taken per lane
  Lane solve(const FingerLanes& fingers, const Mask& solving);

  /// Lanes in which the last `solve` ended without contact forces that can be used.
  [[nodiscard]] const Mask& unsolved() const { return unsolved_; }

  /// Contact forces at t + theta dt on the freedoms of the contact nodes, rows 3 x contact node + axis.
  [[nodiscard]] const LaneArray& node_force() const { return node_force_; }
  [[nodiscard]] const std::vector<int>& active_nodes() const { return active_node_; }
  /// Sum of the normal forces of each pad at t + theta dt.
  [[nodiscard]] const std::array<Lane, 2>& pad_force_theta() const { return pad_force_; }

  /// Moves forces, anchors and register to t + dt and tallies them.
  /// @param u_theta, u displacement at t + theta dt and at t + dt
  /// @param position_m rest positions
  void end_step(const WilsonTheta& wilson, const LaneArray& u_theta, const LaneArray& u,
                const std::vector<std::array<double, 3>>& position_m, const CarrierMotion& next,
                const Mask& running);

  [[nodiscard]] const std::array<SurfaceTally, kSurfaceCount>& tally() const { return tally_; }
  /// Largest pressure over a patch of fixed size in this step, per lane.
  [[nodiscard]] const Lane& patch_pressure() const { return patch_pressure_; }
  /// Fraction of theta dt after the start of the step at which the first pad contact of the step closed; > 1:
  /// none.
  [[nodiscard]] const Lane& first_touch() const { return first_touch_; }
  /// Dissipated by sliding and in viscous layers since load, [J].
  [[nodiscard]] const Lane& dissipated() const { return dissipated_; }
  /// Stored in the layers, [J].
  [[nodiscard]] Lane stored_energy() const;
  /// Mean pressure of a pad's patch / mean pressure at first yield, from the present tally.
  [[nodiscard]] Lane yield_ratio(int pad, const Lane& yield_stress) const;
  /// Forces of one lane per surface, for traces: normal and tangents, on the product along x, y, z.
  [[nodiscard]] std::array<double, 3> surface_force(int surface, int lane) const;

  /// Force of one surface on the product along an axis.
  [[nodiscard]] Lane force_along(int surface, std::size_t axis) const;

  /// Appends the register's changes of the last step in `lane`.
  void record_events(int lane, double step_start_s, const WilsonTheta& wilson,
                     std::vector<ContactEvent>& events) const;

 private:
  void choose_active(const Mask& running);
  [[nodiscard]] Lane surface_place(int surface, const CarrierMotion& carriers,
                                   const std::array<Lane, 2>& way) const;
  /// Of the layer at rest at this penetration.
  [[nodiscard]] Lane elastic_force(std::size_t candidate, const Lane& penetration) const;
  [[nodiscard]] Lane layer_stiffness(std::size_t candidate) const;
  [[nodiscard]] Lane normal_stiffness(std::size_t candidate) const;
  [[nodiscard]] Lane lattice_patch_area(int pad) const;
  [[nodiscard]] Lane patch_area(int pad) const;
  void tally_moments(std::size_t candidate, const Lane& normal, SurfaceTally& tally) const;
  void update_candidate(std::size_t c, const FingerLanes& fingers, const Mask& solving, bool careful,
                        std::array<Lane, 3>& d, const double* own, Lane& largest_change, Lane& largest_force);

  const ContactModel& model_;
  Lane near_margin_;

  // Per lane, set by load.
  std::array<Lane, kSurfaceCount> friction_, stiffness_, relaxation_;  ///< layer stiffness per area
  std::array<Lane, 2> pad_size_, pad_center_;                          ///< along y and z
  std::array<Lane, kSurfaceCount> rest_place_;                         ///< of the surfaces along their normal axes
  std::array<Mask, kSurfaceCount> present_;

  // Per candidate, kept from step to step.
  LaneArray normal_, tangent1_, tangent2_;                    ///< forces at the start of the step
  LaneArray normal_theta_, tangent1_theta_, tangent2_theta_;  ///< at t + theta dt
  LaneArray penetration_, penetration_theta_;                 ///< of the particle's place; meaningful while closed
  LaneArray viscous_;  ///< viscous part of normal_; 0 where the layer has none
  LaneArray anchor1_, anchor2_, travel1_, travel2_;
  LaneArray share_;  ///< of the tributary area under the pad
  // Per candidate, of the present step.
  LaneArray near_, offset_, gap_now_, gap_free_, previous_, sliding_, was_sliding_;
  LaneArray layer_, shear_, shear_relaxed_;  ///< stiffnesses of the near ones; 1 / (1 + shear x compliance)
  // Of the present step.
  LaneArray base_, node_force_;
  Mask has_near_{false};  ///< some candidate is near
  std::vector<int> active_node_;
  std::vector<int> live_candidate_;  ///< near or carrying force in any lane
  Mask unsolved_{false};
  std::array<Lane, 2> pad_force_{Lane(0.0), Lane(0.0)};
  CarrierMotion theta_;
  Lane a1_tau_factor_[kSurfaceCount] = {1.0, 1.0, 1.0};  ///< 1 + tau a1

  std::array<SurfaceTally, kSurfaceCount> tally_;
  Lane patch_pressure_{0.0}, first_touch_{2.0}, dissipated_{0.0};
};

}  // namespace unbruised

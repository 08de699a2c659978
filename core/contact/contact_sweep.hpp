#pragma once

/// @file
/// The contact solve: projected Gauss-Seidel over the candidates near a surface, all lanes at once
/// (docs/theory.md, "Contact").

#include <array>
#include <vector>

#include "core/contact/contact_register.hpp"
#include "core/contact/seen_nodes.hpp"
#include "core/gripper/gripper_lanes.hpp"

namespace unbruised {

class ContactSweep {
 public:
  /// All have to outlive the sweep.
  ContactSweep(const ContactModel& model, const SurfaceLanes& surfaces, ContactRegister& contacts);

  /// Starts a step: the layers of this step, without forces.
  /// @param theta where the carriers are at t + theta dt
  /// @param seen, frame of a product that turns; else null
  void begin_step(const WilsonTheta& wilson, const CarrierMotion& theta, const SeenNodes* seen = nullptr,
                  const FrameLanes* frame = nullptr);
  /// Takes in what a candidate's layer is this step.
  /// @param viscous relaxation time x (a1 p + 2 p' + a3 p'') at the start of the step [m]
  void prepare(std::size_t candidate, const Lane& viscous);
  /// Lists the nodes with something near, once every candidate's `near` is known.
  void list_active(const Mask& running);

  /// Starts from the present forces over a displacement without contact forces, rows 3 x contact node + axis.
  void rebase(const LaneArray& base, const Mask& lanes);
  /// Solves every lane of `solving` to convergence; lanes stop one by one.
  /// @return sweeps taken per lane
  Lane solve(const GripperLanes& gripper, const Mask& solving);
  /// Lanes in which the last `solve` ended without contact forces that can be used.
  [[nodiscard]] const Mask& unsolved() const { return unsolved_; }

  /// Contact forces at t + theta dt on the freedoms of the contact nodes, rows 3 x contact node + axis.
  [[nodiscard]] const LaneArray& node_force() const { return node_force_; }
  /// Contact nodes with something near a surface in any lane.
  [[nodiscard]] const std::vector<int>& active_nodes() const { return active_node_; }
  /// Candidates that are near or carry force in any lane.
  [[nodiscard]] const std::vector<int>& live_candidates() const { return live_candidate_; }
  /// Sum of the normal forces of each pad at t + theta dt.
  [[nodiscard]] const PadForces& pad_force() const { return pad_force_; }

 private:
  /// How a layer's law is followed down.
  enum class Slope {
    tangent,   ///< Newton; the law's kinks can make it go round in circles
    steepest,  ///< cannot overshoot
  };
  /// One pass over all active nodes.
  struct Pass {
    Mask solving;
    Slope slope;
    Lane largest_change{0.0}, largest_force{0.0};
  };
  struct Node;
  struct TurnedNode;
  void update_candidate(std::size_t candidate, const GripperLanes& gripper, Pass& pass, Node& node);
  template <class AnyNode>
  void update_forces(std::size_t candidate, const GripperLanes& gripper, const Mask& active, Pass& pass,
                     AnyNode& node);
  template <class AnyNode>
  Lane update_normal(std::size_t candidate, const GripperLanes& gripper, const Mask& active, Slope slope,
                     AnyNode& node);
  template <class AnyNode>
  Lane update_tangent(std::size_t candidate, const Mask& active, AnyNode& node);
  void prepare_turned(std::size_t candidate);
  [[nodiscard]] const CarrierAxes& axes_of(std::size_t candidate) const {
    return seen_->axes(carrier_number(model_.candidate[candidate].surface));
  }

  const ContactModel& model_;
  const SurfaceLanes& surfaces_;
  ContactRegister& contacts_;

  // Of the present step.
  CarrierMotion theta_;
  const SeenNodes* seen_ = nullptr;
  const FrameLanes* frame_ = nullptr;
  LaneArray
      own_;  ///< 9 per candidate: its node's own block of the compliance in the axes of its surface's carrier
  std::array<Lane, kSurfaceCount> rate_slope_;  ///< d rate / d penetration of viscous layers: tau a1
  LaneArray viscous_;                           ///< per candidate, as of `prepare`
  LaneArray layer_, shear_, shear_relaxed_;     ///< stiffnesses of the near ones; 1 / (1 + shear x compliance)
  LaneArray base_, node_force_;
  std::vector<int> active_node_, live_candidate_;
  Mask has_near_{false};  ///< some candidate is near
  Mask unsolved_{false};
  PadForces pad_force_ = without_force();
};

}  // namespace unbruised

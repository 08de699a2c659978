#pragma once

/// @file
/// The contact solve: projected Gauss-Seidel over the candidates near a surface, all lanes at once
/// (docs/theory.md, "Contact").

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "core/body/held_forces.hpp"
#include "core/contact/contact_register.hpp"
#include "core/contact/layer_law.hpp"
#include "core/contact/lever_sums.hpp"
#include "core/contact/mounted_contacts.hpp"
#include "core/contact/pad_contacts.hpp"
#include "core/contact/patch_modes.hpp"
#include "core/contact/seen_nodes.hpp"
#include "core/contact/seen_places.hpp"
#include "core/contact/shaped_pads.hpp"
#include "core/contact/stuck_patches.hpp"
#include "core/gripper/gripper_lanes.hpp"
#include "core/lanes/lane_archive.hpp"

namespace unbruised {

/// How the product moves until t + theta dt without contact forces but those that are held.
struct FreeMotion {
  const LaneArray& displacement;  ///< rows 3 x contact node + axis
  LaneVector moment_N_m;          ///< by which it turns; of products that touch with places
  HeldForces held = {};           ///< on contact nodes
};

/// Through which eyes a product that turns is seen.
struct Eyes {
  const FrameLanes* frame = nullptr;  ///< null: the product is upright, and nobody has to look
  const SeenNodes* nodes = nullptr;
  const SeenPlaces* places = nullptr;
};

class ContactSweep {
 public:
  /// All have to outlive the sweep.
  /// @param shaped null: the pads are planes
  ContactSweep(const ContactModel& model, const SurfaceLanes& surfaces, ContactRegister& contacts,
               const ShapedPads* shaped = nullptr);

  /// A lane begins anew.
  void forget_effort(int lane) { effort_.clear_lane(lane); }
  /// A lane takes steps of another length from now on: in the first there is much to find.
  void expect_effort(int lane) {
    effort_.clear_lane(lane);
    effort_.slow.set(lane, 1.0);
    effort_.pressed.set(lane, Effort::kUnknown);
  }
  /// All that a lane keeps from step to step.
  void archive(LaneArchive& lane) { effort_.archive(lane); }
  /// Starts a step: the layers of this step, without forces.
  /// @param theta where the carriers are at t + theta dt @param mounted null: no surface is on a mount
  /// @param pads null: they are layers; all have to outlive the step
  void begin_step(const WilsonTheta& wilson, const CarrierMotion& theta, const Eyes& eyes,
                  MountedContacts* mounted, PadContacts* pads = nullptr);
  /// Takes in what a candidate's layer is this step.
  /// @param viscous relaxation time x (a1 p + 2 p' + a3 p'') at the start of the step [m]
  void prepare(std::size_t candidate, const Lane& viscous);
  /// Lists the nodes with something near, once every candidate's `near` is known.
  /// @param awake candidates that may be near or carry force, ascending
  void list_active(const Mask& running, std::span<const int> awake);

  /// Starts from the present forces over a motion without them, or with those that are held.
  void rebase(const FreeMotion& free, const Mask& lanes);
  /// Solves every lane of `solving` to convergence; lanes stop one by one.
  /// @return sweeps taken per lane
  Lane solve(const GripperLanes& gripper, const Mask& solving);
  /// Lanes in which the last `solve` ended without contact forces that can be used.
  [[nodiscard]] const Mask& unsolved() const { return unsolved_; }

  /// Contact forces at t + theta dt on the freedoms of the contact nodes, rows 3 x contact node + axis; after
  /// `solve`.
  [[nodiscard]] const LaneArray& node_force() const { return node_force_; }
  /// How these forces turn the body as a whole.
  [[nodiscard]] const LeverSums& levers() const { return levers_; }
  /// Force of a candidate at t + theta dt in the axes of the product's frame.
  [[nodiscard]] LaneVector force_in_frame(std::size_t candidate) const;
  /// Relaxation time x rate of the penetration of a near candidate at t + theta dt [m].
  [[nodiscard]] Lane viscous_depth(std::size_t candidate) const {
    return rate_slope_[model_.candidate[candidate].surface] * contacts_.penetration_theta.get(candidate) -
           viscous_.get(candidate);
  }
  /// Contact nodes with something near a surface in any lane.
  [[nodiscard]] const std::vector<int>& active_nodes() const { return active_node_; }
  /// Candidates that are near or carry force in any lane.
  [[nodiscard]] const std::vector<int>& live_candidates() const { return live_candidate_; }
  /// Where a shaped pad stands along its normal axis at t + theta dt, as of the last `solve`.
  [[nodiscard]] const Lane& pad_place_m(int pad) const { return pad_place_[static_cast<std::size_t>(pad)]; }
  /// Sum of the forces against the closing of each pad at t + theta dt.
  [[nodiscard]] const PadForces& pad_force() const { return pad_force_; }

 private:
  /// How a layer's law is followed down.
  enum class Slope {
    tangent,   ///< Newton; the law's kinks can make it go round in circles
    steepest,  ///< cannot overshoot; of a contact that lies below its layer the root itself
  };
  /// One pass over all active nodes.
  struct Pass {
    Mask solving;
    Slope slope;
    Lane largest_change{0.0}, largest_force{0.0};
  };
  struct Node;
  struct TurnedNode;
  struct OwnForces;
  struct FixedSurfaces;
  struct DeflatedSurfaces;
  struct MountedSurfaces;
  struct PaddedSurfaces;
  /// The near candidates of an active node.
  [[nodiscard]] std::span<const int> near_of(std::size_t active) const {
    return std::span(near_candidate_).subspan(first_near_[active], first_near_[active + 1] - first_near_[active]);
  }
  /// Changes are measured against at least this force [N].
  static constexpr double kLeastForce = 1e-6;
  /// Nodes whose displacements are summed up in one pass over the forces: neighbours by number, so that a lane's
  /// arithmetic does not depend on what is active in others.
  static constexpr int kGroup = 4;
  /// Past the last active node of the group of `first`.
  [[nodiscard]] std::size_t end_of_group(std::size_t first) const;
  /// Active nodes of one group: their rows of the compliance, and where the present forces bring them.
  struct Group {
    std::array<const double*, kGroup> row;
    std::array<std::array<Lane, 3>, kGroup> d;
  };
  [[nodiscard]] Group look_at_group(std::size_t first, std::size_t end, const BusyPacks& lanes) const;
  void take_left_forces_off(const Mask& lanes);
  void count_held(const Mask& lanes);
  template <class Mounting>
  void update_node(std::size_t active, const GripperLanes& gripper, Pass& pass, Node& node);
  template <class Mounting>
  void update_group(std::size_t first, std::size_t end, const GripperLanes& gripper, Pass& pass);
  /// Until no more than `most` sweeps are taken; those who would need more are `swept_out_` then.
  template <class Mounting>
  Lane solve_with(const GripperLanes& gripper, const Mask& solving, const Lane& most);
  Lane solve_upright(const GripperLanes& gripper, const Mask& solving);
  template <class Mounting>
  void update_candidate(std::size_t candidate, const GripperLanes& gripper, Pass& pass, Node& node);
  template <class Mounting, class AnyNode>
  void update_forces(std::size_t candidate, const GripperLanes& gripper, const Mask& active, Pass& pass,
                     AnyNode& node);
  template <class Mounting>
  void update_shaped(std::size_t candidate, const GripperLanes& gripper, const Mask& active, Pass& pass,
                     TurnedNode& node);
  /// Force of a layer that stands at `unloaded_m` without it, in `lanes`: the root, where one step is not enough.
  [[nodiscard]] Lane force_by_law(std::size_t candidate, const Lane& unloaded_m, const Lane& compliance,
                                  const Mask& lanes) const;
  Lane press(std::size_t candidate, const Lane& gap, const Lane& compliance, const Mask& active, Slope slope);
  std::array<Lane, 2> drag(std::size_t candidate, const std::array<Lane, 2>& r, const Lane& relaxed,
                           const Mask& active);
  void note(std::size_t candidate, const Mask& active, const Lane& change, const Lane& change_across,
            Pass& pass) const;
  template <class Mounting, class AnyNode>
  Lane update_normal(std::size_t candidate, const GripperLanes& gripper, const Mask& active, Slope slope,
                     AnyNode& node, Mounting& mounting);
  template <class Mounting, class AnyNode>
  Lane update_tangent(std::size_t candidate, const Mask& active, AnyNode& node, Mounting& mounting);
  void prepare_turned(std::size_t candidate);
  // Of lanes in which all sticks: stuck_sweep.cpp.
  using SurfacePlaces = std::array<Lane, kFirstCellSurface>;  ///< along the normal axes [m]
  [[nodiscard]] Mask is_stuck(const Mask& lanes, Lane& pressed) const;
  Lane answer_stuck(const GripperLanes& gripper, const Mask& lanes);
  Mask find_lacks(const GripperLanes& gripper, const Mask& lanes);
  Mask find_lack(std::size_t candidate, const SurfacePlaces& place, const std::array<Lane, 3>& d);
  void change_stuck(std::size_t candidate, const Mask& lanes);
  // Of lanes whose patches answer as wholes: deflated_sweep.cpp.
  [[nodiscard]] bool may_deflate() const;
  void before_deflated(int sweep, const GripperLanes& gripper, const Mask& solving);
  void begin_modes(const GripperLanes& gripper, const Mask& lanes);
  void make_room_for_layers();
  [[nodiscard]] SurfacePlaces places_under(const PadForces& pad_force, const GripperLanes& gripper) const;
  [[nodiscard]] static PatchModes::Fingers finger_give(const GripperLanes& gripper, const PadForces& now);
  void prepare_modes(const GripperLanes& gripper, const Mask& lanes);
  void change_members(const Mask& solving, bool may_join, const GripperLanes& gripper);
  void set_member(std::size_t candidate, const Mask& member);
  [[nodiscard]] Mask is_pressed(std::size_t candidate) const;
  void note_law(std::size_t candidate, const Lane& at_m, const LayerLaw& law, const Mask& lanes);
  void step_modes(const GripperLanes& gripper, const Mask& lanes);
  void fold_modes();
  /// With what the modes add.
  [[nodiscard, gnu::always_inline]] Lane whole_force(std::size_t candidate, std::size_t of) const {
    return own_force_.get(PatchModes::kForces * candidate + of) + modes_->force(candidate, of);
  }
  [[nodiscard]] PadForces whole_pad_force() const;
  /// What of a candidate's force acts against the closing of its pad.
  [[nodiscard]] Lane closing_force(std::size_t candidate) const;
  /// Force of a candidate on the product at t + theta dt along the axes of its surface's carrier.
  [[nodiscard]] LaneVector force_on_carrier(std::size_t candidate) const;
  [[nodiscard]] const CarrierAxes& axes_of(const ContactCandidate& candidate) const {
    return candidate.place < 0 ? eyes_.nodes->axes(carrier_number(candidate.surface))
                               : eyes_.places->axes(candidate.surface);
  }
  [[nodiscard]] LaneVector arm_of(const ContactCandidate& candidate) const {
    return candidate.place < 0 ? LaneVector{}
                               : to_lanes(model_.place[static_cast<std::size_t>(candidate.place)].arm_m);
  }
  [[nodiscard]] LaneVector seen_displacement(const ContactCandidate& candidate, const LaneVector& u) const;
  [[nodiscard]] LaneVector rest_place_m(std::size_t contact_node) const {
    return eyes_.nodes->rest_place_m(*eyes_.frame, contact_node);
  }

  const ContactModel& model_;
  const SurfaceLanes& surfaces_;
  ContactRegister& contacts_;
  const ShapedPads* shaped_;

  // Of the present step.
  const CarrierMotion* theta_ = nullptr;
  Eyes eyes_;
  MountedContacts* mounted_ = nullptr;
  PadContacts* pads_ = nullptr;
  LeverSums levers_;
  LaneArray own_;  ///< 9 per candidate: compliance of its node or place in the axes of its surface's carrier
  std::array<Lane, kSurfaceCount> rate_slope_;  ///< d rate / d penetration of viscous layers: tau a1
  LaneArray viscous_;                           ///< per candidate, as of `prepare`
  LaneArray layer_, shear_, shear_relaxed_;     ///< stiffnesses of the near ones; 1 / (1 + shear x compliance)
  LaneArray base_;                              ///< where the nodes would be without the forces of node_force_
  LaneArray node_force_;  ///< while a solve goes on beside those that are held, on nodes with something near
  HeldForces held_;
  std::vector<int> left_node_;  ///< contact nodes that hold forces with nothing near in some lane
  LaneArray left_force_;        ///< these
  std::vector<int> active_node_, live_candidate_;
  std::vector<int> near_candidate_;      ///< those near in any lane, by node
  std::vector<std::size_t> first_near_;  ///< active node -> its first one; one more than active nodes
  std::vector<Mask> near_node_;          ///< of active nodes: lanes in which some candidate of it is near
  std::vector<Mask> shared_node_;        ///< and in which several are
  Mask has_near_{false};                 ///< some candidate is near
  Mask unsolved_{false};
  PadForces pad_force_ = without_force();
  PadForces pad_place_ = without_force();  ///< of shaped pads
  /// Which steps have been hard lately, per lane.
  struct Effort {
    Lane hard_steps{0.0};      ///< in a row
    Lane deflated_steps{0.0};  ///< to come, in which patches answer as wholes
    Lane span{0.0};            ///< so many were they when they began; 0: not of late
    Lane slow{0.0};            ///< 1: what sticks is to be found at once, where all does
    Lane plain{0.0};           ///< sweeps of the last step that went without that
    Lane pressed{0.0};         ///< contacts at the start of the last step, or kUnknown

    static constexpr double kUnknown = -1.0, kMostlyPlain = 30.0;
    void take_in(const Mask& lanes, const Mask& hard);
    void clear_lane(int lane) {
      for (Lane* value : {&hard_steps, &deflated_steps, &span, &slow, &pressed}) value->set(lane, 0.0);
      plain.set(lane, kMostlyPlain);
    }
    void archive(LaneArchive& lane) { lane(hard_steps, deflated_steps, span, slow, plain, pressed); }
  };
  Effort effort_;
  Mask swept_out_{false};       ///< lanes that the last solve_with left as they were
  bool deflating_ = false;      ///< in the present solve
  bool is_first_solve_ = true;  ///< of a step, which may take several
  std::optional<PatchModes> modes_;
  std::optional<StuckPatches> stuck_;
  LaneArray lacks_;  ///< of layers where all sticks, kForces rows a candidate [m]; then changes of forces [N]
  // Per candidate, while deflating; the first two kForces rows each.
  LaneArray own_force_, give_;  ///< without the modes; compliance of the layers where they stand
  LaneArray unpressed_;         ///< penetration at which the layer that stands so would press with no force
};

}  // namespace unbruised

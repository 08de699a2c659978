#pragma once

/// @file
/// Contact of all lanes at once: the register, the sweep that solves it and the tally of what it does
/// (docs/theory.md, "Contact").
///
/// Every contact has a compliant layer. At t + theta dt, with penetration p and relative place r in the plane:
///   normal     N = sum_q k_q (d_q + clamp(tau p', -d_q, d_q)), d_q = p - relief_q > 0: the layer can only push
///   tangential T = -k_t (r - anchor), |T| <= mu N       the anchor is set where the contact closes and moves only
///   when it slips
/// and u = u_free + W J' (N, T). The register's closed contacts decide the equations; the factor never changes.

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "core/body/body_motion.hpp"
#include "core/contact/contact_event.hpp"
#include "core/contact/contact_events.hpp"
#include "core/contact/contact_model.hpp"
#include "core/contact/contact_register.hpp"
#include "core/contact/contact_sweep.hpp"
#include "core/contact/layered_face.hpp"
#include "core/contact/mounted_contacts.hpp"
#include "core/contact/pad_contacts.hpp"
#include "core/contact/pad_slip.hpp"
#include "core/contact/place_windows.hpp"
#include "core/contact/seen_nodes.hpp"
#include "core/contact/seen_places.hpp"
#include "core/contact/shaped_pads.hpp"
#include "core/contact/static_rest.hpp"
#include "core/contact/surface_tally.hpp"
#include "core/contact/window_pressure.hpp"
#include "core/gripper/gripper_lanes.hpp"
#include "core/integration/wilson_theta.hpp"
#include "core/lanes/lane.hpp"
#include "core/scenario/product_frame.hpp"
#include "core/surface/surface_lanes.hpp"

namespace unbruised {

/// What a contact step starts from.
struct ContactStart {
  const LaneArray& u;
  const LaneArray& v;
  const LaneArray& a;
  FreeMotion free;  ///< to t + theta dt
  const CarrierMotion& now;
  const CarrierMotion& theta;
  const GripperLanes& gripper;
  const FrameLanes* frame =
      nullptr;  ///< the axes of all these where the product turns, predicted for t + theta dt
  const MountLanes* mount = nullptr;  ///< null: no surface of any lane is on one
  const PadLanes* pads = nullptr;     ///< null: they are layers
};

/// Where a contact step has ended.
struct ContactEnd {
  const LaneArray& u_theta;  ///< displacement at t + theta dt
  const LaneArray& u;        ///< at t + dt
  const CarrierMotion& theta;
  const CarrierMotion& next;
  const MountLanes* mount = nullptr;  ///< at t + dt
  const PadLanes* pads = nullptr;     ///< at t + dt
};

/// What the layers have dissipated since load, by cause [J].
struct LayerLosses {
  Lane friction{0.0};
  Lane viscous{0.0};
  Lane left{0.0};  ///< what they still held where an edge left them, or their surface was taken away
};

/// The step whose events are asked for, and the state at its end.
struct EventStep {
  double start_s, end_s;
  const BodyMotion& body;
  const CarrierMotion& now;
};

/// How a plane stands to a product.
struct FacedPlane {
  std::array<double, 3> normal;  ///< in the product's axes
  double place_m;                ///< along its normal
  double center_m;               ///< of the product's centre of mass above it
};

class ContactLanes {
 public:
  /// Model, body and time step have to outlive this.
  ContactLanes(const ContactModel& model, const BodyModel& body, const WilsonTheta& wilson,
               ProductFrame frame = ProductFrame::upright);
  ContactLanes(const ContactLanes&) = delete;
  ContactLanes& operator=(const ContactLanes&) = delete;

  /// Opens all contacts of a lane and sets its surfaces up.
  void load(int lane, const Scenario& scenario);
  /// All that a lane keeps from step to step, but for what `load` sets.
  void archive(LaneArchive& lane);
  void set_rest(int lane, const StaticRest& rest);
  /// Takes a surface away from the product of a lane; what its layer holds is lost.
  void leave(int surface, int lane);
  /// There is no support any more in a lane.
  void take_support_away(int lane) { surfaces_.remove(kSupport, lane); }
  /// @param frame in whose axes u is; null: it is upright
  void set_anchors(int lane, const LaneArray& u, const CarrierMotion& now, const FrameLanes* frame);
  /// Lets a lane's slip begin from here.
  void forget_slip(int lane);

  /// The coming step of a lane has another length than its last.
  void forget_trend(int lane) {
    register_.forget_trend(lane);
    sweep_.expect_effort(lane);
  }

  /// Finds what is near a surface and starts the solve from the forces of the last step.
  void begin_step(const ContactStart& start, const Mask& running);
  /// Did begin_step find anything near a surface?
  [[nodiscard]] bool idle() const { return sweep_.active_nodes().empty(); }
  /// The motion without contact forces has changed in `lanes` (plastic iteration); solve again from the present
  /// forces.
  void rebase(const FreeMotion& free, const Mask& lanes) { sweep_.rebase(free, lanes); }
  Lane solve(const GripperLanes& gripper, const Mask& solving) { return sweep_.solve(gripper, solving); }
  /// The solve of this step, and the forces it found.
  [[nodiscard]] const ContactSweep& sweep() const { return sweep_; }
  /// By how much more than their action on particles the contact forces turn the body as a whole; null: they do
  /// not.
  [[nodiscard]] const LaneVector* turn_by_arms() const {
    return places_ ? &sweep_.levers().turn_by_arms() : nullptr;
  }
  /// Of the contacts at t + theta dt on the mounts.
  [[nodiscard]] LaneSix mount_wrench() const { return mounted_now_ ? mounted_.wrench() : LaneSix{}; }
  /// Of the contacts at t + theta dt on a pad that is a body, as PadLanes::advance takes them.
  [[nodiscard]] const LaneArray* pad_face_force(int pad) { return pads_->face_force(pad); }
  /// Takes in where a product that turns has come at t + theta dt, while its frame is still the predicted one.
  void see_theta(const FrameLanes& frame, const LaneArray& u_theta);
  /// Adds what forces on places do by their arms.
  void add_arms(OuterForces& outer) const;
  /// Moves forces, anchors and register to t + dt and tallies them.
  /// @param frame of a product that turns, as it fits at t + dt
  void end_step(const ContactEnd& end, const FrameLanes* frame, const Mask& running);

  [[nodiscard]] const std::array<SurfaceTally, kSurfaceCount>& tally() const { return tally_; }
  /// Of the product past the pad of a finger since load, or since it was last forgotten.
  [[nodiscard]] const PadSlip& slip(std::size_t finger) const { return slip_[finger]; }
  /// Largest pressure over a patch of fixed size in this step, per lane.
  [[nodiscard]] const Lane& patch_pressure() const { return patch_pressure_; }
  /// Largest compression of a layer over its thickness in this step, per lane.
  [[nodiscard]] const Lane& layer_strain() const { return layer_strain_; }
  /// Lanes in which a place of the product has come behind a surface from beside it, in this step: a surface has
  /// no rim that could hold it.
  [[nodiscard]] const Mask& meets_rim() const { return meets_rim_; }
  /// Lowest place of the product along the normal of a surface, per lane [m].
  [[nodiscard]] Lane lowest_place_m(int surface, const LaneArray& u) const;
  /// Least gap of a surface whose candidates are a side's particles at the start of the last step, in one lane
  /// [m].
  [[nodiscard]] double least_gap_m(int surface, int lane) const;
  /// Fraction of theta dt after the start of the step at which the first pad contact of the step closed; > 1:
  /// none.
  [[nodiscard]] Lane first_touch() const;
  /// The same for the pad of one finger, and when the last of those of its contacts that opened in the step did.
  [[nodiscard]] const Lane& touched(std::size_t finger) const { return touched_[finger]; }
  [[nodiscard]] const Lane& left(std::size_t finger) const { return left_[finger]; }
  /// Dissipated by sliding and in viscous layers since load, [J].
  [[nodiscard]] const Lane& dissipated() const { return dissipated_; }
  /// The same by cause.
  [[nodiscard]] const LayerLosses& losses() const { return losses_; }
  /// Stored in the layers, [J].
  [[nodiscard]] Lane stored_energy() const;
  /// Mean pressure of a surface's patch / mean pressure at first yield, from the present tally.
  [[nodiscard]] Lane yield_ratio(int surface, const Lane& yield_stress) const;
  /// A surface without a rim that places may touch, as it stands to the product of one lane at the end of a step;
  /// nothing where it is none. @param now where the carriers are
  [[nodiscard]] std::optional<FacedPlane> faced_plane(int surface, int lane, const CarrierMotion& now) const;
  /// Of the face that meets a surface in one lane.
  [[nodiscard]] const PatchForm& patch_form(int surface, int lane) const;
  /// Force of one surface on the product along the axes of its carrier: the cell or, of a pad, the palm.
  [[nodiscard]] LaneVector carrier_force(int surface) const;
  /// The same in one lane.
  [[nodiscard]] std::array<double, 3> surface_force(int surface, int lane) const;

  // For those who record a lane; nobody else pays for it.

  /// Notes the register's changes in a lane from now on, beginning with the contacts that it holds.
  void note_events(int lane);
  [[nodiscard]] bool notes_events(int lane) const { return events_.lanes()[lane]; }
  /// Another step begins: what was noted of the last one has been read.
  void forget_events() { events_.forget(); }
  /// Appends the changes of the last step in `lane` in the order of time.
  void append_events(int lane, const EventStep& step, std::vector<ContactEvent>& events) const;
  /// How hard a candidate is pressed in one lane [N].
  [[nodiscard]] double normal_N(std::size_t candidate, int lane) const {
    return register_.normal.at(candidate, lane);
  }
  /// Torque of each surface on the product about its centre of mass, along x, y, z, in one lane: that of its
  /// forces where they act on the product's particles and places.
  [[nodiscard]] std::array<std::array<double, 3>, kSurfaceCount> surface_torques(int lane, const BodyMotion& body,
                                                                                 const CarrierMotion& now) const;

 private:
  /// How one candidate went through a step.
  struct CandidateStep {
    Mask closed, sliding;                  ///< at t + theta dt, in running lanes
    std::array<Lane, 3> before, after;     ///< normal, tangents at t and t + dt
    std::array<Lane, 2> moved;             ///< of the anchor
    Lane penetration_before, penetration;  ///< at t and t + dt
  };
  /// A step as each carrier sees it.
  using Starts = std::array<ContactStart, kCarrierCount>;
  using Ends = std::array<ContactEnd, kCarrierCount>;
  /// The places of a node that may touch one surface.
  struct PlaceGroup {
    std::size_t node = 0;  ///< contact node
    int surface = 0;
    int first = 0, end = 0;  ///< candidates
    int awake = 0;           ///< how many of them
  };
  /// How a surface stands to the product in the present step, at t + theta dt.
  struct FacingPlane {
    LaneVector normal;     ///< in the axes of the frame
    Lane center_m{0.0};    ///< of the product's centre of mass above it
    Lane turned_rad{0.0};  ///< at most by so much from where the arms were looked at
  };
  void load_seen(int lane);
  void group_candidates();
  void wake_all();
  void list_awake();
  Starts seen_start(const ContactStart& start);
  Ends seen_end(const ContactEnd& end, const FrameLanes* frame);
  /// Where a candidate stands before its surface, at the start of a step and without contact forces at t + theta
  /// dt.
  struct Meeting {
    Lane gap_now, gap_free;
    Lane rate, second_rate;  ///< of the penetration
  };
  void see_facing(const FrameLanes& frame, const CarrierMotion& there);
  [[nodiscard]] std::array<Lane, 2> place_on_face(const ContactCandidate& candidate) const;
  void meet_side(std::size_t candidate, const ContactStart& start, const Mask& running);
  void meet_shaped(std::size_t candidate, const ContactStart& start, const Mask& running);
  void look_again(std::size_t candidate, const LaneVector& here, const Mask& may);
  [[nodiscard]] LaneVector shaped_place_theta(std::size_t candidate, const ContactEnd& end) const;
  [[nodiscard]] std::array<Lane, 3> of_carrier(std::size_t candidate, const std::array<Lane, 3>& force) const;
  [[nodiscard]] std::array<double, 3> of_carrier(std::size_t candidate, int lane,
                                                 const std::array<double, 3>& force_N) const;
  void meet_place(std::size_t candidate, const ContactStart& start, const Mask& running);
  void meet_places(const ContactStart& start, const Mask& running);
  void meet_group(PlaceGroup& group, bool all_far, const ContactStart& start, const Mask& running);
  FacingPlane facing_plane(int surface);
  void find_lowest_arms(int surface);
  [[nodiscard]] bool is_far(std::size_t candidate, const ContactStart& start) const;
  void take_in(std::size_t candidate, const Meeting& meeting, const Mask& meets, const Mask& running);
  void begin_mounts(const MountLanes* mount);
  [[nodiscard]] Lane sway_m(const MountLanes& mount) const;
  /// A place that comes this near to a surface is looked at closely.
  [[nodiscard]] Lane near_m(int surface) const {
    return surface == kSupport ? near_margin_ + sway_m_ : near_margin_;
  }
  void go_with_mount(std::size_t candidate, const LaneVector& at_m, const MountLanes& mount, Meeting& meeting);
  [[nodiscard]] Mask may_meet(std::size_t candidate, const Meeting& meeting, const Mask& running) const;
  void cover_again(std::size_t candidate, const ContactStart& start, const Mask& lanes);
  [[nodiscard]] std::array<CoveredPiece, 2> covered_place(const ContactCandidate& candidate,
                                                          const LaneVector& displacement,
                                                          const CarrierMotion& now) const;
  Mask comes_from_beside(std::size_t candidate, const Meeting& meeting, const std::array<CoveredPiece, 2>& piece);
  void set_cover(std::size_t candidate, const std::array<CoveredPiece, 2>& piece, const Mask& lanes);
  void carry_open_anchors(const Ends& ends, const Mask& running);
  void end_candidate(std::size_t candidate, const ContactEnd& end, const Mask& running);
  void advance_forces(std::size_t candidate, const Mask& running, CandidateStep& step);
  void advance_anchors(std::size_t candidate, const ContactEnd& end, CandidateStep& step);
  void advance_penetration(std::size_t candidate, const Mask& running, CandidateStep& step);
  void book_viscous(std::size_t candidate, const Mask& running, const CandidateStep& step);
  void tally_candidate(std::size_t candidate, const Mask& running, const CandidateStep& step);
  void tally_torque(std::size_t candidate, const ContactEnd& end, const Mask& running, const CandidateStep& step);
  void tally_place_torque(std::size_t candidate, const LaneVector& u, const Mask& running,
                          const CandidateStep& step);
  void note_touch(std::size_t candidate, const CandidateStep& step);
  void note_changes(std::size_t candidate, const CandidateStep& step);
  [[nodiscard]] ContactStep contact_step(std::size_t candidate, int lane, const CandidateStep& step) const;
  /// Where a contact of one lane is, on the particle or place that its force acts on.
  struct ContactPoint {
    std::array<double, 3> place_m, velocity_m_s;
  };
  [[nodiscard]] ContactPoint contact_point(std::size_t candidate, int lane, const BodyMotion& body) const;
  [[nodiscard]] std::array<double, 3> in_cell(int surface, int lane, const std::array<double, 3>& along_axes,
                                              const CarrierMotion& now) const;
  void note_layer_strain(std::size_t candidate, const CandidateStep& step);
  /// Contacts of a pad nearer together than this say nothing about an angle.
  [[nodiscard]] double least_turning_radius_m() const {
    const auto& extent_m = model_.cell_extent_m[static_cast<std::size_t>(normal_axis(kLeftPad))];
    return 0.1 * std::min(extent_m[0], extent_m[1]);
  }
  void measure_windows(int surface, const ContactEnd& end, const Mask& running);
  void measure_place_windows(int surface, const Mask& running);
  [[nodiscard]] Lane lowest_seen_place_m(int surface, const LaneArray& u) const;
  /// The side of the product that a surface meets.
  [[nodiscard]] std::size_t face_side(int surface, int lane) const;
  [[nodiscard]] const PatchForm& form_under(int surface, int lane) const {
    return shaped_ && is_pad(surface) ? shaped_form_[static_cast<std::size_t>(lane)]
                                      : model_.patch_form[face_side(surface, lane)];
  }
  /// Stiffness per area of a surface's layer under its present force; that of rubber follows the patch.
  [[nodiscard]] Lane layer_under_force_N_m3(int surface) const;

  const ContactModel& model_;
  const BodyModel& body_;
  const WilsonTheta& w_;
  Lane near_margin_;

  SurfaceLanes surfaces_;
  std::array<FaceLayer, kLanes> pad_layer_, support_layer_;
  ContactRegister register_;
  std::optional<ShapedPads> shaped_;       ///< where the pads are no planes
  std::array<LaneArray, 2> shaped_place_;  ///< of their candidates along the tangents, at the start of the step
  std::array<PatchForm, kLanes> shaped_form_;  ///< under the pads of each lane
  std::optional<SeenNodes> seen_;              ///< of a product that turns
  std::optional<SeenPlaces> places_;           ///< of one that may touch the cell anywhere
  /// Per candidate: a place that carries nothing, and has been far from its surface in every lane since it was
  /// last looked at closely.
  std::vector<char> asleep_;
  std::vector<int> side_candidate_;      ///< candidates that are no places
  std::vector<PlaceGroup> place_group_;  ///< of all others
  std::vector<int> awake_candidate_;     ///< all that do not sleep, as of the start of the step, ascending
  /// Per place group: n . arm of the lowest of its places, for the normals in the axes of the frame by which it
  /// was looked for.
  LaneArray lowest_arm_m_;
  std::array<LaneVector, kSurfaceCount> arms_faced_;
  MaskArray over_;         ///< candidates that have been over their rectangle when they last stood before it
  Mask meets_rim_{false};  ///< in this step
  LaneVector free_turn_;   ///< of the body as a whole until t + theta dt without contact forces
  std::array<LaneArray, 2> place_theta_;  ///< per candidate: displacement of its place at t + theta dt, tangential
  /// Of each surface: which side of the product faces it, across x or across z, else across y; the low one?
  std::array<std::array<Mask, 3>, kSurfaceCount> faces_;
  const LaneArray* ended_ = nullptr;   ///< displacement at the end of a step, as it is given
  const FrameLanes* frame_ = nullptr;  ///< of the present step
  /// The carriers as such a product's nodes see them, the palm standing still, at both times of a start or an end.
  std::array<CarrierMotion, 2> resting_;
  MountedContacts mounted_;
  std::optional<PadContacts> pads_;  ///< where these are bodies
  double reach_m_ = 0.0;             ///< of the farthest place from the centre of mass
  Lane sway_m_{0.0};                 ///< of the support on its mount, in the present step
  bool mounted_now_ = false;         ///< is any surface of any lane on a mount, in the present step?
  ContactSweep sweep_;
  std::vector<WindowPressure> window_;  ///< over each surface whose candidates are a side's particles
  PlaceWindows place_windows_;

  // Of the present step.
  std::array<AxisMotion, kSurfaceCount> motion_;  ///< of each surface along its normal axis, at t
  std::array<Lane, kSurfaceCount> place_free_;    ///< at t + theta dt, of fingers that nothing presses on

  std::array<SurfaceTally, kSurfaceCount> tally_;
  std::array<PadSlip, kMostFingers> slip_;
  Lane patch_pressure_{0.0}, layer_strain_{0.0}, dissipated_{0.0};
  PadForces touched_ = without_force(), left_ = without_force();  ///< fractions of theta dt; > 1, < 0: none
  LayerLosses losses_;
  ContactEvents events_;
};

}  // namespace unbruised

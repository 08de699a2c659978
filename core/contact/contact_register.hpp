#pragma once

/// @file
/// The contact state register: what is known of every candidate, all lanes at once. It remembers forces, anchors
/// and penetrations from step to step; the sweep finds those at t + theta dt, and the end of the step takes them
/// over.

#include <array>
#include <vector>

#include "core/contact/contact_model.hpp"
#include "core/contact/place_cover.hpp"
#include "core/contact/static_rest.hpp"
#include "core/lanes/lane.hpp"
#include "core/lanes/lane_archive.hpp"
#include "core/surface/surface_lanes.hpp"

namespace unbruised {

/// Stored in the layer of a contact [J].
struct LayerEnergy {
  Lane pressed{0.0}, sheared{0.0};
};

class ContactRegister {
 public:
  /// The model has to outlive the register.
  explicit ContactRegister(const ContactModel& model);

  /// Opens all contacts of a lane.
  void clear(int lane);
  /// All that a lane keeps from step to step.
  void archive(LaneArchive& lane);
  /// Takes all force from a contact of a lane.
  void open(std::size_t c, int lane);
  /// Puts the contacts of a product at rest on its support into a lane.
  void set_rest(int lane, const StaticRest& rest);
  /// Lets a lane's anchors stand where the particles are.
  void set_anchors(int lane, const LaneArray& u);

  /// Lets the coming solve start from where the forces at t + theta dt of the last two steps lead; where one of
  /// them was open from those of the last, and from none where the contact takes no part.
  void start_solve(std::size_t c, const Mask& takes_part, const Lane& friction);
  /// In the coming step of a lane the forces lead nowhere: it has another length than the last.
  void forget_trend(int lane) {
    for (LaneArray& rows : before_theta) rows.clear_lane(lane);
  }
  /// Does the contact carry force at t + theta dt?
  [[nodiscard]] Mask is_closed(std::size_t c) const { return normal_theta.get(c) > Lane(0.0); }

  /// Stiffness of the layer's springs over the part of the rectangle that the surface covers; a third of it in
  /// shear, of rubber too [N/m].
  [[nodiscard]] Lane layer_stiffness(std::size_t c, const SurfaceLane& surface) const;
  /// Stiffness along the normal, with the compliance of the body within a cell in series [N/m].
  [[nodiscard]] Lane normal_stiffness(std::size_t c, const SurfaceLane& surface) const;
  /// Of the body within the cell under this layer, per pressure [m/Pa].
  [[nodiscard]] Lane body_compliance(std::size_t c, const SurfaceLane& surface) const {
    const Lane within = acting_compliance_m_Pa(model_.candidate[c], surface.backing_N_m3);
    // Flat under flat, nothing is left to flatten.
    const bool flat = model_.is_shaped(c) && !model_.candidate[c].curved_face;
    return (flat ? surface.bent * within : within) + edge_compliance.get(c);
  }
  /// Force of the layer at rest at this penetration [N].
  [[nodiscard]] Lane elastic_force(std::size_t c, const SurfaceLane& surface, const Lane& penetration) const;
  /// The weights of its places.
  [[nodiscard]] PlaceCover cover(std::size_t c) const;
  /// How far the foremost of its places lies behind the one at the particle [m].
  [[nodiscard]] Lane least_relief(std::size_t c) const {
    return model_.is_shaped(c) ? foremost.get(c) : Lane(model_.candidate[c].least_relief_m);
  }
  /// Takes in what of a candidate's piece the surface covers, in `lanes`. @param wider area of the surface over
  /// that of its piece
  void set_cover(std::size_t c, const std::array<CoveredPiece, 2>& piece, const Mask& lanes,
                 const Lane& wider = Lane(1.0));
  /// Stored in one candidate's layer [J].
  [[nodiscard]] LayerEnergy stored_energy(std::size_t c, const SurfaceLane& surface) const;

  // Per candidate, kept from step to step.
  LaneArray normal;                  ///< force at the start of the step
  std::array<LaneArray, 2> tangent;  ///< along tangent_axes(surface)
  LaneArray normal_theta;            ///< at t + theta dt
  std::array<LaneArray, 2> tangent_theta;
  std::array<LaneArray, 3> before_theta;     ///< normal, tangents at the t + theta dt before that
  LaneArray penetration, penetration_theta;  ///< of the particle's place; meaningful while closed
  LaneArray viscous;                         ///< viscous part of `normal`; 0 where the layer has none
  std::array<LaneArray, 2> stretch;          ///< of the layer in shear: tangent / stiffness
  std::array<LaneArray, 2> anchor;
  // Of the part of its tributary piece that the surface covers.
  LaneArray share;                             ///< of its area
  LaneArray edge_compliance;                   ///< of the body beside an edge of the surface, per pressure [m/Pa]
  std::array<LaneArray, 2> mean, mean_square;  ///< offset from the particle along flat tangents
  std::array<LaneArray, 2> place_weight;       ///< along curved tangents, kReliefSide rows each
  std::vector<char> cut;                       ///< does an edge of the surface cut the places, in any lane?
  // Of those that meet a shaped pad, along its normal there.
  LaneArray relief;    ///< kReliefPlaces rows each
  LaneArray foremost;  ///< the least of them
  MaskArray sliding;
  // Per candidate, of the present step.
  MaskArray near;                     ///< takes part in the solve
  MaskArray was_closed, was_sliding;  ///< at the last step's t + theta dt
  LaneArray gap_now, gap_free;        ///< at the start of the step, and at t + theta dt as FreeMotion says

 private:
  const ContactModel& model_;
};

}  // namespace unbruised

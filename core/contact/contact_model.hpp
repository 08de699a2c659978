#pragma once

/// @file
/// What all scenarios of a factor key share about contact: which freedoms can touch which surface, and how far the
/// product yields there, W = J A^-1 J' (docs/theory.md, "Contact").

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/body/body_model.hpp"
#include "core/body/node_compliance.hpp"
#include "core/contact/pad_faces.hpp"
#include "core/contact/patch_form.hpp"
#include "core/contact/tributary.hpp"
#include "core/integration/wilson_theta.hpp"
#include "core/scenario/scenario.hpp"
#include "core/surface/surfaces.hpp"

namespace unbruised {

/// Places at which the true surface is sampled over a particle's tributary rectangle.
inline constexpr int kReliefPlaces = kReliefSide * kReliefSide;

/// One particle, or one place of the true surface that it carries, that may touch one surface.
struct ContactCandidate {
  int surface = 0;
  int node = 0;                                  ///< particle
  int contact_node = 0;                          ///< index into ContactModel::node
  double surface_m = 0;                          ///< coordinate of the true surface at rest, along the normal axis
  double area_m2 = 0;                            ///< tributary area of the true face, 0 for network particles
  double stiffness_N_m = 0;                      ///< of a network particle's own layer; 0: from the area
  std::array<Tributary, 2> tributary{};          ///< along the tangent axes of the surface
  bool flat = true;                              ///< no relief: the whole rectangle touches at once
  std::array<double, kReliefPlaces> relief_m{};  ///< how far the true surface lies behind the one at the particle
  double least_relief_m = 0;
  /// Compliance per pressure in series with a surface's stiff layer where the true surface is curved: such a layer
  /// would touch the highest place of a rectangle only, and the cell cannot flatten within itself.
  double cell_compliance_m_Pa = 0;
  /// Of a unit of softness beside an edge of the surface (tributary.hpp), along the tangents.
  std::array<double, 2> edge_compliance_m_Pa{};
  /// The true surface is curved; a shaped pad meets flat ones with the same compliance where it is.
  bool curved_face = false;
  /// Index into ContactModel::place; -1: the particle meets the surface with the side that faces it.
  int place = -1;
};

/// One place of the true surface, which turns with the product.
struct PlaceArm {
  std::array<double, 3> arm_m{};        ///< from the particle that carries it
  std::array<double, 3> from_mass_m{};  ///< from the centre of mass
  std::array<double, 3> outward{};
  std::array<double, 9> compliance{};  ///< of the place: how far it moves per force on it [m/N], row-major
};

/// Stiffness of a layer over that of a cell, k c, at which half of the cell's compliance acts. Calibrated on a
/// kiwi between soft pads, where k c is 0.5 to 1 (docs/validation.md); at a plate's 5 and more all but 2 % act.
inline constexpr double kHalfCompliance = 0.66;

/// What of a cell's compliance acts under a layer of this stiffness per area: a soft layer touches the whole
/// rectangle, and nothing is left to flatten.
template <class Number>
Number acting_compliance_m_Pa(const ContactCandidate& candidate, const Number& layer_stiffness_N_m3) {
  const Number compliance(candidate.cell_compliance_m_Pa);
  const Number ratio = layer_stiffness_N_m3 * compliance, square = ratio * ratio;
  return compliance * square / (square + Number(kHalfCompliance * kHalfCompliance));
}

/// Normal stiffness of a layer over the whole rectangle of a curved or flat contact, A / (1 / k + c) [N/m].
/// @param layer_stiffness_N_m3 of the surface's layer, per area
inline double normal_stiffness_N_m(const ContactCandidate& candidate, double layer_stiffness_N_m3) {
  return candidate.area_m2 /
         (1.0 / layer_stiffness_N_m3 + acting_compliance_m_Pa(candidate, layer_stiffness_N_m3));
}

/// The candidates of one surface as a grid over the face.
struct FaceGrid {
  std::array<std::vector<Tributary>, 2> piece;  ///< along the tangent axes of the surface, ascending
  std::vector<int> candidate;                   ///< at i * piece[1].size() + j; -1: there is none
  std::array<double, 2> low_m{}, high_m{};      ///< the true face reaches from, to
};

struct ContactModel {
  std::vector<ContactCandidate> candidate;  ///< by contact node, then surface
  std::vector<int> node;                    ///< contact node -> particle
  std::vector<int> first_candidate;         ///< contact node -> its first candidate; size node.size() + 1
  std::vector<double> compliance;           ///< 3x3 blocks, row-major, block (i, j) at 9 (i m + j) [m/N]
  std::vector<int> reach;                   ///< supernodes the contact freedoms touch
  SingleMatrix columns;                     ///< how all of the body answers (NodeCompliance::columns)
  std::vector<PlaceArm> place;              ///< of a product that meets the cell with more than its bottom
  /// Of the sides -x, +x, -y, +y, -z, +z.
  std::array<PatchForm, 6> patch_form;
  std::array<std::array<double, 2>, 3> cell_extent_m{};  ///< of a contact's cell on these, along the tangents
  std::array<double, kJawFingers> pole_m{};  ///< outermost place of the true surface along each pad's normal axis
  std::array<FaceGrid, kFirstCellSurface> face;  ///< of a lattice product; none where places meet the surface
  double patch_side_m = 0;                       ///< of the square over which pressure is averaged
  std::vector<int> surface = {kLeftPad, kRightPad, kSupport};  ///< all of them, in the order of traces
  bool shaped_pads = false;            ///< the pads are no planes: each candidate meets them in axes of its own
  std::vector<double> place_radius_m;  ///< farthest place of a contact node from it; 0 without places
  /// Angular motion of the body as a whole per moment, within a step [rad/(N m)], row-major.
  std::array<double, 9> turn_per_moment{};
  std::optional<PadFaces> pads;  ///< where these are bodies

  [[nodiscard]] std::size_t node_count() const { return node.size(); }
  [[nodiscard]] Touchable touchable() const { return {node, reach, compliance, &columns}; }
  /// Do places of the true surface meet this surface, and not particles?
  [[nodiscard]] bool has_places(int which) const { return !place.empty() && which >= kSupport; }
  /// Does a candidate meet a shaped pad?
  [[nodiscard]] bool is_shaped(std::size_t c) const { return shaped_pads && is_pad(candidate[c].surface); }
  /// Are the pads those of fingers that a gripper lists?
  [[nodiscard]] bool lists_fingers() const { return is_listed_pad(surface.front()); }
  /// Of a gripper's fingers; the pads come first.
  [[nodiscard]] std::size_t finger_count() const {
    return static_cast<std::size_t>(std::find(surface.begin(), surface.end(), kSupport) - surface.begin());
  }
  /// In traces and events.
  [[nodiscard]] int number_of(int which) const {
    return static_cast<int>(std::find(surface.begin(), surface.end(), which) - surface.begin());
  }
};

/// How much of a candidate's area faces a level support while the product stands as at the start.
inline double upright_share(const ContactModel& contact, const ContactCandidate& candidate) {
  if (candidate.place < 0) return 1.0;
  return std::max(0.0, -contact.place[static_cast<std::size_t>(candidate.place)].outward[2]);
}

/// In-plane offset of sample place `q` from the particle [m].
inline std::array<double, 2> place_offset_m(const ContactCandidate& candidate, int q) {
  return {candidate.tributary[0].offset_m(q % kReliefSide), candidate.tributary[1].offset_m(q / kReliefSide)};
}

/// What may touch what.
struct ContactChoice {
  ContactSet set = ContactSet::pads_and_support;
  std::vector<int> surface = {kLeftPad, kRightPad, kSupport};
  bool stands_on_bottom = true;
  double pressure_patch_m = 0.01;
  bool shaped_pads = false;
};
ContactChoice contact_choice(const Scenario& scenario);

/// Candidates of a lattice body against the surfaces.
ContactModel lattice_contact(const LatticeParameters& parameters, const Lattice& lattice,
                             const ContactChoice& choice);

/// Candidates of a network: the particles with a contact stiffness, against the support.
ContactModel network_contact(const NetworkParameters& parameters);

/// Its candidates, without their compliance.
/// @throws std::invalid_argument where that would be larger than kMostComplianceBytes
ContactModel contact_candidates(const Scenario& scenario, const BodyModel& body);

/// Tells candidates how the body answers to forces on them.
void give_compliance(NodeCompliance compliance, const BodyModel& body, const WilsonTheta& wilson,
                     ContactModel& contact);

/// The contact model of a factored body, with its compliance W and reach.
/// @throws std::invalid_argument where W would be larger than kMostComplianceBytes
ContactModel product_contact(const Scenario& scenario, const BodyModel& body, const WilsonTheta& wilson);

}  // namespace unbruised

#include "core/contact/contact_model.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "core/body/node_compliance.hpp"
#include "core/contact/compliance_size.hpp"
#include "core/contact/surface_places.hpp"
#include "core/contact/tributary_face.hpp"
#include "core/door/eigen.hpp"
#include "core/door/require.hpp"
#include "core/scenario/contact_set.hpp"
#include "core/scenario/pad_face.hpp"
#include "core/scenario/pad_meeting.hpp"
#include "core/scenario/true_shape.hpp"

namespace unbruised {
namespace {

/// Cell compliance x E / (1 - nu^2) / width of the rectangle. Calibrated: with it Hertz's force at a given
/// approach is met within 15 % from five cells per radius on, be it a particle or a cell that stands under the
/// pole (docs/validation.md); without it a stiff plate meets 1.4 to 1.7 times that force. It vanishes with the
/// cell size.
constexpr double kCellCompliance = 0.4;
/// Depth of places outside the body.
constexpr double kBeside_m = 1e3;

double cell_compliance_m_Pa(const LatticeParameters& parameters, double cell_m2) {
  return kCellCompliance * std::sqrt(cell_m2) / plane_strain_modulus_Pa(parameters);
}

/// Heights of the true surface around the particle; places outside the body never touch.
/// @param shaped it meets a shaped pad
void fill_relief(const LatticeParameters& parameters, const TrueShape& shape, const Lattice& lattice, bool shaped,
                 ContactCandidate& c) {
  const std::size_t side = facing_side(c.surface);
  const auto tangents = tangent_axes(c.surface);
  std::array<double, 3> place{};
  for (std::size_t t = 0; t < 2; ++t) {
    const auto along = static_cast<std::size_t>(tangents[t]);
    place[along] = c.tributary[t].place_m - lattice.center_m[along];
  }
  const double here = shape.column_m(side, place).value_or(-1.0);
  for (int q = 0; q < kReliefPlaces; ++q) {
    std::array<double, 3> there = place;
    const auto offset = place_offset_m(c, q);
    bool beside = false;
    for (std::size_t t = 0; t < 2; ++t) {
      const auto along = static_cast<std::size_t>(tangents[t]);
      there[along] += offset[t];
      beside = beside || (c.tributary[t].sampled && std::abs(there[along]) > 0.5 * parameters.size_m[along]);
    }
    const auto column = shape.column_m(side, there);
    c.relief_m[static_cast<std::size_t>(q)] = beside || !column ? kBeside_m : here - *column;
  }
  // A face without curvature along both directions, edges included, is flat.
  c.curved_face = !shape.is_plane(side / 2);
  c.flat = !c.curved_face && !shaped;
  if (c.flat) {
    c.relief_m.fill(0.0);
  } else {
    c.cell_compliance_m_Pa = cell_compliance_m_Pa(parameters, c.tributary[0].extent_m * c.tributary[1].extent_m);
  }
  c.least_relief_m = *std::min_element(c.relief_m.begin(), c.relief_m.end());
}

/// The candidates of a surface as a grid; a product's particles stand in one.
FaceGrid face_grid(const ContactModel& contact, int surface, const LatticeParameters& parameters,
                   const FacePlane& plane) {
  FaceGrid grid;
  for (std::size_t t = 0; t < 2; ++t) {
    const double half = 0.5 * parameters.size_m[plane.tangent[t]];
    grid.low_m[t] = plane.center_m[t] - half;
    grid.high_m[t] = plane.center_m[t] + half;
    std::map<double, Tributary> pieces;  // by place; a cell on a side of one particle is a cell of the grid
    for (const ContactCandidate& candidate : contact.candidate) {
      if (candidate.surface != surface) continue;
      const Tributary& piece = candidate.tributary[t];
      auto [at, added] = pieces.try_emplace(piece.place_m, piece);
      for (std::size_t side = 0; side < 2; ++side) {
        at->second.cells[side] = std::max(at->second.cells[side], piece.cells[side]);
      }
    }
    for (const auto& [place, piece] : pieces) grid.piece[t].push_back(piece);
  }
  grid.candidate.assign(grid.piece[0].size() * grid.piece[1].size(), -1);
  const auto at = [&grid](std::size_t t, double place_m) {
    const auto& pieces = grid.piece[t];
    const auto found =
        std::lower_bound(pieces.begin(), pieces.end(), place_m,
                         [](const Tributary& piece, double place) { return piece.place_m < place; });
    return static_cast<std::size_t>(found - pieces.begin());
  };
  for (std::size_t c = 0; c < contact.candidate.size(); ++c) {
    const ContactCandidate& candidate = contact.candidate[c];
    if (candidate.surface != surface) continue;
    const std::size_t i = at(0, candidate.tributary[0].place_m), j = at(1, candidate.tributary[1].place_m);
    grid.candidate[i * grid.piece[1].size() + j] = static_cast<int>(c);
  }
  return grid;
}

/// Sorts candidates by node and numbers the contact nodes.
void number_nodes(ContactModel& contact) {
  std::stable_sort(contact.candidate.begin(), contact.candidate.end(),
                   [](const ContactCandidate& a, const ContactCandidate& b) {
                     return a.node != b.node ? a.node < b.node : a.surface < b.surface;
                   });
  for (std::size_t c = 0; c < contact.candidate.size(); ++c) {
    if (contact.node.empty() || contact.node.back() != contact.candidate[c].node) {
      contact.node.push_back(contact.candidate[c].node);
      contact.first_candidate.push_back(static_cast<int>(c));
    }
    contact.candidate[c].contact_node = static_cast<int>(contact.node.size()) - 1;
  }
  contact.first_candidate.push_back(static_cast<int>(contact.candidate.size()));
}

/// The particles of one side that can touch a surface.
void add_candidates(const LatticeParameters& parameters, const Lattice& lattice, int surface,
                    const FacePlane& plane, double pole_m, ContactModel& contact) {
  const auto& points = lattice.side[facing_side(surface)];
  const TrueShape shape(parameters);
  const TributaryFace face(shape, lattice, plane, points);
  const double sign = normal_sign(surface);
  const double depth = kDeepestMeeting * parameters.size_m[plane.axis];
  const bool shaped = contact.shaped_pads && is_pad(surface);
  for (const SurfacePoint& point : points) {
    if (sign * (point.position_m - pole_m) > depth) continue;
    const auto& position_m = lattice.position_m[static_cast<std::size_t>(point.node)];
    ContactCandidate candidate;
    candidate.surface = surface;
    candidate.node = point.node;
    candidate.surface_m = point.position_m;
    candidate.area_m2 = face.area_m2(position_m);
    for (std::size_t t = 0; t < 2; ++t) {
      candidate.tributary[t] = face.piece(position_m, t);
      candidate.tributary[t].sampled = shaped && !candidate.tributary[t].curved;
      candidate.edge_compliance_m_Pa[t] = candidate.tributary[t].extent_m / plane_strain_modulus_Pa(parameters);
    }
    fill_relief(parameters, shape, lattice, shaped, candidate);
    contact.candidate.push_back(candidate);
  }
}

/// The places of the true surface, and each of them against the support and what cell and gripper list.
void add_places(const LatticeParameters& parameters, const Lattice& lattice, const ContactChoice& choice,
                ContactModel& contact) {
  const auto& cell_m = lattice.cell_extent_m;
  const double cell_m_Pa =
      cell_compliance_m_Pa(parameters, std::cbrt(std::pow(cell_m[0] * cell_m[1] * cell_m[2], 2)));
  for (const SurfacePlace& place : surface_places(parameters, lattice, choice.set)) {
    const auto& particle_m = lattice.position_m[static_cast<std::size_t>(place.node)];
    PlaceArm arm{.outward = place.outward};
    ContactCandidate candidate;
    candidate.node = place.node;
    candidate.surface_m = place.place_m[static_cast<std::size_t>(normal_axis(kSupport))];
    candidate.area_m2 = place.area_m2;
    candidate.place = static_cast<int>(contact.place.size());
    for (std::size_t d = 0; d < 3; ++d) arm.arm_m[d] = place.place_m[d] - particle_m[d];
    for (std::size_t t = 0; t < 2; ++t) {
      const auto along = static_cast<std::size_t>(tangent_axes(kSupport)[t]);
      candidate.tributary[t] = {place.place_m[along], std::sqrt(place.area_m2), false, {2, 2}};
    }
    if (place.curved) candidate.cell_compliance_m_Pa = cell_m_Pa;
    contact.place.push_back(arm);
    for (const int surface : choice.surface) {
      if (surface < kSupport) continue;  // pads that meet a side
      candidate.surface = surface;
      contact.candidate.push_back(candidate);
    }
  }
}

/// The patch that each face makes, where a surface can meet it.
void add_face_forms(const LatticeParameters& parameters, const Lattice& lattice, ContactSet set,
                    ContactModel& contact) {
  const TrueShape shape(parameters);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::array<int, 2> tangents = {axis == 0 ? 1 : 0, axis == 2 ? 1 : 2};
    const FacePlane plane(lattice, axis, tangents);
    contact.cell_extent_m[axis] = plane.extent_m;
    if (axis == 1 && set == ContactSet::pads_and_support) continue;
    contact.patch_form[2 * axis] = patch_form(parameters, 2 * axis, plane.tangent, lattice.center_m);
    contact.patch_form[2 * axis + 1] = shape.is_mirrored(axis)
                                           ? contact.patch_form[2 * axis]
                                           : patch_form(parameters, 2 * axis + 1, plane.tangent, lattice.center_m);
  }
}

}  // namespace

ContactChoice contact_choice(const Scenario& scenario) {
  const ContactSet set = contact_set(scenario);
  ContactChoice choice;
  choice.set = set;
  choice.pressure_patch_m = scenario.simulation.pressure_patch_m;
  choice.shaped_pads = has_shaped_pads(scenario);
  choice.stands_on_bottom = stands_on_its_bottom(scenario);
  if (set != ContactSet::pads_and_support) choice.surface = surfaces_of(scenario);
  return choice;
}

ContactModel lattice_contact(const LatticeParameters& parameters, const Lattice& lattice,
                             const ContactChoice& choice) {
  ContactModel contact;
  contact.patch_side_m = choice.pressure_patch_m;
  contact.surface = choice.surface;
  contact.shaped_pads = choice.shaped_pads;
  add_face_forms(parameters, lattice, choice.set, contact);
  const bool upright = choice.set == ContactSet::pads_and_support;
  std::vector<int> with_sides;  // whose candidates are particles of a side
  for (const int surface : choice.surface) {
    const bool meets_side = surface == kSupport ? choice.stands_on_bottom : upright || surface < kSupport;
    if (meets_side) with_sides.push_back(surface);
  }
  std::vector<FacePlane> plane;
  for (const int surface : with_sides) {
    const auto axis = static_cast<std::size_t>(normal_axis(surface));
    plane.emplace_back(lattice, axis, tangent_axes(surface));
    // Of the true shape: with an even number of particles across, none stands on it. The surface lies at the low
    // end where its force points up.
    const double pole = lattice.center_m[axis] - normal_sign(surface) * 0.5 * parameters.size_m[axis];
    if (is_pad(surface)) contact.pole_m[static_cast<std::size_t>(surface)] = pole;
    add_candidates(parameters, lattice, surface, plane.back(), pole, contact);
  }
  if (!upright) add_places(parameters, lattice, choice, contact);
  number_nodes(contact);
  for (std::size_t i = 0; i < with_sides.size(); ++i) {
    const int surface = with_sides[i];
    contact.face[static_cast<std::size_t>(surface)] = face_grid(contact, surface, parameters, plane[i]);
  }
  return contact;
}

ContactModel network_contact(const NetworkParameters& parameters) {
  ContactModel contact;
  for (std::size_t i = 0; i < parameters.particle.size(); ++i) {
    const NetworkParticle& particle = parameters.particle[i];
    if (particle.contact_stiffness_N_m <= 0.0) continue;
    ContactCandidate candidate;
    candidate.surface = kSupport;
    candidate.node = static_cast<int>(i);
    candidate.surface_m = particle.position_m[2];
    candidate.stiffness_N_m = particle.contact_stiffness_N_m;
    for (std::size_t t = 0; t < 2; ++t) candidate.tributary[t].place_m = particle.position_m[t];
    contact.candidate.push_back(candidate);
  }
  number_nodes(contact);
  return contact;
}

namespace {

/// What its places need of the factored body: their arms and how far each moves per force on it. A force on a
/// place acts on its particle, and with its arm as a moment on the body as a whole.
void give_arms(const BodyModel& body, const WilsonTheta& wilson, ContactModel& contact) {
  using Matrix = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
  const auto cross_matrix = [](const std::array<double, 3>& v) {
    Matrix S;
    S << 0.0, -v[2], v[1], v[2], 0.0, -v[0], -v[1], v[0], 0.0;
    return S;
  };
  const Matrix turn = Eigen::Map<const Matrix>(body.inverse_inertia.data()) / wilson.a0;
  std::copy_n(turn.data(), 9, contact.turn_per_moment.begin());
  contact.place_radius_m.assign(contact.node_count(), 0.0);
  for (const ContactCandidate& candidate : contact.candidate) {
    if (candidate.place < 0 || candidate.surface != kSupport) continue;  // each place once
    PlaceArm& place = contact.place[static_cast<std::size_t>(candidate.place)];
    const auto& particle_m = body.position_m[static_cast<std::size_t>(candidate.node)];
    std::array<double, 3> X{};
    double square = 0.0;
    for (std::size_t d = 0; d < 3; ++d) {
      X[d] = particle_m[d] - body.center_of_mass_m[d];
      place.from_mass_m[d] = X[d] + place.arm_m[d];
      square += place.arm_m[d] * place.arm_m[d];
    }
    double& radius = contact.place_radius_m[static_cast<std::size_t>(candidate.contact_node)];
    radius = std::max(radius, std::sqrt(square));
    const Matrix o = cross_matrix(place.arm_m), x = cross_matrix(X);
    const std::size_t own = 9 * static_cast<std::size_t>(candidate.contact_node) * (contact.node_count() + 1);
    const Matrix W = Eigen::Map<const Matrix>(contact.compliance.data() + own) - o * turn * (x + o) - x * turn * o;
    std::copy_n(W.data(), 9, place.compliance.begin());
  }
}

ContactModel candidates_of(const LatticeParameters& parameters, const BodyModel& body,
                           const ContactChoice& choice) {
  require(body.lattice.has_value(), "product_contact: the body of another product");
  return lattice_contact(parameters, *body.lattice, choice);
}
ContactModel candidates_of(const NetworkParameters& parameters, const BodyModel& body, const ContactChoice&) {
  require(parameters.particle.size() == body.particle_count, "product_contact: the body of another product");
  return network_contact(parameters);
}

}  // namespace

ContactModel contact_candidates(const Scenario& scenario, const BodyModel& body) {
  const ContactChoice choice = contact_choice(scenario);
  ContactModel contact =
      std::visit([&](const auto& kind) { return candidates_of(kind, body, choice); }, scenario.product);
  if (compliance_bytes(contact.node_count()) > kMostComplianceBytes) {
    throw std::invalid_argument("so many particles may touch that their compliance takes more than 4 GB");
  }
  return contact;
}

void give_compliance(NodeCompliance compliance, const BodyModel& body, const WilsonTheta& wilson,
                     ContactModel& contact) {
  contact.compliance = std::move(compliance.block);
  contact.reach = std::move(compliance.reach);
  contact.columns = std::move(compliance.columns);
  if (!contact.place.empty()) give_arms(body, wilson, contact);
}

ContactModel product_contact(const Scenario& scenario, const BodyModel& body, const WilsonTheta& wilson) {
  ContactModel contact = contact_candidates(scenario, body);
  give_compliance(node_compliance(body.factor, body.slot, contact.node), body, wilson, contact);
  return contact;
}

}  // namespace unbruised

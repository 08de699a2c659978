#include "core/contact/contact_model.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/algebra/lane_solve.hpp"
#include "core/contact/tributary_face.hpp"
#include "core/door/require.hpp"
#include "core/scenario/pad_meeting.hpp"
#include "core/scenario/true_shape.hpp"

namespace unbruised {
namespace {

/// Sides of a lattice (-x, +x, -y, +y, -z, +z) that face the surfaces.
constexpr std::array<std::size_t, kSurfaceCount> kFacingSide = {0, 1, 4};

/// Cell compliance x E / (1 - nu^2) / width of the rectangle. Calibrated: with it Hertz's force at a given
/// approach is met within 15 % from five cells per radius on, be it a particle or a cell that stands under the
/// pole (docs/validation.md); without it a stiff plate meets 1.4 to 1.7 times that force. It vanishes with the
/// cell size.
constexpr double kCellCompliance = 0.4;

/// Heights of the true surface around the particle; places outside the body never touch.
void fill_relief(const LatticeParameters& parameters, const Lattice& lattice, std::size_t axis,
                 ContactCandidate& c) {
  const auto tangents = tangent_axes(c.surface);
  std::array<double, 3> place{};
  for (std::size_t t = 0; t < 2; ++t) {
    const auto along = static_cast<std::size_t>(tangents[t]);
    place[along] = c.tributary[t].place_m - lattice.center_m[along];
  }
  const TrueShape shape(parameters);
  const double here = shape.half_chord_m(axis, place);
  for (int q = 0; q < kReliefPlaces; ++q) {
    std::array<double, 3> there = place;
    const auto offset = relief_offset(q);
    for (std::size_t t = 0; t < 2; ++t) {
      there[static_cast<std::size_t>(tangents[t])] += offset[t] * c.tributary[t].extent_m;
    }
    const double chord = shape.half_chord_m(axis, there);
    c.relief_m[static_cast<std::size_t>(q)] = chord < 0.0 ? 1e3 : here - chord;
  }
  // A face without curvature along both directions, edges included, is flat.
  c.flat = shape.curvatures(axis) == 0;
  if (c.flat) {
    c.relief_m.fill(0.0);
  } else {
    c.cell_compliance_m_Pa = kCellCompliance * std::sqrt(c.tributary[0].extent_m * c.tributary[1].extent_m) /
                             plane_strain_modulus_Pa(parameters);
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

/// Fills `compliance` and `reach` from the factored effective stiffness.
/// @param slot elimination position of each freedom (3 per particle), -1 where it is fixed
void fill_compliance(const SupernodalFactor& factor, const std::vector<int>& slot, ContactModel& contact) {
  const std::size_t m = contact.node_count();
  require(m == 0 || 3 * static_cast<std::size_t>(contact.node.back()) + 2 < slot.size(),
          "product_contact: the body is not factored");
  std::vector<int> freedoms;
  for (int node : contact.node) {
    for (int axis = 0; axis < 3; ++axis) {
      const int at = slot[3 * static_cast<std::size_t>(node) + axis];
      if (at >= 0) freedoms.push_back(factor.permutation[at]);
    }
  }
  contact.reach = reach(factor, freedoms);
  contact.compliance.assign(9 * m * m, 0.0);
  LaneArray x(static_cast<std::size_t>(factor.size));
  const std::size_t columns = 3 * m;
  for (std::size_t first = 0; first < columns; first += kLanes) {
    x.fill(0.0);
    const std::size_t count = std::min<std::size_t>(kLanes, columns - first);
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t column = first + k;
      const int at = slot[3 * static_cast<std::size_t>(contact.node[column / 3]) + column % 3];
      if (at >= 0) x.at(static_cast<std::size_t>(at), static_cast<int>(k)) = 1.0;
    }
    solve_forward(factor, contact.reach, x.data());
    solve_backward(factor, contact.reach, x.data());
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t column = first + k;
      for (std::size_t i = 0; i < m; ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const int at = slot[3 * static_cast<std::size_t>(contact.node[i]) + axis];
          const double value = at >= 0 ? x.at(static_cast<std::size_t>(at), static_cast<int>(k)) : 0.0;
          contact.compliance[9 * (i * m + column / 3) + 3 * axis + column % 3] = value;
        }
      }
    }
  }
}

/// The particles of one side that can touch a surface.
void add_candidates(const LatticeParameters& parameters, const Lattice& lattice, int surface,
                    const FacePlane& plane, double pole_m, ContactModel& contact) {
  const auto& points = lattice.side[kFacingSide[static_cast<std::size_t>(surface)]];
  const TrueShape shape(parameters);
  const TributaryFace face(shape, lattice, plane, points);
  const double sign = normal_sign(surface);
  const double depth = kDeepestMeeting * parameters.size_m[plane.axis];
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
      candidate.edge_compliance_m_Pa[t] = candidate.tributary[t].extent_m / plane_strain_modulus_Pa(parameters);
    }
    fill_relief(parameters, lattice, plane.axis, candidate);
    contact.candidate.push_back(candidate);
  }
}

}  // namespace

ContactModel lattice_contact(const LatticeParameters& parameters, const Lattice& lattice,
                             double pressure_patch_m) {
  ContactModel contact;
  contact.patch_side_m = pressure_patch_m;
  std::vector<FacePlane> plane;
  for (int surface = 0; surface < kSurfaceCount; ++surface) {
    const auto axis = static_cast<std::size_t>(normal_axis(surface));
    plane.emplace_back(lattice, axis, tangent_axes(surface));
    // Of the true shape: with an even number of particles across, none stands on it. The surface lies at the low
    // end where its force points up.
    const double pole = lattice.center_m[axis] - normal_sign(surface) * 0.5 * parameters.size_m[axis];
    const auto at = static_cast<std::size_t>(surface);
    if (is_pad(surface)) contact.pole_m[at] = pole;
    contact.patch_form[at] = patch_form(parameters, axis, plane.back().tangent, lattice.center_m);
    contact.cell_extent_m[at] = plane.back().extent_m;
    add_candidates(parameters, lattice, surface, plane.back(), pole, contact);
  }
  number_nodes(contact);
  for (int surface = 0; surface < kSurfaceCount; ++surface) {
    const auto at = static_cast<std::size_t>(surface);
    contact.face[at] = face_grid(contact, surface, parameters, plane[at]);
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

ContactModel candidates_of(const LatticeParameters& parameters, const BodyModel& body, double pressure_patch_m) {
  require(body.lattice.has_value(), "product_contact: the body of another product");
  return lattice_contact(parameters, *body.lattice, pressure_patch_m);
}
ContactModel candidates_of(const NetworkParameters& parameters, const BodyModel& body, double) {
  require(parameters.particle.size() == body.particle_count, "product_contact: the body of another product");
  return network_contact(parameters);
}

}  // namespace

ContactModel product_contact(const ProductParameters& product, const BodyModel& body, double pressure_patch_m) {
  ContactModel contact =
      std::visit([&](const auto& kind) { return candidates_of(kind, body, pressure_patch_m); }, product);
  fill_compliance(body.factor, body.slot, contact);
  return contact;
}

}  // namespace unbruised

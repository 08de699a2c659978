#pragma once

/// @file
/// Resultants of the surfaces at the end of a step, all lanes at once.

#include <array>
#include <cstddef>

#include "core/contact/contact_model.hpp"
#include "core/contact/place_cover.hpp"
#include "core/lanes/lane.hpp"

namespace unbruised {

/// Where in a candidate's tributary piece its force sits.
struct PressedPiece {
  Lane penetration;  ///< of the particle's place
  PlaceCover cover;
  std::array<Lane, 2> mean_m,
      mean_square_m2;  ///< offset of the covered part from the particle, along flat tangents
};

/// What one surface does to the product, per lane.
struct SurfaceTally {
  Lane normal{0.0};
  std::array<Lane, 2> tangent{Lane(0.0), Lane(0.0)};            ///< along tangent_axes(surface), on the product
  Lane closed{0.0};                                             ///< contacts that carry force
  Lane sliding{0.0};                                            ///< of these, at the friction cone
  std::array<Lane, 2> first{Lane(0.0), Lane(0.0)};              ///< moments of the normal force over the plane
  std::array<Lane, 3> second{Lane(0.0), Lane(0.0), Lane(0.0)};  ///< yy, zz, yz
  std::array<Lane, 3> torque{Lane(0.0), Lane(0.0), Lane(0.0)};  ///< about the palm centre, on the product
  Lane deepest_Pa{0.0};  ///< pressure where a layer with a law of its own is pressed in deepest

  /// Force on the product along x, y, z.
  [[nodiscard]] std::array<Lane, 3> force(int surface) const;

  /// Forgets what another scenario left in a lane.
  void clear_lane(int lane);
  /// Adds the moments of one candidate's normal force over the plane.
  void add_moments(const ContactCandidate& candidate, const Lane& normal_force, const PressedPiece& piece);
  /// Adds the normal force of a place of the true surface. @param at on the face @param extent_m of its piece
  void add_place(const Lane& normal_force, const std::array<Lane, 2>& at, double extent_m);
  /// Adds the torque of a force on the product about the point its arm is measured from.
  void add_torque(const std::array<Lane, 3>& arm, const std::array<Lane, 3>& force, const Mask& running);
};

/// x, y, z of a force given along the normal and the tangents of a surface.
[[gnu::always_inline]] inline std::array<Lane, 3> along_axes(int surface, const Lane& normal, const Lane& tangent1,
                                                             const Lane& tangent2) {
  const auto tangents = tangent_axes(surface);
  std::array<Lane, 3> force;
  force[static_cast<std::size_t>(normal_axis(surface))] = Lane(normal_sign(surface)) * normal;
  force[static_cast<std::size_t>(tangents[0])] = tangent1;
  force[static_cast<std::size_t>(tangents[1])] = tangent2;
  return force;
}

}  // namespace unbruised

#pragma once

/// @file
/// Pads whose face is no plane: each candidate meets them in axes of its own, the first along the normal of the
/// face where it is, the other two along the face (docs/theory.md, "Shaped pads"). With D from the pad's middle to
/// the particle's place on the true surface, less its place in the plane at rest, the candidate sees x = T D, and
/// its gap is sign x_0 - offset. Axes and reliefs are looked at anew while a contact is open or slides; one that
/// sticks keeps what it closed with, so that its layer is a conservative spring.

#include <array>

#include "core/contact/contact_model.hpp"
#include "core/contact/contact_register.hpp"
#include "core/lanes/lane_archive.hpp"
#include "core/lanes/lane_vector.hpp"
#include "core/surface/surface_lanes.hpp"

namespace unbruised {

class ShapedPads {
 public:
  /// All have to outlive this.
  ShapedPads(const ContactModel& model, const SurfaceLanes& surfaces, ContactRegister& contacts);

  /// Forgets where the candidates of a lane have been looked at.
  void load(int lane);
  /// All that a lane keeps from step to step.
  void archive(LaneArchive& lane) { lane(turn_, offset_, looked_); }
  /// Looks at the face under a candidate in the lanes of `may` in which it has moved since it was looked at.
  /// @param place_m of the particle along the tangents, from where it is at rest to the pad
  /// @return lanes in which it has been looked at
  Mask look(std::size_t candidate, const std::array<Lane, 2>& place_m, const Mask& may);

  /// From the axes of the carrier into those of a candidate.
  [[nodiscard]] LaneMatrix axes(std::size_t candidate) const;
  /// A vector along the axes of the carrier.
  [[nodiscard, gnu::always_inline]] LaneVector seen(std::size_t candidate, const LaneVector& along_carrier) const {
    LaneVector x;
    for (std::size_t i = 0; i < 3; ++i) {
      x[i] = axis(candidate, i, 0) * along_carrier[0] + axis(candidate, i, 1) * along_carrier[1] +
             axis(candidate, i, 2) * along_carrier[2];
    }
    return x;
  }
  /// The other way.
  [[nodiscard, gnu::always_inline]] LaneVector along_carrier(std::size_t candidate, const LaneVector& x) const {
    LaneVector v;
    for (std::size_t j = 0; j < 3; ++j) {
      v[j] = axis(candidate, 0, j) * x[0] + axis(candidate, 1, j) * x[1] + axis(candidate, 2, j) * x[2];
    }
    return v;
  }
  /// One number of the matrix.
  [[nodiscard, gnu::always_inline]] Lane axis(std::size_t candidate, std::size_t i, std::size_t j) const {
    return turn_.get(9 * candidate + 3 * i + j);
  }
  [[nodiscard]] Lane offset_m(std::size_t candidate) const { return offset_.get(candidate); }
  /// Gap at the particle's place. @param x as the candidate sees it
  [[nodiscard]] Lane gap_m(std::size_t candidate, const LaneVector& x) const {
    return Lane(normal_sign(model_.candidate[candidate].surface)) * x[0] - offset_.get(candidate);
  }
  /// Area of the face over that of its plane.
  [[nodiscard]] Lane wider(std::size_t candidate) const { return Lane(1.0) / axis(candidate, 0, 0); }

 private:
  void look_in_lane(std::size_t candidate, const std::array<double, 2>& place_m, int lane);

  const ContactModel& model_;
  const SurfaceLanes& surfaces_;
  ContactRegister& contacts_;
  LaneArray turn_;  ///< 9 rows each
  LaneArray offset_;
  std::array<LaneArray, 2> looked_;  ///< place at which it was looked at; far away: never
};

}  // namespace unbruised

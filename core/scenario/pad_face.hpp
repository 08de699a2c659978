#pragma once

/// @file
/// The face of a pad: its height towards the product over the plane of the pad, in the pad's own axes
/// (docs/theory.md, "Shaped pads"). The only place of these formulas. The middle of every face but a profile's has
/// the height 0.

#include <array>
#include <cstddef>
#include <vector>

#include "core/scenario/scenario.hpp"

namespace unbruised {

/// Is the face anything but a plane?
inline bool is_shaped(const PadParameters& pad) { return pad.shape != PadShape::flat; }
/// Has the scenario a gripper with such pads?
inline bool has_shaped_pads(const Scenario& scenario) {
  const auto* jaw = parallel_jaw(scenario);
  return jaw != nullptr && is_shaped(jaw->pad);
}

/// Places are along the tangents of the pad, y and z, from its middle.
class PadFace {
 public:
  /// A plane.
  PadFace() = default;
  explicit PadFace(const ParallelJawParameters& jaw);

  /// [m]; beside the pad that of its edge.
  [[nodiscard]] double height_m(const std::array<double, 2>& place_m) const;
  /// Mean slope along a tangent over a stretch of this length about a place, of which only what lies on the pad
  /// counts.
  [[nodiscard]] double slope(const std::array<double, 2>& place_m, std::size_t tangent, double length_m) const;
  /// Of the face in its middle along the tangents, negative where it is hollow [1/m]; of a profile that of the
  /// parabola through its middle half.
  [[nodiscard]] std::array<double, 2> curvature_1_m() const;
  /// Cosine of the angle between a face of a V groove and the pad's plane; 1 of all other shapes.
  [[nodiscard]] double groove_cosine() const;
  /// Least and greatest of the height over the pad [m].
  [[nodiscard]] std::array<double, 2> range_m() const;
  [[nodiscard]] const std::array<double, 2>& half_size_m() const { return half_m_; }

 private:
  [[nodiscard]] double round_m(double square_m2) const;
  [[nodiscard]] double profile_m(double across_m) const;
  [[nodiscard]] double profile_curvature_1_m() const;

  PadShape shape_ = PadShape::flat;
  std::size_t across_ = 0;  ///< tangent across which a cylinder, a groove or a profile changes
  double radius_m_ = 1.0, cotangent_ = 0.0;
  std::vector<double> place_m_, profile_m_;
  std::array<double, 2> half_m_{1.0, 1.0};
};

}  // namespace unbruised

#pragma once

/// @file
/// What the edge of a pad adds to the stress where it ends within a face (docs/theory.md, "Pad edges").
///
/// The pressure rises towards the edge, the more the stiffer the layer is against the body, lambda = k w / E* with
/// half the pad's side w. Counted is the von Mises stress that is passed in 0.3 % of w^3, which is 10 mm^3 below a
/// pad of 30 mm; in the edge itself it has no bound.

#include <array>
#include <cstddef>

namespace unbruised {

class PadEdge {
 public:
  PadEdge() = default;
  /// Of a flat pad on a flat face, both directions within it: peak stress / mean pressure.
  static PadEdge of_flat(double poisson_ratio);
  /// Of a pad across a cylinder: peak stress / that below a strip without ends.
  static PadEdge of_strip();
  /// @param lambda > 0; beyond the table, 0.3 to 100, that of its end
  [[nodiscard]] double at(double lambda) const;
  /// What its ends leave the middle of such a strip: half-space under pads of 30 mm, 0.93 to 0.98.
  static constexpr double kMiddleOfStrip = 0.95;

 private:
  static constexpr std::size_t kSteps = 6;
  std::array<double, kSteps> peak_{1.0, 1.0, 1.0, 1.0, 1.0, 1.0};
};

}  // namespace unbruised

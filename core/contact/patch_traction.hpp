#pragma once

/// @file
/// What friction adds to the stress below a patch (docs/theory.md, "First yield").
///
/// A patch that carries T besides N is dragged by the traction q = (T / N) p wherever it is pressed. The largest
/// von Mises stress of both together, over that of the pressure alone, is a function of T / N and Poisson's ratio.
/// The circular patch of Hertz is the reference for all curved contacts. Looked at is the flesh from a twentieth
/// of the patch's radius down: in the surface itself q alone makes sqrt(3) q, which passes the stress below from T
/// / N of about 0.35 on, but in a skin thinner than half a millimetre that the yield stress of the flesh does not
/// speak of.

#include <array>
#include <cstddef>

#include "core/lanes/lane.hpp"

namespace unbruised {

/// Depth over the patch's radius from which on stress counts.
inline constexpr double kSkinDepth = 0.05;

/// Largest von Mises stress below a circular patch of Hertz / its largest pressure, without traction: 0.62 at a
/// Poisson ratio of 0.3 (tau = 0.31 p0 at a depth of 0.48 a). @param poisson_ratio 0 to 0.5
double hertz_peak_stress(double poisson_ratio);

/// Peak stress with traction / without, by T / N.
class TractionFactor {
 public:
  /// Of a curved patch. @param poisson_ratio 0 to 0.5
  static TractionFactor of_curved(double poisson_ratio);
  /// Of a flat one, pressed and dragged evenly: sqrt(1 + 3 (T / N)^2).
  static TractionFactor of_flat();
  /// @param traction_over_pressure T / N >= 0; beyond the table its last slope goes on
  [[nodiscard]] double at(double traction_over_pressure) const;
  [[nodiscard]] Lane at(const Lane& traction_over_pressure) const;

  static constexpr std::size_t kSteps = 17;
  static constexpr double kStep = 0.05;  ///< of T / N

 private:
  std::array<double, kSteps> factor_{};
};

}  // namespace unbruised

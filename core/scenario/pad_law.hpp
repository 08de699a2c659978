#pragma once

/// @file
/// The force law of a measured fingertip: its force against a flat plate over the depth by which that presses it
/// in. Spread evenly over the pad it is the law of the pad's layer (docs/theory.md, "Measured fingertips").

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/scenario/scenario.hpp"

namespace unbruised {

/// Most terms of a polynomial and most points of a law.
inline constexpr std::size_t kMostLawTerms = 4, kMostLawPoints = 16;

/// F(d) = sum_i c_i d^(i+1), plus at every knot d_j a change of slope: + s_j max(0, d - d_j).
struct PadLaw {
  std::array<double, kMostLawTerms> term_N{};  ///< c_i [N/m, N/m2, ...]
  std::vector<double> knot_m, slope_N_m;

  [[nodiscard]] double force_N(double depth_m) const;
  /// dF / dd.
  [[nodiscard]] double slope_at_N_m(double depth_m) const;
  /// Depth at which it gives a force [m].
  [[nodiscard]] double depth_m(double force_N) const;
};

/// Of a pad; none where its layer follows from its modulus.
std::optional<PadLaw> pad_law(const PadParameters& pad);

/// A depth at which the law's slope stands for the layer's shear and for the body within a cell: a tenth of the
/// layer's thickness.
double reference_depth_m(const ParallelJawParameters& jaw);

/// Why a law of points or of a polynomial is none.
struct LawFlaw {
  std::string_view field;
  std::string rule;
};
/// @return none: it rises from (0, 0). Lists of points have to be equally long.
std::optional<LawFlaw> law_flaw(const ParallelJawParameters& jaw);

}  // namespace unbruised

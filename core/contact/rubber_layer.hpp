#pragma once

/// @file
/// How much stiffer than springs of E / t a layer of rubber is that is bonded to what carries it (docs/theory.md,
/// "Rubber").
///
/// Rubber keeps its volume: where it is pressed it has to go aside, which its bonded back forbids. Under a
/// pressure wave of wave number q its face gives way by 2 (1 - nu^2) L(q t) p / (E q), with L in closed form.
/// Springs that make a patch as large and the stress below it as high as the layer does have the stiffness that
/// follows from the energy of both, W = F^2 c(a) / 2: the patch is where d/da of layer and body add up to nothing,
/// so that c' has to be the same.

#include <array>
#include <cstddef>
#include <optional>

#include "core/contact/patch_area.hpp"
#include "core/scenario/pad_law.hpp"
#include "core/scenario/scenario.hpp"

namespace unbruised {

/// L(x): deflection of the face under a pressure wave, over that of a half-space of the same rubber; 1 for short
/// waves. @param x wave number x thickness, > 0
double layer_response(double x, double poisson_ratio, PadBulge bulge);

/// Stiffness under a patch over E / t, by the patch's half width over the thickness.
class RubberFactor {
 public:
  /// Springs: 1.
  RubberFactor() = default;
  /// @param kind ellipse or strip @param poisson_ratio > 0, <= 0.5
  RubberFactor(PatchKind kind, double poisson_ratio, PadBulge bulge);
  [[nodiscard]] bool is_springs() const { return springs_; }
  /// @param slenderness radius (of an ellipse that of the circle of its area) or half width / thickness; beyond
  /// the table, 0.25 to 64, that of its end
  [[nodiscard]] double at(double slenderness) const;

 private:
  static constexpr std::size_t kSteps = 25;
  bool springs_ = true;
  std::array<double, kSteps> log_{};
};

/// Of a pad that is pressed as a whole, between its bonded back and a face, its sides free (Gent and Lindley 1959,
/// E (1 + 2 S^2), with the confined modulus as the end of it). @param side_m of what is pressed
double whole_pad_factor(const std::array<double, 2>& side_m, double thickness_m, double poisson_ratio,
                        PadBulge bulge);

/// The compliant layer of a surface.
struct LayerParameters {
  double modulus_Pa = 0.0, thickness_m = 0.0;
  double poisson_ratio = 0.0;
  PadBulge bulge = PadBulge::free;
  std::optional<PadLaw> law{};  ///< of a measured pad,
  double law_area_m2 = 0.0;     ///< and its area
  double law_depth_m = 0.0;     ///< at which its springs are taken

  [[nodiscard]] bool is_springs() const { return poisson_ratio == 0.0 && !law; }
  [[nodiscard]] double springs_N_m3() const {
    return law ? law->force_N(law_depth_m) / (law_depth_m * law_area_m2) : modulus_Pa / thickness_m;
  }
};
LayerParameters pad_layer(const ParallelJawParameters& gripper);
LayerParameters support_layer(const CellParameters& cell);

/// The layer under the patches of one face.
struct FaceLayer {
  LayerParameters layer;
  PatchArea area;
  /// What of the face lies under the surface, along the tangents [m].
  std::array<double, 2> covered_m{};
  RubberFactor rubber;

  FaceLayer() = default;
  FaceLayer(const LayerParameters& layer, const PatchArea& area, const std::array<double, 2>& covered_m);
  /// Stiffness per area of the springs that stand for it under a force [N/m3].
  [[nodiscard]] double stiffness_N_m3(double force_N) const;

 private:
  [[nodiscard]] double patch_half_width_m(double force_N, double layer_N_m3) const;
  [[nodiscard]] double law_stiffness_N_m3(double force_N) const;
};

}  // namespace unbruised

#pragma once

/// @file
/// How much damage there is below a contact patch, from its elastic stress (docs/theory.md, "Damage below a
/// patch").
///
/// The yield ratio r is the elastic peak of von Mises stress over the yield stress Y. Neuber's rule, in closed
/// form for linear hardening, gives the plastic strain p where the elastic stress would be r Y:
///   (Y + H p) (Y + (H + 3 G) p) = (r Y)^2
/// The elastic field of a circular patch of Hertz, in units of sqrt(A) and its peak, gives what lies around: the
/// volume in which the stress is above a part v of the peak, A^1.5 V(v), and its weight in the dent, sqrt(A) W(v),
/// by the reciprocal theorem with the field of a unit force at the pole. Plastic flow and the finite body widen
/// both; how wide and how deep bruised flesh is follows from that field as its volume does. The three factors that
/// say by how much are kFiniteBody, kWiderVolume and kDeeperDent.

#include <array>
#include <cstddef>
#include <optional>

#include "core/contact/contact_model.hpp"
#include "core/scenario/product.hpp"

namespace unbruised {

/// How flesh flows: q = Y + H p.
struct FlowLaw {
  YieldLaw yield;

  /// Plastic strain at `ratio` times the yield stress of elastic stress, by Neuber's rule; 0 up to 1.
  [[nodiscard]] double strain_at(double ratio) const;
  /// The ratio that makes this plastic strain.
  [[nodiscard]] double ratio_at(double strain) const;
  /// Plastic work per volume [Pa].
  [[nodiscard]] double work_at(double strain) const;
};
/// Nothing: the product cannot yield, or is no lattice.
std::optional<FlowLaw> flow_law(const ProductParameters& product);

/// What a patch is pressed with.
struct PatchLoad {
  double yield_ratio = 0.0;
  double area_m2 = 0.0;
};

/// What stays below one patch.
struct PatchDamage {
  double plastic_strain = 0.0;
  double set_m = 0.0;  ///< of the pole
  double bruised_volume_m3 = 0.0;
  double absorbed_energy_J = 0.0;
  double bruised_area_m2 = 0.0;  ///< across the widest
  double bruised_depth_m = 0.0;  ///< from the surface to the deepest
};

/// The worst that each surface's patch has come to.
class WorstPatches {
 public:
  void raise(std::size_t surface, const PatchDamage& damage);
  /// The largest of all in strain, set and depth, all together in volume, area and energy.
  [[nodiscard]] PatchDamage together() const;

 private:
  std::array<PatchDamage, kSurfaceCount> worst_{};
};

/// Grows with the load, from 0 at first yield, without a jump.
/// @param bruised_strain of bruised flesh
PatchDamage patch_damage(const PatchLoad& load, const PatchForm& form, const FlowLaw& law, double bruised_strain);

/// The load of a patch of this form. @param traction_N size of the resultant along the pad
PatchLoad patch_load(const PatchForm& form, const FlowLaw& law, double yield_ratio, double normal_N,
                     double traction_N);

}  // namespace unbruised

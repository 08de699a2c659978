#include "core/contact/patch_damage.hpp"

#include <algorithm>
#include <cmath>

namespace unbruised {
namespace {

/// The field as a half-space has it at r Y: in a body as thick as the gripped one the peak grows with the part of
/// the cross-section that the patch covers, from a value that a sphere and an ellipsoid have in common within 2 %.
/// Finite elements of the kiwi and of a sphere, 0.06 to 0.17 of the cross-section: slopes 0.44 and 0.52. Within
/// these 2 % the base is the kiwi's, where 1 % of strain begins.
constexpr double kFiniteBodyBase = 0.972, kFiniteBodySlope = 0.48;
/// Flow spreads to where the elastic stress is lower: volume and dent of finite elements over those of the elastic
/// field; fitted to the kiwi, checked on two spheres (docs/validation.md, "How much damage").
constexpr double kWiderVolume = 1.46;
constexpr double kDeeperDent = 1.37;

/// What flow adds up to over the field: sum of f(p) over volume and of p over the dent.
struct Flow {
  double work = 0.0;  ///< per A^1.5
  double dent = 0.0;  ///< per sqrt(A)
};
Flow flow_through(const PatchField& field, const FlowLaw& law, double ratio) {
  const double from = std::max(PatchField::kLeastPart, 1.0 / ratio);
  constexpr int kSlices = 100;  ///< of the field between yield and its peak
  Flow sum;
  for (int i = 0; i < kSlices; ++i) {
    const double low = from + (1.0 - from) * i / kSlices, high = from + (1.0 - from) * (i + 1) / kSlices;
    const double strain = law.strain_at(0.5 * (low + high) * ratio);
    sum.work += law.work_at(strain) * (field.volume_above(low) - field.volume_above(high));
    sum.dent += strain * (field.dent_above(low) - field.dent_above(high));
  }
  return sum;
}

}  // namespace

double FlowLaw::strain_at(double ratio) const {
  if (!(ratio > 1.0)) return 0.0;
  const double Y = yield.yield_stress_Pa, H = yield.hardening_modulus_Pa, S = H + 3.0 * yield.shear_modulus_Pa;
  // H S p^2 + Y (H + S) p = Y^2 (r^2 - 1), in the form that keeps its digits with H = 0.
  const double right = Y * Y * (ratio * ratio - 1.0), linear = Y * (H + S);
  return 2.0 * right / (linear + std::sqrt(linear * linear + 4.0 * H * S * right));
}

double FlowLaw::ratio_at(double strain) const {
  const double Y = yield.yield_stress_Pa, H = yield.hardening_modulus_Pa;
  return std::sqrt((Y + H * strain) * (Y + (H + 3.0 * yield.shear_modulus_Pa) * strain)) / Y;
}

double FlowLaw::work_at(double strain) const {
  return (yield.yield_stress_Pa + 0.5 * yield.hardening_modulus_Pa * strain) * strain;
}

std::optional<FlowLaw> flow_law(const ProductParameters& product) {
  const std::optional<YieldLaw> yield = yield_law(product);
  return yield ? std::optional<FlowLaw>(FlowLaw{*yield}) : std::nullopt;
}

void WorstPatches::raise(std::size_t surface, const PatchDamage& damage) {
  PatchDamage& worst = worst_[surface];
  worst.plastic_strain = std::max(worst.plastic_strain, damage.plastic_strain);
  worst.set_m = std::max(worst.set_m, damage.set_m);
  worst.bruised_volume_m3 = std::max(worst.bruised_volume_m3, damage.bruised_volume_m3);
  worst.bruised_area_m2 = std::max(worst.bruised_area_m2, damage.bruised_area_m2);
  worst.bruised_depth_m = std::max(worst.bruised_depth_m, damage.bruised_depth_m);
  worst.absorbed_energy_J = std::max(worst.absorbed_energy_J, damage.absorbed_energy_J);
}

PatchDamage WorstPatches::together() const {
  PatchDamage all;
  for (const PatchDamage& worst : worst_) {
    all.plastic_strain = std::max(all.plastic_strain, worst.plastic_strain);
    all.set_m = std::max(all.set_m, worst.set_m);
    all.bruised_volume_m3 += worst.bruised_volume_m3;
    all.bruised_area_m2 += worst.bruised_area_m2;
    all.bruised_depth_m = std::max(all.bruised_depth_m, worst.bruised_depth_m);
    all.absorbed_energy_J += worst.absorbed_energy_J;
  }
  return all;
}

PatchLoad patch_load(const PatchForm& form, const FlowLaw& law, double yield_ratio, double normal_N,
                     double traction_N) {
  if (!(yield_ratio > 0.0) || !(normal_N > 0.0)) return {};
  const double dragged = form.traction.at(traction_N / normal_N) * normal_N * form.share;
  return {yield_ratio, dragged / (yield_ratio * form.yield_factor * law.yield.yield_stress_Pa)};
}

PatchDamage patch_damage(const PatchLoad& load, const PatchForm& form, const FlowLaw& law, double bruised_strain) {
  if (form.cross_section_m2 == 0.0) return {};
  const double covered = std::min(1.0, load.area_m2 / form.cross_section_m2);
  const double ratio = load.yield_ratio * (kFiniteBodyBase + kFiniteBodySlope * covered);
  if (!(ratio > 1.0)) return {};
  const double root = std::sqrt(load.area_m2), cube = root * load.area_m2;
  const Flow flow = flow_through(form.field, law, ratio);
  PatchDamage damage;
  damage.plastic_strain = law.strain_at(ratio);
  damage.set_m = kDeeperDent * root * flow.dent;
  damage.absorbed_energy_J = form.patches * kWiderVolume * cube * flow.work;
  const double bruised_part = law.ratio_at(bruised_strain) / ratio;
  if (bruised_part < 1.0) {
    const double wider = std::cbrt(kWiderVolume);  // along each direction
    damage.bruised_volume_m3 = form.patches * kWiderVolume * cube * form.field.volume_above(bruised_part);
    damage.bruised_area_m2 = form.patches * wider * wider * load.area_m2 * form.field.area_above(bruised_part);
    damage.bruised_depth_m = wider * root * form.field.depth_above(bruised_part);
  }
  return damage;
}

}  // namespace unbruised

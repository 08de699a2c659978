#include "core/contact/contact_time.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <variant>

#include "core/scenario/lattice_cells.hpp"
#include "core/scenario/true_shape.hpp"

namespace unbruised {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

double series(double a, double b) { return a > 0.0 && b > 0.0 ? a * b / (a + b) : 0.0; }

/// One side of a lattice product against a layer.
struct LayeredFace {
  double youngs_modulus_Pa;
  double poisson_ratio;
  double half_depth_m;  ///< from the face to the product's middle plane
  bool is_flat;
  double flat_area_m2;
  double radius_m;             ///< of a curved face
  double largest_patch_m2;     ///< that the layer gives a curved face
  double layer_per_area_Pa_m;  ///< E / thickness

  [[nodiscard]] double flat_stiffness_N_m() const {
    return series(layer_per_area_Pa_m * flat_area_m2, youngs_modulus_Pa * flat_area_m2 / half_depth_m);
  }

  [[nodiscard]] double curved_stiffness_N_m(double force_N) const {
    const double reduced = youngs_modulus_Pa / (1.0 - poisson_ratio * poisson_ratio);
    const double depth_m = std::pow(0.75 * force_N / (reduced * std::sqrt(radius_m)), 2.0 / 3.0);
    const double patch_m2 = std::min(std::numbers::pi * radius_m * depth_m, largest_patch_m2);
    return series(layer_per_area_Pa_m * patch_m2, 2.0 * reduced * std::sqrt(radius_m * depth_m));
  }

  [[nodiscard]] double stiffness_N_m(double force_N) const {
    return is_flat ? flat_stiffness_N_m() : curved_stiffness_N_m(force_N);
  }
};

/// Half a period of a mass that meets the face at this speed and is pressed with at least this force.
double half_period_s(const LayeredFace& face, double mass_kg, double speed_m_s, double least_force_N) {
  constexpr double kGravity_m_s2 = 9.80665;  // any start but zero serves
  double stiffness = face.stiffness_N_m(std::max(least_force_N, mass_kg * kGravity_m_s2));
  constexpr int kImpactIterations = 4;  // force and stiffness of a Hertz contact settle to per cents
  for (int i = 0; i < kImpactIterations; ++i) {
    stiffness = face.stiffness_N_m(std::max(least_force_N, speed_m_s * std::sqrt(mass_kg * stiffness)));
  }
  return std::numbers::pi * std::sqrt(mass_kg / stiffness);
}

LayeredFace side_at_pad(const LatticeParameters& product, const ParallelJawParameters& gripper) {
  return {.youngs_modulus_Pa = product.youngs_modulus_Pa,
          .poisson_ratio = product.poisson_ratio,
          .half_depth_m = 0.5 * product.size_m[0],
          .is_flat = TrueShape(product).curvatures(0) == 0,
          .flat_area_m2 = std::min(gripper.pad_size_m[0], product.size_m[1]) *
                          std::min(gripper.pad_size_m[1], product.size_m[2]),
          .radius_m = 0.25 * (product.size_m[1] + product.size_m[2]),
          .largest_patch_m2 = gripper.pad_size_m[0] * gripper.pad_size_m[1],
          .layer_per_area_Pa_m = gripper.pad_modulus_Pa / gripper.pad_thickness_m};
}

LayeredFace side_at_support(const LatticeParameters& product, const CellParameters& cell) {
  const double base_m2 = product.size_m[0] * product.size_m[1];
  return {.youngs_modulus_Pa = product.youngs_modulus_Pa,
          .poisson_ratio = product.poisson_ratio,
          .half_depth_m = 0.5 * product.size_m[2],
          .is_flat = TrueShape(product).curvatures(2) == 0,
          .flat_area_m2 = base_m2,
          .radius_m = 0.25 * (product.size_m[0] + product.size_m[1]),
          .largest_patch_m2 = base_m2,
          .layer_per_area_Pa_m = cell.support_modulus_Pa / cell.support_thickness_m};
}

/// With which the product meets the support; 0: it does not hit it.
double landing_speed_m_s(const Scenario& scenario, const LatticeParameters& product) {
  const double gravity_m_s2 = std::abs(scenario.cell.gravity_m_s2[2]);
  if (has_gripper(scenario)) return std::sqrt(2.0 * gravity_m_s2 * scenario.strategy.release_height_m);
  return std::abs(product.initial_velocity_m_s[2]);
}

double network_contact_time_s(const NetworkParameters& network) {
  double mass_kg = 0.0;
  double stiffness_N_m = 0.0;
  for (const NetworkParticle& particle : network.particle) {
    mass_kg += particle.mass_kg;
    stiffness_N_m += particle.contact_stiffness_N_m;
  }
  return stiffness_N_m > 0.0 ? std::numbers::pi * std::sqrt(mass_kg / stiffness_N_m) : kNever;
}

}  // namespace

double finger_contact_time_s(const Scenario& scenario) {
  const auto* product = std::get_if<LatticeParameters>(&scenario.product);
  const auto* jaw = parallel_jaw(scenario);
  if (jaw == nullptr || product == nullptr) return kNever;
  return half_period_s(side_at_pad(*product, *jaw), jaw->finger_mass_kg, scenario.strategy.approach_speed_m_s,
                       scenario.strategy.grip_force_N);
}

double support_contact_time_s(const Scenario& scenario) {
  if (!scenario.cell.support) return kNever;
  const auto* product = std::get_if<LatticeParameters>(&scenario.product);
  if (product == nullptr) return network_contact_time_s(std::get<NetworkParameters>(scenario.product));
  const double speed_m_s = landing_speed_m_s(scenario, *product);
  if (!(speed_m_s > 0.0)) return kNever;
  const double mass_kg = lattice_mass_kg(*product);
  return half_period_s(side_at_support(*product, scenario.cell), mass_kg, speed_m_s,
                       mass_kg * std::abs(scenario.cell.gravity_m_s2[2]));
}

double contact_time_s(const Scenario& scenario) {
  return std::min(finger_contact_time_s(scenario), support_contact_time_s(scenario));
}

}  // namespace unbruised

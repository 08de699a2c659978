#include "core/scenario/product.hpp"

#include <algorithm>

#include "core/scenario/lattice_cells.hpp"
#include "core/scenario/relaxation.hpp"

namespace unbruised {
namespace {

std::optional<TrueShape> shape_of(const LatticeParameters& p) { return TrueShape(p); }
std::optional<TrueShape> shape_of(const NetworkParameters&) { return std::nullopt; }

double mass_of(const LatticeParameters& p) { return lattice_mass_kg(p); }
double mass_of(const NetworkParameters& p) {
  double mass_kg = 0.0;
  for (const NetworkParticle& particle : p.particle) mass_kg += particle.mass_kg;
  return mass_kg;
}

std::optional<std::array<double, 3>> extents_of(const LatticeParameters& p) { return p.size_m; }
std::optional<std::array<double, 3>> extents_of(const NetworkParameters&) { return std::nullopt; }

std::optional<double> reach_of(const LatticeParameters& p, const std::array<double, 3>& direction) {
  return TrueShape(p).reach_m(direction);
}
std::optional<double> reach_of(const NetworkParameters&, const std::array<double, 3>&) { return std::nullopt; }

std::optional<double> yield_stress_of(const LatticeParameters& p) { return p.yield_stress_Pa; }
std::optional<double> yield_stress_of(const NetworkParameters&) { return std::nullopt; }

/// What the product's own keys say, as if it were a layer.
ProductLayer own_material(const LatticeParameters& p) {
  ProductLayer own;
  own.youngs_modulus_Pa = p.youngs_modulus_Pa;
  own.poisson_ratio = p.poisson_ratio;
  own.yield_stress_Pa = p.yield_stress_Pa;
  own.tangent_modulus_Pa = p.tangent_modulus_Pa;
  return own;
}

std::optional<YieldLaw> law_of(const LatticeParameters& p, std::size_t material) {
  const ProductLayer part = material == 0 ? own_material(p) : p.layer[material - 1];
  if (!part.yield_stress_Pa || !part.tangent_modulus_Pa) return std::nullopt;
  const double E = part.youngs_modulus_Pa, E_t = *part.tangent_modulus_Pa;
  const double instantaneous_Pa = material == 0 ? instantaneous_modulus_Pa(p) : instantaneous_modulus_Pa(p, E);
  return YieldLaw{*part.yield_stress_Pa, E * E_t / (E - E_t),
                  0.5 * instantaneous_Pa / (1.0 + part.poisson_ratio.value_or(p.poisson_ratio))};
}
std::optional<YieldLaw> law_of(const NetworkParameters&, std::size_t) { return std::nullopt; }

bool yields(const LatticeParameters& p) {
  return p.yield_stress_Pa ||
         std::ranges::any_of(p.layer, [](const ProductLayer& layer) { return layer.yield_stress_Pa.has_value(); });
}
bool yields(const NetworkParameters& p) {
  return std::any_of(p.spring.begin(), p.spring.end(),
                     [](const NetworkSpring& spring) { return spring.yield_force_N.has_value(); });
}

bool is_loaded(const LatticeParameters&) { return false; }
bool is_loaded(const NetworkParameters& p) { return !p.load.empty(); }

}  // namespace

double product_friction(const ProductParameters& product) {
  return std::visit([](const auto& kind) { return kind.friction; }, product);
}

double product_mass_kg(const ProductParameters& product) {
  return std::visit([](const auto& p) { return mass_of(p); }, product);
}

std::optional<TrueShape> true_shape(const ProductParameters& product) {
  return std::visit([](const auto& kind) { return shape_of(kind); }, product);
}

std::optional<std::array<double, 3>> shape_extents_m(const ProductParameters& product) {
  return std::visit([](const auto& kind) { return extents_of(kind); }, product);
}

std::optional<double> shape_reach_m(const ProductParameters& product, const std::array<double, 3>& direction) {
  return std::visit([&](const auto& kind) { return reach_of(kind, direction); }, product);
}

std::optional<double> yield_stress_Pa(const ProductParameters& product) {
  return std::visit([](const auto& kind) { return yield_stress_of(kind); }, product);
}

std::optional<YieldLaw> yield_law(const ProductParameters& product, std::size_t material) {
  return std::visit([material](const auto& kind) { return law_of(kind, material); }, product);
}

bool can_yield(const ProductParameters& product) {
  return std::visit([](const auto& kind) { return yields(kind); }, product);
}

bool can_flow(const ProductParameters& product) {
  return std::visit([](const auto& kind) { return flows(kind); }, product);
}

bool starts_in_the_air(const LatticeParameters& product) {
  const std::array<double, 3> none{};
  return product.initial_spin_rad_s != none || product.initial_rotation_rad != none ||
         product.initial_height_m > 0.0;
}

bool starts_in_the_air(const ProductParameters& product) {
  const auto* lattice = std::get_if<LatticeParameters>(&product);
  return lattice != nullptr && starts_in_the_air(*lattice);
}

const NetworkLoad* first_load(const ProductParameters& product) {
  const auto* network = std::get_if<NetworkParameters>(&product);
  return network != nullptr && !network->load.empty() ? &network->load.front() : nullptr;
}

bool has_loads(const ProductParameters& product) {
  return std::visit([](const auto& kind) { return is_loaded(kind); }, product);
}

}  // namespace unbruised

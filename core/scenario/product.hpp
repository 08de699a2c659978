#pragma once

/// @file
/// What everybody asks of a product, whatever its kind. Another kind answers here, and whoever asks stays as he
/// is.

#include <array>
#include <optional>

#include "core/scenario/scenario.hpp"
#include "core/scenario/true_shape.hpp"

namespace unbruised {

/// Coulomb coefficient against the pads.
double product_friction(const ProductParameters& product);

/// Of all of it [kg].
double product_mass_kg(const ProductParameters& product);

/// None: it has no shape.
std::optional<TrueShape> true_shape(const ProductParameters& product);

/// Full extents of its true shape along x, y, z [m]; none: it has no shape.
std::optional<std::array<double, 3>> shape_extents_m(const ProductParameters& product);

/// How far its true shape reaches from its middle along a unit vector [m]; none: it has no shape.
std::optional<double> shape_reach_m(const ProductParameters& product, const std::array<double, 3>& direction);

/// Yield stress of its material [Pa]; none: it stays elastic, or has springs for a material.
std::optional<double> yield_stress_Pa(const ProductParameters& product);

/// Linear hardening of a material that yields.
struct YieldLaw {
  double yield_stress_Pa;
  double hardening_modulus_Pa;  ///< yield stress gained per accumulated plastic strain, E E_t / (E - E_t)
  double shear_modulus_Pa;      ///< E / (2 (1 + nu))
};
/// None: it stays elastic, or has springs for a material.
/// @param material 0: its own; i + 1: of its layer i, which it has to have
std::optional<YieldLaw> yield_law(const ProductParameters& product, std::size_t material = 0);

/// Can it yield?
bool can_yield(const ProductParameters& product);
/// Does any part of it creep under a force for as long as that lasts, and keep it?
bool can_flow(const ProductParameters& product);

/// Does it begin turned, spinning or above its support, and so at rest on nothing?
bool starts_in_the_air(const LatticeParameters& product);
bool starts_in_the_air(const ProductParameters& product);

/// Do its parameters say of forces that act on it?
bool has_loads(const ProductParameters& product);
/// The first of the written loads; null: there is none.
const NetworkLoad* first_load(const ProductParameters& product);

}  // namespace unbruised

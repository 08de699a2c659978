#include "studies/config/keys/key_fields.hpp"
#include "studies/config/keys/key_tables.hpp"

namespace unbruised::studies::key_rows {

using enum KeyType;

Table shape_keys() {
  using L = LatticeParameters;
  const Use use = Use::lattice;
  return {
      {.path = "product.use",
       .type = text,
       .meaning = "A product file, relative to this file's folder or to the configs folder; keys given here "
                  "override it."},
      {.path = "product.kind",
       .type = choice,
       .meaning = "A solid filled with a lattice, or particles and springs written out.",
       .choices = {"lattice", "network"}},
      {.path = "product.shape",
       .type = choice,
       .meaning = "True shape of the product.",
       .choices = {"box", "sphere", "ellipsoid", "cylinder", "revolution", "superellipsoid", "mesh"},
       .use = use,
       .required = true,
       .field = lattice<&L::shape>},
      {.path = "product.size_m",
       .type = numbers,
       .meaning =
           "Full extents along x (grip axis), y and z (up). A mesh brings its own, and is stretched to these "
           "where they are given.",
       .size = 3,
       .use = use,
       .required = true,
       .field = lattice<&L::size_m>},
      {.path = "product.axis",
       .type = choice,
       .meaning = "Axis of a cylinder or a solid of revolution.",
       .choices = {"x", "y", "z"},
       .use = Use::with_axis,
       .field = lattice<&L::axis>},
      {.path = "product.profile_height",
       .type = series,
       .meaning =
           "Heights of the points of a solid of revolution's profile along its axis, in any unit: size_m says "
           "how large it is. A smooth curve goes through them (twice continuously differentiable in the "
           "squared radius); a flat end has its middle and its rim at one height.",
       .use = Use::revolution,
       .field = lattice<&L::profile_height>},
      {.path = "product.profile_radius",
       .type = series,
       .meaning = "Its distances from the axis at these heights, in the same unit.",
       .use = Use::revolution,
       .field = lattice<&L::profile_radius>},
      {.path = "product.profile_file",
       .type = text,
       .meaning = "CSV file of such a profile with the columns height and radius, in place of both lists.",
       .use = Use::revolution},
      {.path = "product.exponents",
       .type = numbers,
       .meaning =
           "Of a superellipsoid: of its outline across z, and between that and z. 2 makes an ellipse, 4 nearly "
           "a rectangle with round corners.",
       .size = 2,
       .use = Use::superellipsoid,
       .field = lattice<&L::exponents>},
      {.path = "product.mesh_file",
       .type = text,
       .meaning =
           "STL, OBJ or PLY file of the product's surface: one closed mesh that looks outward, x, y and z as of "
           "the product, 200,000 triangles at most. Between its corners the surface is smooth, but for edges at "
           "which it turns by more than 40 degrees.",
       .use = Use::mesh,
       .default_words = "required with shape = \"mesh\""},
      {.path = "product.mesh_unit",
       .type = text,
       .meaning =
           "Unit of the numbers in that file, which does not say it itself: \"mm\", \"cm\", \"m\" or \"in\".",
       .use = Use::mesh,
       .default_words = "required with shape = \"mesh\""},
      {.path = "product.mesh_hash",
       .type = text,
       .meaning = "XXH3 of that file, 16 hexadecimal digits; where it is given, another file is refused. The "
                  "resolved config gives it.",
       .use = Use::mesh},
      {.path = "product.cell_size_m",
       .type = number,
       .meaning =
           "Wanted side of a lattice cell. With few of them the product is not quite itself: a slab of four "
           "cells sags 0.93 of what it should, the lowest modes of a kiwi (10 cells across) are 4 % too low; "
           "halve the cells where such a per cent decides.",
       .use = use,
       .field = lattice<&L::cell_size_m>},
      {.path = "product.mass_kg",
       .type = optional_number,
       .meaning = "Mass of the product.",
       .use = use,
       .field = lattice<&L::mass_kg>},
      {.path = "product.density_kg_m3",
       .type = optional_number,
       .meaning = "Density; times the volume of the true shape it is the mass.",
       .use = use,
       .field = lattice<&L::density_kg_m3>},
  };
}

Table material_keys() {
  using L = LatticeParameters;
  const Use use = Use::lattice;
  return {
      {.path = "product.youngs_modulus_Pa",
       .type = number,
       .meaning = "Young's modulus.",
       .use = use,
       .required = true,
       .field = lattice<&L::youngs_modulus_Pa>},
      {.path = "product.poisson_ratio",
       .type = number,
       .meaning = "Poisson's ratio.",
       .use = use,
       .field = lattice<&L::poisson_ratio>},
      {.path = "product.yield_stress_Pa",
       .type = optional_number,
       .meaning = "Yield stress in uniaxial compression; without it the product stays elastic.",
       .use = use,
       .field = lattice<&L::yield_stress_Pa>},
      {.path = "product.tangent_modulus_Pa",
       .type = optional_number,
       .meaning = "Slope of the stress-strain curve after yield.",
       .use = use,
       .field = lattice<&L::tangent_modulus_Pa>},
      {.path = "product.relaxation_time_s",
       .type = optional_number,
       .meaning = "Stiffness-proportional damping, C = relaxation_time_s K; 0: none, the product vibrates for "
                  "ever. Where no key of damping is given, loss_ratio and at_frequency_Hz have their defaults.",
       .use = use,
       .field = lattice<&L::relaxation_time_s>},
      {.path = "product.loss_ratio",
       .type = optional_number,
       .meaning = "The same damping as the loss factor at one frequency: relaxation time = loss_ratio / (2 pi "
                  "at_frequency_Hz). The default is an assumption for fruit.",
       .use = use,
       .field = lattice<&L::loss_ratio>},
      {.path = "product.at_frequency_Hz",
       .type = optional_number,
       .meaning = "The frequency at which loss_ratio holds.",
       .use = use,
       .field = lattice<&L::at_frequency_Hz>},
      {.path = "product.friction",
       .type = number,
       .meaning = "Coulomb coefficient against the pads.",
       .field = product_friction},
      {.path = "product.initial_velocity_m_s",
       .type = numbers,
       .meaning = "Velocity of the product at the start.",
       .size = 3,
       .use = use,
       .field = lattice<&L::initial_velocity_m_s>},
      {.path = "product.initial_spin_rad_s",
       .type = numbers,
       .meaning = "Angular velocity of the product at the start; it begins as deformed as a steady spin keeps it.",
       .size = 3,
       .use = use,
       .field = lattice<&L::initial_spin_rad_s>},
      {.path = "product.initial_rotation_rad",
       .type = numbers,
       .meaning = "Attitude of the product at the start, about the vector by its length.",
       .size = 3,
       .use = use,
       .field = lattice<&L::initial_rotation_rad>},
      {.path = "product.initial_height_m",
       .type = number,
       .meaning = "Height of the product's lowest place above the support at the start, from which it falls.",
       .use = use,
       .field = lattice<&L::initial_height_m>},
  };
}

}  // namespace unbruised::studies::key_rows

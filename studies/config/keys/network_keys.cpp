#include "studies/config/keys/key_fields.hpp"
#include "studies/config/keys/key_tables.hpp"

namespace unbruised::studies::key_rows {

using enum KeyType;

Table network_file_keys() {
  const Use use = Use::network;
  return {
      {.path = "product.particles_csv",
       .type = text,
       .meaning = "CSV file with one particle per row, in place of [[product.particle]].",
       .use = use},
      {.path = "product.springs_csv",
       .type = text,
       .meaning = "CSV file with one spring per row, in place of [[product.spring]].",
       .use = use},
  };
}

Table particle_keys() {
  using P = NetworkParticle;
  const Use use = Use::network;
  return {
      {.path = "product.particle[].position_m",
       .type = numbers,
       .meaning = "Place in the rest shape.",
       .size = 3,
       .use = use,
       .required = true,
       .field = particle<&P::position_m>},
      {.path = "product.particle[].mass_kg",
       .type = number,
       .meaning = "Mass of the particle.",
       .use = use,
       .field = particle<&P::mass_kg>},
      {.path = "product.particle[].fixed",
       .type = axes,
       .meaning = "Freedoms that do not move.",
       .use = use,
       .field = particle<&P::fixed>},
      {.path = "product.particle[].initial_displacement_m",
       .type = numbers,
       .meaning = "Displacement from the rest shape at the start.",
       .size = 3,
       .use = use,
       .field = particle<&P::initial_displacement_m>},
      {.path = "product.particle[].initial_velocity_m_s",
       .type = numbers,
       .meaning = "Velocity at the start.",
       .size = 3,
       .use = use,
       .field = particle<&P::initial_velocity_m_s>},
      {.path = "product.particle[].contact_stiffness_N_m",
       .type = number,
       .meaning = "Stiffness of the layer through which the particle touches the support; 0: it does not.",
       .use = Use::network_support,
       .field = particle<&P::contact_stiffness_N_m>},
  };
}

Table spring_and_load_keys() {
  using S = NetworkSpring;
  using P = NetworkLoad;
  const Use use = Use::network;
  return {
      {.path = "product.spring[].between",
       .type = integers,
       .meaning = "The two particles it joins, counted from 0 in file order.",
       .size = 2,
       .use = use,
       .required = true,
       .field = spring<&S::between>},
      {.path = "product.spring[].stiffness_N_m",
       .type = number,
       .meaning = "Stiffness along the line between its particles in the rest shape.",
       .use = use,
       .field = spring<&S::stiffness_N_m>},
      {.path = "product.spring[].damping_N_s_m",
       .type = number,
       .meaning = "Viscous damping along the same line.",
       .use = use,
       .field = spring<&S::damping_N_s_m>},
      {.path = "product.spring[].rest_length_m",
       .type = optional_number,
       .meaning = "Length without force; without it the distance of the particles.",
       .use = use,
       .field = spring<&S::rest_length_m>},
      {.path = "product.spring[].yield_force_N",
       .type = optional_number,
       .meaning = "Size of the force at first yield; without it the spring stays elastic.",
       .use = use,
       .field = spring<&S::yield_force_N>},
      {.path = "product.spring[].hardening_ratio",
       .type = number,
       .meaning = "The yield force grows by hardening_ratio x stiffness x plastic elongation.",
       .use = use,
       .field = spring<&S::hardening_ratio>},
      {.path = "product.load[].particle",
       .type = integer,
       .meaning = "The particle the force acts on.",
       .use = use,
       .required = true,
       .field = load<&P::particle>},
      {.path = "product.load[].time_s",
       .type = series,
       .meaning = "Times of the points of the force.",
       .use = use,
       .required = true,
       .note = "not decreasing; a repeated time is a jump",
       .field = load<&P::time_s>},
      {.path = "product.load[].force_N",
       .type = vector_series,
       .meaning = "The force [x, y, z] at those times; linear between them, constant outside.",
       .use = use,
       .required = true,
       .field = load<&P::force_N>},
  };
}

}  // namespace unbruised::studies::key_rows

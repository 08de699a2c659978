#include "studies/config/keys/key_fields.hpp"
#include "studies/config/keys/key_tables.hpp"

namespace unbruised::studies::key_rows {

using enum KeyType;

Table relaxation_keys() {
  using L = LatticeParameters;
  const Use use = Use::lattice;
  return {
      {.path = "product.prony_modulus",
       .type = series,
       .meaning = "Shares of the instantaneous modulus that fade while the product is held deformed, up to six: a "
                  "generalized Maxwell model. Where they add up to 1 it flows without end.",
       .use = use,
       .field = lattice<&L::prony_modulus>},
      {.path = "product.prony_time_s",
       .type = series,
       .meaning = "The times in which they fade to 1/e.",
       .use = use,
       .field = lattice<&L::prony_time_s>},
      {.path = "product.prony_from",
       .type = choice,
       .meaning = "Whether youngs_modulus_Pa is the instantaneous modulus or what is left of it in the long term.",
       .choices = {"instantaneous", "long term"},
       .use = use,
       .field = lattice<&L::prony_from>},
      {.path = "product.burgers_flow_time_s",
       .type = optional_number,
       .meaning =
           "In place of prony_modulus, a Burgers model: the time in which a lasting stress makes the product "
           "flow by as much as it yields at once, c1 / k1. This stays.",
       .use = use,
       .field = lattice<&L::burgers_flow_time_s>},
      {.path = "product.burgers_recovery_modulus",
       .type = optional_number,
       .meaning = "Modulus of what creeps and recovers, over the instantaneous one, k2 / k1.",
       .use = use,
       .field = lattice<&L::burgers_recovery_modulus>},
      {.path = "product.burgers_recovery_time_s",
       .type = optional_number,
       .meaning = "The time of this creep and recovery, c2 / k2.",
       .use = use,
       .field = lattice<&L::burgers_recovery_time_s>},
  };
}

Table spring_relaxation_keys() {
  using S = NetworkSpring;
  const Use use = Use::network;
  return {
      {.path = "product.spring[].prony_modulus",
       .type = series,
       .meaning = "Shares of its instantaneous stiffness that fade, up to six.",
       .use = use,
       .field = spring<&S::prony_modulus>},
      {.path = "product.spring[].prony_time_s",
       .type = series,
       .meaning = "The times in which they fade to 1/e.",
       .use = use,
       .field = spring<&S::prony_time_s>},
      {.path = "product.spring[].prony_from",
       .type = choice,
       .meaning = "Whether stiffness_N_m is the instantaneous stiffness or what is left of it in the long term.",
       .choices = {"instantaneous", "long term"},
       .use = use,
       .field = spring<&S::prony_from>},
      {.path = "product.spring[].burgers_flow_N_s_m",
       .type = optional_number,
       .meaning = "In place of prony_modulus, a Burgers model: the dashpot c1 in series with the spring.",
       .use = use,
       .field = spring<&S::burgers_flow_N_s_m>},
      {.path = "product.spring[].burgers_recovery_N_m",
       .type = optional_number,
       .meaning = "The spring k2 of what creeps and recovers.",
       .use = use,
       .field = spring<&S::burgers_recovery_N_m>},
      {.path = "product.spring[].burgers_recovery_N_s_m",
       .type = optional_number,
       .meaning = "The dashpot c2 beside that spring.",
       .use = use,
       .field = spring<&S::burgers_recovery_N_s_m>},
  };
}

}  // namespace unbruised::studies::key_rows

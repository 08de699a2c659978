#include "studies/config/keys/key_fields.hpp"
#include "studies/config/keys/key_tables.hpp"

namespace unbruised::studies::key_rows {

using enum KeyType;

Table limit_keys() {
  using M = LimitParameters;
  const Use use = Use::gripper;
  return {
      {.path = "limits.damage",
       .type = choice,
       .meaning = "Is damage judged by the limits below, or deliberately not looked at?",
       .choices = {"judged", "not considered"},
       .note = "\"not considered\" has to be written where no limit can act, for every kind that judges damage",
       .field = limits<&M::damage>},
      {.path = "limits.permanent_set_m",
       .type = optional_number,
       .meaning = "Damage: largest permanent_set_max_m.",
       .field = limits<&M::permanent_set_m>},
      {.path = "limits.plastic_strain",
       .type = optional_number,
       .meaning = "Damage: largest plastic_strain_max; also the strain from which a cell counts as bruised.",
       .field = limits<&M::plastic_strain>},
      {.path = "limits.bruised_volume_m3",
       .type = optional_number,
       .meaning = "Damage: largest bruised_volume_m3.",
       .use = Use::lattice,
       .field = limits<&M::bruised_volume_m3>},
      {.path = "limits.peak_pressure_Pa",
       .type = optional_number,
       .meaning = "Damage: largest peak_pressure_Pa.",
       .use = Use::lattice,
       .field = limits<&M::peak_pressure_Pa>},
      {.path = "limits.absorbed_energy_J",
       .type = optional_number,
       .meaning = "Damage: largest absorbed_energy_J.",
       .field = limits<&M::absorbed_energy_J>},
      {.path = "limits.finger_force_N",
       .type = optional_number,
       .meaning = "Damage: largest peak_finger_force_N; for products with nothing but a measured force.",
       .use = use,
       .field = limits<&M::finger_force_N>},
      {.path = "limits.contact_yield_ratio",
       .type = optional_number,
       .meaning = "Damage: largest contact_yield_ratio_max (1: first yield under the contact).",
       .use = Use::lattice,
       .note = "default where a yield stress is known: 1",
       .field = limits<&M::contact_yield_ratio>},
      {.path = "limits.slip_m",
       .type = number,
       .meaning = "A longer slip_max_m makes the outcome 'slipped'.",
       .use = use,
       .field = limits<&M::slip_m>},
      {.path = "limits.slip_rad",
       .type = number,
       .meaning = "A larger slip_max_rad makes the outcome 'slipped'.",
       .use = use,
       .field = limits<&M::slip_rad>},
      {.path = "limits.place_error_m",
       .type = optional_number,
       .meaning = "A larger place_error_m makes the outcome 'misplaced'.",
       .use = use,
       .field = limits<&M::place_error_m>},
      {.path = "limits.place_attitude_rad",
       .type = optional_number,
       .meaning = "A larger place_attitude_rad makes the outcome 'misplaced'.",
       .use = use,
       .field = limits<&M::place_attitude_rad>},
  };
}

}  // namespace unbruised::studies::key_rows

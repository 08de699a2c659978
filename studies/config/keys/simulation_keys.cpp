#include "studies/config/keys/key_fields.hpp"
#include "studies/config/keys/key_tables.hpp"

namespace unbruised::studies::key_rows {

using enum KeyType;

Table simulation_keys() {
  using S = SimulationParameters;
  return {
      {.path = "simulation.time_step_s",
       .type = number,
       .meaning = "Time step. Where it is not given, one is chosen for the whole study: 20 steps in the shortest "
                  "contact that any scenario may have, rounded down to two digits, 0.1 ms to 1 ms.",
       .default_words = "chosen by the shortest contact",
       .field = simulation<&S::time_step_s>},
      {.path = "simulation.theta",
       .type = number,
       .meaning = "Wilson's theta; from 1.37 on the method is stable for every step.",
       .field = simulation<&S::theta>},
      {.path = "simulation.duration_s",
       .type = optional_number,
       .meaning = "Length of the run; with a gripper its phases fix it.",
       .use = Use::not_gripper,
       .field = simulation<&S::duration_s>},
      {.path = "simulation.initial_acceleration",
       .type = choice,
       .meaning = "Acceleration at the start of a network: from the equations of motion, or zero.",
       .choices = {"consistent", "zero"},
       .use = Use::network,
       .field = simulation<&S::initial_acceleration>},
      {.path = "simulation.trace_interval_s",
       .type = optional_number,
       .meaning = "Wanted time between rows of the trace; without it every step.",
       .field = simulation<&S::trace_interval_s>},
      {.path = "simulation.pressure_patch_m",
       .type = number,
       .meaning = "Side of the square patch over which peak_pressure_Pa averages.",
       .use = Use::lattice,
       .field = simulation<&S::pressure_patch_m>},
      {.path = "simulation.max_strain",
       .type = number,
       .meaning =
           "A larger strain of a cell (the root of the sum of its squared components) ends the run as "
           "out_of_range. "
           "It guards against a product that is squeezed flat, not the last per cent: strains are taken as "
           "small. A kiwi of 50 mm that is pressed by 4 mm a side passes, with its force right within 1.6 %, but "
           "with finite strains its permanent set would be 17 to 33 % larger from 12 N on.",
       .use = Use::lattice,
       .field = simulation<&S::max_strain>},
      {.path = "simulation.max_rotation_rad",
       .type = number,
       .meaning =
           "A larger rotation of the product ends the run as out_of_range. A product that spins or is "
           "tilted may turn by any angle, about the grip axis between the pads too; of it the rotation of a "
           "cell against the whole and the lean against the pads are meant.",
       .use = Use::lattice,
       .field = simulation<&S::max_rotation_rad>},
      {.path = "simulation.contact_set",
       .type = choice,
       .meaning =
           "Which places of the product can touch the cell. \"pads and support\": the bottom of a product that "
           "stays "
           "upright; \"six sides\": what lies within 15 % of the poles of its six sides; \"whole surface\": any "
           "place, so that it can roll, tip and lean. \"automatic\": the first, unless the product falls, is put "
           "down "
           "on another side, or [[cell.surface]] lists something.",
       .choices = {"automatic", "pads and support", "six sides", "whole surface"},
       .use = Use::lattice,
       .field = simulation<&S::contact_set>},
      {.path = "simulation.levels",
       .type = choice,
       .meaning =
           "Which steps a run takes. \"auto\": time_step_s where something happens, twice that while the product "
           "is "
           "pressed or put down, and up to eight times, at most 6 ms, while the fingers only approach or the "
           "product "
           "is merely carried; the scenario itself decides at the end of each step. It serves a product that "
           "stays "
           "upright between the flat pads of two fingers, without sensors, guards, belts or listed surfaces; all "
           "others take time_step_s throughout, as with \"off\".",
       .choices = {"auto", "off"},
       .use = Use::gripper,
       .field = simulation<&S::levels>},
      {.path = "simulation.body",
       .type = choice,
       .meaning =
           "How the product's motion is computed. \"full\": every particle. \"modes\": its mode_count slowest "
           "modes of vibration, in axes that go with a product that turns; what they leave out answers at once, "
           "so "
           "that statics are those of the full body, at a fraction of the time. It serves a lattice that does not "
           "creep for ever and is not seen by range sensors; it does not flow within: permanent set, plastic "
           "strain, bruises and absorbed energy are those below the contact patches alone. All others are "
           "computed with every particle, which `check` and the run say.",
       .choices = {"full", "modes"},
       .use = Use::lattice,
       .field = simulation<&S::body>},
      {.path = "simulation.mode_count",
       .type = integer,
       .meaning =
           "How many modes the product deforms in, with body = \"modes\"; its six rigid motions are extra, and "
           "with 0 every particle moves. `check` says what share of its give under a pad they leave out.",
       .use = Use::lattice,
       .field = simulation<&S::mode_count>},
  };
}

}  // namespace unbruised::studies::key_rows

#include "studies/config/keys/key_fields.hpp"
#include "studies/config/keys/key_tables.hpp"

namespace unbruised::studies::key_rows {

using enum KeyType;

Table pad_keys() {
  using P = PadParameters;
  const Use use = Use::gripper;
  return {
      {.path = "gripper.pad.kind",
       .type = choice,
       .meaning = "Is each pad a rigid plate with a compliant layer, or a body of its own, bonded to its finger?",
       .choices = {"layer", "lattice"},
       .use = use,
       .field = pad<&P::kind>},
      {.path = "gripper.pad.shape",
       .type = choice,
       .meaning = "Form of the pads' faces.",
       .choices = {"flat", "cylinder", "v_groove", "sphere", "profile"},
       .use = use,
       .field = pad<&P::shape>},
      {.path = "gripper.pad.along",
       .type = choice,
       .meaning = "Direction in which a cylinder, a groove or a profile is straight.",
       .choices = {"y", "z"},
       .use = use,
       .field = pad<&P::along>},
      {.path = "gripper.pad.radius_m",
       .type = optional_number,
       .meaning = "Of a cylinder or sphere: positive where it bulges towards the product, negative of a cradle.",
       .use = use,
       .field = pad<&P::radius_m>},
      {.path = "gripper.pad.half_angle_rad",
       .type = optional_number,
       .meaning = "Of a V groove: between each of its faces and the plane in its middle.",
       .use = use,
       .field = pad<&P::half_angle_rad>},
      {.path = "gripper.pad.profile_place_m",
       .type = series,
       .meaning = "Places across a profile, from the middle of the pad.",
       .use = use,
       .field = pad<&P::profile_place_m>},
      {.path = "gripper.pad.profile_height_m",
       .type = series,
       .meaning = "Height of the face towards the product at these places; linear between them.",
       .use = use,
       .field = pad<&P::profile_height_m>},
      {.path = "gripper.pad.law_depth_m",
       .type = series,
       .meaning = "Depths at which the force of a fingertip on a flat plate was measured.",
       .use = use,
       .field = pad<&P::law_depth_m>},
      {.path = "gripper.pad.law_force_N",
       .type = series,
       .meaning = "Force of the fingertip at these depths.",
       .use = use,
       .field = pad<&P::law_force_N>},
      {.path = "gripper.pad.law_coefficients",
       .type = series,
       .meaning = "The same law as a polynomial: factors of depth, depth squared and so on, in N and m.",
       .use = use,
       .field = pad<&P::law_coefficients>},
      {.path = "gripper.pad.cell_size_m",
       .type = optional_number,
       .meaning = "Side of the cells of a lattice pad.",
       .use = use,
       .field = pad<&P::cell_size_m>},
      {.path = "gripper.pad.density_kg_m3",
       .type = number,
       .meaning = "Density of a lattice pad.",
       .use = use,
       .field = pad<&P::density_kg_m3>},
  };
}

}  // namespace unbruised::studies::key_rows

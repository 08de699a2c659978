#include "studies/config/keys/key_fields.hpp"
#include "studies/config/keys/key_tables.hpp"

namespace unbruised::studies::key_rows {

using enum KeyType;

Table finger_and_pad_keys() {
  using G = ParallelJawParameters;
  const Use use = Use::gripper;
  return {
      {.path = "gripper.use",
       .type = text,
       .meaning = "A gripper file, relative to this file's folder or to the configs folder; keys given here "
                  "override it."},
      {.path = "gripper.kind",
       .type = choice,
       .meaning = "Two driven fingers with flat pads that face each other.",
       .choices = {"parallel_jaw"},
       .use = use,
       .field = gripper_kind},
      {.path = "gripper.finger_mass_kg",
       .type = number,
       .meaning = "Moving mass of each finger.",
       .use = use,
       .field = parallel_jaw<&G::finger_mass_kg>},
      {.path = "gripper.stroke_m",
       .type = number,
       .meaning = "How far each finger can travel inwards from its starting place; it comes to rest against a "
                  "stop there.",
       .use = use,
       .field = parallel_jaw<&G::stroke_m>},
      {.path = "gripper.pad_size_m",
       .type = numbers,
       .meaning = "Extents of a pad along y and z.",
       .size = 2,
       .use = use,
       .field = parallel_jaw<&G::pad_size_m>},
      {.path = "gripper.pad_thickness_m",
       .type = number,
       .meaning = "Thickness of the pad's compliant layer.",
       .use = use,
       .field = parallel_jaw<&G::pad_thickness_m>},
      {.path = "gripper.pad_modulus_Pa",
       .type = number,
       .meaning = "Young's modulus of the layer; its stiffness per area is modulus / thickness, of rubber more.",
       .use = use,
       .field = parallel_jaw<&G::pad_modulus_Pa>},
      {.path = "gripper.pad_poisson_ratio",
       .type = number,
       .meaning =
           "Of rubber that is bonded to the finger, 0.49 or so: it cannot shrink where it is pressed, which "
           "makes it two to four times as stiff below a fruit as its modulus alone. 0: springs, as thin foam.",
       .use = use,
       .field = parallel_jaw<&G::pad_poisson_ratio>},
      {.path = "gripper.pad_bulge",
       .type = choice,
       .meaning =
           "May the pressed layer move along the product, or does it stick to it and is stiffer still? Asked "
           "of rubber only.",
       .choices = {"free", "held"},
       .use = use,
       .field = parallel_jaw<&G::pad_bulge>},
      {.path = "gripper.pad_edge_radius_m",
       .type = number,
       .meaning =
           "Radius of the edges of a pad's face. Asked where a pad that ends within a flat or straight face "
           "begins to mark it.",
       .use = use,
       .field = parallel_jaw<&G::pad_edge_radius_m>},
      {.path = "gripper.pad_relaxation_time_s",
       .type = number,
       .meaning = "Kelvin-Voigt relaxation time of the layer; 0: it bounces for ever. The default is a loss "
                  "ratio of 0.2 at 50 Hz: rubber loses 0.1 to 0.3.",
       .use = use,
       .field = parallel_jaw<&G::pad_relaxation_time_s>},
  };
}

Table drive_keys() {
  using G = ParallelJawParameters;
  const Use use = Use::gripper;
  return {
      {.path = "gripper.drive_gain_N_s_m",
       .type = number,
       .meaning = "Speed gain: drive force = clamp(gain x (wanted - actual speed), +-limit).",
       .use = use,
       .field = parallel_jaw<&G::drive_gain_N_s_m>},
      {.path = "gripper.drive_viscous_N_s_m",
       .type = number,
       .meaning = "Viscous friction of the finger's guide.",
       .use = use,
       .field = parallel_jaw<&G::drive_viscous_N_s_m>},
      {.path = "gripper.max_force_N",
       .type = number,
       .meaning = "The largest force the drive can give.",
       .use = use,
       .field = parallel_jaw<&G::max_force_N>},
      {.path = "gripper.max_speed_m_s",
       .type = number,
       .meaning = "The largest finger speed the drive can give.",
       .use = use,
       .field = parallel_jaw<&G::max_speed_m_s>},
      {.path = "gripper.coupling",
       .type = choice,
       .meaning = "Do both fingers stay at equal distance from the palm's centre, or is each driven alone?",
       .choices = {"centric", "independent"},
       .use = use,
       .field = parallel_jaw<&G::coupling>},
      {.path = "gripper.min_force_N",
       .type = number,
       .meaning = "The least force the drive holds: no window or set-point lies below it.",
       .use = use,
       .field = parallel_jaw<&G::min_force_N>},
      {.path = "gripper.force_accuracy",
       .type = number,
       .meaning =
           "How far the force that acts may lie from the one that is set, relative (0.1: 10 %); set-points leave "
           "room for it.",
       .use = use,
       .field = parallel_jaw<&G::force_accuracy>},
      {.path = "gripper.force_step_N",
       .type = number,
       .meaning = "Forces that can be set are multiples of it; 0: any force.",
       .use = use,
       .field = parallel_jaw<&G::force_step_N>},
      {.path = "gripper.opening_m",
       .type = optional_number,
       .meaning = "Distance of the pad faces when the gripper is open.",
       .use = use,
       .note = "absent: as wide as the product and the approach gaps need",
       .field = parallel_jaw<&G::opening_m>},
      {.path = "gripper.force_rate_Hz",
       .type = optional_number,
       .meaning = "How often the force of a finger is measured, which a guard by force waits for.",
       .use = Use::force_guard,
       .note = "absent: at all times",
       .field = parallel_jaw<&G::force_rate_Hz>},
  };
}

}  // namespace unbruised::studies::key_rows

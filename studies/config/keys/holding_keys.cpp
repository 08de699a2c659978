#include "studies/config/keys/key_fields.hpp"
#include "studies/config/keys/key_tables.hpp"

namespace unbruised::studies::key_rows {

using enum KeyType;

Table holding_keys() {
  using G = ParallelJawParameters;
  const Use use = Use::gripper;
  return {
      {.path = "gripper.hold",
       .type = choice,
       .meaning =
           "What keeps the fingers pressed once the force has risen: their drives, or a lock that holds their "
           "places from the end of settle_s, when the lift begins, to the release.",
       .choices = {"force", "position"},
       .use = use,
       .field = parallel_jaw<&G::hold>},
      {.path = "gripper.lock_stiffness_N_m",
       .type = optional_number,
       .meaning = "Stiffness with which a lock holds each finger to its place.",
       .use = Use::position_hold,
       .note = "absent: a lock does not give way",
       .field = parallel_jaw<&G::lock_stiffness_N_m>},
      {.path = "gripper.curve_speed_m_s",
       .type = series,
       .meaning = "Speeds of a finger at which the largest force of its drive is known.",
       .use = use,
       .note = "absent: max_force_N at every speed",
       .field = parallel_jaw<&G::curve_speed_m_s>},
      {.path = "gripper.curve_force_N",
       .type = series,
       .meaning = "Largest force of the drive at these speeds; linear between them, the last beyond.",
       .use = use,
       .field = parallel_jaw<&G::curve_force_N>},
  };
}

Table data_sheet_keys() {
  using G = ParallelJawParameters;
  const Use use = Use::gripper;
  return {
      {.path = "gripper.payload_kg",
       .type = optional_number,
       .meaning = "Largest mass that the maker lets the gripper carry by friction; for the sizing sheet.",
       .use = use,
       .field = parallel_jaw<&G::payload_kg>},
      {.path = "gripper.jaw_moment_N_m",
       .type = optional_number,
       .meaning = "Largest moment that the maker lets act on a jaw; for the sizing sheet.",
       .use = use,
       .field = parallel_jaw<&G::jaw_moment_N_m>},
      {.path = "gripper.finger_length_m",
       .type = optional_number,
       .meaning =
           "Distance of the pads' middle from the jaw's guide, the lever of its moment; for the sizing sheet.",
       .use = use,
       .field = parallel_jaw<&G::finger_length_m>},
      {.path = "gripper.safety_factor",
       .type = optional_number,
       .meaning = "Safety factor of the maker's rule for the grip force; for the sizing sheet.",
       .use = use,
       .field = parallel_jaw<&G::safety_factor>},
  };
}

Table finger_list_keys() {
  using F = FingerParameters;
  const Use use = Use::gripper;
  return {
      {.path = "gripper.finger[].angle_rad",
       .type = optional_number,
       .meaning = "Where the finger stands about the vertical, from x; it closes towards the middle.",
       .use = use,
       .field = finger<&F::angle_rad>},
      {.path = "gripper.finger[].direction",
       .type = maybe_numbers,
       .meaning = "In which the finger closes; of any length.",
       .size = 3,
       .use = use,
       .field = finger<&F::direction>},
      {.path = "gripper.finger[].offset_m",
       .type = numbers,
       .meaning = "From the middle of the grip to the line on which the middle of its pad moves.",
       .size = 3,
       .use = use,
       .field = finger<&F::offset_m>},
  };
}

}  // namespace unbruised::studies::key_rows

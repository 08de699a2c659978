#include "studies/config/keys/key_fields.hpp"
#include "studies/config/keys/key_tables.hpp"

namespace unbruised::studies::key_rows {

using enum KeyType;

Table support_keys() {
  using C = CellParameters;
  return {
      {.path = "cell.gravity_m_s2",
       .type = numbers,
       .meaning = "Gravity as a vector.",
       .size = 3,
       .field = cell<&C::gravity_m_s2>},
      {.path = "cell.support",
       .type = boolean,
       .meaning = "Is there a support plane z = 0?",
       .note = "default for networks: false",
       .field = cell<&C::support>},
      {.path = "cell.support_friction",
       .type = number,
       .meaning = "Coulomb coefficient against the support.",
       .use = Use::support,
       .field = cell<&C::support_friction>},
      {.path = "cell.support_modulus_Pa",
       .type = number,
       .meaning = "Young's modulus of the support's compliant layer.",
       .use = Use::lattice_support,
       .field = cell<&C::support_modulus_Pa>},
      {.path = "cell.support_thickness_m",
       .type = number,
       .meaning = "Thickness of that layer.",
       .use = Use::lattice_support,
       .field = cell<&C::support_thickness_m>},
      {.path = "cell.support_poisson_ratio",
       .type = number,
       .meaning = "Of a mat of rubber that is bonded to its table, 0.49 or so; 0: springs. As that of a pad.",
       .use = Use::lattice_support,
       .field = cell<&C::support_poisson_ratio>},
      {.path = "cell.support_relaxation_time_s",
       .type = number,
       .meaning = "Relaxation time of that layer; 0: it bounces for ever. The default is a loss ratio of 0.2 at "
                  "50 Hz; under a network it is 0.",
       .use = Use::support,
       .field = cell<&C::support_relaxation_time_s>},
  };
}

Table path_keys() {
  using C = CellParameters;
  const Use use = Use::gripper;
  return {
      {.path = "cell.approach_gap_m",
       .type = optional_number,
       .meaning = "Way from each pad to the nearest point of the product at the start.",
       .use = use,
       .note = "absent: what gripper.opening_m leaves on either side of the product, without an opening 0.005",
       .field = cell<&C::approach_gap_m>},
      {.path = "cell.grip_height_m",
       .type = number,
       .meaning = "Height of the pads' centres above the product's centre.",
       .use = use,
       .field = cell<&C::grip_height_m>},
      {.path = "cell.grip_offset_m",
       .type = number,
       .meaning = "Offset of the pads' centres from the product's centre along y, across the grip axis.",
       .use = use,
       .field = cell<&C::grip_offset_m>},
      {.path = "cell.lift_height_m",
       .type = number,
       .meaning = "Height of the lift; 0: none.",
       .use = use,
       .field = cell<&C::lift_height_m>},
      {.path = "cell.transfer_m",
       .type = numbers,
       .meaning = "Horizontal way along x (the grip axis) and y (across it).",
       .size = 2,
       .use = use,
       .field = cell<&C::transfer_m>},
      {.path = "cell.place_height_m",
       .type = number,
       .meaning = "Height of the target plane above the support.",
       .use = use,
       .field = cell<&C::place_height_m>},
      {.path = "cell.place_velocity_m_s",
       .type = numbers,
       .meaning =
           "Velocity of the target along x and y, which was at transfer_m when the run began: a belt to place on.",
       .size = 2,
       .use = use,
       .field = cell<&C::place_velocity_m_s>},
      {.path = "cell.target_plane",
       .type = boolean,
       .meaning =
           "Is there a plane at place_height_m, like the support, once the product is lifted? false: only what "
           "[[cell.surface]] lists is there then.",
       .use = use,
       .field = cell<&C::target_plane>},
      {.path = "cell.stop_deceleration_m_s2",
       .type = number,
       .meaning = "Deceleration with which an emergency stop brings the palm to rest, along its path; an arm "
                  "stops as hard as its joints can.",
       .use = Use::stop,
       .note = "the default is assumed: arms stop with 5 to 20, as loaded and fast as they are",
       .field = cell<&C::stop_deceleration_m_s2>},
  };
}

Table conveyor_keys() {
  using B = ConveyorParameters;
  const Use use = Use::lattice_support;
  return {
      {.path = "cell.conveyor.speed_m_s",
       .type = number,
       .meaning =
           "Speed of the belt on the support, on which the product rides: its points move, its plane does not.",
       .use = use,
       .field = conveyor<&B::speed_m_s>},
      {.path = "cell.conveyor.initial_speed_m_s",
       .type = optional_number,
       .meaning = "Speed of belt and product at the start.",
       .use = use,
       .note = "absent: 0 with an acceleration, else speed_m_s",
       .field = conveyor<&B::initial_speed_m_s>},
      {.path = "cell.conveyor.acceleration_m_s2",
       .type = optional_number,
       .meaning = "Acceleration, or braking, with which the belt gets from its initial speed to speed_m_s.",
       .use = use,
       .field = conveyor<&B::acceleration_m_s2>},
      {.path = "cell.conveyor.start_s",
       .type = number,
       .meaning = "When the belt begins to change its speed.",
       .use = use,
       .field = conveyor<&B::start_s>},
      {.path = "cell.conveyor.direction",
       .type = numbers,
       .meaning = "Where it runs, along x (the grip axis) and y; of any length.",
       .size = 2,
       .use = use,
       .field = conveyor<&B::direction>},
      {.path = "cell.conveyor.length_m",
       .type = optional_number,
       .meaning =
           "Way from the product's starting place to the end of the belt. A product that gets there before it is "
           "lifted ends the run as out_of_range.",
       .use = use,
       .note = "absent: the belt does not end",
       .field = conveyor<&B::length_m>},
  };
}

}  // namespace unbruised::studies::key_rows

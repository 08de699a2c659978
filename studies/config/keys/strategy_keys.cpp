#include "studies/config/keys/key_fields.hpp"
#include "studies/config/keys/key_tables.hpp"

namespace unbruised::studies::key_rows {

using enum KeyType;

Table grip_keys() {
  using S = StrategyParameters;
  const Use use = Use::gripper;
  return {
      {.path = "strategy.approach_speed_m_s",
       .type = number,
       .meaning = "Closing speed of each finger.",
       .use = use,
       .field = strategy<&S::approach_speed_m_s>},
      {.path = "strategy.grip_force_N",
       .type = number,
       .meaning = "Drive force limit of each finger, so its normal force at rest.",
       .use = Use::not_window,
       .note = "a window study searches it",
       .field = strategy<&S::grip_force_N>},
      {.path = "strategy.contact_force_N",
       .type = number,
       .meaning = "Drive force limit before the first contact.",
       .use = use,
       .note = "of a window study window.from_N; lowered to it where not written",
       .field = strategy<&S::contact_force_N>},
      {.path = "strategy.grip_ramp_s",
       .type = number,
       .meaning = "Time in which the limit rises linearly to grip_force_N, from the first contact.",
       .use = use,
       .field = strategy<&S::grip_ramp_s>},
      {.path = "strategy.ramp_from_start",
       .type = boolean,
       .meaning = "Does the ramp start at t = 0 instead of at the first contact?",
       .use = use,
       .field = strategy<&S::ramp_from_start>},
      {.path = "strategy.settle_s",
       .type = number,
       .meaning = "Rest after the ramp, before the lift.",
       .use = use,
       .field = strategy<&S::settle_s>},
  };
}

Table pick_keys() {
  using S = StrategyParameters;
  const Use use = Use::gripper;
  return {
      {.path = "strategy.pick",
       .type = choice,
       .meaning = "Does the palm wait, or go with the belt from the start until the hold ends?",
       .choices = {"still", "tracking"},
       .use = use,
       .field = strategy<&S::pick>},
      {.path = "strategy.pick_offset_m",
       .type = number,
       .meaning =
           "How far along the belt's direction the palm stands from the product at the start: where a palm that "
           "waits meets it, or by how much one that tracks is off.",
       .use = use,
       .field = strategy<&S::pick_offset_m>},
      {.path = "strategy.tracking_lag_s",
       .type = number,
       .meaning = "A palm that tracks is where the belt was so long ago.",
       .use = Use::tracking,
       .field = strategy<&S::tracking_lag_s>},
  };
}

Table motion_keys() {
  using S = StrategyParameters;
  const Use use = Use::gripper;
  return {
      {.path = "strategy.profile",
       .type = choice,
       .meaning = "Motion profile of lift, transfer and lowering.",
       .choices = {"trapezoid", "minimum_jerk", "s_curve"},
       .use = use,
       .field = strategy<&S::profile>},
      {.path = "strategy.lift_acceleration_m_s2",
       .type = number,
       .meaning = "Peak acceleration of the lift's profile.",
       .use = use,
       .field = strategy<&S::lift_acceleration_m_s2>},
      {.path = "strategy.transfer_acceleration_m_s2",
       .type = optional_number,
       .meaning = "Peak acceleration of the transfer; without it the lift's.",
       .use = use,
       .field = strategy<&S::transfer_acceleration_m_s2>},
      {.path = "strategy.lower_acceleration_m_s2",
       .type = optional_number,
       .meaning = "Peak acceleration of the lowering; without it the lift's.",
       .use = use,
       .field = strategy<&S::lower_acceleration_m_s2>},
      {.path = "strategy.speed_m_s",
       .type = number,
       .meaning = "Speed limit of every phase of the path.",
       .use = use,
       .field = strategy<&S::speed_m_s>},
      {.path = "strategy.jerk_m_s3",
       .type = optional_number,
       .meaning = "Largest jerk of lift, carrying and lowering, for profile = \"s_curve\".",
       .use = use,
       .field = strategy<&S::jerk_m_s3>},
      {.path = "strategy.tilt_rad",
       .type = numbers,
       .meaning =
           "Rotation of the gripper about the centre of its pads, about the vector by its length; taken after the "
           "lift and taken back before the lowering. A product is put down as it was turned by "
           "[[strategy.waypoint]].",
       .size = 3,
       .use = use,
       .field = strategy<&S::tilt_rad>},
      {.path = "strategy.tilt_speed_rad_s",
       .type = number,
       .meaning = "Speed limit of the tilt, and of turns between waypoints.",
       .use = use,
       .field = strategy<&S::tilt_speed_rad_s>},
      {.path = "strategy.tilt_acceleration_rad_s2",
       .type = number,
       .meaning = "Peak acceleration of the tilt, and of turns between waypoints.",
       .use = use,
       .field = strategy<&S::tilt_acceleration_rad_s2>},
      {.path = "strategy.tilt_jerk_rad_s3",
       .type = optional_number,
       .meaning = "Largest jerk of turns, for profile = \"s_curve\".",
       .use = use,
       .note = "required with profile = \"s_curve\" where the palm turns",
       .field = strategy<&S::tilt_jerk_rad_s3>},
      {.path = "strategy.hold_s",
       .type = number,
       .meaning = "Rest after the lift and the tilt or the waypoints.",
       .use = use,
       .field = strategy<&S::hold_s>},
      {.path = "strategy.release_height_m",
       .type = number,
       .meaning = "Height above the target plane at which the fingers open.",
       .use = use,
       .field = strategy<&S::release_height_m>},
      {.path = "strategy.place_settle_s",
       .type = number,
       .meaning = "Rest after lowering, before the fingers open.",
       .use = use,
       .field = strategy<&S::place_settle_s>},
      {.path = "strategy.release_speed_m_s",
       .type = number,
       .meaning = "Opening speed of each finger.",
       .use = use,
       .field = strategy<&S::release_speed_m_s>},
      {.path = "strategy.recover_s",
       .type = number,
       .meaning = "Time without gripper contact before the permanent set is measured.",
       .use = use,
       .field = strategy<&S::recover_s>},
      {.path = "strategy.stop_time_s",
       .type = optional_number,
       .meaning =
           "An emergency stop so long after the start: the palm brakes along its path, fingers that hold go on "
           "holding, others stop; 0.3 s after the palm has come to rest the run ends.",
       .use = use,
       .note = "absent, or after the release has begun: no stop",
       .field = strategy<&S::stop_time_s>},
      {.path = "strategy.repeat",
       .type = integer,
       .meaning =
           "Handlings one after another, each of the product as the one before has left it: it keeps its plastic "
           "strain and its shape, is put back to where it began and comes to rest there. The first handling that "
           "does not go well is the last. Metrics are the worst of all handlings, or their sum, or what the last "
           "one shows (docs/metrics.md, \"Repeated handling\").",
       .field = strategy<&S::repeat>},
  };
}

Table waypoint_keys() {
  using W = Waypoint;
  const Use use = Use::gripper;
  return {
      {.path = "strategy.demonstration",
       .type = text,
       .meaning =
           "CSV file of a recorded demonstration in place of [[strategy.waypoint]]: columns time_s; x_m, y_m, "
           "z_m of the palm; rx_rad, ry_rad, rz_rad or qw, qx, qy, qz; closed (0 or 1); grip_force_N. Lift, "
           "waypoints, place and grip force are what it shows, where other keys do not say them.",
       .use = use},
      {.path = "strategy.demonstration_tolerance_m",
       .type = number,
       .meaning = "So far the palm may go from where the demonstration went.",
       .use = use,
       .note = "default 0.002"},
      {.path = "strategy.demonstration_tolerance_rad",
       .type = number,
       .meaning = "So far it may be turned from how it was turned there.",
       .use = use,
       .note = "default 0.03"},
      {.path = "strategy.demonstration_timing",
       .type = choice,
       .meaning = "Does each way take the time that it took at least, or as little as the limits let it?",
       .choices = {"as shown", "free"},
       .use = use,
       .note = "default \"as shown\""},
      {.path = "strategy.waypoint_file",
       .type = text,
       .meaning =
           "CSV file of waypoints in place of [[strategy.waypoint]]: columns x_m, y_m, z_m; rx_rad, ry_rad, "
           "rz_rad or qw, qx, qy, qz; time_s (since the lift ended) or speed_m_s; blend_m; wait_s.",
       .use = use},
      {.path = "strategy.waypoint[].place_m",
       .type = maybe_numbers,
       .meaning = "Place that the palm goes to after the lift and rests at: x and y as cell.transfer_m, z as "
                  "cell.lift_height_m. The transfer starts from the last one.",
       .size = 3,
       .use = use,
       .note = "absent: that of the waypoint before, at the first where the lift ends",
       .field = waypoint<&W::place_m>},
      {.path = "strategy.waypoint[].rotation_rad",
       .type = maybe_numbers,
       .meaning =
           "Rotation of the gripper there about the centre of its pads, from upright, about the vector by its "
           "length. It turns by the shortest way as it goes; the product is put down with the last rotation.",
       .size = 3,
       .use = use,
       .note = "absent: that of the waypoint before, at the first none",
       .field = waypoint<&W::rotation_rad>},
      {.path = "strategy.waypoint[].quaternion",
       .type = maybe_numbers,
       .meaning = "The same rotation as a quaternion w, x, y, z.",
       .size = 4,
       .use = use,
       .note = "in place of rotation_rad",
       .field = waypoint<&W::quaternion>},
      {.path = "strategy.waypoint[].via_m",
       .type = maybe_numbers,
       .meaning = "The palm goes there on the arc of the circle through this place, seen as place_m is.",
       .size = 3,
       .use = use,
       .note = "absent: straight",
       .field = waypoint<&W::via_m>},
      {.path = "strategy.waypoint[].blend_m",
       .type = number,
       .meaning = "The palm does not rest there but passes within so much of it, as close as its limits ask for.",
       .use = use,
       .field = waypoint<&W::blend_m>},
      {.path = "strategy.waypoint[].speed_m_s",
       .type = optional_number,
       .meaning = "Speed limit of the way there, beside strategy.speed_m_s.",
       .use = use,
       .note = "absent: strategy.speed_m_s alone",
       .field = waypoint<&W::speed_m_s>},
      {.path = "strategy.waypoint[].duration_s",
       .type = optional_number,
       .meaning = "The way there takes so long at least, from where the palm rested or would have rested.",
       .use = use,
       .note = "absent: as fast as the limits let it",
       .field = waypoint<&W::duration_s>},
      {.path = "strategy.waypoint[].wait_s",
       .type = number,
       .meaning = "Rest at the waypoint.",
       .use = use,
       .field = waypoint<&W::wait_s>},
  };
}

}  // namespace unbruised::studies::key_rows

#include <algorithm>
#include <cmath>

#include "core/scenario/conveyor.hpp"
#include "core/scenario/palm_stops.hpp"
#include "core/scenario/relaxation.hpp"
#include "core/scenario/rule_tables.hpp"
#include "core/scenario/words.hpp"

namespace unbruised {
namespace {

/// The rule where there is a gripper.
Rule gripped(Rule rule) {
  rule.check = [check = std::move(rule.check)](const Scenario& s, Violations& out) {
    if (has_gripper(s)) check(s, out);
  };
  return rule;
}

void place_below_lift(const Scenario& s, Violations& out) {
  const CellParameters& c = s.cell;
  if (!has_gripper(s) || (c.lift_height_m > 0.0 ? c.place_height_m < c.lift_height_m : c.place_height_m <= 0.0))
    return;
  add_bound(out, "cell.place_height_m", c.place_height_m, "cell.lift_height_m", c.lift_height_m,
            c.lift_height_m > 0.0 ? Strictness::below : Strictness::at_most);
}

void release_below_lift(const Scenario& s, Violations& out) {
  const double release = s.strategy.release_height_m;
  const PalmStop placing = placing_stop(s);
  const double room = placing.place_m[2] + lowest_place_m(s, placing.attitude) - s.cell.place_height_m;
  constexpr double kRounding_m = 1e-12;  // 0.1 - 0.03 is not 0.07
  if (!has_gripper(s) || room < 0.0 || release <= room + kRounding_m) return;
  out.push_back({"strategy.release_height_m", spelled(release),
                 "must be <= " +
                     std::string(s.strategy.waypoint.empty()
                                     ? "cell.lift_height_m - cell.place_height_m"
                                     : "the height of the product above the target at the last waypoint") +
                     " = " + for_people(room) + " m: the product would be lowered upwards"});
}

void belt_runs_somewhere(const Scenario& s, Violations& out) {
  const ConveyorParameters& belt = s.cell.conveyor;
  if (!(std::hypot(belt.direction[0], belt.direction[1]) > 0.0)) {
    out.push_back({"cell.conveyor.direction", "[0.0, 0.0]", "must not be zero: it says whereto the belt runs"});
  }
}

void belt_needs_support(const Scenario& s, Violations& out) {
  if (!has_belt(s.cell)) return;
  if (!s.cell.support) {
    out.push_back({"cell.conveyor.speed_m_s", spelled(s.cell.conveyor.speed_m_s),
                   "needs cell.support = true: the belt is the support's surface"});
  }
  if (!std::holds_alternative<LatticeParameters>(s.product)) {
    out.push_back({"cell.conveyor.speed_m_s", spelled(s.cell.conveyor.speed_m_s),
                   "needs a product with a shape: a network of particles does not ride on a belt"});
  }
}

void belt_can_change_speed(const Scenario& s, Violations& out) {
  const ConveyorParameters& belt = s.cell.conveyor;
  if (belt.acceleration_m_s2 || belt_start_speed_m_s(belt) == belt.speed_m_s) return;
  out.push_back({"cell.conveyor.initial_speed_m_s", spelled(*belt.initial_speed_m_s),
                 "differs from speed_m_s = " + spelled(belt.speed_m_s) +
                     ": needs cell.conveyor.acceleration_m_s2, with which the belt gets from one to the other"});
}

/// A palm that meets a moving place has to be faster than it.
void palm_keeps_up(const Scenario& s, Violations& out) {
  if (!has_gripper(s)) return;
  const double limit = s.strategy.speed_m_s;
  const auto fits = [&](double speed_m_s, std::string_view what) {
    if (limit >= kPalmRoom * speed_m_s) return;
    out.push_back({"strategy.speed_m_s", spelled(limit),
                   "must be >= " + for_people(kPalmRoom) + " x the speed of the " + std::string(what) + " = " +
                       for_people(kPalmRoom * speed_m_s) + ": the palm has to catch up with it"});
  };
  if (s.strategy.pick == PickKind::tracking) {
    fits(std::max(s.cell.conveyor.speed_m_s, belt_start_speed_m_s(s.cell.conveyor)), "belt");
  }
  fits(std::hypot(s.cell.place_velocity_m_s[0], s.cell.place_velocity_m_s[1]), "target");
}

void tracking_needs_belt(const Scenario& s, Violations& out) {
  if (!has_gripper(s) || s.strategy.pick == PickKind::still || has_belt(s.cell)) return;
  out.push_back({"strategy.pick", "\"tracking\"", "needs a belt that runs: cell.conveyor.speed_m_s > 0"});
}

void duration_known(const Scenario& s, Violations& out) {
  if (has_gripper(s) || s.simulation.duration_s) return;
  out.push_back({"simulation.duration_s", "", "missing; a study without [gripper] needs it"});
}

bool relaxes(const ProductParameters& product) {
  if (const auto* lattice = std::get_if<LatticeParameters>(&product))
    return !relaxation_branches(*lattice).empty();
  const auto* network = std::get_if<NetworkParameters>(&product);
  return network != nullptr && std::ranges::any_of(network->spring, [](const NetworkSpring& spring) {
           return !relaxation_branches(spring).empty();
         });
}

void repeated_keeps_stiffness(const Scenario& s, Violations& out) {
  if (s.strategy.repeat == 1 || !relaxes(s.product)) return;
  out.push_back(
      {"strategy.repeat", std::to_string(s.strategy.repeat),
       "must be 1 of a product that relaxes: what it remembers of one handling in the next one depends on "
       "the time between them, which nothing says"});
}

void repeated_is_not_stopped(const Scenario& s, Violations& out) {
  if (s.strategy.repeat == 1 || !s.strategy.stop_time_s) return;
  out.push_back({"strategy.repeat", std::to_string(s.strategy.repeat),
                 "must be 1 with strategy.stop_time_s: a handling that is stopped does not put the product down"});
}

}  // namespace

std::vector<Rule> motion_rules() {
  return {
      {{"strategy.repeat", "product.prony_modulus", "product.burgers_flow_time_s",
        "product.spring[].prony_modulus", "product.spring[].burgers_flow_N_s_m"},
       "1 of a product that relaxes",
       repeated_keeps_stiffness},
      {{"strategy.repeat", "strategy.stop_time_s"}, "1 with an emergency stop", repeated_is_not_stopped},
      gripped(bounded("strategy.approach_speed_m_s", "<= gripper.max_speed_m_s", "gripper.max_speed_m_s")),
      gripped(bounded("strategy.grip_force_N", "<= gripper.max_force_N", "gripper.max_force_N")),
      gripped(bounded("strategy.contact_force_N", "<= strategy.grip_force_N", "strategy.grip_force_N")),
      gripped(bounded("strategy.release_speed_m_s", "<= gripper.max_speed_m_s", "gripper.max_speed_m_s")),
      {{"cell.place_height_m", "cell.lift_height_m"}, "< lift_height_m when there is a lift", place_below_lift},
      {{"strategy.release_height_m", "cell.lift_height_m", "cell.place_height_m", "strategy.waypoint[].place_m",
        "strategy.waypoint[].rotation_rad", "strategy.waypoint[].quaternion", "cell.grip_offset_m",
        "cell.grip_height_m", "product.size_m", "product.shape", "product.axis", "product.profile_height",
        "product.profile_radius", "product.exponents"},
       "<= cell.lift_height_m - cell.place_height_m",
       release_below_lift},
      {{"cell.conveyor.direction"}, "not zero", belt_runs_somewhere},
      {{"cell.conveyor.speed_m_s", "cell.conveyor.initial_speed_m_s", "cell.conveyor.acceleration_m_s2",
        "cell.support", "product.kind"},
       "needs a lattice product on a support",
       belt_needs_support},
      {{"cell.conveyor.initial_speed_m_s", "cell.conveyor.acceleration_m_s2", "cell.conveyor.speed_m_s"},
       "= speed_m_s without an acceleration",
       belt_can_change_speed},
      {{"strategy.speed_m_s", "cell.conveyor.speed_m_s", "cell.conveyor.initial_speed_m_s",
        "cell.conveyor.acceleration_m_s2", "cell.place_velocity_m_s"},
       ">= 1.5 x the speed of a belt that is tracked and of a moving target",
       palm_keeps_up},
      {{"strategy.pick", "cell.conveyor.speed_m_s", "cell.conveyor.initial_speed_m_s",
        "cell.conveyor.acceleration_m_s2"},
       "\"tracking\" needs a belt that runs",
       tracking_needs_belt},
      {{"simulation.duration_s"}, "required without a gripper", duration_known},
      {{"simulation.duration_s", "simulation.time_step_s"},
       ">= time_step_s",
       [](const Scenario& s, Violations& out) {
         const auto& duration = s.simulation.duration_s;
         if (!duration || *duration >= s.simulation.time_step_s) return;
         out.push_back({"simulation.duration_s", spelled(*duration),
                        "must be >= simulation.time_step_s = " + spelled(s.simulation.time_step_s)});
       }},
      {{"simulation.trace_interval_s", "simulation.time_step_s"},
       ">= time_step_s",
       [](const Scenario& s, Violations& out) {
         const auto& interval = s.simulation.trace_interval_s;
         if (!interval || *interval >= s.simulation.time_step_s) return;
         out.push_back({"simulation.trace_interval_s", spelled(*interval),
                        "must be >= simulation.time_step_s = " + spelled(s.simulation.time_step_s)});
       }},
  };
}

}  // namespace unbruised

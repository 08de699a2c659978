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
  const double room = s.cell.lift_height_m - s.cell.place_height_m;
  constexpr double kRounding_m = 1e-12;  // 0.1 - 0.03 is not 0.07
  if (!has_gripper(s) || room < 0.0 || release <= room + kRounding_m) return;
  out.push_back({"strategy.release_height_m", spelled(release),
                 "must be <= cell.lift_height_m - cell.place_height_m = " + for_people(room) +
                     " m: the product would be lowered upwards"});
}

void duration_known(const Scenario& s, Violations& out) {
  if (has_gripper(s) || s.simulation.duration_s) return;
  out.push_back({"simulation.duration_s", "", "missing; a study without [gripper] needs it"});
}

}  // namespace

std::vector<Rule> motion_rules() {
  return {
      gripped(bounded("strategy.approach_speed_m_s", "<= gripper.max_speed_m_s", "gripper.max_speed_m_s")),
      gripped(bounded("strategy.grip_force_N", "<= gripper.max_force_N", "gripper.max_force_N")),
      gripped(bounded("strategy.contact_force_N", "<= strategy.grip_force_N", "strategy.grip_force_N")),
      gripped(bounded("strategy.release_speed_m_s", "<= gripper.max_speed_m_s", "gripper.max_speed_m_s")),
      {{"cell.place_height_m", "cell.lift_height_m"}, "< lift_height_m when there is a lift", place_below_lift},
      {{"strategy.release_height_m", "cell.lift_height_m", "cell.place_height_m"},
       "<= cell.lift_height_m - cell.place_height_m",
       release_below_lift},
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

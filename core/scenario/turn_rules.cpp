#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/scenario/palm_stops.hpp"
#include "core/scenario/product.hpp"
#include "core/scenario/rule_tables.hpp"
#include "core/scenario/vectors.hpp"
#include "core/scenario/words.hpp"

namespace unbruised {
namespace {

using Vector = std::array<double, 3>;

/// Of the way from stop to stop, at which the product's lowest place is looked at.
constexpr int kLooks = 32;
/// By which the length of a quaternion may differ from 1.
constexpr double kUnitRoom = 1e-6;

std::string waypoint_key(std::size_t i, std::string_view leaf) {
  return "strategy.waypoint[" + std::to_string(i) + "]." + std::string(leaf);
}

bool is_tilted(const Scenario& s) { return has_gripper(s) && length(s.strategy.tilt_rad) > 0.0; }

void tilts_with_both_fingers(const Scenario& s, Violations& out) {
  const auto* jaw = parallel_jaw(s);
  if (!is_tilted(s) || jaw == nullptr || jaw->coupling == FingerCoupling::centric) return;
  out.push_back({"strategy.tilt_rad", "", std::string(kNeedsCentric)});
}

void turns_with_both_fingers(const Scenario& s, Violations& out) {
  const auto* jaw = parallel_jaw(s);
  if (jaw == nullptr || jaw->coupling == FingerCoupling::centric) return;
  for (std::size_t i = 0; i < s.strategy.waypoint.size(); ++i) {
    const Waypoint& waypoint = s.strategy.waypoint[i];
    const bool turns = waypoint.rotation_rad && length(*waypoint.rotation_rad) > 0.0;
    if (!turns && !waypoint.quaternion) continue;
    out.push_back({waypoint_key(i, turns ? "rotation_rad" : "quaternion"), "", std::string(kNeedsCentric)});
    return;
  }
}

void by_half_a_turn(const Vector& turn_rad, const std::string& key, Violations& out) {
  if (length(turn_rad) <= kHalfTurn_rad) return;
  out.push_back({key, "", "turns by " + for_people(length(turn_rad)) + " rad; it must be <= pi in length"});
}

void turns_by_half_a_turn(const Scenario& s, Violations& out) {
  for (std::size_t i = 0; i < s.strategy.waypoint.size(); ++i) {
    if (const auto& turn = s.strategy.waypoint[i].rotation_rad)
      by_half_a_turn(*turn, waypoint_key(i, "rotation_rad"), out);
  }
}

void quaternions_are_rotations(const Scenario& s, Violations& out) {
  for (std::size_t i = 0; i < s.strategy.waypoint.size(); ++i) {
    const auto& q = s.strategy.waypoint[i].quaternion;
    if (!q) continue;
    const double size = std::hypot(std::hypot((*q)[0], (*q)[1]), std::hypot((*q)[2], (*q)[3]));
    if (std::abs(size - 1.0) <= kUnitRoom) continue;
    out.push_back({waypoint_key(i, "quaternion"), "",
                   "has the length " + for_people(size) + "; a rotation has the length 1 (within 1e-6)"});
  }
}

void one_kind_of_rotation(const Scenario& s, Violations& out) {
  for (std::size_t i = 0; i < s.strategy.waypoint.size(); ++i) {
    if (!s.strategy.waypoint[i].quaternion || !s.strategy.waypoint[i].rotation_rad) continue;
    out.push_back({waypoint_key(i, "quaternion"), "", "excludes rotation_rad; give one of them"});
  }
}

void not_too_many_waypoints(const Scenario& s, Violations& out) {
  if (s.strategy.waypoint.size() <= kWaypointsMost) return;
  out.push_back({"strategy.waypoint", "",
                 "there are " + std::to_string(s.strategy.waypoint.size()) + " waypoints; at most " +
                     std::to_string(kWaypointsMost) + " are followed"});
}

void no_tilt_with_waypoints(const Scenario& s, Violations& out) {
  if (!is_tilted(s) || s.strategy.waypoint.empty()) return;
  out.push_back({"strategy.tilt_rad", "",
                 "does not go with [[strategy.waypoint]], which say how the gripper turns; give one of the two"});
}

void first_stop_off_the_belt(const Scenario& s, Violations& out) {
  if (!has_gripper(s) || s.strategy.pick == PickKind::still || s.strategy.waypoint.empty()) return;
  if (s.strategy.waypoint.front().place_m) return;
  out.push_back(
      {waypoint_key(0, "place_m"), "",
       "missing: a palm that goes with a belt comes to rest over its first waypoint, and has to know where"});
}

/// The lowest that the product comes above the plane that it was lifted from or is put down on, whichever is
/// higher, on the way from stop to stop [m].
double least_clearance_m(const Scenario& s, const PalmStop& from, const PalmStop& to) {
  const Vector turn_rad = rotation_to(to.attitude * inverse(from.attitude));
  double least = std::numeric_limits<double>::infinity();
  for (int look = 1; look <= kLooks; ++look) {
    const double share = static_cast<double>(look) / kLooks;
    const Attitude attitude =
        attitude_of({share * turn_rad[0], share * turn_rad[1], share * turn_rad[2]}) * from.attitude;
    const double height_m = place_between(from, to, share)[2];
    least = std::min(least, height_m + lowest_place_m(s, attitude));
  }
  return least - std::max(0.0, s.cell.place_height_m);
}

void stops_clear_the_plane(const Scenario& s, Violations& out) {
  if (!has_gripper(s) || !shape_extents_m(s.product)) return;
  PalmStop from = lifted_stop(s);
  std::size_t waypoint = 0;
  for (const PalmStop& stop : palm_stops(s)) {
    const double clearance_m = least_clearance_m(s, from, stop);
    const bool is_tilt = is_tilted(s) && waypoint == 0 && s.strategy.waypoint.empty();
    if (!(clearance_m > 0.0) && is_tilt) {
      const double room_m = s.cell.lift_height_m - std::max(0.0, s.cell.place_height_m);
      out.push_back({"strategy.tilt_rad", "",
                     "turns the product into the plane below it: it needs a lift of more than " +
                         for_people(room_m - clearance_m) + " m above that, and has " + for_people(room_m) +
                         " m (cell.lift_height_m)"});
      return;
    }
    if (!(clearance_m > 0.0)) {
      const bool arrives = least_clearance_m(s, stop, stop) <= clearance_m;
      out.push_back({waypoint_key(waypoint, "place_m"), "",
                     "takes the product's lowest place down to " + for_people(clearance_m) +
                         " m above the support or the target" + (arrives ? "" : ", on the way there") +
                         "; it has to stay clear of both"});
      return;
    }
    from = stop;
    ++waypoint;
  }
}

void steps_resolve_the_turn(const Scenario& s, Violations& out) {
  if (!has_gripper(s)) return;
  const double most_rad_s =
      std::min(s.strategy.tilt_speed_rad_s, std::sqrt(s.strategy.tilt_acceleration_rad_s2 * largest_turn_rad(s)));
  const double turn_rad = most_rad_s * s.simulation.time_step_s;
  if (turn_rad <= kLargestStepTurn_rad) return;
  out.push_back({"strategy.tilt_speed_rad_s", spelled(s.strategy.tilt_speed_rad_s),
                 "turns the product by up to " + for_people(turn_rad) +
                     " rad within simulation.time_step_s = " + spelled(s.simulation.time_step_s) +
                     "; steps follow " + for_people(kLargestStepTurn_rad) + " rad"});
}

/// A palm that tracked a belt comes to rest over the first waypoint.
bool rests_at_first(const Scenario& s) { return s.strategy.pick == PickKind::tracking; }

void arcs_are_of_circles(const Scenario& s, Violations& out) {
  if (!has_gripper(s)) return;
  PalmStop from = lifted_stop(s);
  for (std::size_t i = 0; i < s.strategy.waypoint.size(); ++i) {
    const Waypoint& waypoint = s.strategy.waypoint[i];
    const PalmStop to = palm_stops(s).at(i);
    if (waypoint.via_m && i == 0 && rests_at_first(s)) {
      out.push_back(
          {waypoint_key(i, "via_m"), "",
           "does not go with pick = \"tracking\" at the first waypoint, to which the palm leaves the belt"});
    } else if (waypoint.via_m && !arc_between(from, to)) {
      out.push_back({waypoint_key(i, "via_m"), "",
                     "lies in a line with the places before and after it, or on one of them: there is no arc"});
    }
    from = to;
  }
}

void blends_pass_on(const Scenario& s, Violations& out) {
  const std::vector<Waypoint>& all = s.strategy.waypoint;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!(all[i].blend_m > 0.0)) continue;
    if (i + 1 == all.size()) {
      out.push_back({waypoint_key(i, "blend_m"), spelled(all[i].blend_m),
                     "must be 0 at the last waypoint: the palm rests there before the transfer"});
    } else if (all[i].wait_s > 0.0) {
      out.push_back(
          {waypoint_key(i, "blend_m"), spelled(all[i].blend_m),
           "excludes wait_s = " + spelled(all[i].wait_s) + ": where it is blended the palm does not rest"});
    }
  }
}

void s_curves_have_jerks(const Scenario& s, Violations& out) {
  if (!has_gripper(s) || s.strategy.profile != ProfileKind::s_curve) return;
  if (!s.strategy.jerk_m_s3) out.push_back({"strategy.jerk_m_s3", "", "missing: profile = \"s_curve\" needs it"});
  if (!s.strategy.tilt_jerk_rad_s3 && turns_product(s)) {
    out.push_back(
        {"strategy.tilt_jerk_rad_s3", "", "missing: profile = \"s_curve\" needs it where the palm turns"});
  }
}

constexpr std::string_view kPlace = "strategy.waypoint[].place_m", kRotation = "strategy.waypoint[].rotation_rad",
                           kQuaternion = "strategy.waypoint[].quaternion";

}  // namespace

std::vector<Rule> turn_rules() {
  return {
      {{"strategy.tilt_rad", "gripper", "gripper.coupling"}, "needs centric fingers", tilts_with_both_fingers},
      {{"strategy.tilt_rad"},
       "<= pi in length",
       [](const Scenario& s, Violations& out) { by_half_a_turn(s.strategy.tilt_rad, "strategy.tilt_rad", out); }},
      {{"strategy.tilt_rad", "gripper"}, "not with waypoints", no_tilt_with_waypoints},
      {{kPlace, "strategy.pick", "gripper"},
       "of the first: required with pick = \"tracking\"",
       first_stop_off_the_belt},
      {{kPlace}, "at most 16 waypoints", not_too_many_waypoints},
      {{kRotation}, "<= pi in length", turns_by_half_a_turn},
      {{kQuaternion}, "of length 1", quaternions_are_rotations},
      {{kQuaternion, kRotation}, "excludes rotation_rad", one_kind_of_rotation, "excludes quaternion"},
      {{kRotation, kQuaternion, "gripper", "gripper.coupling"},
       "needs centric fingers",
       turns_with_both_fingers,
       "needs centric fingers"},
      {{"strategy.waypoint[].via_m", kPlace, "cell.lift_height_m", "strategy.pick", "strategy.pick_offset_m",
        "cell.conveyor.direction", "gripper"},
       "on an arc from the waypoint before to place_m",
       arcs_are_of_circles},
      {{"strategy.waypoint[].blend_m", "strategy.waypoint[].wait_s", kPlace},
       "0 at the last waypoint and with wait_s",
       blends_pass_on},
      {{"strategy.jerk_m_s3", "strategy.tilt_jerk_rad_s3", "strategy.profile", "strategy.tilt_rad", kRotation,
        kQuaternion, "gripper"},
       "required with profile = \"s_curve\"",
       s_curves_have_jerks},
      {{kPlace, "strategy.tilt_rad", "strategy.waypoint[].via_m", kRotation, kQuaternion, "gripper",
        "cell.lift_height_m", "cell.place_height_m", "cell.grip_offset_m", "cell.grip_height_m", "product.size_m",
        "product.shape", "product.axis", "product.profile_height", "product.profile_radius", "product.exponents"},
       "clear of the plane below",
       stops_clear_the_plane,
       "clear of the plane below"},
      {{"strategy.tilt_speed_rad_s", "strategy.tilt_acceleration_rad_s2", "strategy.tilt_rad", kRotation,
        kQuaternion, "gripper", "simulation.time_step_s"},
       "turns by <= 0.1 rad a step",
       steps_resolve_the_turn},
  };
}

}  // namespace unbruised

#include <algorithm>
#include <cmath>

#include "core/scenario/rule_tables.hpp"
#include "core/scenario/vectors.hpp"
#include "core/scenario/words.hpp"

namespace unbruised {
namespace {

/// Longer arms do not exist: their file has another unit.
constexpr double kLongestReach_m = 20.0;

std::string path_of(std::size_t joint, std::string_view leaf) {
  return "robot.joint[" + std::to_string(joint) + "]." + std::string(leaf);
}

void few_joints(const Scenario& s, Violations& out) {
  if (s.robot.joint.size() <= kMostArmJoints) return;
  out.push_back({"robot.joint", std::to_string(s.robot.joint.size()),
                 "must be " + std::to_string(kMostArmJoints) + " tables at most"});
}

void carries_a_gripper(const Scenario& s, Violations& out) {
  if (!has_robot(s) || has_gripper(s)) return;
  out.push_back({"robot.joint", "", "needs [gripper]: the arm carries it along the palm's path"});
}

void axes_point_somewhere(const Scenario& s, Violations& out) {
  for (std::size_t i = 0; i < s.robot.joint.size(); ++i) {
    if (length(s.robot.joint[i].axis) > 0.0) continue;
    out.push_back({path_of(i, "axis"), "[0.0, 0.0, 0.0]", "must not be zero: the joint turns about it"});
  }
}

void limits_are_in_order(const Scenario& s, Violations& out) {
  for (std::size_t i = 0; i < s.robot.joint.size(); ++i) {
    const ArmJointParameters& joint = s.robot.joint[i];
    if (!joint.lower_rad || !joint.upper_rad || *joint.lower_rad < *joint.upper_rad) continue;
    add_bound(out, path_of(i, "lower_rad"), *joint.lower_rad, path_of(i, "upper_rad"), *joint.upper_rad,
              Strictness::below);
  }
}

/// Can a body have these moments? They are positive definite, and none of those about x, y, z exceeds the sum of
/// the others.
bool is_of_a_body(const std::array<double, 6>& inertia) {
  const auto [xx, yy, zz, xy, xz, yz] = inertia;
  const double rounding = 1e-9 * (std::abs(xx) + std::abs(yy) + std::abs(zz));
  const double minor = xx * yy - xy * xy;
  const double all = xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz);
  const double least = rounding * rounding;
  if (xx < 0.0 || yy < 0.0 || zz < 0.0 || minor < -least || all < -least * rounding) return false;
  return xx <= yy + zz + rounding && yy <= xx + zz + rounding && zz <= xx + yy + rounding;
}

void inertias_are_of_bodies(const Scenario& s, Violations& out) {
  for (std::size_t i = 0; i < s.robot.joint.size(); ++i) {
    if (is_of_a_body(s.robot.joint[i].inertia_kg_m2)) continue;
    out.push_back({path_of(i, "inertia_kg_m2"), "",
                   "is of no body: its moments must be positive, and each at most the sum of the other two"});
  }
}

void reach_is_of_an_arm(const Scenario& s, Violations& out) {
  double reach_m = length(s.robot.flange_place_m);
  for (std::size_t i = 1; i < s.robot.joint.size(); ++i) reach_m += length(s.robot.joint[i].place_m);
  if (!has_robot(s) || reach_m <= kLongestReach_m) return;
  out.push_back({"robot.joint[0].place_m", "",
                 "gives a reach of " + spelled(reach_m) + " m, must be <= " + spelled(kLongestReach_m) +
                     " m: centimetres or millimetres taken for metres?"});
}

void one_for_each_joint(std::string_view field, const std::vector<double>& list, const Scenario& s,
                        Violations& out) {
  if (list.empty() || !has_robot(s) || list.size() == s.robot.joint.size()) return;
  out.push_back({std::string(field), std::to_string(list.size()) + " numbers",
                 "must have one for each joint, " + std::to_string(s.robot.joint.size())});
}

void seed_has_all_joints(const Scenario& s, Violations& out) {
  one_for_each_joint("robot.seed_posture_rad", s.robot.seed_posture_rad, s, out);
}

void accelerations_of_all_joints(const Scenario& s, Violations& out) {
  one_for_each_joint("robot.acceleration_rad_s2", s.robot.acceleration_rad_s2, s, out);
}

void seed_lies_within_limits(const Scenario& s, Violations& out) {
  const std::vector<double>& seed = s.robot.seed_posture_rad;
  for (std::size_t i = 0; i < std::min(seed.size(), s.robot.joint.size()); ++i) {
    const ArmJointParameters& joint = s.robot.joint[i];
    if (seed[i] < joint.lower_rad.value_or(seed[i])) {
      out.push_back({"robot.seed_posture_rad[" + std::to_string(i) + "]", spelled(seed[i]),
                     "must be >= " + path_of(i, "lower_rad") + " = " + spelled(*joint.lower_rad)});
    }
    if (seed[i] > joint.upper_rad.value_or(seed[i])) {
      add_bound(out, "robot.seed_posture_rad[" + std::to_string(i) + "]", seed[i], path_of(i, "upper_rad"),
                *joint.upper_rad);
    }
  }
}

}  // namespace

std::vector<Rule> robot_rules() {
  return {
      {{"robot.joint"}, "at most 8", few_joints},
      {{"robot.joint", "gripper"}, "needs [gripper]", carries_a_gripper},
      {{"robot.joint[].axis"}, "not zero", axes_point_somewhere},
      {{"robot.joint[].lower_rad", "robot.joint[].upper_rad"}, "< robot.joint[].upper_rad", limits_are_in_order},
      {{"robot.joint[].inertia_kg_m2"}, "of a body that can be", inertias_are_of_bodies},
      {{"robot.joint[].place_m", "robot.flange_place_m", "robot.joint"},
       "of an arm that reaches 20 m at most",
       reach_is_of_an_arm},
      {{"robot.seed_posture_rad", "robot.joint"}, "one for each joint", seed_has_all_joints},
      {{"robot.seed_posture_rad", "robot.joint[].lower_rad", "robot.joint[].upper_rad"},
       "within the joints' limits",
       seed_lies_within_limits},
      {{"robot.acceleration_rad_s2", "robot.joint"}, "one for each joint", accelerations_of_all_joints},
  };
}

}  // namespace unbruised

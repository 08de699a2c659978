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

void seed_has_all_joints(const Scenario& s, Violations& out) {
  const std::size_t given = s.robot.seed_posture_rad.size(), joints = s.robot.joint.size();
  if (given == 0 || !has_robot(s) || given == joints) return;
  out.push_back({"robot.seed_posture_rad", std::to_string(given) + " numbers",
                 "must have one for each joint, " + std::to_string(joints)});
}

/// One for each joint or one for all.
Rule lists_joints(std::string_view field, std::vector<double> RobotParameters::*list) {
  return {{field, "robot.joint"},
          "one for each joint, or one for all",
          [field, list](const Scenario& s, Violations& out) {
            const std::size_t given = (s.robot.*list).size(), joints = s.robot.joint.size();
            if (given <= 1 || !has_robot(s) || given == joints) return;
            out.push_back({std::string(field), std::to_string(given) + " numbers",
                           "must have one for each joint, " + std::to_string(joints) + ", or one for all"});
          }};
}

void jerks_are_finite(const Scenario& s, Violations& out) {
  if (s.robot.jerk_rad_s3.empty() || !has_robot(s) || s.strategy.profile != ProfileKind::trapezoid) return;
  out.push_back(
      {"robot.jerk_rad_s3", "",
       "needs strategy.profile = \"minimum_jerk\" or \"s_curve\": the acceleration of a trapezoid jumps"});
}

/// A palm that sways accelerates every way.
void sways_with_both_fingers(const Scenario& s, Violations& out) {
  const ParallelJawParameters* jaw = parallel_jaw(s);
  if (!arm_sways(s) || jaw == nullptr || jaw->coupling == FingerCoupling::centric) return;
  const bool is_elastic = !s.robot.stiffness_N_m_rad.empty();
  out.push_back({is_elastic ? "robot.stiffness_N_m_rad" : "robot.bandwidth_Hz", "", std::string(kNeedsCentric)});
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
      lists_joints("robot.acceleration_rad_s2", &RobotParameters::acceleration_rad_s2),
      lists_joints("robot.deceleration_rad_s2", &RobotParameters::deceleration_rad_s2),
      lists_joints("robot.jerk_rad_s3", &RobotParameters::jerk_rad_s3),
      lists_joints("robot.stiffness_N_m_rad", &RobotParameters::stiffness_N_m_rad),
      lists_joints("robot.bandwidth_Hz", &RobotParameters::bandwidth_Hz),
      {{"robot.jerk_rad_s3", "strategy.profile", "robot.joint"}, "not with a trapezoid", jerks_are_finite},
      {{"robot.stiffness_N_m_rad", "robot.bandwidth_Hz", "robot.joint", "gripper", "gripper.coupling"},
       "needs centric fingers",
       sways_with_both_fingers,
       "needs centric fingers"},
  };
}

}  // namespace unbruised

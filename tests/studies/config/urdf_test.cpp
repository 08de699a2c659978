// Arms out of URDF texts: what arrives of a chain, and one sentence for whatever cannot be followed.

#include <cmath>

#include <gtest/gtest.h>

#include "studies/config/problems.hpp"
#include "studies/config/urdf_arm.hpp"

namespace unbruised::studies {
namespace {

/// Base, two links, a bracket fast to the second, and a tool at its end.
std::string two_links() {
  return R"(<robot name="two">
  <link name="base"/>
  <joint name="first" type="revolute"><parent link="base"/><child link="one"/><origin xyz="0 0 0.5"/>
    <axis xyz="0 0 1"/><limit lower="-2" upper="3" velocity="1.5" effort="40"/></joint>
  <link name="one"><visual><geometry><mesh filename="package://nowhere/one.stl"/></geometry></visual>
    <inertial><origin xyz="0.2 0 0"/><mass value="3"/>
    <inertia ixx="0.01" iyy="0.04" izz="0.05" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <joint name="mount" type="fixed"><parent link="one"/><child link="plate"/><origin xyz="0.4 0 0" rpy="0 0 1.5707963267948966"/></joint>
  <link name="plate"/>
  <joint name="second" type="continuous"><parent link="plate"/><child link="two"/><origin xyz="0.1 0 0"/>
    <axis xyz="0 1 0"/><limit velocity="2" effort="20"/></joint>
  <link name="two"><inertial><mass value="1"/><inertia ixx="0.01" iyy="0.01" izz="0.01" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <joint name="end" type="fixed"><parent link="two"/><child link="tool"/><origin xyz="0.3 0 0"/></joint>
  <link name="tool"><inertial><origin xyz="0.1 0 0"/><mass value="1"/><inertia ixx="0" iyy="0" izz="0" ixy="0" ixz="0" iyz="0"/></inertial></link>
</robot>)";
}

std::string with(std::string text, const std::string& old, const std::string& now) {
  const std::size_t at = text.find(old);
  EXPECT_NE(at, std::string::npos) << old;
  return text.replace(at, old.size(), now);
}

std::vector<Entry> entries_of(const std::string& text, Problems& problems, const std::string& tip = "") {
  return urdf_entries({text, tip, std::make_shared<const std::string>("arm.urdf"), 1}, problems);
}

std::vector<double> numbers(const std::vector<Entry>& entries, const std::string& path) {
  for (const Entry& entry : entries) {
    if (entry.path != path) continue;
    if (entry.value.kind != Value::Kind::array) return {entry.value.number};
    std::vector<double> out;
    for (const Value& item : entry.value.items) out.push_back(item.number);
    return out;
  }
  return {};
}

TEST(Urdf, JointsLimitsAndInertiasArrive) {
  Problems problems;
  const std::vector<Entry> entries = entries_of(two_links(), problems);
  EXPECT_EQ(problems.lines(), std::vector<std::string>{});
  EXPECT_EQ(numbers(entries, "robot.joint[0].place_m"), (std::vector<double>{0.0, 0.0, 0.5}));
  EXPECT_EQ(numbers(entries, "robot.joint[0].upper_rad"), std::vector<double>{3.0});
  EXPECT_EQ(numbers(entries, "robot.joint[0].torque_N_m"), std::vector<double>{40.0});
  EXPECT_EQ(numbers(entries, "robot.joint[0].mass_kg"), std::vector<double>{3.0});
  EXPECT_TRUE(numbers(entries, "robot.joint[1].lower_rad").empty()) << "it turns without end";
}

TEST(Urdf, FixedJointsAreTakenIntoTheLinks) {
  Problems problems;
  const std::vector<Entry> entries = entries_of(two_links(), problems);
  // The second joint stands behind the plate, turned by a right angle: 0.4 along x, then 0.1 along y.
  const std::vector<double> place = numbers(entries, "robot.joint[1].place_m");
  ASSERT_EQ(place.size(), 3U);
  EXPECT_NEAR(place[0], 0.4, 1e-12);
  EXPECT_NEAR(place[1], 0.1, 1e-12);
  EXPECT_NEAR(numbers(entries, "robot.joint[1].rotation_rad")[2], std::acos(0.0), 1e-12);
  // Link and tool, 1 kg each, 0.4 m apart: moments m d^2 / 2 = 0.08 about their middle, beside the link's own.
  EXPECT_EQ(numbers(entries, "robot.joint[1].mass_kg"), std::vector<double>{2.0});
  EXPECT_NEAR(numbers(entries, "robot.joint[1].center_of_mass_m")[0], 0.2, 1e-12);
  const std::vector<double> inertia = numbers(entries, "robot.joint[1].inertia_kg_m2");
  EXPECT_NEAR(inertia[0], 0.01, 1e-12);
  EXPECT_NEAR(inertia[1], 0.09, 1e-12);
  EXPECT_NEAR(inertia[2], 0.09, 1e-12);
  EXPECT_NEAR(numbers(entries, "robot.flange_place_m")[0], 0.3, 1e-12);
}

void expect_refused(const std::string& text, const std::string& sentence, const std::string& tip = "") {
  Problems problems;
  EXPECT_TRUE(entries_of(text, problems, tip).empty());
  ASSERT_EQ(problems.lines().size(), 1U) << sentence;
  EXPECT_EQ(problems.lines()[0].substr(0, sentence.size()), sentence);
}

TEST(Urdf, WhatCannotBeFollowedIsRefusedInOneSentence) {
  const std::string text = two_links();
  expect_refused(with(text, "\"revolute\"", "\"prismatic\""),
                 "arm.urdf:1: joint \"first\": is prismatic: only joints that turn are followed");
  expect_refused(with(text, "<axis xyz=\"0 1 0\"/>", "<axis xyz=\"0 1 0\"/><mimic joint=\"first\"/>"),
                 "arm.urdf:1: joint \"second\": mimics \"first\"");
  expect_refused(with(text, "effort=\"40\"", "effort=\"0\""),
                 "arm.urdf:1: joint \"first\": has the limit effort = 0.0: must be > 0");
  expect_refused(with(text, "lower=\"-2\"", "lower=\"4\""),
                 "arm.urdf:1: joint \"first\": has the limits lower = 4.0, upper = 3.0: lower must be < upper");
  expect_refused(with(text, "<mass value=\"3\"/>", "<mass value=\"0\"/>"),
                 "arm.urdf:1: link \"one\": has no <inertial> with a mass > 0");
  expect_refused("<robot", "arm.urdf:1: robot.urdf: is no URDF file");
  expect_refused("<robot xmlns:xacro=\"x\"><xacro:arm/></robot>", "arm.urdf:1: robot.urdf: is a xacro file");
  expect_refused(text, "arm.urdf:1: robot.tip_link: there is no link \"hand\"", "hand");
  expect_refused("<robot name=\"r\"><link name=\"a\"/></robot>",
                 "arm.urdf:1: robot.urdf: has no joint that turns");
}

TEST(Urdf, SeveralEndsNeedATip) {
  const std::string forked = with(
      two_links(), "</robot>",
      "<link name=\"camera\"/><joint name=\"eye\" type=\"fixed\"><parent link=\"one\"/><child link=\"camera\"/>"
      "</joint></robot>");
  expect_refused(forked, "arm.urdf:1: robot.urdf: has several links at an end, camera and tool; robot.tip_link");
  Problems problems;
  EXPECT_FALSE(entries_of(forked, problems, "tool").empty());
  EXPECT_EQ(problems.lines(), std::vector<std::string>{});
}

}  // namespace
}  // namespace unbruised::studies

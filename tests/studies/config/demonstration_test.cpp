// A recorded demonstration as a strategy: nowhere further from what was shown than its tolerance, in the time that
// it took; what cannot be followed is refused with file and line.

#include "studies/config/demonstration.hpp"

#include <cmath>
#include <limits>
#include <map>

#include "core/motion/motion_plan.hpp"
#include "core/scenario/palm_stops.hpp"
#include "studies/config/csv_rows.hpp"
#include "studies/config/library.hpp"
#include "tests/places.hpp"
#include "tests/studies/config/config_testing.hpp"

namespace unbruised::studies {
namespace {

using Vector = std::array<double, 3>;
using Lines = std::vector<std::string>;

const std::string kConfigs = std::string(UNBRUISED_SOURCE_DIR) + "/configs";

Study taught(const std::vector<std::string>& sets) {
  StudyOrError study = read_study(kConfigs + "/taught_pick.toml", sets, kConfigs);
  EXPECT_TRUE(study) << study.error().messages.front();
  return *std::move(study);
}

/// What is in the file while the gripper is closed, from where it closed, x along the grip axis.
std::vector<Vector> shown_places() {
  std::string why;
  const auto text = read_text_file(kConfigs + "/data/kiwi_demonstration.csv", why);
  EXPECT_TRUE(text) << why;
  CsvRows rows(*text, std::make_shared<const std::string>("shown.csv"), 0);
  rows.next();
  std::vector<Vector> places;
  Vector first{};
  double heading = 0.0;
  bool was_closed = false;
  while (rows.next()) {
    std::array<double, 10> n{};
    for (std::size_t i = 0; i < n.size(); ++i) n[i] = cell_number(rows.cells().at(i)).value_or(NAN);
    const bool closed = n[8] == 1.0;
    if (closed && !was_closed && places.empty()) {
      first = {n[1], n[2], n[3]};
      heading = 2.0 * std::atan2(n[7], n[4]);
    }
    if (!closed && was_closed) break;
    was_closed = closed;
    if (!closed) continue;
    const Vector off = {n[1] - first[0], n[2] - first[1], n[3] - first[2]};
    places.push_back(turned(attitude_of({0.0, 0.0, -heading}), off));
  }
  return places;
}

double distance_m(const Vector& a, const Vector& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

double nearest_m(const Vector& place, const std::vector<Vector>& all) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Vector& other : all) nearest = std::min(nearest, distance_m(place, other));
  return nearest;
}

void expect_way_of(const std::vector<Vector>& shown, const Scenario& scenario, double most_m) {
  const MotionPlan plan = planned_motion(scenario);
  std::vector<Vector> gone;
  constexpr int kLooks = 3000;
  for (int i = 0; i <= kLooks; ++i) {
    const double t = plan.lift_start_s() + (plan.lower_end_s() - plan.lift_start_s()) * i / kLooks;
    gone.push_back(plan.palm(t).position_m);
  }
  // Between places that were shown, 20 ms apart at up to 0.5 m/s, lie 10 mm: half of that to the nearest.
  for (const Vector& place : gone) EXPECT_LE(nearest_m(place, shown), std::hypot(most_m, 0.0055)) << most_m;
  for (const Vector& place : shown) EXPECT_LE(nearest_m(place, gone), most_m + 5e-4) << most_m;
}

TEST(Demonstration, ThePalmStaysWithinTheToleranceOfWhatWasShown) {
  const std::vector<Vector> shown = shown_places();
  ASSERT_GT(shown.size(), 200U);
  for (const char* timing : {"as shown", "free"}) {
    for (const char* tolerance : {"0.003", "0.004", "0.008"}) {
      const Study study = taught({std::string("strategy.demonstration_timing=\"") + timing + "\"",
                                  std::string("strategy.demonstration_tolerance_m=") + tolerance});
      expect_way_of(shown, study.scenario(0), std::stod(tolerance));
    }
  }
}

TEST(Demonstration, ASearchChangesItsHasteAndLeavesItsWay) {
  const StudyOrError study = read_study(kConfigs + "/taught_optimize.toml", {}, kConfigs);
  ASSERT_TRUE(study) << study.error().messages.front();
  const std::vector<Vector> shown = shown_places();
  Scenario scenario = study->scenario(0);
  double before_s = std::numeric_limits<double>::infinity();
  for (const double most_m_s2 : {0.5, 3.0, 20.0}) {
    scenario.strategy.transfer_acceleration_m_s2 = scenario.strategy.lift_acceleration_m_s2 = most_m_s2;
    expect_way_of(shown, scenario, 0.004);
    const double time_s = planned_motion(scenario).lower_end_s();
    EXPECT_LT(time_s, before_s);
    before_s = time_s;
  }
}

TEST(Demonstration, TakesTheTimeThatItTookOrLess) {
  const Scenario shown = taught({"strategy.demonstration_timing=\"as shown\""}).scenario(4);
  const MotionPlan plan = planned_motion(shown);
  // From the start of the lift at 1.2 s to rest at 4.6 s; blends save some, the tremor moves both ends.
  EXPECT_NEAR(plan.lower_end_s() - plan.lift_start_s(), 3.4, 0.5);
  const MotionPlan free = planned_motion(taught({}).scenario(4));
  EXPECT_LT(free.lower_end_s() - free.lift_start_s(), 0.7 * 3.4);
  EXPECT_EQ(shown.strategy.grip_force_N, 3.0);
}

TEST(Demonstration, IsPartOfTheResolvedStudy) {
  const Study study = taught({});
  EXPECT_EQ(study.resolved_toml().find("demonstration ="), std::string::npos);
  EXPECT_NE(study.resolved_toml().find("[[strategy.waypoint]]"), std::string::npos);
  const auto again = read_study_text(study.resolved_toml(), "config.toml", {}, kConfigs, kConfigs);
  ASSERT_TRUE(again);
  EXPECT_EQ(again->resolved_toml(), study.resolved_toml());
}

TEST(Demonstration, WhatTheStudySaysCounts) {
  const Scenario scenario = taught({"strategy.grip_force_N=2.5", "cell.lift_height_m=0.07"}).scenario(0);
  EXPECT_EQ(scenario.strategy.grip_force_N, 2.5);
  EXPECT_EQ(scenario.cell.lift_height_m, 0.07);
}

std::vector<std::string> said_of(const std::string& text) {
  Problems problems;
  demonstration_entries({.content = text, .file = std::make_shared<const std::string>("demo.csv"), .rank = 1},
                        problems);
  return problems.lines();
}

TEST(Demonstration, IsRefusedWithFileAndLine) {
  const std::string header = "time_s,x_m,y_m,z_m,closed\n", up = "0,0,0,0,1\n0.5,0,0,0.1,1\n";
  EXPECT_EQ(said_of(header + up + "1,0,0.2,0.1,1\n1.5,0,0.2,0.05,0\n"), Lines{});
  const std::string columns =
      "demo.csv:1: strategy.demonstration: the first line must name the columns time_s, x_m, y_m, z_m, closed, "
      "and of "
      "these what there is: rx_rad, ry_rad, rz_rad or qw, qx, qy, qz; grip_force_N";
  EXPECT_EQ(said_of("time_s,x_m\n0,0\n"), Lines{columns});
  EXPECT_EQ(said_of("time_s,x_m,y_m,z_m,closed,qw\n0,0,0,0,1,1\n"), Lines{columns});
  EXPECT_EQ(said_of(header + "0,0,0,0\n"),
            Lines{"demo.csv:2: strategy.demonstration: a row must have 5 cells, not 4"});
  EXPECT_EQ(said_of(header + "0,0,0,up,1\n"), Lines{"demo.csv:2: z_m = up: must be a number"});
  EXPECT_EQ(said_of(header + "0,0,0,0,0.5\n"), Lines{"demo.csv:2: closed = 0.5: must be 0, open, or 1, closed"});
  EXPECT_EQ(said_of(header + "1,0,0,0,1\n0.5,0,0,0,1\n"),
            Lines{"demo.csv:3: time_s = 0.5: must be > 1.0, the time before it"});
  EXPECT_EQ(said_of(header + "0,0,0,0,0\n"),
            Lines{"demo.csv:1: strategy.demonstration: the gripper never closes: `closed` is never 1"});
  EXPECT_EQ(said_of(header + up), Lines{"demo.csv:1: strategy.demonstration: the gripper does not open again: "
                                        "after its last 1 `closed` has no 0"});
  EXPECT_EQ(
      said_of(header + "0,0,0,0,1\n0.5,0,0.1,0,1\n1,0,0.2,0,0\n"),
      Lines{
          "demo.csv:1: strategy.demonstration: goes sideways before it has risen by 0.005 m: the lift is straight "
          "up, within half of strategy.demonstration_tolerance_m"});
  EXPECT_EQ(
      said_of("time_s,x_m,y_m,z_m,closed,qw,qx,qy,qz\n0,0,0,0,1,1,0.5,0,0\n"),
      Lines{"demo.csv:2: qw = 1.0: is of a quaternion of length 1.118033988749895; a rotation has the length 1"});
  std::string zigzag = header + "0,0,0,0,1\n0.5,0,0,0.1,1\n";
  for (int i = 1; i < 40; ++i) {
    zigzag += std::to_string(0.5 + 0.1 * i) + "," + (i % 2 == 0 ? "0" : "0.05") + "," + std::to_string(0.01 * i) +
              ",0.1,1\n";
  }
  const Lines said = said_of(zigzag + "8,0,0.4,0.1,1\n9,0,0.4,0.05,0\n");
  ASSERT_EQ(said.size(), 1U);
  EXPECT_NE(said[0].find("waypoints to stay within 0.002 m and 0.03 rad of it, and 16 are followed"),
            std::string::npos)
      << said[0];
}

}  // namespace
}  // namespace unbruised::studies

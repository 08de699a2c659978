#include <cmath>
#include <limits>

#include "core/scenario/gripper.hpp"
#include "core/scenario/opening.hpp"
#include "core/scenario/pad_meeting.hpp"
#include "core/scenario/plausible_parts.hpp"

namespace unbruised::plausible {
namespace {

constexpr double kNoEnd = std::numeric_limits<double>::infinity();

void gravity_down(const Scenario& s, const MeasureVisit& visit) {
  visit({"cell.gravity_m_s2[2]", s.cell.gravity_m_s2[2], -s.cell.gravity_m_s2[2]});
}

/// Height of the pads that faces the product; negative: the air between them.
void pad_overlap(const Scenario& s, const MeasureVisit& visit) {
  const auto* jaw = parallel_jaw(s);
  if (jaw == nullptr) return;
  const double half = 0.5 * (lattice_of(s).size_m[2] + jaw->pad_size_m[1]);
  visit({"cell.grip_height_m", s.cell.grip_height_m, half - std::abs(s.cell.grip_height_m)});
}
void pad_overlap_across(const Scenario& s, const MeasureVisit& visit) {
  const auto* jaw = parallel_jaw(s);
  if (jaw == nullptr) return;
  const double half = 0.5 * (lattice_of(s).size_m[1] + jaw->pad_size_m[0]);
  visit({"cell.grip_offset_m", s.cell.grip_offset_m, half - std::abs(s.cell.grip_offset_m)});
}

void pad_lean(const Scenario& s, const MeasureVisit& visit) {
  const auto meeting = pad_meeting(s);
  if (!meeting) return;
  const bool across = std::abs(s.cell.grip_offset_m) > std::abs(s.cell.grip_height_m);
  visit({across ? "cell.grip_offset_m" : "cell.grip_height_m",
         across ? s.cell.grip_offset_m : s.cell.grip_height_m, meeting->lean_rad});
}

void approach_gap(const Scenario& s, const MeasureVisit& visit) {
  if (!has_gripper(s)) return;
  const double gap = approach_gap_m(s);
  const auto opening = opening_m(s.gripper);
  if (s.cell.approach_gap_m || !opening) return visit({"cell.approach_gap_m", gap, gap});
  visit({"gripper.opening_m", *opening, gap});
}

}  // namespace

Rows cell_rows() {
  return {
      {"gravity downwards",
       "m/s2",
       0.0,
       15.0,
       {"cell.gravity_m_s2"},
       {{-1.0, "the sign forgotten"}, {1e3, "mm/s2 taken for m/s2"}},
       "",
       "0 in free fall, 9.81 on earth",
       gravity_down},
      plain("cell.support_friction", "friction coefficient of the support", "", 0.0, 2.0, kFraction,
            "as the product's; 0: a test without friction"),
      plain("cell.support_modulus_Pa", "Young's modulus of the support", "Pa", 5e3, 2.5e11, kStress,
            "foam 10 kPa, rubber 1 to 10 MPa, steel 210 GPa"),
      plain("cell.support_thickness_m", "layer of the support", "m", 5e-5, 0.1, kLength, "trays and mats"),
      plain("cell.support_relaxation_time_s", "relaxation time of the support", "s", 0.0, 0.1, kTime,
            "as that of the pads"),
      plain("cell.surface[].center_m", "place of a surface", "m", 0.0, 10.0, kLength, "cells of robots"),
      plain("cell.surface[].size_m", "extent of a surface", "m", 1e-3, 10.0, kLength, "ribs of a tray to tables"),
      plain("cell.surface[].friction", "friction coefficient of a surface", "", 0.0, 2.0, kFraction,
            "as the product's; 0: a test without friction"),
      plain("cell.surface[].modulus_Pa", "Young's modulus of a surface", "Pa", 5e3, 2.5e11, kStress,
            "foam 10 kPa, rubber 1 to 10 MPa, steel 210 GPa"),
      plain("cell.surface[].thickness_m", "layer of a surface", "m", 5e-5, 0.1, kLength, "trays and mats"),
      plain("cell.surface[].relaxation_time_s", "relaxation time of a surface", "s", 0.0, 0.1, kTime,
            "as that of the pads"),
      plain("cell.surface[].path_time_s", "time of a surface's path", "s", 0.0, 3600.0, kTime, "cycles of cells"),
      plain("cell.surface[].path_m", "way of a surface", "m", 0.0, 10.0, kLength, "lifts and indexing belts"),
      {"way of the pads to the product",
       "m",
       1e-4,
       0.15,
       {"cell.approach_gap_m", "gripper.opening_m", "product.size_m"},
       kLength,
       "",
       "half the opening of a large jaw",
       approach_gap},
      {"height of pad that faces the product",
       "m",
       0.0,
       kNoEnd,
       {"cell.grip_height_m", "product.size_m", "gripper.pad_size_m"},
       {},
       "the pads pass above or below the product",
       "geometry",
       pad_overlap},
      {"width of pad that faces the product",
       "m",
       0.0,
       kNoEnd,
       {"cell.grip_offset_m", "product.size_m", "gripper.pad_size_m"},
       {},
       "the pads pass beside the product",
       "geometry",
       pad_overlap_across},
      {"lean of the product's side where the pads meet it",
       "rad",
       0.0,
       0.3,
       {"cell.grip_height_m", "cell.grip_offset_m", "product.size_m", "gripper.pad_size_m", "product.shape",
        "product.axis", "product.profile_height", "product.profile_radius", "product.exponents"},
       {},
       "a pad's edge on a slope pushes along the grip axis only here, in truth across the slope too",
       "arc tangent of the least usual friction coefficient of fruit, 0.3",
       pad_lean},
      plain("cell.lift_height_m", "lift", "m", 0.0, 10.0, kLength, "cells of robots and gantries"),
      plain("cell.transfer_m", "way of the transfer", "m", 0.0, 10.0, kLength, "cells of robots and gantries"),
      plain("cell.place_height_m", "height of the target", "m", 0.0, 10.0, kLength,
            "cells of robots and gantries"),
      plain("cell.place_velocity_m_s", "speed of the target", "m/s", 0.0, 5.0, kSpeed, "conveyors 0.05 to 3 m/s"),
      plain("cell.stop_deceleration_m_s2", "deceleration of a stop", "m/s2", 0.5, 150.0, kAcceleration,
            "robot arms 5 to 20, delta robots up to 150 m/s2"),
      plain("cell.conveyor.speed_m_s", "speed of the belt", "m/s", 0.0, 5.0, kSpeed, "conveyors 0.05 to 3 m/s"),
      plain("cell.conveyor.initial_speed_m_s", "initial speed of the belt", "m/s", 0.0, 5.0, kSpeed,
            "conveyors 0.05 to 3 m/s"),
      plain("cell.conveyor.acceleration_m_s2", "acceleration of the belt", "m/s2", 0.05, 50.0, kAcceleration,
            "conveyors 0.1 to 10 m/s2"),
      plain("cell.conveyor.length_m", "length of the belt", "m", 0.01, 100.0, kLength, "cells of robots"),
  };
}

}  // namespace unbruised::plausible

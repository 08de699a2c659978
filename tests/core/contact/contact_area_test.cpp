// The area of contact is the overlap of pad and true face, whatever the cell size.

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/motion/motion_plan.hpp"
#include "core/scenario/opening.hpp"
#include "tests/comparison.hpp"
#include "tests/core/simulation/scenes.hpp"
#include "tests/reference_data.hpp"

namespace unbruised {
namespace {

using namespace testing;

/// A block of 5 cm that nothing but two fingers touches, pressed slowly and held.
Scenario pressed_block(double cell_size_m, const std::array<double, 2>& pad_size_m, double grip_force_N) {
  Scenario scenario = small_box();
  make_product(scenario, {0.05, 0.05, 0.05}, cell_size_m, 0.1, 1e9).friction = 0.0;
  jaw_of(scenario).pad_size_m = pad_size_m;
  only_grip(scenario);
  scenario.strategy.approach_speed_m_s = 0.02;
  scenario.strategy.contact_force_N = 0.05;
  scenario.strategy.grip_force_N = grip_force_N;
  scenario.strategy.grip_ramp_s = 0.2;
  scenario.strategy.settle_s = 0.3;
  scenario.strategy.hold_s = 0.0;
  scenario.simulation.time_step_s = 5e-4;
  return scenario;
}

/// At the end of the grip, before anything opens.
struct Pressed {
  double approach_m = 0;  ///< of the pads towards each other since they touched
  double force_N = 0;
  double pressure_Pa = 0;  ///< largest of a window
};

Pressed press(const Scenario& scenario) {
  Trace trace;
  const ScenarioResult result = run(scenario, &trace);
  EXPECT_EQ(result.outcome, Outcome::held) << result.cause;
  const auto phase = column(trace, "phase");
  std::size_t last = 0;
  while (last + 1 < phase.size() && phase[last + 1] < static_cast<double>(CyclePhase::lift)) ++last;
  Pressed pressed;
  pressed.approach_m = column(trace, "finger_way_m", 0)[last] + column(trace, "finger_way_m", 1)[last] -
                       2.0 * approach_gap_m(scenario);
  pressed.force_N = column(trace, "finger_force_N", 0)[last];
  pressed.pressure_Pa = column(trace, "patch_pressure_Pa")[last];
  return pressed;
}

/// Both pads in series under a uniform pressure, and the block of area 25 cm2 where they cover it in full.
double closed_form_approach_m(const Scenario& scenario, double force_N, double area_m2) {
  const ParallelJawParameters& gripper = jaw_of(scenario);
  return 2.0 * force_N * gripper.pad_thickness_m / (gripper.pad_modulus_Pa * area_m2);
}

TEST(ContactArea, OfAPadAsLargeAsTheFaceIsTheFace) {
  for (const double cell : {0.025, 0.0125}) {
    const Scenario scenario = pressed_block(cell, {0.05, 0.05}, 2.0);
    const Pressed pressed = press(scenario);
    const double block = pressed.force_N * 0.05 / (1e9 * 0.0025);
    const double expected = closed_form_approach_m(scenario, pressed.force_N, 0.0025) + block;
    // The fingers still settle by a part in 1e5 at the end of the grip.
    EXPECT_NEAR(pressed.approach_m, expected, 1e-3 * expected) << cell;
    EXPECT_NEAR(pressed.pressure_Pa, pressed.force_N / 0.0025, 1e-6 * pressed.pressure_Pa) << cell;
  }
}

TEST(ContactArea, OfAPadThatReachesOverAnEdgeIsTheOverlap) {
  for (const double cell : {0.025, 0.0125}) {
    Scenario scenario = pressed_block(cell, {0.03, 0.024}, 2.0);
    scenario.cell.grip_height_m = 0.02;    // from 8 mm to 32 mm above the centre; the block ends at 25 mm
    scenario.cell.grip_offset_m = -0.017;  // from -32 mm to -2 mm
    const Pressed pressed = press(scenario);
    const double area = 0.017 * 0.023;
    const double expected = closed_form_approach_m(scenario, pressed.force_N, area);
    // The block is not rigid: with 1 GPa behind a layer of 1.3e8 Pa/m its own give is 2 per cent at most.
    EXPECT_GT(pressed.approach_m, expected) << cell;
    EXPECT_LT(pressed.approach_m, 1.02 * expected) << cell;
  }
}

TEST(ContactArea, OfARoundFlatFaceIsTheEllipse) {
  for (const double cell : {0.025, 0.0125}) {
    Scenario scenario = pressed_block(cell, {0.06, 0.06}, 2.0);
    lattice_of(scenario).shape = Shape::cylinder;
    lattice_of(scenario).axis = Axis::x;
    const Pressed pressed = press(scenario);
    const double area = std::numbers::pi / 4.0 * 0.0025;
    const double expected =
        closed_form_approach_m(scenario, pressed.force_N, area) + pressed.force_N * 0.05 / (1e9 * area);
    // The cylinder's own give is 0.3 per cent of the pads', on cells that stand for more or less of its section.
    EXPECT_NEAR(pressed.approach_m, expected, 1e-3 * expected) << cell;
  }
}

/// Presses the block of a row of fe_blocks.csv with 2 N, and says how stiff it is [N/mm].
double block_stiffness(const TableRow& row, double cell_size_m) {
  Scenario scenario =
      pressed_block(cell_size_m, {1e-3 * number(row, "pad_mm"), 1e-3 * number(row, "pad_mm")}, 2.0);
  lattice_of(scenario).youngs_modulus_Pa = 1e6 * number(row, "youngs_modulus_MPa");
  lattice_of(scenario).poisson_ratio = number(row, "poisson_ratio");
  jaw_of(scenario).pad_modulus_Pa = 1e9 * number(row, "springs_MPa_mm") * jaw_of(scenario).pad_thickness_m;
  scenario.simulation.time_step_s = 1e-3;
  const Pressed pressed = press(scenario);
  return 1e-3 * pressed.force_N / pressed.approach_m;
}

TEST(ContactArea, UnderAPadThatEndsWithinTheFaceTheBlockIsAsStiffAsFiniteElements) {
  for (const TableRow& row : read_table("fe_blocks.csv")) {
    for (const int cells : {5, 7}) {
      if (cells == 5 && row.at("pad_mm") != "30") continue;
      const std::string quantity = "pad " + row.at("pad_mm") + " mm, springs " + row.at("springs_MPa_mm") +
                                   " MPa/mm, nu " + row.at("poisson_ratio") + ", " + std::to_string(cells) +
                                   " cells: N/mm";
      // Within a cell the edge of a pad is known by a calibrated softness only.
      expect_agreement({"pads", quantity, block_stiffness(row, 0.05 / cells), number(row, "stiffness_N_mm")},
                       0.05);
    }
  }
}

TEST(ContactArea, ThereIsNoForceWithoutOverlap) {
  for (const double cell : {0.025, 0.0125}) {
    std::vector<Scenario> passing;  // the block ends at 25 mm, half a pad is 15 mm
    for (const double height : {0.0449, 0.0401, -0.0401, -0.0449}) {
      passing.push_back(pressed_block(cell, {0.03, 0.03}, 2.0));
      passing.back().cell.grip_height_m = height;
    }
    for (const ScenarioResult& result : run_side_by_side(passing)) {
      EXPECT_EQ(result.outcome, Outcome::not_grasped) << cell;
      EXPECT_EQ(result.metrics[Metric::peak_finger_force_N], 0.0) << cell;
    }
  }
}

TEST(ContactArea, APadBesideThePoleOfABallTouchesWhereItReaches) {
  Scenario scenario = pressed_block(0.00625, {0.03, 0.03}, 0.5);
  scenario.strategy.settle_s = 0.0;
  lattice_of(scenario).shape = Shape::sphere;
  scenario.cell.grip_height_m = 0.023;  // from 8 mm above the pole on
  Trace trace;
  const ScenarioResult result = run(scenario, &trace);
  ASSERT_FALSE(trace.events.empty());
  const double way = 0.02 * trace.events.front().time_s - approach_gap_m(scenario);
  // The ball lies this far behind its pole at the pad's edge. Places are 1.6 mm wide, and stand in the middle of
  // what they cover: half of that at the slope 0.32 of the ball there.
  const double relief = 0.025 - std::sqrt(0.025 * 0.025 - 0.008 * 0.008);
  EXPECT_NEAR(way, relief, 0.32 * 0.5 * 0.0016 + 0.02 * 5e-4) << result.cause;
}

TEST(ContactArea, YieldOfAFlatFaceIsThatOfItsMeanPressure) {
  for (const double cell : {0.025, 0.01}) {
    Scenario scenario = pressed_block(cell, {0.12, 0.12}, 25.5);
    lattice_of(scenario).youngs_modulus_Pa = 1e6;
    lattice_of(scenario).yield_stress_Pa = 1e4;
    lattice_of(scenario).tangent_modulus_Pa = 1e5;
    scenario.strategy.approach_speed_m_s = 0.005;
    scenario.strategy.grip_ramp_s = 0.3;
    const ScenarioResult result = run(scenario);
    const double peak = result.metrics[Metric::peak_finger_force_N];
    EXPECT_NEAR(result.metrics[Metric::contact_yield_ratio_max], peak / (0.0025 * 1e4), 1e-3) << cell;
    // Every cell flows on its hardening line beyond Y, under the force at rest (the peak is damping).
    EXPECT_NEAR(result.metrics[Metric::plastic_strain_max], (25.5 / 0.0025 - 1e4) * (1e-5 - 1e-6), 2e-5) << cell;
  }
}

TEST(ContactArea, PadsFarUpABallAreNotFollowed) {
  // A pad of 1 cm at 20 mm above the middle of a ball of 5 cm meets it 5 mm behind its pole, at 24 mm 8.8 mm.
  Scenario scenario = pressed_block(0.005, {0.01, 0.01}, 0.2);
  lattice_of(scenario).shape = Shape::ellipsoid;
  lattice_of(scenario).friction = 1.0;
  scenario.cell.grip_height_m = 0.02;
  const ScenarioResult followed = run(scenario);
  EXPECT_FALSE(std::isnan(followed.metrics[Metric::first_contact_time_s])) << followed.cause;
  scenario.cell.grip_height_m = 0.024;
  const ScenarioResult refused = run(scenario);
  EXPECT_EQ(refused.outcome, Outcome::out_of_range);
  EXPECT_EQ(refused.cause, "the pads meet the product too far behind its outermost place");
  EXPECT_EQ(refused.outcome_time_s, 0.0);
}

TEST(ContactArea, TheLargestWindowIsNotBelowThePadsMeanPressure) {
  // Nine windows of 10 mm tile the pad.
  for (const double modulus : {1e5, 1e6}) {
    for (const double cell : {0.025, 0.01}) {
      Scenario scenario = pressed_block(cell, {0.03, 0.03}, 1.0);
      lattice_of(scenario).youngs_modulus_Pa = modulus;
      scenario.simulation.time_step_s = 2e-3;
      const Pressed pressed = press(scenario);
      EXPECT_GE(pressed.pressure_Pa, pressed.force_N / 9e-4) << modulus << ", " << cell;
      EXPECT_LT(pressed.pressure_Pa, 2.0 * pressed.force_N / 9e-4) << modulus << ", " << cell;
    }
  }
}

}  // namespace
}  // namespace unbruised

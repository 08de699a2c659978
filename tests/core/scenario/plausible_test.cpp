// The one list of plausible values: a sentence for each kind of slip, and a scenario that trips each row.

#include "core/scenario/plausible.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/scenario/number_fields.hpp"
#include "tests/core/scenario/scenarios.hpp"

namespace unbruised {
namespace {

using namespace testing;

std::vector<std::string> said_of(const Scenario& scenario) {
  std::vector<std::string> out;
  for (const Implausible& found : implausible_values(scenario)) out.push_back(found.sentence());
  return out;
}

using S = Scenario&;
using Sentences = std::vector<std::string>;

Sentences said_after(void (*change)(Scenario&)) {
  Scenario scenario = usual_grip();
  change(scenario);
  return said_of(scenario);
}

TEST(Plausible, UsualScenariosAndNetworksOfAnyScaleAre) {
  EXPECT_EQ(said_of(usual_grip()), Sentences{});
  Scenario network = usual_network();
  network.simulation.time_step_s = 0.28;
  EXPECT_EQ(said_of(network), Sentences{});
}

TEST(Plausible, GramsTakenForKilogramsAreSaidWithTheDensityTheyGive) {
  EXPECT_EQ(
      said_after([](S s) { lattice_in(s).mass_kg = 95.0; }),
      Sentences{
          "product.mass_kg = 95.0 gives a density of 760,000 kg/m3 (plausible: 100 to 3000): grams taken for "
          "kilograms (0.095)?"});
}

TEST(Plausible, RadiiTakenForExtentsAreToldByTheDensity) {
  EXPECT_EQ(
      said_after([](S s) {
        lattice_in(s).mass_kg = 0.1;
        lattice_in(s).size_m = {0.025, 0.025, 0.025};
      }),
      Sentences{"product.mass_kg = 0.1 gives a density of 6400 kg/m3 (plausible: 100 to 3000): radii taken for "
                "full extents?"});
}

TEST(Plausible, MegapascalsTakenForPascalsAreSaid) {
  EXPECT_EQ(
      said_after([](S s) {
        lattice_in(s).youngs_modulus_Pa = 0.288;
        lattice_in(s).yield_stress_Pa.reset();
        lattice_in(s).tangent_modulus_Pa.reset();
      }),
      Sentences{"product.youngs_modulus_Pa = 0.288 means a Young's modulus of 0.288 Pa (plausible: 500 to 5e10): "
                "MPa taken for Pa (288,000)?"});
}

TEST(Plausible, MillimetresTakenForMetresAreSaidOnceForAField) {
  EXPECT_EQ(
      said_after([](S s) {
        jaw_of(s).pad_size_m = {30.0, 30.0};
      }),
      Sentences{"gripper.pad_size_m[0] = 30.0 means a pad side of 30 m (plausible: 0.002 to 0.3): millimetres "
                "taken for metres (0.03)?"});
}

TEST(Plausible, PerCentTakenForAFractionIsSaid) {
  EXPECT_EQ(
      said_after([](S s) { lattice_in(s).friction = 60.0; }),
      Sentences{
          "product.friction = 60.0 means a friction coefficient of 60 (plausible: 0.05 to 2): per cent taken "
          "for a fraction (0.6)?"});
}

TEST(Plausible, MillisecondsTakenForSecondsAreSaid) {
  EXPECT_EQ(
      said_after([](S s) { s.simulation.time_step_s = 1.0; }),
      Sentences{"simulation.time_step_s = 1.0 means a time step of 1 s (plausible: 1e-7 to 0.01): milliseconds "
                "taken for seconds (0.001)?"});
}

TEST(Plausible, MillimetresPerSecondTakenForMetresPerSecondAreSaid) {
  EXPECT_EQ(
      said_after([](S s) {
        jaw_of(s).max_speed_m_s = 50.0;
        s.strategy.approach_speed_m_s = 50.0;
      }),
      (Sentences{"gripper.max_speed_m_s = 50.0 means a largest finger speed of 50 m/s (plausible: 0.001 to 3): "
                 "mm/s taken for m/s (0.05)?",
                 "strategy.approach_speed_m_s = 50.0 means an approach speed of 50 m/s (plausible: 0.0001 to 2): "
                 "mm/s taken for m/s (0.05)?"}));
}

TEST(Plausible, ASignForgottenAndDegreesAreSaid) {
  EXPECT_EQ(
      said_after([](S s) {
        s.cell.gravity_m_s2 = {0.0, 0.0, 9.81};
      }),
      Sentences{
          "cell.gravity_m_s2[2] = 9.81 means a gravity downwards of -9.81 m/s2 (plausible: 0 to 15): the sign "
          "forgotten (-9.81)?"});
  EXPECT_EQ(
      said_after([](S s) { s.simulation.max_rotation_rad = 12.0; }),
      Sentences{"simulation.max_rotation_rad = 12.0 means a bound of the rotation of 12 rad (plausible: 0.001 to "
                "1.6): degrees taken for radians (0.2094)?"});
}

TEST(Plausible, PadsThatPassAboveTheProductAreSaid) {
  EXPECT_EQ(
      said_after([](S s) { s.cell.grip_height_m = 0.0449; }),
      Sentences{
          "cell.grip_height_m = 0.0449 gives a height of pad that faces the product of -0.0049 m (plausible: "
          "at least 0): the pads pass above or below the product"});
}

TEST(Plausible, TheStrokeOfBothFingersTakenForOneIsSaid) {
  EXPECT_EQ(
      said_after([](S s) {
        jaw_of(s).opening_m = 0.08;
        jaw_of(s).stroke_m = 0.08;
      }),
      Sentences{
          "gripper.stroke_m = 0.08 gives a stroke over half the opening of 2 (plausible: 0 to 1): the stroke "
          "of both fingers together taken for that of one (0.04)?"});
}

TEST(Plausible, AValueThatNoSlipExplainsIsSaidAllTheSame) {
  EXPECT_EQ(said_after([](S s) { lattice_in(s).friction = 0.01; }),
            Sentences{"product.friction = 0.01 means a friction coefficient of 0.01 (plausible: 0.05 to 2)"});
}

TEST(Plausible, WhatFollowsFromAFieldIsSilentWhereTheFieldHasBeenNamed) {
  const Sentences said = said_after([](S s) {
    lattice_in(s).size_m = {50.0, 50.0, 50.0};
    lattice_in(s).cell_size_m = 10.0;
  });
  ASSERT_FALSE(said.empty());
  EXPECT_EQ(
      said[0],
      "product.size_m[0] = 50.0 means a product extent of 50 m (plausible: 0.003 to 0.5): millimetres taken for "
      "metres (0.05)?");
  EXPECT_TRUE(std::none_of(said.begin(), said.end(),
                           [](const std::string& text) { return text.find("density") != std::string::npos; }));
}

/// Pads of 1 cm that meet a ball of 5 cm with an edge, on a slope of 0.64 rad.
Scenario small_pads_up_a_ball() {
  Scenario scenario = usual_grip();
  lattice_in(scenario).shape = Shape::ellipsoid;
  lattice_in(scenario).size_m = {0.05, 0.05, 0.05};
  jaw_of(scenario).pad_size_m = {0.01, 0.01};
  scenario.cell.grip_height_m = 0.02;
  return scenario;
}

TEST(Plausible, PadsThatMeetASlopeAreSaid) {
  const Sentences said = said_of(small_pads_up_a_ball());
  ASSERT_EQ(said.size(), 1U);
  EXPECT_EQ(said[0],
            "cell.grip_height_m = 0.02 gives a lean of the product's side where the pads meet it of 0.6435 rad "
            "(plausible: 0 to 0.3): a pad's edge on a slope pushes along the grip axis only here, in truth across "
            "the slope too");
}

bool trips(const PlausibleRow& row, const Scenario& scenario) {
  bool tripped = false;
  row.measure(scenario, [&](const Measured& measured) { tripped = tripped || !row.contains(measured.value); });
  return tripped;
}

/// A scenario with the row's first field far above or below what is plausible.
bool can_be_tripped(const PlausibleRow& row) {
  Scenario grip = usual_grip();
  lattice_in(grip).prony_modulus = {0.2};
  lattice_in(grip).prony_time_s = {1.0};
  jaw_of(grip).opening_m = 0.08;
  jaw_of(grip).finger.resize(1);
  grip.strategy.waypoint = {{.place_m = std::array<double, 3>{},
                             .rotation_rad = std::array<double, 3>{},
                             .via_m = std::array<double, 3>{}}};
  grip.robot.joint.resize(1);
  grip.robot.acceleration_rad_s2 = grip.robot.deceleration_rad_s2 = grip.robot.jerk_rad_s3 = {1.0};
  grip.robot.stiffness_N_m_rad = grip.robot.bandwidth_Hz = grip.robot.seed_posture_rad = {1.0};
  grip.cell.surface.resize(1);
  grip.cell.surface[0].size_m = {0.1, 0.1};
  grip.cell.surface[0].path_time_s = {0.0};
  grip.cell.surface[0].path_m = {{0.0, 0.0, 0.0}};
  const std::array<double, 3> stiff = {1e6, 1e6, 1e6};
  grip.sensor.ring_stiffness_N_m = grip.sensor.stiffness_N_m = grip.sensor.stiffness_N_m_rad = stiff;
  grip.sensor.stiffness_matrix.emplace().fill(1.0);
  grip.sensor.position_m = std::array<double, 3>{};
  Scenario turned = usual_grip();
  lattice_in(turned).shape = Shape::revolution;
  lattice_in(turned).profile_height = {0.0, 1.0, 3.0, 4.0};
  lattice_in(turned).profile_radius = {0.0, 1.5, 1.5, 0.0};
  for (const Scenario& base : {grip, turned, small_pads_up_a_ball()}) {
    for (const double factor : {1e-12, 1e-6, 1e-3, 1e3, 1e6, 1e12, -1.0}) {
      Scenario scenario = base;
      find_number_field(row.fields.front())->each(scenario, [&](const NumberPlace&, NumberSlot slot) {
        const double now = std::visit(
            [](const auto* field) {
              if constexpr (std::is_same_v<decltype(field), const std::optional<double>*>) {
                return field->value_or(1e-3);
              } else {
                return static_cast<double>(*field);
              }
            },
            slot);
        set(slot, factor * (now == 0.0 ? 1e-3 : now));
      });
      if (trips(row, scenario)) return true;
    }
  }
  return false;
}

TEST(Plausible, EveryRowCanBeTripped) {
  EXPECT_GE(plausible_rows().size(), 60U);
  for (const PlausibleRow& row : plausible_rows()) EXPECT_TRUE(can_be_tripped(row)) << row.quantity;
}

TEST(Plausible, EveryRowNamesKnownFieldsAndASource) {
  for (const PlausibleRow& row : plausible_rows()) {
    EXPECT_NE(find_number_field(row.fields.front()), nullptr) << row.quantity;
    EXPECT_FALSE(row.source.empty()) << row.quantity;
    EXPECT_LT(row.low, row.high) << row.quantity;
  }
}

TEST(Plausible, EverySlipExplainsTheMiddleOfItsRow) {
  // A value that is plausible in the middle of the row, written in the other unit, is recognised as that slip or
  // as one that is likelier; it is never silently accepted as another unit's value where no slip fits.
  for (const PlausibleRow& row : plausible_rows()) {
    for (const UnitSlip& slip : row.slips) {
      const double low = row.low > 0.0 ? row.low : 1e-3 * row.high;
      const double written = std::sqrt(low * row.high) * slip.factor;
      if (row.contains(written)) continue;  // the wider the row, the less it can tell
      EXPECT_NE(likely_slip(row, written), nullptr) << row.quantity << ": " << slip.words;
    }
  }
}

}  // namespace
}  // namespace unbruised

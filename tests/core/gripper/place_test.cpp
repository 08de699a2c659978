// Where the fingers grip: pads beside the product's middle.

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "tests/core/simulation/scenes.hpp"

namespace unbruised {
namespace {

using namespace testing;

/// A board of 8 cm along y, held still on its support by two pads of 2 cm, far from its ends.
Scenario board(double grip_offset_m) {
  Scenario scenario = small_box();
  lattice_of(scenario).size_m = {0.02, 0.08, 0.02};
  jaw_of(scenario).pad_size_m = {0.02, 0.02};
  scenario.cell.gravity_m_s2 = {0.0, 0.0, 0.0};
  scenario.cell.grip_offset_m = grip_offset_m;
  scenario.cell.lift_height_m = 0.0;
  scenario.cell.transfer_m = {0.0, 0.0};
  scenario.strategy.settle_s = 0.3;
  return scenario;
}

/// Mean place along y of the closing of the board, weighted by it, at the end of the grip phase.
double place_of_closing_m(const Scenario& scenario) {
  Trace trace;
  const ScenarioResult result = run(scenario, &trace);
  const auto count = static_cast<std::size_t>(trace.particle_count);
  const auto row = static_cast<std::size_t>((result.metrics[Metric::first_contact_time_s] + 0.3) / 1e-3);
  double weight = 0.0, moment = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    // A particle on the left is pushed to the right and the other way round.
    const double x = trace.rest_position_m[3 * i], y = trace.rest_position_m[3 * i + 1];
    const double closing = -std::copysign(trace.displacement_m[(row * count + i) * 3], x);
    const double inward = trace.displacement_m[(row * count + i) * 3] * x < 0.0 ? std::abs(closing) : 0.0;
    weight += inward;
    moment += inward * y;
  }
  return moment / weight;
}

TEST(GripPlace, MovesThePatchToTheOffset) {
  // Pads that cover whole cells on either side press evenly about their centre, so the closing is symmetric about
  // it where the ends of the board are far: by Saint-Venant what is left there is a few per cent of the way.
  EXPECT_NEAR(place_of_closing_m(board(0.0)), 0.0, 1e-9);
  EXPECT_NEAR(place_of_closing_m(board(0.01)), 0.01, 1e-3);
  EXPECT_NEAR(place_of_closing_m(board(0.02)), 0.02, 2e-3);
}

TEST(GripPlace, OffsetsToEitherSideAreMirrorImages) {
  Scenario right = small_box();
  right.cell.grip_offset_m = 0.004;
  right.cell.transfer_m = {0.0, 0.0};
  Scenario left = right;
  left.cell.grip_offset_m = -0.004;
  const ScenarioResult a = run(right), b = run(left);
  EXPECT_EQ(a.outcome, b.outcome);
  // The contact sweep goes through the particles in one order only: its tolerance, not rounding.
  for (const Metric metric : {Metric::cycle_time_s, Metric::peak_finger_force_N, Metric::slip_max_m,
                              Metric::friction_margin_min, Metric::compression_max_m}) {
    EXPECT_NEAR(a.metrics[metric], b.metrics[metric], 1e-4 * std::abs(a.metrics[metric]) + 1e-9)
        << kMetricTable[static_cast<std::size_t>(metric)].name;
  }
}

TEST(GripPlace, AnOffsetGripTurnsTheProductWithItsWeightTimesTheOffset) {
  // The weight m g acts e beside the pads: they carry the torque m g e by friction that is uneven along y, and the
  // product hangs lower on the side that overhangs.
  Scenario scenario = small_box();
  scenario.cell.grip_offset_m = 0.004;
  scenario.cell.transfer_m = {0.0, 0.0};
  jaw_of(scenario).pad_size_m = {0.01, 0.01};
  scenario.strategy.grip_force_N = 0.5;
  scenario.strategy.hold_s = 0.3;
  const auto sag = [](const Scenario& s) {
    Trace trace;
    run(s, &trace);
    const auto count = static_cast<std::size_t>(trace.particle_count);
    const std::size_t row = trace.time_s.size() / 2;  // held
    double moment = 0.0, second = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      const double y = trace.rest_position_m[3 * i + 1];
      moment += y * trace.displacement_m[(row * count + i) * 3 + 2];
      second += y * y;
    }
    return moment / second;  // slope of the vertical displacement along y
  };
  const double slope = sag(scenario);
  EXPECT_GT(slope, 0.0) << "pads at +y: the side at -y hangs";
  scenario.cell.grip_offset_m = 0.0;
  EXPECT_NEAR(sag(scenario), 0.0, 1e-3 * slope);  // symmetric, to the tolerance of the contact sweep
}

}  // namespace
}  // namespace unbruised

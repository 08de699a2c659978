// A product between two pads that each press on one particle swings about the line through them.

#include "tests/core/frame/held_scenes.hpp"

namespace unbruised {
namespace {

using namespace testing;

constexpr double kPivot_m = 0.005;

/// A sphere of 40 mm in cells of 5 mm between pads of 1 mm, 5 mm above its centre. A particle of a curved side
/// stands for its cell, and a pad lies within the cell of one particle however far the product turns about it.
/// Friction is too large for slip. A transfer across the grip axis starts the swing; the product is let go of
/// where that ends, and later.
Scenario hanging_sphere(double transfer_acceleration_m_s2) {
  Scenario scenario = tilted_block({1e-9, 0.0, 0.0}, 2.0, 1e-3);
  LatticeParameters& sphere = make_product(scenario, {0.04, 0.04, 0.04}, 0.005, 0.1, 2e8);
  sphere.shape = Shape::sphere;
  sphere.friction = 5.0;
  sphere.relaxation_time_s = 1e-5;
  ParallelJawParameters& jaw = jaw_of(scenario);
  jaw.pad_size_m = {1e-3, 1e-3};
  jaw.pad_modulus_Pa = 1e9;
  jaw.pad_thickness_m = 1e-3;
  scenario.cell.grip_height_m = kPivot_m;
  scenario.cell.transfer_m = {0.0, 0.1};
  scenario.strategy.transfer_acceleration_m_s2 = transfer_acceleration_m_s2;
  scenario.strategy.hold_s = 0.0;
  scenario.strategy.release_height_m = scenario.cell.lift_height_m;
  scenario.strategy.place_settle_s = 5.0;
  scenario.simulation.duration_s = 3.0;
  return scenario;
}

struct Swing {
  double period_s = 0.0;
  double first_rad = 0.0, last_rad = 0.0;  ///< largest angles in the first and the last half period
};

/// What a trace shows once the transfer has ended.
Swing swing_in(const Trace& trace) {
  const double* q = signal(trace, "attitude").values.data();
  std::vector<double> zero_s, largest_rad;
  double before = 0.0, largest = 0.0;
  for (std::size_t i = last_in_phase(trace, CyclePhase::transfer) + 1; i < trace.time_s.size(); ++i) {
    const double angle = 2.0 * std::atan2(q[4 * i + 1], q[4 * i]);
    largest = std::max(largest, std::abs(angle));
    if (before * angle < 0.0) {
      zero_s.push_back(trace.time_s[i] - (trace.time_s[i] - trace.time_s[i - 1]) * angle / (angle - before));
      if (zero_s.size() > 1) largest_rad.push_back(largest);
      largest = 0.0;
    }
    before = angle;
  }
  if (zero_s.size() < 5) return {};
  const std::size_t periods = (zero_s.size() - 1) / 2;
  return {(zero_s[2 * periods] - zero_s[0]) / static_cast<double>(periods), largest_rad.front(),
          largest_rad.back()};
}

/// 4 sqrt(I / (m g d)) K(sin(A / 2)), I about the pivot.
double pendulum_period_s(const Points& points, double amplitude_rad) {
  double inertia = 0.0, mass = 0.0;
  for (std::size_t p = 0; p < points.X.size(); ++p) {
    inertia += points.mass_kg[p] * points.X[p].tail<2>().squaredNorm();
    mass += points.mass_kg[p];
  }
  return 4.0 * std::sqrt((inertia + mass * kPivot_m * kPivot_m) / (mass * kGravity * kPivot_m)) *
         std::comp_ellint_1(std::sin(0.5 * amplitude_rad));
}

TEST(GripPendulum, HasThePeriodOfAPhysicalPendulumAtAnyAmplitude) {
  const std::vector<Scenario> scenarios = {hanging_sphere(1.0), hanging_sphere(4.0), hanging_sphere(10.0)};
  const Points points = points_of(scenarios.front());
  double largest_rad = 0.0;
  for (const Trace& trace : traces_of(scenarios)) {
    const Swing swing = swing_in(trace);
    ASSERT_GT(swing.period_s, 0.0);
    SCOPED_TRACE(swing.first_rad);
    // 4e-5 to 6e-5 are left: the time step, and a pivot that yields by a micrometre.
    EXPECT_NEAR(swing.period_s / pendulum_period_s(points, swing.first_rad), 1.0, 2e-4);
    // Nothing takes energy from the swing; a row stands up to 0.5 ms beside the largest angle.
    EXPECT_NEAR(swing.last_rad, swing.first_rad, 1e-3 * swing.first_rad);
    largest_rad = std::max(largest_rad, swing.first_rad);
  }
  EXPECT_GT(largest_rad, kQuarter_rad);
}

}  // namespace
}  // namespace unbruised

// Products that turn and move by their modes, against the same with every particle.

#include "core/scenario/body_modes.hpp"
#include "tests/core/frame/held_scenes.hpp"
#include "tests/core/frame/rolling_scenes.hpp"

namespace unbruised {
namespace {

using namespace testing;

/// 64 particles, so that all of their modes are soon turned.
Scenario coarse_block() {
  Scenario scenario = tilted_block({0.0, 0.7, 0.0}, 4.0, 1e-3);
  lattice_of(scenario).cell_size_m = 0.05 / 3.0;
  scenario.strategy.hold_s = 0.1;
  return scenario;
}

/// Metrics that say what became of the product.
constexpr Metric kPhysics[] = {
    Metric::peak_finger_force_N,    Metric::slip_max_m,        Metric::friction_margin_min,
    Metric::cycle_time_s,           Metric::place_error_m,     Metric::place_attitude_rad,
    Metric::peak_acceleration_m_s2, Metric::compression_max_m, Metric::energy_input_J};

void expect_alike(const Scenario& scenario) {
  SCOPED_TRACE(std::get<LatticeParameters>(scenario.product).cell_size_m);
  Trace full_trace, modal_trace;
  full_trace.keeps_motion = modal_trace.keeps_motion = true;
  const Scenario modal = by_modes(scenario, kAllModes);
  ASSERT_GT(mode_count(modal), 0);
  const ScenarioResult a = run(scenario, &full_trace), b = run(modal, &modal_trace);
  EXPECT_EQ(a.outcome, b.outcome);
  EXPECT_EQ(a.cause, b.cause);
  for (const Metric metric : kPhysics) {
    if (std::isnan(a.metrics[metric]) && std::isnan(b.metrics[metric])) continue;
    EXPECT_NEAR(a.metrics[metric], b.metrics[metric], 1e-9 * std::max(1.0, std::abs(a.metrics[metric])))
        << info_of(metric).name;
  }
  EXPECT_NEAR(a.metrics[Metric::energy_balance_error], b.metrics[Metric::energy_balance_error], 1e-9);
  EXPECT_LT(b.metrics[Metric::impulse_balance_error], 1e-9);
  const auto& full = full_trace.displacement_m;
  ASSERT_EQ(full.size(), modal_trace.displacement_m.size());
  ASSERT_FALSE(full.empty());
  double most = 0.0, farthest = 0.0;
  for (std::size_t i = 0; i < full.size(); ++i) {
    most = std::max(most, std::abs(full[i] - modal_trace.displacement_m[i]));
    farthest = std::max(farthest, std::abs(full[i]));
  }
  EXPECT_LT(most, 1e-9 * farthest);
}

// The frame, its turns and its sums lose nothing where modes carry everything.
TEST(ModesThatTurn, AllOfThemSpinAsTheFullBodyDoes) {
  Scenario scenario = spinning_box({1.0, 10.0, 2.0}, 2e-3, 0.3);
  LatticeParameters& box = lattice_of(scenario);
  box.size_m = {0.08, 0.04, 0.04};
  box.cell_size_m = 0.02;
  box.initial_velocity_m_s = {0.3, 0.0, 2.0};
  box.initial_rotation_rad = {0.4, 0.0, -0.3};
  scenario.cell.gravity_m_s2 = {0.0, 0.0, -kGravity};
  expect_alike(scenario);
}

TEST(ModesThatTurn, AllOfThemAreTiltedAsTheFullBodyIs) { expect_alike(coarse_block()); }

TEST(ModesThatTurn, AllOfThemFadeAsTheFullBodyDoes) {
  Scenario scenario = coarse_block();
  lattice_of(scenario).prony_modulus = {0.3, 0.2};
  lattice_of(scenario).prony_time_s = {0.05, 1.0};
  scenario.strategy.hold_s = 0.02;
  expect_alike(scenario);
}

// Places of the surface, their arms and the turn of the whole body by them.
TEST(ModesThatTurn, AllOfThemTumbleAsTheFullBodyDoes) {
  Scenario scenario = thrown_box(1e-3, 0.3);
  lattice_of(scenario).size_m = {0.06, 0.04, 0.04};
  lattice_of(scenario).cell_size_m = 0.02;
  expect_alike(scenario);
}

// A steady spin, 10 rad in 500 steps. The stretches that stand beside the modes carry a body that has turned, so
// that the error is that of its shape alone, whatever the step.
TEST(ModesThatTurn, AFewKeepAngularMomentumPhaseAndStretch) {
  const Scenario scenario = spinning_box({0.0, 0.0, 10.0}, 2e-3, 1.0);
  const Points points = points_of(scenario);
  Trace full_trace, trace;
  run(scenario, &full_trace);
  const ScenarioResult result = run(by_modes(scenario, 60), &trace);
  EXPECT_EQ(result.cause, "");
  const SpinRow start = spin_row(trace, points, 0), end = last_row(trace, points),
                full = last_row(full_trace, points);
  // Given back in every step; the rest is rounding.
  EXPECT_LT((end.momentum_kg_m2_s - start.momentum_kg_m2_s).norm(), 1e-12 * start.momentum_kg_m2_s.norm());
  // 60 modes leave 0.8 % out of the centrifugal displacement, which is 2.5e-4 of the places that make the inertia.
  EXPECT_LT((end.u - full.u).cwiseAbs().maxCoeff(), 0.02 * full.u.cwiseAbs().maxCoeff());
  EXPECT_LT(angle_between(end.attitude, full.attitude), 1e-5);
  EXPECT_LT(std::abs(result.metrics[Metric::energy_balance_error]), 1e-7);
}

// The margins that modes are held to: force 0.5 %, slip 1 um + 1 %, times 0.1 ms; 216 particles in 40 modes.
TEST(ModesThatTurn, AFewAreTiltedAsTheFullBodyIs) {
  for (const std::array<double, 3>& tilt_rad : {std::array{0.0, 0.7, 0.0}, {0.9, 0.3, -0.5}}) {
    const Scenario scenario = tilted_block(tilt_rad, 4.0, 1e-3);
    const ScenarioResult full = run(scenario), modal = run(by_modes(scenario, 40));
    const Metrics &a = modal.metrics, &b = full.metrics;
    EXPECT_EQ(modal.outcome, full.outcome) << modal.cause;
    const auto near = [&](Metric metric, double share, double absolute = 0.0) {
      EXPECT_NEAR(a[metric], b[metric], share * std::abs(b[metric]) + absolute) << info_of(metric).name;
    };
    near(Metric::peak_finger_force_N, 0.005);
    near(Metric::friction_margin_min, 0.005);
    near(Metric::slip_max_m, 0.01, 1e-6);
    near(Metric::cycle_time_s, 0.0, 1e-4);
    EXPECT_LT(std::abs(a[Metric::energy_balance_error]), 2.0 * std::abs(b[Metric::energy_balance_error]) + 1e-4);
    EXPECT_LT(a[Metric::impulse_balance_error], 1e-9);
    EXPECT_LT(a[Metric::angular_impulse_balance_error], 1e-9);
  }
}

TEST(ModesThatTurn, GiveTheSameBitsAloneAndInCompany) {
  std::vector<Scenario> scenarios;
  for (int i = 0; i < lane_count() + 3; ++i) {
    Scenario scenario = by_modes(coarse_block(), 20);
    scenario.strategy.grip_force_N = 3.0 + 0.1 * (i % 5);
    scenario.strategy.tilt_rad[1] = 0.2 * (i / 5);
    scenario.strategy.tilt_rad[0] = 0.3;
    scenarios.push_back(scenario);
  }
  const std::vector<ScenarioResult> together = run_side_by_side(scenarios);
  const auto model = build(scenarios.front());
  for (const std::size_t i : {std::size_t{0}, std::size_t{7}, scenarios.size() - 1}) {
    expect_same_bits(simulate(model, scenarios[i], nullptr), together[i], "block " + std::to_string(i));
  }
}

// A cell that turns against the body is seen where it can be touched.
TEST(ModesThatTurn, CellsThatTurnBeyondTheModelAreSeen) {
  Scenario scenario = tilted_block({0.0, 0.7, 0.0}, 40.0, 1e-3);
  lattice_of(scenario).youngs_modulus_Pa = 5e4;
  scenario.simulation.max_rotation_rad = 0.05;
  const ScenarioResult full = run(scenario), modal = run(by_modes(scenario, 40));
  EXPECT_EQ(full.cause, "a cell's rotation against the product > simulation.max_rotation_rad");
  EXPECT_EQ(modal.cause, full.cause);
}

}  // namespace
}  // namespace unbruised

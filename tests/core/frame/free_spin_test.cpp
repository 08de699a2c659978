// A body that spins about a principal axis far beyond small rotations, against the steady spin it began with.

#include "core/scenario/product_frame.hpp"
#include "core/simulation/lane_observer.hpp"
#include "tests/core/frame/spin_scenes.hpp"

namespace unbruised {
namespace {

using namespace testing;

constexpr double kSpin_rad_s = 10.0, kStep_s = 2e-3;

/// 10 rad in 500 steps.
class FreeSpin : public ::testing::Test {
 protected:
  void run_for(double duration_s) {
    scenario_ = spinning_box({0.0, 0.0, kSpin_rad_s}, kStep_s, duration_s);
    result_ = run(scenario_, &trace_);
    points_ = points_of(scenario_);
    start_ = spin_row(trace_, points_, 0);
    end_ = last_row(trace_, points_);
  }
  Scenario scenario_;
  Trace trace_;
  ScenarioResult result_;
  Points points_;
  SpinRow start_, end_;
};

TEST_F(FreeSpin, KeepsAngularMomentumEnergyPhaseAndShape) {
  run_for(1.0);
  EXPECT_EQ(result_.cause, "");
  // Kept by construction; the rest is rounding of 500 steps.
  EXPECT_LT((end_.momentum_kg_m2_s - start_.momentum_kg_m2_s).norm(), 1e-12 * start_.momentum_kg_m2_s.norm());
  // A steady spin does no work; what is lost belongs to the numerical settling of the shape, 7e-8 of the strain.
  const std::vector<double> energy = column(trace_, "stored_energy_J");
  EXPECT_NEAR(energy.back() / energy.front(), 1.0, 1e-10);
  // The scheme is second order: 7.2e-7 rad of 10 in a prototype.
  EXPECT_LT(angle_between(end_.attitude, Eigen::Quaterniond(Eigen::AngleAxisd(10.0, Eigen::Vector3d::UnitZ()))),
            2e-6);
  // 0.35 (omega dt)^2 of the centrifugal displacement, which is what the body starts with.
  EXPECT_LT((end_.u - start_.u).cwiseAbs().maxCoeff(), 5e-4 * start_.u.cwiseAbs().maxCoeff());
  EXPECT_LT(std::abs(result_.metrics[Metric::energy_balance_error]), 1e-9);
}

TEST_F(FreeSpin, StartsStretchedAsTheCentrifugalLoadStretchesABar) {
  // A bar of length L spinning about its middle: u(L/2) = rho omega^2 L^3 / (24 E) + what the width adds;
  // d2u/dx2 = -rho omega^2 x / E at the middle of the section, from free ends.
  const double L = 0.2, E = 1e6, rho = 1000.0;
  Scenario bar = spinning_box({0.0, 0.0, 5.0}, kStep_s, 0.5, E);
  lattice_of(bar).size_m = {L, 0.02, 0.02};
  lattice_of(bar).poisson_ratio = 0.0;
  Trace trace;
  EXPECT_EQ(run(bar, &trace).cause, "");
  const Points points = points_of(bar);
  const SpinRow end = last_row(trace, points);
  double stretch_m = 0.0, area = 0.0;
  for (std::size_t p = 0; p < points.X.size(); ++p) {
    if (std::abs(points.X[p].x() - L / 2.0) > 1e-9) continue;
    stretch_m += points.mass_kg[p] * end.u(0, static_cast<Eigen::Index>(p));
    area += points.mass_kg[p];
  }
  // Particle masses of twenty cells stand for the bar to (h / L)^2 = 0.25 %; the load of the stretched bar adds
  // the strain, 0.4 %.
  EXPECT_NEAR(stretch_m / area, rho * 25.0 * L * L * L / (24.0 * E), 0.01 * rho * 25.0 * L * L * L / (24.0 * E));
}

/// Sums what the steps would have lost of the angular momentum, as a share of it.
class Corrections final : public LaneObserver {
 public:
  explicit Corrections(double& share) : share_(share) {}
  void start(const LaneStep&) override {}
  bool observe(const LaneStep& step) override {
    const FrameLanes* frame = step.view.body.frame();
    if (frame == nullptr) return false;
    const LaneVector L = frame->angular_momentum_kg_m2_s();
    share_ = (frame->corrected_kg_m2_s() / sqrt(dot(L, L)))[step.lane];
    return true;
  }
  void end(const LaneStep&) override {}

 private:
  double& share_;
};

TEST_F(FreeSpin, LosesByItselfOnlyWhatWilsonsDampingOfATurningVectorTakes) {
  // 0.168 (omega dt)^3 of the spin per radian; in the frame of t_n it would gain omega dt theta of it per radian.
  const Scenario scenario = spinning_box({0.0, 0.0, kSpin_rad_s}, kStep_s, 1.0);
  double lost = 0.0;
  LaneSimulation simulation(build(scenario));
  simulation.load(0, scenario);
  simulation.watch(0, std::make_unique<Corrections>(lost));
  while (simulation.busy(0)) simulation.step();
  // The law is the first term of a series in omega dt = 0.02.
  const double law = 0.168 * std::pow(kSpin_rad_s * kStep_s, 3.0) * 10.0;
  EXPECT_NEAR(lost, law, 0.05 * law);
}

TEST_F(FreeSpin, DoesNotFeelASteadyMotion) {
  Scenario still = spinning_box({1.0, 10.0, 2.0}, kStep_s, 0.6);
  Scenario moving = still;
  lattice_of(moving).initial_velocity_m_s = {5.0, -3.0, 2.0};
  Trace still_trace, moving_trace;
  run(still, &still_trace);
  run(moving, &moving_trace);
  const Points points = points_of(still);
  const SpinRow a = last_row(still_trace, points), b = last_row(moving_trace, points);
  // Rounding at places 4 m away: 1e-15 m over the 40 mm of the body.
  EXPECT_LT(angle_between(a.attitude, b.attitude), 1e-12);
  EXPECT_LT((a.u - b.u).cwiseAbs().maxCoeff(), 1e-12 * 0.04);
  EXPECT_LT((b.center_motion_m - Eigen::Vector3d(3.0, -1.8, 1.2)).norm(), 1e-12);
}

TEST_F(FreeSpin, FallsExactly) {
  Scenario scenario = spinning_box({1.0, 10.0, 2.0}, kStep_s, 0.5);
  scenario.cell.gravity_m_s2 = {0.0, 0.0, -kGravity};
  lattice_of(scenario).initial_velocity_m_s = {0.3, 0.0, 2.0};
  Trace trace;
  const ScenarioResult result = run(scenario, &trace);
  const SpinRow end = last_row(trace, points_of(scenario));
  // Wilson's recursion is exact for a constant acceleration: rounding only.
  EXPECT_LT((end.center_motion_m - Eigen::Vector3d(0.15, 0.0, 1.0 - 0.125 * kGravity)).norm(), 1e-13);
  EXPECT_LT(result.metrics[Metric::impulse_balance_error], 1e-10);
}

/// Every place and attitude, bit by bit: the metrics of a flight say little.
void expect_same_bits(const Trace& a, const Trace& b) {
  ASSERT_EQ(a.displacement_m.size(), b.displacement_m.size());
  const std::vector<double>&q = signal(a, "attitude").values, &p = signal(b, "attitude").values;
  EXPECT_EQ(std::memcmp(a.displacement_m.data(), b.displacement_m.data(), 8 * a.displacement_m.size()), 0);
  EXPECT_EQ(std::memcmp(a.velocity_m_s.data(), b.velocity_m_s.data(), 8 * a.velocity_m_s.size()), 0);
  EXPECT_EQ(std::memcmp(q.data(), p.data(), 8 * q.size()), 0);
}

TEST_F(FreeSpin, IsTheSameWhateverFliesBesideItAndIsLoadedOnTheWay) {
  const Scenario scenario = spinning_box({3.0, -8.0, 1.0}, kStep_s, 0.1);
  Scenario other = scenario, third = scenario;
  lattice_of(other).initial_spin_rad_s = {0.0, 20.0, 0.0};
  other.simulation.duration_s = 0.04;
  lattice_of(third).initial_velocity_m_s = {1.0, 0.0, 0.0};
  Trace lone, beside;
  run(scenario, &lone);
  LaneSimulation simulation(build(scenario));
  simulation.load(0, other);
  simulation.load(5, scenario);
  simulation.record(5, &beside);
  for (int k = 0; k < 13; ++k) simulation.step();
  for (int lane = 6; lane < 12; ++lane) simulation.load(lane, third);
  while (simulation.busy(5)) simulation.step();
  expect_same_bits(lone, beside);
}

TEST_F(FreeSpin, EndsWhereAStepCannotResolveTheTurning) {
  Scenario scenario = spinning_box({0.0, 0.0, 60.0}, kStep_s, 0.1, 2e7);
  const ScenarioResult result = run(scenario);
  EXPECT_EQ(result.outcome, Outcome::out_of_range);
  EXPECT_EQ(result.cause,
            "the product turns by more than 0.1 rad within a step; use a smaller simulation.time_step_s");
}

TEST_F(FreeSpin, EndsWhereTheSpinStrainsTheProductTooMuch) {
  const ScenarioResult result = run(spinning_box({0.0, 0.0, 90.0}, 1e-3, 0.1, 1e4));
  EXPECT_EQ(result.outcome, Outcome::out_of_range);
  EXPECT_EQ(result.cause, "a cell's strain > simulation.max_strain");
}

TEST(ProductFrame, IsFloatingOnlyWhereAProductSpinsFreely) {
  Scenario scenario = spinning_box({0.0, 0.0, 1.0}, kStep_s, 0.1);
  EXPECT_EQ(product_frame(scenario), ProductFrame::floating);
  lattice_of(scenario).initial_spin_rad_s = {0.0, 0.0, 0.0};
  EXPECT_EQ(product_frame(scenario), ProductFrame::upright);
  EXPECT_EQ(product_frame(small_box()), ProductFrame::upright);
  EXPECT_EQ(product_frame(oscillator(1.0, 1.0, 1e-3, 10)), ProductFrame::upright);
}

}  // namespace
}  // namespace unbruised

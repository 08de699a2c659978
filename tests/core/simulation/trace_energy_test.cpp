// The balances of energy and of angular momentum, worked out again from the signals of a trace.

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "core/motion/handling_cycle.hpp"
#include "core/surface/surfaces.hpp"
#include "tests/core/frame/rolling_scenes.hpp"

namespace unbruised {
namespace {

using namespace testing;

Scenario marked_box() {
  Scenario scenario = small_box();
  LatticeParameters& product = lattice_of(scenario);
  product.yield_stress_Pa = 800.0;
  product.tangent_modulus_Pa = 5e4;
  scenario.limits.contact_yield_ratio = 0.5;
  jaw_of(scenario).drive_viscous_N_s_m = 5.0;
  return scenario;
}
Scenario sliding_block() {
  Scenario scenario = small_box();
  scenario.gripper = NoGripper{};
  lattice_of(scenario).initial_velocity_m_s = {0.3, 0.0, 0.0};
  scenario.simulation.duration_s = 0.2;
  return scenario;
}
Scenario tumbling_box() { return thrown_box(2.5e-4, 0.2); }

struct Scene {
  const char* name;
  Scenario (*scenario)();
};
class TraceEnergy : public ::testing::TestWithParam<Scene> {
 protected:
  void SetUp() override {
    scenario_ = GetParam().scenario();
    result_ = run(scenario_, &trace_);
    ASSERT_NE(result_.outcome, Outcome::diverged) << result_.cause;
    for (double value : column(trace_, "stored_energy_J")) scale_ = std::max(scale_, std::abs(value));
  }
  [[nodiscard]] double sum_of(const std::string& name, std::size_t row) const {
    const TraceSignal& from = signal(trace_, name);
    double sum = 0.0;
    for (std::size_t i = 0; i < width(from); ++i) sum += from.values[row * width(from) + i];
    return sum;
  }
  [[nodiscard]] bool has(const std::string& name) const {
    return std::any_of(trace_.signals.begin(), trace_.signals.end(),
                       [&](const TraceSignal& each) { return each.name == name; });
  }
  Scenario scenario_;
  ScenarioResult result_;
  Trace trace_;
  double scale_ = 0.0;
};

TEST_P(TraceEnergy, ClosesToTheMetric) {
  const std::size_t last = trace_.time_s.size() - 1;
  const auto account = [&](std::size_t row) {
    return sum_of("stored_energy_J", row) + sum_of("dissipated_energy_J", row) - sum_of("work_J", row);
  };
  const double error_J = account(last) - account(0);
  // The same sums in another order: rounding of the largest of them.
  EXPECT_NEAR(error_J, result_.metrics[Metric::energy_balance_error] * result_.metrics[Metric::energy_input_J],
              1e-12 * (scale_ + result_.metrics[Metric::energy_input_J]));
  EXPECT_EQ(sum_of("dissipated_energy_J", 0), 0.0);
  EXPECT_EQ(sum_of("work_J", 0), 0.0);
}

TEST_P(TraceEnergy, PartsAddUp) {
  for (std::size_t row = 0; row < trace_.time_s.size(); ++row) {
    double parts = 0.0;
    for (const char* name : {"kinetic_energy_J", "elastic_energy_J", "hardening_energy_J", "contact_energy_J"}) {
      parts += sum_of(name, row);
    }
    if (has("finger_energy_J")) parts += sum_of("finger_energy_J", row);
    EXPECT_NEAR(sum_of("stored_energy_J", row), parts, 1e-12 * scale_) << row;
    EXPECT_NEAR(sum_of("dissipated_energy_J", row), sum_of("dissipated_by_cause_J", row), 1e-15) << row;
    EXPECT_GE(sum_of("plastic_work_J", row), sum_of("hardening_energy_J", row)) << row;
  }
  // Plastic flow takes nothing back; neither does friction, within the trapezoid rule by which it is summed.
  const std::vector<double> flow = column(trace_, "dissipated_by_cause_J", 1);
  const std::vector<double> friction = column(trace_, "dissipated_by_cause_J", 3);
  for (std::size_t row = 1; row < flow.size(); ++row) {
    EXPECT_GE(flow[row], flow[row - 1] - 1e-15) << row;
    EXPECT_GE(friction[row], friction[row - 1] - 1e-3 * friction.back()) << row;
  }
}

TEST_P(TraceEnergy, KineticEnergyIsThatOfTheParticles) {
  const std::vector<double> kinetic = column(trace_, "kinetic_energy_J");
  const Points points = points_of(scenario_);
  for (std::size_t row = 0; row < kinetic.size(); row += 7) {
    double sum = 0.0;
    for (std::size_t i = 0; i < 3 * points.X.size(); ++i) {
      const double v = trace_.velocity_m_s[row * 3 * points.X.size() + i];
      sum += 0.5 * points.mass_kg[i / 3] * v * v;
    }
    EXPECT_NEAR(kinetic[row], sum, 1e-9 * std::max(sum, scale_));
  }
}

TEST_P(TraceEnergy, SurfacesGiveTheForcesOfFingersAndSupport) {
  const TraceSignal& force = signal(trace_, "surface_force_N");
  for (std::size_t row = 0; row < trace_.time_s.size(); ++row) {
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(force.values[row * width(force) + 3 * kSupport + i],
                signal(trace_, "support_force_N").values[3 * row + i]);
    }
    for (std::size_t i = 0; has("finger_force_N") && i < 6; ++i) {
      EXPECT_EQ(force.values[row * width(force) + i], signal(trace_, "finger_force_N").values[6 * row + i]);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, TraceEnergy,
                         ::testing::Values(Scene{"marked_box", marked_box}, Scene{"slipping_box", slipping_box},
                                           Scene{"sliding_block", sliding_block},
                                           Scene{"tumbling_box", tumbling_box}),
                         [](const auto& tested) { return std::string(tested.param.name); });

TEST(SurfaceTorque, IsTheRateOfTheAngularMomentum) {
  const Scenario scenario = tumbling_box();
  Trace trace;
  run(scenario, &trace);
  const Points points = points_of(scenario);
  const TraceSignal& torque = signal(trace, "surface_torque_N_m");
  const Eigen::Vector3d first = spin_row(trace, points, 0).momentum_kg_m2_s;
  Eigen::Vector3d gained = Eigen::Vector3d::Zero(), before = Eigen::Vector3d::Zero();
  double largest_change = 0.0, largest_error = 0.0;
  for (std::size_t row = 0; row < trace.time_s.size(); ++row) {
    Eigen::Vector3d now = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < width(torque); ++i)
      now[static_cast<Eigen::Index>(i % 3)] += torque.values[row * width(torque) + i];
    if (row > 0) gained += 0.5 * (trace.time_s[row] - trace.time_s[row - 1]) * (before + now);
    before = now;
    const Eigen::Vector3d change = spin_row(trace, points, row).momentum_kg_m2_s - first;
    largest_change = std::max(largest_change, change.norm());
    largest_error = std::max(largest_error, (gained - change).norm());
  }
  ASSERT_GT(largest_change, 1e-4) << "it tumbles";
  // Torques at the ends of steps against what the steps were solved with, at t + theta dt: 6e-5 here.
  EXPECT_LT(largest_error, 1e-3 * largest_change);
  std::cout << "[ measured ] torque over time against angular momentum: " << largest_error / largest_change
            << "\n";
}

TEST(FrictionMargin, IsLeastWhereTheMetricSays) {
  const Scenario scenario = small_box();
  Trace trace;
  const ScenarioResult result = run(scenario, &trace);
  double least = HUGE_VAL;
  const std::vector<double> phase = column(trace, "phase");
  for (std::size_t f = 0; f < 2; ++f) {
    const std::vector<double> margin = column(trace, "friction_margin", f);
    EXPECT_TRUE(std::isnan(margin.front())) << "nothing touches yet";
    for (std::size_t row = 0; row < margin.size(); ++row) {
      const bool carried = phase[row] >= static_cast<double>(CyclePhase::lift) &&
                           phase[row] <= static_cast<double>(CyclePhase::lower);
      if (carried && !std::isnan(margin[row])) least = std::min(least, margin[row]);
    }
  }
  EXPECT_EQ(least, result.metrics[Metric::friction_margin_min]);
}

}  // namespace
}  // namespace unbruised

// Stiffness that fades: the recursion of one step, springs and blocks, against closed forms.

#include <cmath>
#include <complex>
#include <iostream>
#include <numbers>

#include <gtest/gtest.h>

#include "core/body/relaxation_step.hpp"
#include "tests/core/material/relaxing_block.hpp"
#include "tests/core/simulation/scenes.hpp"

namespace unbruised {
namespace {

using namespace testing;

/// k1 = 2000 N/m, c1 = 2e5 N s/m, k2 = 4000 N/m, c2 = 2e4 N s/m, 10 N for 10 s: x and, of a step of 5 mm, the
/// force.
struct BurgersRow {
  double time_s, x_m, force_N;
};
constexpr BurgersRow kBurgers[] = {
    {0.5, 0.00526290645491, 9.48817231896},  {1.0, 0.00550317311731, 9.04544080597},
    {2.0, 0.00592419988491, 8.32976944089},  {5.0, 0.00683030139707, 7.06905684088},
    {11.0, 0.00226981898679, 6.18410217319}, {12.0, 0.00194900523187, 6.11189442011},
    {15.0, 0.00129523093201, 5.93940135544}, {20.0, 0.00079254911087, 5.71932115914},
    {30.0, 0.00053959221678, 5.34730925984}, {40.0, 0.000505358223872, 5.00584804975},
    {60.0, 0.000500098139294, 4.38753485755}};
constexpr double kStiffness_N_m = 2000.0;

NetworkSpring burgers_spring() {
  NetworkSpring spring;
  spring.between = {0, 1};
  spring.stiffness_N_m = kStiffness_N_m;
  spring.burgers_flow_N_s_m = 2e5;
  spring.burgers_recovery_N_m = 4000.0;
  spring.burgers_recovery_N_s_m = 2e4;
  return spring;
}

/// What a spring that fades remembers, without a mass: moved, or pulled.
struct BareSpring {
  RelaxationStep step;
  double x = 0.0;
  std::vector<double> q = std::vector<double>(step.branch.size(), 0.0);

  [[nodiscard]] double force() const {
    double sum = step.long_term * x;
    for (std::size_t i = 0; i < q.size(); ++i) sum += step.branch[i].share * q[i];
    return sum;
  }
  void jump(double by) {
    x += by;
    for (double& each : q) each += by;
  }
  void move(double to) {
    for (std::size_t i = 0; i < q.size(); ++i) q[i] = step.branch[i].keep * q[i] + step.branch[i].gain * (to - x);
    x = to;
  }
  void pull(double force) {
    double stiffness = step.long_term, past = step.long_term * x;
    for (std::size_t i = 0; i < q.size(); ++i) {
      stiffness += step.branch[i].share * step.branch[i].gain;
      past += step.branch[i].share * step.branch[i].keep * q[i];
    }
    move(x + (force - past) / stiffness);
  }
};

TEST(RelaxationStep, ABurgersSpringCreepsRecoversAndRelaxesAsPublished) {
  const auto branches = relaxation_branches(burgers_spring());
  EXPECT_NEAR(branches[0].share + branches[1].share, 1.0, 1e-14);
  const double dt = 5e-4;
  const RelaxationStep step = relaxation_step(branches, WilsonTheta(dt, 1.4));
  EXPECT_TRUE(step.flows());
  EXPECT_NEAR(step.flow_time_s(), 2e5 / kStiffness_N_m, 1e-9);  // c1 / k1
  BareSpring pulled{step}, held{step};
  held.jump(5e-3);
  pulled.jump(5e-3);
  int at = 0;
  for (const BurgersRow& row : kBurgers) {
    for (; at < std::lround(row.time_s / dt); ++at) {
      if (at == std::lround(10.0 / dt)) pulled.jump(-pulled.force());
      pulled.pull(at < std::lround(10.0 / dt) ? 10.0 / kStiffness_N_m : 0.0);
      held.move(held.x);
    }
    EXPECT_NEAR(pulled.x / row.x_m, 1.0, 1e-9) << row.time_s;
    EXPECT_NEAR(held.force() * kStiffness_N_m / row.force_N, 1.0, 1e-9) << row.time_s;
  }
}

TEST(RelaxationStep, AHeldCarrotHasThePublishedShareOfItsForceLeft) {
  LatticeParameters carrot = small_block();
  carrot.prony_modulus = kCarrotModulus;
  carrot.prony_time_s = kCarrotTime_s;
  BareSpring held{relaxation_step(relaxation_branches(carrot), WilsonTheta(0.1, 1.4))};
  held.jump(1.0);
  std::vector<double> left = {1.0};
  while (left.size() <= 600) {
    held.move(1.0);
    left.push_back(held.force());
  }
  EXPECT_NEAR(left[20], 0.83, 0.005);
  EXPECT_NEAR(left[50], 0.75, 0.005);
  EXPECT_NEAR(left[600], 0.57, 0.005);
}

TEST(RelaxationStep, TheLongTermModulusIsTheOtherEndOfTheSameCurve) {
  LatticeParameters block = small_block();
  block.prony_modulus = kCarrotModulus;
  block.prony_time_s = kCarrotTime_s;
  EXPECT_EQ(instantaneous_modulus_Pa(block), 3e6);
  block.prony_from = PronyFrom::long_term;
  EXPECT_NEAR(instantaneous_modulus_Pa(block), 3e6 / 0.549, 1.0);
}

TEST(SpringRelaxation, APulledBurgersSpringOfANetworkFollowsItsClosedForm) {
  // A particle so light that it has no inertia to speak of. It begins 5 mm out, where the spring carries the force
  // at once; the jump of the load takes effect within two steps of the ten seconds.
  const double dt = 1e-3, late = 2.0 * dt / 10.0;
  Scenario scenario = oscillator(1e-6, kStiffness_N_m, dt, 60000);
  network_of(scenario).spring[0] = burgers_spring();
  network_of(scenario).particle[1].initial_displacement_m = {5e-3, 0.0, 0.0};
  network_of(scenario).load = {{1, {0.0, 10.0, 10.0}, {{10, 0, 0}, {10, 0, 0}, {0, 0, 0}}}};
  Trace trace;
  const ScenarioResult result = run(scenario, &trace);
  const std::vector<double> x = freedom(trace, trace.displacement_m, 3);
  double worst = 0.0;
  for (const BurgersRow& row : kBurgers) {
    const double ratio = x[static_cast<std::size_t>(std::lround(row.time_s / dt))] / row.x_m;
    worst = std::max(worst, std::abs(ratio - 1.0));
  }
  EXPECT_LT(worst, late);
  // The set: F t / c1, although 0.1 um of the rest has not recovered yet.
  EXPECT_NEAR(result.metrics[Metric::permanent_set_max_m], 10.0 * 10.0 / 2e5, 1e-4 * 5e-4);
  std::cout << "[ measured ] Burgers spring in a network: " << worst << ", set "
            << result.metrics[Metric::permanent_set_max_m] / 5e-4 << " of F t / c1\n";
}

TEST(SpringRelaxation, AHeldBurgersSpringOfANetworkFollowsItsClosedForm) {
  // A particle that a spring holds where it is put, stiff enough to give way by a millionth of that.
  const double dt = 2e-3, stiff_N_m = 1e10;
  Scenario scenario = oscillator(1.0, kStiffness_N_m, dt, 30000);
  NetworkSpring holds = network_of(scenario).spring[0];
  holds.stiffness_N_m = stiff_N_m;
  holds.rest_length_m = 1.005;
  network_of(scenario).spring = {burgers_spring(), holds};
  network_of(scenario).particle[1].initial_displacement_m = {5e-3, 0.0, 0.0};
  Trace trace;
  run(scenario, &trace);
  const std::vector<double> x = freedom(trace, trace.displacement_m, 3);
  double worst = 0.0;
  for (const BurgersRow& row : kBurgers) {
    const double force = stiff_N_m * (5e-3 - x[static_cast<std::size_t>(std::lround(row.time_s / dt))]);
    worst = std::max(worst, std::abs(force / row.force_N - 1.0));
  }
  EXPECT_LT(worst, 1e-6);
  // Half the work of the step, 1/2 k d^2, less what the branches still store, is heat.
  const auto branches = relaxation_branches(burgers_spring());
  double lost = 0.0;
  for (const RelaxationBranch& b : branches) {
    lost += 0.5 * kStiffness_N_m * 25e-6 * b.share * (1.0 - std::exp(-2.0 * 60.0 / b.time_s));
  }
  EXPECT_NEAR(column(trace, "dissipated_energy_J").back(), lost, 1e-6 * lost);
  std::cout << "[ measured ] held Burgers spring: " << worst << ", heat "
            << column(trace, "dissipated_energy_J").back() / lost << "\n";
}

/// A block of the carrot's relaxation.
LatticeParameters carrot_block() {
  LatticeParameters block = small_block();
  block.prony_modulus = kCarrotModulus;
  block.prony_time_s = kCarrotTime_s;
  block.relaxation_time_s = 1e-4;
  return block;
}

TEST(LatticeRelaxation, ABlockCreepsUnderAConstantForce) {
  const double dt = 5e-3, force_N = 0.5;
  LatticeParameters elastic = carrot_block();
  elastic.prony_modulus.clear();
  elastic.prony_time_s.clear();
  HeldBlock at_once(elastic, dt), block(carrot_block(), dt);
  for (int i = 0; i < 400; ++i) at_once.step(force_N);
  const TwoBranchCreep creep(0.218, 1.68, 0.233, 26.3);
  EXPECT_NEAR(creep.at(0.0), 1.0, 1e-12);
  double worst = 0.0;
  for (const double time_s : {0.5, 2.0, 10.0, 60.0}) {
    while (block.time_s() < time_s - 1e-9) block.step(force_N);
    worst = std::max(worst, std::abs(block.way_m() / at_once.way_m() / creep.at(time_s) - 1.0));
  }
  EXPECT_LT(worst, 1e-3);
  std::cout << "[ measured ] creep of a block at 0.5, 2, 10, 60 s: " << worst << "\n";
}

TEST(LatticeRelaxation, ABurgersBlockKeepsForceTimesTimeOverItsViscosity) {
  const double dt = 5e-3, force_N = 0.5, hold_s = 4.0;
  LatticeParameters elastic = small_block(), burgers = elastic;
  elastic.relaxation_time_s = burgers.relaxation_time_s = 1e-4;
  burgers.burgers_flow_time_s = 100.0;
  burgers.burgers_recovery_modulus = 2.0;
  burgers.burgers_recovery_time_s = 1.0;
  HeldBlock at_once(elastic, dt), block(burgers, dt);
  for (int i = 0; i < 400; ++i) at_once.step(force_N);
  while (block.time_s() < hold_s - 1e-9) block.step(force_N);
  const double set_m = at_once.way_m() * hold_s / 100.0;
  const auto kept_m = [&] {
    const LastingShape shape = block.material().lasting(HeldBlock::kLane, block.body().u());
    EXPECT_EQ(largest(shape.load_N), 0.0);
    return largest(shape.displacement_m);
  };
  const double before = kept_m();
  while (block.time_s() < 16.0) block.step(0.0);
  // The force goes within a step.
  EXPECT_NEAR(kept_m() / before, 1.0, 2e-3) << "the set is known before it shows";
  EXPECT_NEAR(block.way_m() / set_m, 1.0, 2e-3);
}

TEST(LatticeRelaxation, LossAngleOverThreeDecadesOfFrequency) {
  for (const double frequency_Hz : {0.01, 0.1, 1.0, 10.0}) {
    const double omega = 2.0 * std::numbers::pi * frequency_Hz;
    constexpr int kPerCycle = 200, kCycles = 15;
    LatticeParameters product = carrot_block();
    product.relaxation_time_s = 0.0;
    HeldBlock block(product, 1.0 / frequency_Hz / kPerCycle);
    // Sums over the last cycles against sine and cosine of times that do not matter to them: a trend is taken out
    // by the difference of two cycles that follow each other.
    std::vector<double> way;
    for (int i = 0; i < kCycles * kPerCycle; ++i) {
      const double t = block.time_s();
      const double now = std::sin(omega * t), next = std::sin(omega * (t + block.wilson().dt));
      block.step(0.5 * (now + block.wilson().theta * (next - now)));
      way.push_back(block.way_m());
    }
    double sine = 0.0, cosine = 0.0;
    const std::size_t last = way.size() - kPerCycle;
    const double drift = (way.back() - way[last - 1]) / kPerCycle;
    for (std::size_t i = last; i < way.size(); ++i) {
      const double phase = omega * static_cast<double>(i + 1) * block.wilson().dt;
      const double value = way[i] - drift * static_cast<double>(i - last);
      sine += value * std::sin(phase);
      cosine += value * std::cos(phase);
    }
    std::complex<double> modulus(1.0 - 0.218 - 0.233, 0.0);
    for (std::size_t b = 0; b < 2; ++b) {
      const std::complex<double> x(0.0, omega * kCarrotTime_s[b]);
      modulus += kCarrotModulus[b] * x / (1.0 + x);
    }
    const double delta = std::arg(modulus);
    EXPECT_NEAR(std::atan2(-cosine, sine), delta, 0.01 * delta + 1e-5) << frequency_Hz;
    std::cout << "[ measured ] loss angle at " << frequency_Hz << " Hz: " << delta << ", "
              << std::atan2(-cosine, sine) / delta << " of it\n";
  }
}

/// Way and heat of a block that is pulled up and let go again within 0.4 s.
std::pair<double, double> pulled_twice(double dt) {
  LatticeParameters product = carrot_block();
  product.prony_time_s = {0.05, 0.3};
  product.relaxation_time_s = 2e-3;
  HeldBlock block(product, dt);
  const auto force = [](double t) { return 0.5 * std::pow(std::sin(std::numbers::pi * t / 0.4), 2.0); };
  while (block.time_s() < 0.3 - 1e-9) {
    const double t = block.time_s();
    block.step(force(t) + 1.4 * (force(t + dt) - force(t)));
  }
  return {block.way_m(), block.relaxed_J()};
}

TEST(LatticeRelaxation, IsOfSecondOrderInTheStep) {
  const auto fine = pulled_twice(1.25e-4), a = pulled_twice(4e-3), b = pulled_twice(2e-3), c = pulled_twice(1e-3);
  const auto order = [](double coarse, double finer, double exact) {
    return std::log2(std::abs(coarse - exact) / std::abs(finer - exact));
  };
  EXPECT_NEAR(order(a.first, b.first, fine.first), 2.0, 0.25);
  EXPECT_NEAR(order(b.first, c.first, fine.first), 2.0, 0.25);
  EXPECT_GT(order(a.second, b.second, fine.second), 0.9);
  EXPECT_GT(order(b.second, c.second, fine.second), 0.9);
  std::cout << "[ measured ] order of the way " << order(b.first, c.first, fine.first) << ", of the heat "
            << order(b.second, c.second, fine.second) << "\n";
}

TEST(LatticeRelaxation, WhatABlockLosesIsTheAreaOfItsLoop) {
  // Pulled, held and let go until all is over: the work of the force is heat of the branches, but for the little
  // that damps the block's own swings.
  LatticeParameters product = carrot_block();
  product.prony_time_s = {0.05, 0.3};
  HeldBlock block(product, 1e-3);
  double work = 0.0, way = 0.0;
  const auto force = [](double t) { return t < 0.2 ? 2.5 * t : t < 0.6 ? 0.5 : t < 0.8 ? 2.5 * (0.8 - t) : 0.0; };
  while (block.time_s() < 6.0) {
    const double t = block.time_s(), now = force(t), next = force(t + 1e-3);
    block.step(now + 1.4 * (next - now));
    work += 0.5 * (now + next) * (block.way_m() - way);
    way = block.way_m();
  }
  const double damped = block.body().damped_J(HeldBlock::kLane);
  EXPECT_LT(damped, 0.01 * work);
  EXPECT_NEAR((block.relaxed_J() + damped) / work, 1.0, 2e-3);
  EXPECT_NEAR(block.elastic_J() / work, 0.0, 1e-6);
}

}  // namespace
}  // namespace unbruised

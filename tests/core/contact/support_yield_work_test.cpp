// The fall at which a fruit yields has the energy that a slow press has spent by then.

#include <gtest/gtest.h>

#include "tests/comparison.hpp"
#include "tests/core/contact/fall_scenes.hpp"

namespace unbruised {
namespace {

using namespace testing;

LatticeParameters apple() {
  LatticeParameters apple;
  apple.shape = Shape::ellipsoid;
  apple.size_m = {0.074, 0.074, 0.074};
  apple.cell_size_m = 0.0074;
  apple.mass_kg = 0.18;
  apple.youngs_modulus_Pa = 2.27e6;
  apple.poisson_ratio = 0.3;
  apple.yield_stress_Pa = 0.29e6;
  apple.tangent_modulus_Pa = 0.227e6;
  apple.friction = 0.0;
  return apple;
}

/// Work of one of two fingers with the support's layer that press slowly until the ratio passes 1.
double slow_work_J(const LatticeParameters& product, double grip_force_N) {
  Scenario scenario = kiwi_grip(product.cell_size_m);
  scenario.product = product;
  only_grip(scenario);
  ParallelJawParameters& jaw = jaw_of(scenario);
  jaw.pad_modulus_Pa = scenario.cell.support_modulus_Pa;
  jaw.pad_thickness_m = scenario.cell.support_thickness_m;
  jaw.pad_size_m = {0.08, 0.08};
  jaw.max_force_N = 1e3;
  scenario.strategy.grip_force_N = grip_force_N;
  scenario.strategy.grip_ramp_s = 1.0;
  scenario.simulation.duration_s = 1.2;
  Trace trace;
  run(scenario, &trace);
  const auto force = column(trace, "finger_force_N"), way = column(trace, "finger_way_m"),
             ratio = column(trace, "contact_yield_ratio");
  double work = 0.0;
  for (std::size_t i = 1; i < ratio.size(); ++i) {
    if (ratio[i] > 1.0) return work;
    work += 0.5 * (force[i] + force[i - 1]) * (way[i] - way[i - 1]);
  }
  ADD_FAILURE() << "the fingers do not press hard enough";
  return work;
}

TEST(SupportYield, OfAnAppleComesAtTheWorkOfASlowPress) {
  const double work_J = slow_work_J(apple(), 400.0);
  expect_agreement({"fall of work", "apple, energy of the fall over the work of a slow press that mark it",
                    yield_energy_J(apple(), work_J) / work_J, 1.0},
                   0.1);
}

TEST(SupportYield, OfTheRipeKiwiComesAtTheWorkOfASlowPress) {
  const auto kiwi = std::get<LatticeParameters>(kiwi_grip(0.005).product);
  const double work_J = slow_work_J(kiwi, 12.0);
  expect_agreement({"fall of work", "ripe kiwi, energy of the fall over the work of a slow press that mark it",
                    yield_energy_J(kiwi, work_J) / work_J, 1.0},
                   0.1);
}

}  // namespace
}  // namespace unbruised

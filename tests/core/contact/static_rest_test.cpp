#include "core/contact/static_rest.hpp"

#include <cmath>
#include <random>
#include <thread>
#include <type_traits>

#include <gtest/gtest.h>

#include "core/body/rigid_motion.hpp"
#include "core/simulation/model_parts.hpp"
#include "tests/core/simulation/scenes.hpp"

namespace unbruised {
namespace {

using namespace testing;

std::shared_ptr<const Model> body(Shape shape, int cells) {
  Scenario scenario = small_box();
  lattice_of(scenario).shape = shape;
  lattice_of(scenario).size_m = {0.04, 0.04, 0.04};
  lattice_of(scenario).cell_size_m = 0.04 / cells;
  return build(scenario);
}

TEST(StaticSolver, FreeShapeRecoversTheShapeThatMadeTheForces) {
  const auto model = body(Shape::sphere, 5);
  const auto& parts = model->parts();
  std::mt19937 random(2);
  std::normal_distribution<double> normal(0.0, 1e-3);
  std::vector<double> shape(3 * parts.body.particle_count), force(shape.size());
  for (double& u : shape) u = normal(random);
  multiply(parts.body.K, std::span<const double>(shape), std::span<double>(force));
  std::vector<double> found = parts.body.statics->free_shape(force);
  remove_rigid_motion(parts.body.position_m, shape);
  remove_rigid_motion(parts.body.position_m, found);
  for (std::size_t i = 0; i < shape.size(); ++i) EXPECT_NEAR(found[i], shape[i], 1e-10);
}

TEST(StaticSolver, AnswersManyThreadsAtATimeWithTheSameBits) {
  const auto model = body(Shape::sphere, 5);
  const auto& parts = model->parts();
  std::vector<double> force(3 * parts.body.particle_count);
  for (std::size_t i = 0; i < force.size(); ++i) force[i] = std::sin(static_cast<double>(i));
  const std::vector<double> alone = parts.body.statics->free_shape(force);
  const StaticRest rest = parts.rest->under_gravity(kGravity, 4e8);
  std::vector<std::thread> threads;
  std::vector<int> different(4, 0);
  for (std::size_t k = 0; k < different.size(); ++k) {
    threads.emplace_back([&, k] {
      for (int round = 0; round < 20; ++round) {
        different[k] += parts.body.statics->free_shape(force) != alone;
        different[k] += parts.rest->under_gravity(kGravity, 4e8).displacement_m != rest.displacement_m;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const int count : different) EXPECT_EQ(count, 0);
}

class Rest : public ::testing::TestWithParam<std::tuple<Shape, int>> {
 protected:
  std::shared_ptr<const Model> model = body(std::get<0>(GetParam()), std::get<1>(GetParam()));
  const Model::Parts& parts = model->parts();
  StaticRest rest = parts.rest->under_gravity(kGravity, 4e8);
};

TEST_P(Rest, TheSupportCarriesExactlyTheWeightAndNeverPulls) {
  double sum = 0.0;
  for (std::size_t c = 0; c < rest.normal_force_N.size(); ++c) {
    EXPECT_GE(rest.normal_force_N[c], 0.0);
    if (parts.contact.candidate[c].surface != kSupport) {
      EXPECT_EQ(rest.normal_force_N[c], 0.0);
    }
    sum += rest.normal_force_N[c];
  }
  // The shift that makes the matrix regular is taken out to (s / omega^2)^5 < 1e-12 of the weight.
  EXPECT_NEAR(sum, parts.body.total_mass_kg * kGravity, 1e-9 * parts.body.total_mass_kg * kGravity);
}

TEST_P(Rest, EveryParticleIsInEquilibrium) {
  std::vector<double> force(rest.displacement_m.size());
  multiply(parts.body.K, std::span<const double>(rest.displacement_m), std::span<double>(force));
  for (std::size_t i = 2; i < force.size(); i += 3) force[i] += parts.body.mass_kg[i / 3] * kGravity;
  for (std::size_t c = 0; c < rest.normal_force_N.size(); ++c) {
    force[3 * static_cast<std::size_t>(parts.contact.candidate[c].node) + 2] -= rest.normal_force_N[c];
  }
  for (double residual : force) EXPECT_NEAR(residual, 0.0, 1e-8 * parts.body.total_mass_kg * kGravity);
}

TEST_P(Rest, ASymmetricBodyRestsSymmetrically) {
  for (std::size_t i = 0; i < parts.body.particle_count; ++i) {
    for (std::size_t j = 0; j < parts.body.particle_count; ++j) {
      const auto& p = parts.body.position_m[i];
      const auto& q = parts.body.position_m[j];
      if (p[0] != -q[0] || p[1] != q[1] || p[2] != q[2]) continue;
      // Rounding only: displacements are about 1e-5 m, and rigid motion is held by a weak shift.
      EXPECT_NEAR(rest.displacement_m[3 * i], -rest.displacement_m[3 * j], 1e-12);
      EXPECT_NEAR(rest.displacement_m[3 * i + 1], rest.displacement_m[3 * j + 1], 1e-12);
      EXPECT_NEAR(rest.displacement_m[3 * i + 2], rest.displacement_m[3 * j + 2], 1e-12);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Bodies, Rest,
                         ::testing::Values(std::tuple(Shape::box, 3), std::tuple(Shape::sphere, 4),
                                           std::tuple(Shape::sphere, 7), std::tuple(Shape::cylinder, 4)));

TEST(StaticSolver, AProductAtRestStaysAtRest) {
  for (Shape shape : {Shape::box, Shape::sphere}) {
    Scenario scenario = small_box();
    lattice_of(scenario).shape = shape;
    lattice_of(scenario).cell_size_m = 0.005;
    scenario.gripper = NoGripper{};
    scenario.simulation.duration_s = 0.2;
    Trace trace;
    run(scenario, &trace);
    double moved = 0.0;
    const std::size_t freedoms = 3 * static_cast<std::size_t>(trace.particle_count);
    for (std::size_t i = 0; i < trace.displacement_m.size(); ++i) {
      moved = std::max(moved, std::abs(trace.displacement_m[i] - trace.displacement_m[i % freedoms]));
    }
    // The contact solve stops at 1e-8 of the largest force, which is 1e-8 of a deformation of some 10 um.
    EXPECT_LT(moved, 1e-11);
    std::cout << "[ measured ] moved " << moved << " m in 0.2 s\n";
  }
}

}  // namespace
}  // namespace unbruised

// The stiffness and the mass of a six-axis sensor.

#include "core/scenario/sensor.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace unbruised {
namespace {

SixBySix diagonal(const std::array<double, 6>& values) {
  SixBySix matrix{};
  for (std::size_t i = 0; i < 6; ++i) matrix[7 * i] = values[i];
  return matrix;
}

void expect_near(const SixBySix& matrix, const SixBySix& expected, double relative) {
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t j = 0; j < 6; ++j) {
      const double scale = std::sqrt(expected[7 * i] * expected[7 * j]);
      EXPECT_NEAR(matrix[6 * i + j], expected[6 * i + j], relative * scale) << i << ", " << j;
    }
  }
}

// Li, Wang & Ho (1998), Eqs 3-1 to 3-6.
TEST(SensorStiffness, OfThePapersCross) {
  SixAxisSensorParameters sensor;
  sensor.element_stiffness_N_m = 2.5e6;
  sensor.element_radius_m = 0.02;
  const double K = 2.5e6, a2 = 4e-4;
  const SixBySix expected = diagonal({2 * K, 2 * K, 4 * K, 2 * K * a2, 2 * K * a2, 4 * K * a2});
  expect_near(sensor_stiffness(sensor), expected, 1e-14);
  sensor.model = SensorModel::ring;
  sensor.ring_stiffness_N_m = {0.0, K, K};
  expect_near(sensor_stiffness(sensor), expected, 1e-14);
}

// Any ring of three or more is as stiff along x as along y.
TEST(SensorStiffness, OfARingIsTheSameAllAround) {
  SixAxisSensorParameters sensor;
  sensor.model = SensorModel::ring;
  sensor.ring_stiffness_N_m = {1e6, 2e6, 3e6};
  sensor.element_radius_m = 0.05;
  for (const int count : {3, 5, 8}) {
    sensor.element_count = count;
    const double across = 0.5 * count * (1e6 + 2e6), about = 0.5 * count * 3e6 * 0.0025;
    expect_near(sensor_stiffness(sensor),
                diagonal({across, across, count * 3e6, about, about, count * 2e6 * 0.0025}), 1e-14);
    EXPECT_TRUE(is_positive_definite(sensor_stiffness(sensor)));
  }
}

TEST(SensorStiffness, IsRefusedWhereItHoldsNothing) {
  EXPECT_FALSE(is_positive_definite(diagonal({1e6, 1e6, 1e6, 1e2, 1e2, 0.0})));
  EXPECT_TRUE(is_positive_definite(diagonal({1e9, 1e9, 1e9, 1e-2, 1e-2, 1e-2})));
  SixBySix coupled = diagonal({1e6, 1e6, 1e6, 1e2, 1e2, 1e2});
  coupled[4] = coupled[24] = 1.01e4;  // sqrt(1e6 x 1e2) is the most
  EXPECT_FALSE(is_positive_definite(coupled));
  coupled[4] = coupled[24] = 0.99e4;
  EXPECT_TRUE(is_positive_definite(coupled));
}

// Twice the kinetic energy of a rigid body about another point.
TEST(CarriedMass, HoldsTheKineticEnergy) {
  SixAxisSensorParameters sensor;
  sensor.mass_kg = 2.0;
  sensor.center_of_mass_m = {0.1, -0.2, 0.3};
  sensor.inertia_kg_m2 = {0.01, 0.02, 0.03};
  const SixBySix M = carried_mass(sensor);
  const std::array<double, 6> rate = {1.0, 2.0, 3.0, 4.0, 5.0, 6.0};
  // v + w x c = (1, 2, 3) + (4, 5, 6) x (0.1, -0.2, 0.3)
  const std::array<double, 3> v = {1.0 + 5.0 * 0.3 + 6.0 * 0.2, 2.0 + 6.0 * 0.1 - 4.0 * 0.3,
                                   3.0 - 4.0 * 0.2 - 5.0 * 0.1};
  const double expected = 2.0 * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) + 0.01 * 16 + 0.02 * 25 + 0.03 * 36;
  double energy = 0.0;
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t j = 0; j < 6; ++j) energy += rate[i] * M[6 * i + j] * rate[j];
  }
  EXPECT_NEAR(energy, expected, 1e-12 * expected);
  EXPECT_TRUE(is_positive_definite(M));
}

}  // namespace
}  // namespace unbruised

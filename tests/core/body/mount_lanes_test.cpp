// Rigid bodies on springs, all lanes at once.

#include "core/body/mount_lanes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace unbruised {
namespace {

/// A plate on the paper's cross.
Scenario plate(double mass_kg, double element_N_m, double damping_ratio) {
  Scenario scenario;
  scenario.sensor.at = SensorMount::support;
  scenario.sensor.position_m = {0.0, 0.0, 0.0};
  scenario.sensor.element_stiffness_N_m = element_N_m;
  scenario.sensor.mass_kg = mass_kg;
  scenario.sensor.inertia_kg_m2 = {1e-4, 2e-4, 3e-4};
  scenario.sensor.damping_ratio = damping_ratio;
  return scenario;
}

std::optional<Mount> mount_of(const Scenario& scenario) { return sensor_mount(scenario, {}, {}); }

LaneSix along(std::size_t axis, double value) {
  LaneSix six;
  six[axis] = Lane(value);
  return six;
}

/// Highest place of one freedom in each step, after it was let go under a constant force from rest.
std::vector<double> swings(const Scenario& scenario, std::size_t axis, double force, double dt, int steps) {
  const WilsonTheta w(dt, 1.4);
  MountLanes mounts;
  mounts.load(0, mount_of(scenario), {}, {}, w);
  std::vector<double> place;
  for (int i = 0; i < steps; ++i) {
    mounts.begin_step(w);
    mounts.advance(w, along(axis, force), Mask(true));
    place.push_back(mounts.displacement()[axis][0]);
  }
  return place;
}

// omega_z = sqrt(4K/m), omega_x = sqrt(2K/m), omega_Mz = sqrt(4Ka2/I): a step of force swings to twice its statics
// after half a period.
TEST(MountLanes, SwingsWithItsClosedFrequencies) {
  const Scenario scenario = plate(0.5, 1e5, 0.0);
  const double a2 = 0.03 * 0.03;
  const std::array<double, 6> stiffness = {2e5, 2e5, 4e5, 2e5 * a2, 2e5 * a2, 4e5 * a2};
  const std::array<double, 6> inertia = {0.5, 0.5, 0.5, 1e-4, 2e-4, 3e-4};
  for (std::size_t axis = 0; axis < 6; ++axis) {
    const double half_s = std::numbers::pi * std::sqrt(inertia[axis] / stiffness[axis]);
    const std::vector<double> place = swings(scenario, axis, 1.0, half_s / 200.0, 260);
    const auto top = std::max_element(place.begin(), place.end());
    EXPECT_NEAR(*top, 2.0 / stiffness[axis], 1e-3 * 2.0 / stiffness[axis]) << axis;  // second order, 200 steps
    EXPECT_NEAR(static_cast<double>(top - place.begin() + 1), 200.0, 1.5) << axis;
  }
}

TEST(MountLanes, LosesWhatItsDampingRatioSays) {
  const double zeta = 0.1;
  const Scenario scenario = plate(0.5, 1e5, zeta);
  const double half_s = std::numbers::pi * std::sqrt(0.5 / 4e5);
  const std::vector<double> place = swings(scenario, 2, 1.0, half_s / 400.0, 500);
  const double overshoot = *std::max_element(place.begin(), place.end()) * 4e5 - 1.0;
  EXPECT_NEAR(overshoot, std::exp(-std::numbers::pi * zeta / std::sqrt(1.0 - zeta * zeta)), 2e-3);
}

// 1e6 N/m and 1 kg swing with 1000 rad/s: from 0.1 to 100 of them within a step.
TEST(MountLanes, StayBoundedAtEveryStep) {
  for (const double dt : {1e-4, 1e-3, 1e-2, 1e-1}) {
    const std::vector<double> place = swings(plate(1.0, 2.5e5, 0.0), 2, 10.0, dt, 2000);
    for (const double z : place) ASSERT_LE(std::abs(z), 2.5 * 10.0 / 1e6) << dt;
    EXPECT_NEAR(place.back(), 1e-5, dt > 5e-4 ? 1e-7 : 2e-5) << dt;  // long steps damp what they cannot follow
  }
}

TEST(MountLanes, WithoutAMountNothingMoves) {
  const WilsonTheta w(1e-3, 1.4);
  MountLanes mounts;
  EXPECT_FALSE(mounts.any());
  mounts.load(1, mount_of(plate(1.0, 1e5, 0.02)), {}, {}, w);
  EXPECT_TRUE(mounts.any());
  mounts.begin_step(w);
  mounts.advance(w, along(2, -5.0), Mask(true));
  EXPECT_EQ(mounts.displacement()[2][0], 0.0);
  EXPECT_LT(mounts.displacement()[2][1], 0.0);
  mounts.load(1, std::nullopt, {}, {}, w);
  EXPECT_FALSE(mounts.any());
  EXPECT_EQ(mounts.displacement()[2][1], 0.0);
}

TEST(MountLanes, KeepTheirEnergyAccount) {
  const WilsonTheta w(1e-5, 1.4);
  MountLanes mounts;
  const Six weight = {0.0, 0.0, -4.9, 0.0, 0.0, 0.0};
  mounts.load(0, mount_of(plate(0.5, 1e5, 0.05)), {}, weight, w);
  const double before = mounts.energy()[0];
  double work = 0.0;
  for (int i = 0; i < 2000; ++i) {
    const double z = mounts.twist()[2][0];
    mounts.begin_step(w);
    mounts.advance(w, along(2, 3.0), Mask(true));
    work += 3.0 * (mounts.twist()[2][0] - z);
  }
  const double stored = mounts.energy()[0] - before;
  const double put_in = work + mounts.work()[0];
  EXPECT_NEAR(stored + mounts.dissipated()[0], put_in, 1e-3 * std::abs(work));  // second order in the step
  EXPECT_GT(mounts.dissipated()[0], 0.1 * work);
}

}  // namespace
}  // namespace unbruised

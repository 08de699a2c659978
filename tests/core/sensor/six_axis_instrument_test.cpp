// What the instrument makes of the motion of its mount: statics, transport, filter, sampling, range, noise.

#include "core/sensor/six_axis_instrument.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace unbruised {
namespace {

SixAxisSensorParameters plain() {
  SixAxisSensorParameters sensor;
  sensor.at = SensorMount::support;
  sensor.position_m = {0.0, 0.0, 0.0};
  return sensor;
}

Mount mount_of(const SixAxisSensorParameters& sensor) {
  Scenario scenario;
  scenario.sensor = sensor;
  return *sensor_mount(scenario, {}, {});
}

/// At rest under a wrench of contacts.
MountState at_rest(const Mount& mount, const Six& contact, const Six& own = {}) {
  return {.twist = solve(mount.stiffness, add(own, 1.0, contact)), .own_wrench = own, .contact_wrench = contact};
}

/// Reads it at rest.
Six read_at_rest(const SixAxisSensorParameters& sensor, const Six& contact, const Six& own = {}) {
  const Mount mount = mount_of(sensor);
  SixAxisInstrument instrument(sensor, mount.stiffness, at_rest(mount, {}, own));
  instrument.observe(0.0, 1.0, at_rest(mount, contact, own));
  return instrument.reading();
}

// T1: six unit wrenches, without crosstalk; also with every constant rounded to single precision.
TEST(SixAxisInstrument, ReadsUnitWrenches) {
  std::vector<SixAxisSensorParameters> sensors(3, plain());
  sensors[1].model = SensorModel::datasheet;
  sensors[1].stiffness_N_m = {1e7, 2e7, 3e7};
  sensors[1].stiffness_N_m_rad = {1e3, 2e3, 3e3};
  sensors[2].model = SensorModel::matrix;
  sensors[2].stiffness_matrix = sensor_stiffness(sensors[1]);
  (*sensors[2].stiffness_matrix)[4] = (*sensors[2].stiffness_matrix)[24] = 5e4;
  for (const SixAxisSensorParameters& sensor : sensors) {
    for (std::size_t axis = 0; axis < 6; ++axis) {
      Six contact{};
      contact[axis] = -1.0;
      const Six reading = read_at_rest(sensor, contact);
      for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(reading[i], i == axis ? 1.0 : 0.0, 1e-10) << axis << i;
    }
  }
}

TEST(SixAxisInstrument, ReadsUnitWrenchesInSinglePrecision) {
  const SixAxisSensorParameters sensor = plain();
  const Mount mount = mount_of(sensor);
  const auto rounded = [](Six six) {
    for (double& value : six) value = static_cast<float>(value);
    return six;
  };
  for (std::size_t axis = 0; axis < 6; ++axis) {
    Six contact{};
    contact[axis] = -1.0;
    Mount single = mount;
    for (double& value : single.stiffness) value = static_cast<float>(value);
    SixAxisInstrument instrument(sensor, single.stiffness, {});
    instrument.observe(0.0, 1.0, {.twist = rounded(at_rest(mount, contact).twist)});
    const Six reading = rounded(instrument.reading());
    for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(reading[i], i == axis ? 1.0 : 0.0, 1e-4) << axis << i;
  }
}

// A force of 2 N upwards at (0.1, 0.2, 0) turns about the origin by (0.4, -0.2, 0) N m, and not about its own
// line.
TEST(SixAxisInstrument, MovesItsWrenchToTheReport) {
  SixAxisSensorParameters sensor = plain();
  const Six contact = {0.0, 0.0, -2.0, -0.4, 0.2, 0.0};
  EXPECT_NEAR(read_at_rest(sensor, contact)[3], 0.4, 1e-12);
  EXPECT_NEAR(read_at_rest(sensor, contact)[4], -0.2, 1e-12);
  sensor.report_at_m = {0.1, 0.2, 0.3};
  const Six moved = read_at_rest(sensor, contact);
  for (std::size_t i = 3; i < 6; ++i) EXPECT_NEAR(moved[i], 0.0, 1e-12) << i;
  EXPECT_NEAR(moved[2], 2.0, 1e-12);
}

TEST(SixAxisInstrument, TaresWhatItIsTold) {
  SixAxisSensorParameters sensor = plain();
  const Six own = {0.0, 0.0, -5.0, 0.1, 0.0, 0.0}, contact = {0.0, 0.0, -2.0, 0.0, 0.0, 0.0};
  EXPECT_NEAR(read_at_rest(sensor, contact, own)[2], 2.0, 1e-10);
  EXPECT_NEAR(read_at_rest(sensor, contact, own)[3], 0.0, 1e-12);
  sensor.tare = SensorTare::none;
  EXPECT_NEAR(read_at_rest(sensor, contact, own)[2], 7.0, 1e-10);
  EXPECT_NEAR(read_at_rest(sensor, contact, own)[3], -0.1, 1e-12);
  sensor.tare = SensorTare::start;
  const Mount mount = mount_of(sensor);
  SixAxisInstrument instrument(sensor, mount.stiffness, at_rest(mount, contact, own));
  EXPECT_NEAR(instrument.reading()[2], 0.0, 1e-10);
  EXPECT_NEAR(instrument.compensated()[2], 2.0, 1e-10);
}

/// A ramp of 1 N/ms along z in steps of 1 ms.
SixAxisInstrument after_ramp(const SixAxisSensorParameters& sensor, int steps) {
  const Mount mount = mount_of(sensor);
  SixAxisInstrument instrument(sensor, mount.stiffness, {});
  for (int i = 1; i <= steps; ++i) {
    const double z = -1e-3 * i * 1000.0 / 4e6;
    instrument.observe(1e-3 * (i - 1), 1e-3 * i, {.twist = {0.0, 0.0, z}, .velocity = {0.0, 0.0, -1000.0 / 4e6}});
  }
  return instrument;
}

// The first-order low pass of a ramp c t: c (t - tau (1 - exp(-t / tau))).
TEST(SixAxisInstrument, FiltersARampAsItsClosedForm) {
  SixAxisSensorParameters sensor = plain();
  sensor.bandwidth_Hz = 50.0;
  const double tau = 1.0 / (2.0 * std::numbers::pi * 50.0), t = 0.007;
  // Before the first step it stood still: the ramp's speed appears within it.
  EXPECT_NEAR(after_ramp(sensor, 7).reading()[2], 1000.0 * (t - tau * (1.0 - std::exp(-t / tau))), 0.1);
  sensor.bandwidth_Hz.reset();
  EXPECT_NEAR(after_ramp(sensor, 7).reading()[2], 7.0, 1e-9);
}

TEST(SixAxisInstrument, HoldsItsLastSample) {
  SixAxisSensorParameters sensor = plain();
  sensor.rate_Hz = 400.0;  // at 5 ms and 7.5 ms
  EXPECT_NEAR(after_ramp(sensor, 7).reading()[2], 5.0, 1e-9);
  EXPECT_NEAR(after_ramp(sensor, 8).reading()[2], 7.5, 1e-9);
}

TEST(SixAxisInstrument, ReadsStepsOfItsResolutionWithinItsRange) {
  SixAxisSensorParameters sensor = plain();
  sensor.resolution_N = 0.4;
  sensor.range_N = 5.0;
  EXPECT_NEAR(after_ramp(sensor, 3).reading()[2], 3.2, 1e-12);
  EXPECT_NEAR(*after_ramp(sensor, 3).overload(), 3.2 / 5.0, 1e-12);
  EXPECT_EQ(after_ramp(sensor, 6).reading()[2], 5.0);
  EXPECT_NEAR(*after_ramp(sensor, 6).overload(), 6.0 / 5.0, 1e-12);
  EXPECT_EQ(after_ramp(plain(), 7).overload(), std::nullopt);
}

TEST(SixAxisInstrument, HasTheNoiseOfItsSeed) {
  SixAxisSensorParameters sensor = plain();
  sensor.rate_Hz = 1000.0;
  sensor.noise_N = 0.5;
  sensor.noise_N_m = 0.01;
  const Mount mount = mount_of(sensor);
  SixAxisInstrument one(sensor, mount.stiffness, {}), again(sensor, mount.stiffness, {});
  sensor.noise_seed = 2;
  SixAxisInstrument other(sensor, mount.stiffness, {});
  double squares_N = 0.0, squares_N_m = 0.0, across = 0.0;
  constexpr int kSamples = 20000;
  for (int i = 1; i <= kSamples; ++i) {
    for (SixAxisInstrument* each : {&one, &again, &other}) each->observe(1e-3 * (i - 1), 1e-3 * i, {});
    ASSERT_EQ(one.reading(), again.reading());
    squares_N += one.reading()[0] * one.reading()[0];
    squares_N_m += one.reading()[5] * one.reading()[5];
    across += one.reading()[0] * other.reading()[0] + one.reading()[0] * one.reading()[1];
  }
  // The deviation of a deviation of 20,000 samples is 0.5 %; four of them.
  EXPECT_NEAR(std::sqrt(squares_N / kSamples), 0.5, 0.01);
  EXPECT_NEAR(std::sqrt(squares_N_m / kSamples), 0.01, 2e-4);
  EXPECT_NEAR(across / kSamples / 0.25, 0.0, 0.04);
}

}  // namespace
}  // namespace unbruised

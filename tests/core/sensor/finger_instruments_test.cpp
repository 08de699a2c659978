// When instruments sample, what they hold, how they scatter, and when they show what a guard waits for.

#include "core/sensor/finger_instruments.hpp"

#include <cmath>
#include <functional>
#include <vector>

#include <gtest/gtest.h>

#include "core/sensor/sample_clock.hpp"

namespace unbruised {
namespace {

constexpr double kStep_s = 1e-3;

Scenario sensing() {
  Scenario scenario;
  scenario.gripper = ParallelJawParameters{};
  jaw_of(scenario).range.maximum_m = 0.1;
  return scenario;
}

FingerSigns signs(double distance_m, double force_N = 0.0) {
  FingerSigns now;
  now.distance_m.fill(distance_m);
  now.force_N = {0.5 * force_N, force_N};
  return now;
}

/// Runs through a motion, and shows the reading of the first finger at the end of each step.
std::vector<double> readings(FingerInstruments& instruments, int steps,
                             const std::function<FingerSigns(double)>& at_time) {
  std::vector<double> all;
  instruments.start(at_time(0.0));
  for (int n = 0; n < steps; ++n) {
    instruments.observe(n * kStep_s, (n + 1) * kStep_s, at_time((n + 1) * kStep_s));
    all.push_back(instruments.range_m()[0]);
  }
  return all;
}

TEST(SampleClock, PutsEverySampleIntoOneStep) {
  for (const double rate_Hz : {1.0 / 3e-4, 1000.0, 300.0, 7.0}) {
    const SampleClock clock(rate_Hz);
    for (int n = 0; n < 4000; ++n) {
      const double start_s = n * 3e-4, end_s = (n + 1) * 3e-4;
      for (std::int64_t k = clock.last(start_s) + 1; k <= clock.last(end_s); ++k) {
        EXPECT_GT(clock.time_s(k), start_s);
        EXPECT_LE(clock.time_s(k), end_s);
      }
      EXPECT_LE(clock.last(end_s) - clock.last(start_s), 1 + (rate_Hz * 3e-4 > 0.999 ? 1 : 0));
    }
  }
}

TEST(FingerInstruments, HoldASampleUntilTheNextAndReadBetweenSteps) {
  Scenario scenario = sensing();
  jaw_of(scenario).range.rate_Hz = 300.0;
  FingerInstruments instruments(scenario);
  const auto closing = [](double time_s) { return signs(0.05 - 0.2 * time_s); };
  const std::vector<double> read = readings(instruments, 20, closing);
  for (int n = 0; n < 20; ++n) {
    // The last sample at or before the end of the step, of a motion that is a straight line.
    const double sample_s = std::floor((n + 1) * kStep_s * 300.0 + 1e-9) / 300.0;
    EXPECT_NEAR(read[static_cast<std::size_t>(n)], 0.05 - 0.2 * sample_s, 1e-15) << n;
  }
}

TEST(FingerInstruments, ReadAtAllTimesWithoutARate) {
  FingerInstruments instruments(sensing());
  const std::vector<double> read =
      readings(instruments, 10, [](double time_s) { return signs(0.05 - 0.2 * time_s); });
  EXPECT_NEAR(read[4], 0.05 - 0.2 * 5.0 * kStep_s, 1e-15);
}

TEST(FingerInstruments, ReadTheMaximumWhereTheRayMeetsNothingNearer) {
  Scenario scenario = sensing();
  jaw_of(scenario).range.rate_Hz = 1000.0;
  jaw_of(scenario).range.noise_m = 1e-3;
  FingerInstruments instruments(scenario);
  const auto passing = [](double time_s) { return signs(time_s < 4.5e-3 ? HUGE_VAL : 0.05); };
  const std::vector<double> read = readings(instruments, 10, passing);
  EXPECT_EQ(read[2], 0.1);
  EXPECT_NEAR(read[6], 0.05, 6e-3);
  EXPECT_EQ(readings(instruments, 3, [](double) { return signs(0.2); })[1], 0.1);
}

TEST(FingerInstruments, ReadMultiplesOfTheResolution) {
  Scenario scenario = sensing();
  jaw_of(scenario).range.resolution_m = 0.002;
  FingerInstruments instruments(scenario);
  const std::vector<double> read = readings(instruments, 40, [](double time_s) { return signs(0.05 - time_s); });
  for (std::size_t n = 0; n < read.size(); ++n) {
    EXPECT_NEAR(std::remainder(read[n], 0.002), 0.0, 1e-15);
    EXPECT_NEAR(read[n], 0.05 - (static_cast<double>(n) + 1.0) * kStep_s, 0.001 + 1e-12);
  }
}

TEST(FingerInstruments, ScatterByTheGivenDeviationAndAlikeForTheSameSeed) {
  Scenario scenario = sensing();
  jaw_of(scenario).range.rate_Hz = 1000.0;
  jaw_of(scenario).range.noise_m = 2e-4;
  const auto still = [](double) { return signs(0.05); };
  FingerInstruments first(scenario), again(scenario);
  constexpr int kSamples = 20000;
  const std::vector<double> read = readings(first, kSamples, still);
  EXPECT_EQ(read, readings(again, kSamples, still));
  double mean = 0.0, square = 0.0;
  for (const double value : read) {
    mean += (value - 0.05) / kSamples;
    square += (value - 0.05) * (value - 0.05) / kSamples;
  }
  // Five standard errors.
  EXPECT_NEAR(mean, 0.0, 5.0 * 2e-4 / std::sqrt(kSamples));
  EXPECT_NEAR(std::sqrt(square), 2e-4, 5.0 * 2e-4 / std::sqrt(2.0 * kSamples));
  EXPECT_NE(first.range_m()[0], first.range_m()[1]) << "each finger has a noise of its own";
  jaw_of(scenario).range.noise_seed = 2;
  FingerInstruments other(scenario);
  EXPECT_NE(readings(other, 10, still)[9], read[9]);
}

TEST(FingerInstruments, ShowTheGuardAtASampleOrWhereTheReadingCrossesIt) {
  Scenario scenario = sensing();
  scenario.strategy.guard = GuardKind::range;
  scenario.strategy.guard_range_m = 0.0491;
  // The distance passes 49.1 mm at 4.5 ms.
  const auto closing = [](double time_s) { return signs(0.05 - 0.2 * time_s); };
  FingerInstruments steady(scenario);
  readings(steady, 10, closing);
  EXPECT_NEAR(steady.guard_s().value(), 4.5e-3, 1e-12);
  jaw_of(scenario).range.rate_Hz = 300.0;
  FingerInstruments sampling(scenario);
  readings(sampling, 10, closing);
  EXPECT_EQ(sampling.guard_s(), 2.0 / 300.0) << "the first sample after it";
  FingerInstruments away(scenario);
  readings(away, 10, [](double) { return signs(0.05); });
  EXPECT_FALSE(away.guard_s());
}

TEST(FingerInstruments, ShowTheGuardWhereTheLargerForceExceedsIt) {
  Scenario scenario = sensing();
  jaw_of(scenario).range.maximum_m.reset();
  scenario.strategy.guard = GuardKind::force;
  scenario.strategy.guard_force_N = 0.45;
  const auto pressing = [](double time_s) { return signs(0.0, 100.0 * time_s); };
  FingerInstruments steady(scenario);
  readings(steady, 10, pressing);
  EXPECT_NEAR(steady.guard_s().value(), 4.5e-3, 1e-12);
  jaw_of(scenario).force_rate_Hz = 300.0;
  FingerInstruments sampling(scenario);
  readings(sampling, 10, pressing);
  EXPECT_EQ(sampling.guard_s(), 2.0 / 300.0);
}

TEST(FingerInstruments, AreIdleWithoutSensorsAndGuard) {
  Scenario scenario;
  EXPECT_TRUE(FingerInstruments(scenario).idle());
  scenario.gripper = ParallelJawParameters{};
  EXPECT_TRUE(FingerInstruments(scenario).idle());
}

}  // namespace
}  // namespace unbruised

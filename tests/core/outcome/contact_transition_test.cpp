// Bounces and forces written by hand, against the times and counts they have.

#include "core/outcome/contact_transition.hpp"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

namespace unbruised {
namespace {

constexpr double kStep_s = 0.01;

/// First contact at 0.1 s, the lift from 0.3 s on.
Scenario scene() {
  Scenario scenario;
  scenario.gripper = ParallelJawParameters{};
  scenario.strategy.grip_ramp_s = 0.1;
  scenario.strategy.settle_s = 0.1;
  return scenario;
}

using Fingers = std::array<TouchObservation, kJawFingers>;

/// The metrics of what the fingers show at the end of each step, until `end_s`.
Metrics metrics_of(const std::function<Fingers(double)>& fingers, double end_s = 0.5) {
  HandlingCycle cycle(scene());
  ContactTransition transition;
  for (int n = 1; n * kStep_s < end_s + 1e-9; ++n) {
    const double time_s = n * kStep_s;
    cycle.observe(time_s, time_s >= 0.1 ? std::optional(0.1) : std::nullopt);
    transition.observe(time_s, fingers(time_s), cycle);
  }
  Metrics metrics;
  transition.measure(metrics);
  return metrics;
}

/// Of one finger that touches from `from_s` on with a force.
TouchObservation touching(double time_s, double from_s, double force_N) {
  if (time_s < from_s) return {};
  return {.touches = true, .touched_s = time_s - from_s < kStep_s ? from_s : kNever, .force_N = force_N};
}

TEST(ContactTransition, OfFingersThatStayHasNoReboundAndNoLoss) {
  const Metrics metrics = metrics_of([](double t) {
    return Fingers{touching(t, 0.1, 2.0), touching(t, 0.1, 2.0)};
  });
  EXPECT_EQ(metrics[Metric::contact_rebounds], 0.0);
  EXPECT_EQ(metrics[Metric::contact_loss_s], 0.0);
}

TEST(ContactTransition, CountsWhatEachFingerLosesBetweenItsTouchAndTheLift) {
  // The first finger leaves at 0.153 s and comes back at 0.178 s; the second touches at 0.12 s, leaves at 0.205 s
  // and is still away as the lift starts.
  const Metrics metrics = metrics_of([](double t) {
    Fingers fingers = {touching(t, 0.1, 2.0), touching(t, 0.12, 2.0)};
    if (t > 0.153 && t < 0.178) fingers[0] = {.left_s = t < 0.163 ? 0.153 : kNever};
    if (t > 0.178 && t < 0.188) fingers[0].touched_s = 0.178;
    if (t > 0.205) fingers[1] = {.left_s = t < 0.215 ? 0.205 : kNever};
    return fingers;
  });
  EXPECT_EQ(metrics[Metric::contact_rebounds], 2.0);
  EXPECT_NEAR(metrics[Metric::contact_loss_s], 0.025 + 0.095, 1e-12);
  EXPECT_TRUE(std::isnan(metrics[Metric::time_to_steady_force_s]))
      << "a finger that holds nothing as the lift starts";
}

TEST(ContactTransition, LooksAwayAfterTheStartOfTheLift) {
  const Metrics metrics = metrics_of([](double t) {
    return Fingers{touching(t, 0.1, 2.0), t > 0.31 ? TouchObservation{.left_s = t} : touching(t, 0.1, 2.0)};
  });
  EXPECT_EQ(metrics[Metric::contact_rebounds], 0.0);
  EXPECT_EQ(metrics[Metric::contact_loss_s], 0.0);
}

TEST(ContactTransition, IsSteadyWhereTheForceComesIntoItsBandForTheLastTime) {
  // A ramp of 20 N/s up to 2 N at 0.2 s: 1.9 N at 0.195 s. The second finger swings past 2.1 N until 0.25 s, from
  // where it falls by 0.3 N in a step.
  const Metrics metrics = metrics_of([](double t) {
    const double ramp_N = std::min(2.0, 20.0 * (t - 0.1));
    return Fingers{touching(t, 0.1, ramp_N), touching(t, 0.1, t < 0.2501 ? ramp_N + (t > 0.2 ? 0.3 : 0.0) : 2.0)};
  });
  EXPECT_NEAR(metrics[Metric::time_to_steady_force_s], 0.15 + kStep_s * 0.2 / 0.3, 1e-9);
  const Metrics one = metrics_of([](double t) {
    const double ramp_N = std::min(2.0, 20.0 * (t - 0.1));
    return Fingers{touching(t, 0.1, ramp_N), touching(t, 0.1, ramp_N)};
  });
  EXPECT_NEAR(one[Metric::time_to_steady_force_s], 0.095, 1e-9);
}

TEST(ContactTransition, HasNoSteadyForceWithoutALift) {
  const auto held = [](double t) { return Fingers{touching(t, 0.1, 2.0), touching(t, 0.1, 2.0)}; };
  const Metrics metrics = metrics_of(held, 0.25);
  EXPECT_TRUE(std::isnan(metrics[Metric::time_to_steady_force_s]));
  EXPECT_EQ(metrics[Metric::contact_rebounds], 0.0);
}

}  // namespace
}  // namespace unbruised

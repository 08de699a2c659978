#include "studies/goals/verdict.hpp"

#include <gtest/gtest.h>

namespace unbruised::studies {
namespace {

Metrics metrics_with(Metric metric, double value) {
  Metrics metrics;
  metrics[metric] = value;
  return metrics;
}

TEST(Verdict, ARunThatSlippedAndIsDamagedNeitherHoldsNorIsUndamaged) {
  LimitParameters limits;
  limits.permanent_set_m = 1e-4;
  Metrics metrics = metrics_with(Metric::permanent_set_max_m, 2e-4);
  metrics[Metric::slip_max_m] = 3e-3;
  EXPECT_EQ(holds(metrics, Outcome::slipped, limits), Verdict::no);
  EXPECT_EQ(undamaged(metrics, Outcome::slipped, limits), Verdict::no);
}

TEST(Verdict, DamageDoesNotMeanThatTheGripFails) {
  LimitParameters limits;
  limits.plastic_strain = 0.01;
  const Metrics metrics = metrics_with(Metric::plastic_strain_max, 0.02);
  EXPECT_EQ(holds(metrics, Outcome::damaged, limits), Verdict::yes);
  EXPECT_EQ(undamaged(metrics, Outcome::damaged, limits), Verdict::no);
}

TEST(Verdict, ADroppedProductCanBeUndamaged) {
  LimitParameters limits;
  limits.plastic_strain = 0.01;
  const Metrics metrics = metrics_with(Metric::plastic_strain_max, 0.0);
  EXPECT_EQ(holds(metrics, Outcome::dropped, limits), Verdict::no);
  EXPECT_EQ(holds(metrics, Outcome::not_grasped, limits), Verdict::no);
  EXPECT_EQ(undamaged(metrics, Outcome::dropped, limits), Verdict::yes);
}

TEST(Verdict, LimitsThemselvesAreAllowed) {
  LimitParameters limits;
  limits.finger_force_N = 30.0;
  Metrics metrics = metrics_with(Metric::peak_finger_force_N, 30.0);
  metrics[Metric::slip_max_m] = limits.slip_m;
  EXPECT_EQ(holds(metrics, Outcome::held, limits), Verdict::yes);
  EXPECT_EQ(undamaged(metrics, Outcome::held, limits), Verdict::yes);
}

TEST(Verdict, EveryDamageLimitIsLookedAt) {
  const auto judged = [](Metric metric, std::optional<double> LimitParameters::*limit) {
    LimitParameters limits;
    limits.*limit = 1.0;
    return undamaged(metrics_with(metric, 1.5), Outcome::held, limits);
  };
  EXPECT_EQ(judged(Metric::permanent_set_max_m, &LimitParameters::permanent_set_m), Verdict::no);
  EXPECT_EQ(judged(Metric::plastic_strain_max, &LimitParameters::plastic_strain), Verdict::no);
  EXPECT_EQ(judged(Metric::bruised_volume_m3, &LimitParameters::bruised_volume_m3), Verdict::no);
  EXPECT_EQ(judged(Metric::peak_pressure_Pa, &LimitParameters::peak_pressure_Pa), Verdict::no);
  EXPECT_EQ(judged(Metric::absorbed_energy_J, &LimitParameters::absorbed_energy_J), Verdict::no);
  EXPECT_EQ(judged(Metric::peak_finger_force_N, &LimitParameters::finger_force_N), Verdict::no);
  EXPECT_EQ(judged(Metric::contact_yield_ratio_max, &LimitParameters::contact_yield_ratio), Verdict::no);
  EXPECT_EQ(judged(Metric::contact_yield_ratio_max, &LimitParameters::finger_force_N), Verdict::yes);
}

TEST(Verdict, ARunThatEndedEarlyIsUnknownUnlessALimitWasExceededBefore) {
  LimitParameters limits;
  limits.plastic_strain = 0.01;
  EXPECT_EQ(holds({}, Outcome::out_of_range, limits), Verdict::unknown);
  EXPECT_EQ(undamaged({}, Outcome::diverged, limits), Verdict::unknown);
  EXPECT_EQ(undamaged(metrics_with(Metric::plastic_strain_max, 0.2), Outcome::out_of_range, limits), Verdict::no);
  EXPECT_EQ(holds(metrics_with(Metric::slip_max_m, 0.2), Outcome::out_of_range, limits), Verdict::no);
}

}  // namespace
}  // namespace unbruised::studies

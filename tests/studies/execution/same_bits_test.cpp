/// @file
/// The shipped kiwi sweep gives the same bits whatever the threads, the order and the company of a scenario, and
/// its balances hold. The quick tests run every seventh scenario of it on coarse cells, the heavy ones all of it
/// as shipped.

#include <algorithm>
#include <atomic>
#include <map>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

#include "studies/config/study.hpp"
#include "studies/execution/batch_runner.hpp"
#include "studies/execution/lane_executor.hpp"
#include "studies/execution/lone_run.hpp"
#include "studies/goals/verdict.hpp"
#include "studies/results/digest.hpp"
#include "tests/places.hpp"

namespace unbruised::studies {
namespace {

Study kiwi_sweep(const std::vector<std::string>& sets) {
  const std::string root = std::string(UNBRUISED_SOURCE_DIR) + "/configs";
  return read_study(root + "/kiwi_sweep.toml", sets, root).value();
}

using Results = std::map<std::uint64_t, ScenarioResult>;

Results run_ids(const Study& study, const std::vector<std::uint64_t>& ids, int threads) {
  Batch batch;
  batch.ids = ids;
  batch.scenario = [&study](std::uint64_t id) { return study.scenario(id); };
  Results results;
  run_batch(LaneExecutor(core_simulator(), threads), batch,
            [&results](std::uint64_t id, const ScenarioResult& result) { results[id] = result; });
  return results;
}

std::string digest_of(const Results& results) {
  std::vector<std::uint64_t> digests;
  for (const auto& [id, result] : results) digests.push_back(result_digest(result));
  return digest_text(digest_of_digests(digests));
}

/// Reversed, then shuffled: any order of handing out gives other neighbours in the lanes.
std::vector<std::vector<std::uint64_t>> other_orders(std::vector<std::uint64_t> ids) {
  std::reverse(ids.begin(), ids.end());
  std::vector<std::vector<std::uint64_t>> orders = {ids};
  std::mt19937_64 random(7);
  std::shuffle(ids.begin(), ids.end(), random);
  orders.push_back(ids);
  return orders;
}

/// What is compared has to be there: results of runs that failed, and no results at all, are the same bits too.
void expect_simulated(const Results& results, const std::vector<std::uint64_t>& ids) {
  ASSERT_FALSE(ids.empty());
  ASSERT_EQ(results.size(), ids.size());
  for (const auto& [id, result] : results) {
    EXPECT_GT(result.metrics[Metric::step_count], 0.0) << "scenario " << id;
    EXPECT_NE(result.outcome, Outcome::diverged) << "scenario " << id << ": " << result.cause;
  }
}

void expect_same_bits(const Study& study, const std::vector<std::uint64_t>& ids, std::size_t alone_stride) {
  const Results once = run_ids(study, ids, 1);
  expect_simulated(once, ids);
  const std::string digest = digest_of(once);
  EXPECT_EQ(digest_of(run_ids(study, ids, 2)), digest) << "two threads";
  for (const auto& order : other_orders(ids))
    EXPECT_EQ(digest_of(run_ids(study, order, 2)), digest) << "another order";
  for (std::size_t i = 0; i < ids.size(); i += alone_stride) {
    const auto alone = run_alone(core_simulator(), study.scenario(ids[i]), nullptr, nullptr);
    ASSERT_TRUE(alone.has_value());
    EXPECT_EQ(result_digest(*alone), result_digest(once.at(ids[i]))) << "scenario " << ids[i] << " alone";
  }
}

bool is_lost(Outcome outcome) {
  return outcome == Outcome::slipped || outcome == Outcome::dropped || outcome == Outcome::not_grasped;
}
bool is_kept(Outcome outcome) { return outcome == Outcome::held || outcome == Outcome::damaged; }

/// Energy may not appear: what the quadrature of the account itself can show (trapezoid rule in time, some 20
/// steps per contact) is of the order 1e-4 of the work put in, 4.6e-4 seen at steps of 2 ms and, as the rule is of
/// second order, up to four times that where levels make them 4 ms (1.1e-3 seen); a real gain is a hundred times
/// that.
constexpr double kGainMost = 2e-3;
/// Nor may it vanish but by Wilson-theta's damping of impacts. Of a product that is kept the work of the cycle is
/// put in, and 0.7 % of it is seen to go that way at 2 ms; of one that is lost at once little more than the impact
/// itself is, and 6.3 % are seen.
constexpr double kLossMostKept = 0.02;
constexpr double kLossMostLost = 0.1;

void expect_balances(const Results& results) {
  double impulse = 0.0, energy = -1.0, least_energy = 1.0;
  for (const auto& [id, result] : results) {
    const double error = result.metrics[Metric::energy_balance_error];
    impulse = std::max(impulse, result.metrics[Metric::impulse_balance_error]);
    energy = std::max(energy, error);
    least_energy = std::min(least_energy, error);
    EXPECT_LT(result.metrics[Metric::impulse_balance_error], 5e-3) << "scenario " << id;
    EXPECT_LT(error, kGainMost) << "scenario " << id;
    EXPECT_GT(error, is_kept(result.outcome) ? -kLossMostKept : -kLossMostLost) << "scenario " << id;
  }
  std::printf("largest impulse balance error %.3g, energy balance errors %.3g to %.3g\n", impulse, least_energy,
              energy);
}

std::vector<std::uint64_t> all_ids(const Study& study) {
  std::vector<std::uint64_t> ids(study.scenario_count());
  std::iota(ids.begin(), ids.end(), 0);
  return ids;
}

TEST(SameBits, CoarseKiwiSweepForAnyThreadsOrderAndCompany) {
  const Study study = kiwi_sweep({"product.cell_size_m=0.0125", "simulation.time_step_s=2e-3"});
  std::vector<std::uint64_t> ids;
  for (std::uint64_t id = 0; id < study.scenario_count(); id += 7) ids.push_back(id);
  expect_same_bits(study, ids, 10);
  const Results results = run_ids(study, ids, 2);
  expect_simulated(results, ids);
  expect_balances(results);
}

TEST(HeavySameBits, KiwiSweepAsShippedForAnyThreadsOrderAndCompany) {
  const Study study = kiwi_sweep({});
  expect_same_bits(study, all_ids(study), 101);
}

TEST(HeavySameBits, KiwiSweepKeepsItsBalancesAndItsClosedFormHoldLimit) {
  const Study study = kiwi_sweep({});
  const Results results = run_ids(study, all_ids(study), 2);
  expect_simulated(results, all_ids(study));
  expect_balances(results);
  std::size_t below = 0;
  std::size_t above = 0;
  for (const auto& [id, result] : results) {
    const Scenario scenario = study.scenario(id);
    const auto& product = std::get<LatticeParameters>(scenario.product);
    const double needed =
        *product.mass_kg * (9.80665 + scenario.strategy.lift_acceleration_m_s2) / (2.0 * product.friction);
    // Well off the closed form the answer must be plain, where the fingers close gently enough not to bounce off.
    if (scenario.strategy.approach_speed_m_s > 0.1) continue;
    if (scenario.strategy.grip_force_N < 0.85 * needed) {
      ++below;
      // Some turn out of the pads before they fall, which an upright product is not followed in.
      const bool slips_away = result.outcome == Outcome::out_of_range &&
                              result.metrics[Metric::slip_max_m] > 5.0 * scenario.limits.slip_m;
      EXPECT_TRUE(is_lost(result.outcome) || slips_away)
          << "scenario " << id << ": " << outcome_word(result.outcome);
    }
    if (scenario.strategy.grip_force_N > 1.1 * needed) {
      ++above;
      EXPECT_TRUE(is_kept(result.outcome)) << "scenario " << id << ": " << outcome_word(result.outcome);
    }
  }
  EXPECT_GT(below, 0U);
  EXPECT_GT(above, 0U);
}

}  // namespace
}  // namespace unbruised::studies

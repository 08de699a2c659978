#include "studies/estimate/study_cost.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/motion/motion_plan.hpp"
#include "studies/estimate/cost_estimate.hpp"
#include "studies/estimate/memory_need.hpp"
#include "studies/kinds/kind_table.hpp"
#include "studies/scenarios/scenario_set.hpp"

namespace unbruised::studies {
namespace {

/// Bytes of a row, in the journal and again in results.h5, beside its metrics and inputs.
constexpr double kRowBytesBesideColumns = 160.0;
/// Of more scenarios some, evenly spaced, say how many steps they all take: to go through a plan takes 0.2 ms.
constexpr std::size_t kStepsLookedAt = 1000;
/// Of more factor groups the others are taken to be like these.
constexpr std::size_t kGroupsLookedAt = 10000;

/// The scenarios of one factor key.
struct GroupCost {
  ModelSize size;
  double lane_step_s = 0.0;  ///< of its first scenario
  std::size_t count = 0;
  std::size_t looked_at = 0;
  double steps = 0.0;  ///< of those that were looked at

  [[nodiscard]] double mean_steps() const { return steps / static_cast<double>(looked_at); }
};

struct KnownCost {
  std::vector<GroupCost> groups;       ///< of more than kGroupsLookedAt those that come first
  std::vector<ModelSize> other_sizes;  ///< of some of the others
  std::size_t group_count = 0;         ///< of all
  std::size_t looked_at = 0;           ///< scenarios of `groups`
  std::vector<std::size_t> group_of;   ///< of each scenario
  double longest_run_s = 0.0;
};

KnownCost known_cost(const ScenarioSet& set) {
  KnownCost cost;
  GroupNumbers groups;
  cost.group_of.reserve(set.count);
  const std::size_t stride = (set.count / kStepsLookedAt) | 1;  // odd, so that no variable is left standing
  for (std::size_t point = 0; point < set.count; ++point) {
    const Scenario scenario = set.scenario(point);
    const std::size_t number = groups.number_of(scenario);
    cost.group_of.push_back(number);
    cost.longest_run_s = std::max(cost.longest_run_s, planned_end_s(scenario));
    if (number >= kGroupsLookedAt) {
      if (point % stride == 0) cost.other_sizes.push_back(model_size(scenario));
      continue;
    }
    const bool is_new = number == cost.groups.size();
    if (is_new) {
      const ModelSize size = model_size(scenario);
      cost.groups.push_back({.size = size, .lane_step_s = estimated_lane_step_s(scenario, size)});
    }
    GroupCost& group = cost.groups[number];
    ++group.count;
    ++cost.looked_at;
    if (is_new || point % stride == 0) {
      ++group.looked_at;
      group.steps += estimated_steps(scenario);
    }
  }
  cost.group_count = groups.count();
  return cost;
}

/// In full lanes: what a batch leaves empty costs as much as what is filled, up to half of it.
double paid_lanes(double scenarios) {
  const double half = 0.5 * lane_count();
  return std::max(1.0, std::ceil(scenarios / half)) * half;
}

double compute_seconds(const KnownCost& known, const Evaluations& evaluations, int threads) {
  double seconds = 0.0, batches = 0.0;  // of a round
  for (const GroupCost& group : known.groups) {
    const double scenarios = evaluations.each * static_cast<double>(group.count) / evaluations.rounds;
    batches += std::ceil(scenarios / lane_count());
    seconds += paid_lanes(scenarios) * group.mean_steps() * group.lane_step_s;
  }
  const double all = static_cast<double>(known.group_of.size()) / static_cast<double>(known.looked_at);
  batches *= all;
  return evaluations.rounds * seconds * all /
         std::min(static_cast<double>(threads), batches);  // a batch is one thread's
}

double memory_bytes(const KnownCost& known, int threads) {
  std::vector<ModelSize> sizes;
  for (const GroupCost& group : known.groups) sizes.push_back(group.size);
  return estimated_run_bytes(std::move(sizes), threads);
}

double disk_bytes(const Study& study, const KnownCost& known, std::size_t inputs, double evaluations) {
  const double columns = static_cast<double>(kMetricCount + inputs + 1) * sizeof(double);
  double bytes = evaluations * 2.0 * (columns + kRowBytesBesideColumns);
  if (leaves_trace(study.kind())) {
    bytes += estimated_trace_bytes(study.scenario(0), known.groups.front().size);
  }
  return bytes;
}

}  // namespace

StudyCost study_cost(const Study& study, int threads) {
  const ScenarioFamily& family = *runner_of(study.kind()).scenarios;
  const ScenarioSet set = family.known(study);
  const KnownCost known = known_cost(set);
  const Evaluations evaluations = family.evaluations(study, known.group_of);
  StudyCost cost{.scenarios = evaluations.each * static_cast<double>(set.count), .groups = known.group_count};
  std::vector<ModelSize> sizes = known.other_sizes;
  for (const GroupCost& group : known.groups) sizes.push_back(group.size);
  const auto [least, most] = std::ranges::minmax_element(sizes, {}, &ModelSize::freedom_count);
  cost.least = *least;
  cost.most = *most;
  for (const GroupCost& group : known.groups) {
    cost.steps_each += static_cast<double>(group.count) * group.mean_steps();
  }
  cost.steps_each /= static_cast<double>(known.looked_at);
  cost.longest_run_s = known.longest_run_s;
  cost.memory_bytes =
      memory_bytes(known, threads) + estimated_rows_bytes(study.kind(), cost.scenarios, set.columns.size());
  cost.disk_bytes = disk_bytes(study, known, set.columns.size(), cost.scenarios);
  cost.seconds = compute_seconds(known, evaluations, threads);
  cost.threads = threads;
  return cost;
}

ProgressPlan progress_plan(const Study& study, const StudyCost& cost) {
  return {.scenarios = std::round(cost.scenarios),
          .steps_each = cost.steps_each,
          .seconds_per_step = cost.seconds / (cost.scenarios * cost.steps_each),
          .may_end_sooner = runner_of(study.kind()).scenarios->count == ScenarioCount::at_most};
}

}  // namespace unbruised::studies

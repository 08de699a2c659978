#include "studies/results/row_summary.hpp"

#include <cmath>

#include "core/outcome/peak_rise.hpp"
#include "studies/results/digest.hpp"

namespace unbruised::studies {
namespace {

void keep_worse(std::optional<ScenarioRow>& worst, const ScenarioRow& row, Metric metric) {
  const double size = std::abs(row.result.metrics[metric]);
  if (std::isnan(size) || (worst && !(size > std::abs(worst->result.metrics[metric])))) return;
  worst = row;
}

void keep_better(std::optional<ScenarioRow>& best, const ScenarioRow& row) {
  const double cycle_time_s = row.result.metrics[Metric::cycle_time_s];
  if (row.result.outcome != Outcome::held || std::isnan(cycle_time_s)) return;
  const double least_s = best ? best->result.metrics[Metric::cycle_time_s] : kAbsent;
  if (!best || cycle_time_s < least_s || (cycle_time_s == least_s && row.id < best->id)) best = row;
}

void keep_fewer_steps(std::optional<ScenarioRow>& fewest, const ScenarioRow& row) {
  const double steps = row.result.metrics[Metric::peak_rise_steps];
  if (!fewest || steps < fewest->result.metrics[Metric::peak_rise_steps]) fewest = row;
}

void look_at(const ScenarioRow& row, RowSummary& seen) {
  const Outcome outcome = row.result.outcome;
  seen.outcomes.add(outcome);
  if (outcome != Outcome::held && outcome != Outcome::not_run) seen.first_of.try_emplace(outcome, row);
  keep_better(seen.best, row);
  seen.has_cycles = seen.has_cycles || !std::isnan(row.result.metrics[Metric::cycle_time_s]);
  for (std::size_t i = 0; i < kBalances.size(); ++i) {
    keep_worse(seen.worst[i].of_all, row, kBalances[i]);
    if (outcome == Outcome::held) keep_worse(seen.worst[i].of_held, row, kBalances[i]);
  }
  const bool is_off = std::abs(row.result.metrics[Metric::energy_balance_error]) > kEnergyErrorMost;
  if (is_off && outcome == Outcome::out_of_range) ++seen.energy_off;
  if (impact_is_unresolved(row.result)) {
    ++seen.impacts_unresolved;
    keep_fewer_steps(seen.fewest_rise_steps, row);
  }
}

}  // namespace

bool impact_is_unresolved(const ScenarioResult& result) {
  return result.metrics[Metric::peak_rise_steps] < kFewestRiseSteps && result.outcome != Outcome::diverged;
}

RowSummary summary_of(const StudyRows& rows) {
  RowSummary seen;
  DigestOfDigests digest;
  for (const ScenarioRow& row : rows) {
    look_at(row, seen);
    digest.add(result_digest(row.result));
  }
  seen.digest = digest_text(digest.value());
  return seen;
}

}  // namespace unbruised::studies

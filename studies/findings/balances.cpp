#include "studies/findings/balances.hpp"

#include "core/outcome/peak_rise.hpp"
#include "studies/findings/table_text.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

std::string signed_number(double value) { return joined({value > 0.0 ? "+" : "", short_number(value)}); }

/// "-0.152 (scenario 7, dropped)"
std::string error_text(const ScenarioRow& row, Metric metric) {
  return joined({signed_number(row.result.metrics[metric]), " (scenario ", std::to_string(row.id), ", ",
                 outcome_word(row.result.outcome), ")"});
}

std::string worst_text(const WorstRows& worst, Metric metric) {
  if (!worst.of_all) return {};
  std::string text = joined({info_of(metric).name, " ", error_text(*worst.of_all, metric)});
  if (worst.of_held && worst.of_held->id != worst.of_all->id) {
    text += joined({", of those held ", error_text(*worst.of_held, metric)});
  }
  return text;
}

}  // namespace

std::string balance_line(const StudyRows& rows) {
  const RowSummary& seen = rows.seen();
  std::string worst;
  for (std::size_t i = 0; i < kBalances.size(); ++i) {
    add_part(worst, "; ", worst_text(seen.worst[i], kBalances[i]));
  }
  return worst.empty() ? worst : joined({"worst balances: ", worst});
}

std::string balance_doubt(const StudyRows& rows) {
  const RowSummary& seen = rows.seen();
  const std::size_t count = seen.energy_off;
  if (count == 0) return {};
  return joined(
      {"in ", with_thousands(count), count == 1 ? " scenario" : " scenarios", " more than ",
       percent(kEnergyErrorMost), " of the energy put in is unaccounted for (worst: energy_balance_error ",
       error_text(*seen.worst.back().of_all, Metric::energy_balance_error),
       "), so forces and damage there are not to be trusted and the outcome is out_of_range; try a smaller "
       "simulation.time_step_s"});
}

std::string impact_doubt(const StudyRows& rows) {
  const RowSummary& seen = rows.seen();
  const std::size_t count = seen.impacts_unresolved;
  if (count == 0) return {};
  const ScenarioRow& fewest = *seen.fewest_rise_steps;
  return joined(
      {"in ", with_thousands(count), count == 1 ? " scenario" : " scenarios",
       " the force rose by half of its peak within fewer than ", std::to_string(kFewestRiseSteps),
       " time steps (fewest: ", short_number(fewest.result.metrics[Metric::peak_rise_steps]), ", scenario ",
       std::to_string(fewest.id),
       "): an impact that the step does not resolve, so the true peak, and the damage, are higher; use a "
       "smaller simulation.time_step_s"});
}

}  // namespace unbruised::studies

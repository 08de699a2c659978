#include "studies/findings/balances.hpp"

#include <cmath>

#include "core/outcome/peak_rise.hpp"
#include "studies/findings/table_text.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

enum class Among { all, held };

/// The row whose metric has the largest size, the first where several have it; nullptr: none has it.
const ScenarioRow* worst_row(const std::vector<ScenarioRow>& rows, Metric metric, Among among) {
  const ScenarioRow* worst = nullptr;
  for (const ScenarioRow& row : rows) {
    if (among == Among::held && row.result.outcome != Outcome::held) continue;
    const double size = std::abs(row.result.metrics[metric]);
    if (std::isnan(size)) continue;
    if (worst == nullptr || size > std::abs(worst->result.metrics[metric])) worst = &row;
  }
  return worst;
}

std::string signed_number(double value) { return joined({value > 0.0 ? "+" : "", short_number(value)}); }

/// "-0.152 (scenario 7, dropped)"
std::string error_text(const ScenarioRow& row, Metric metric) {
  return joined({signed_number(row.result.metrics[metric]), " (scenario ", std::to_string(row.id), ", ",
                 outcome_word(row.result.outcome), ")"});
}

std::string worst_text(const std::vector<ScenarioRow>& rows, Metric metric) {
  const ScenarioRow* worst = worst_row(rows, metric, Among::all);
  if (worst == nullptr) return {};
  std::string text = joined({info_of(metric).name, " ", error_text(*worst, metric)});
  const ScenarioRow* held = worst_row(rows, metric, Among::held);
  if (held != nullptr && held != worst) text += joined({", of those held ", error_text(*held, metric)});
  return text;
}

}  // namespace

std::string balance_line(const std::vector<ScenarioRow>& rows) {
  std::string worst = worst_text(rows, Metric::impulse_balance_error);
  add_part(worst, "; ", worst_text(rows, Metric::angular_impulse_balance_error));
  add_part(worst, "; ", worst_text(rows, Metric::energy_balance_error));
  return worst.empty() ? worst : joined({"worst balances: ", worst});
}

std::string balance_doubt(const std::vector<ScenarioRow>& rows) {
  std::size_t count = 0;
  for (const ScenarioRow& row : rows) {
    const bool is_off = std::abs(row.result.metrics[Metric::energy_balance_error]) > kEnergyErrorMost;
    count += is_off && row.result.outcome == Outcome::out_of_range ? 1 : 0;
  }
  if (count == 0) return {};
  const ScenarioRow* worst = worst_row(rows, Metric::energy_balance_error, Among::all);
  return joined(
      {"in ", with_thousands(count), count == 1 ? " scenario" : " scenarios", " more than ",
       percent(kEnergyErrorMost), " of the energy put in is unaccounted for (worst: energy_balance_error ",
       error_text(*worst, Metric::energy_balance_error),
       "), so forces and damage there are not to be trusted and the outcome is out_of_range; try a smaller "
       "simulation.time_step_s"});
}

bool impact_is_unresolved(const ScenarioResult& result) {
  return result.metrics[Metric::peak_rise_steps] < kFewestRiseSteps && result.outcome != Outcome::diverged;
}

std::string impact_doubt(const std::vector<ScenarioRow>& rows) {
  std::size_t count = 0;
  const ScenarioRow* fewest = nullptr;
  for (const ScenarioRow& row : rows) {
    if (!impact_is_unresolved(row.result)) continue;
    const double steps = row.result.metrics[Metric::peak_rise_steps];
    ++count;
    if (fewest == nullptr || steps < fewest->result.metrics[Metric::peak_rise_steps]) fewest = &row;
  }
  if (count == 0) return {};
  return joined(
      {"in ", with_thousands(count), count == 1 ? " scenario" : " scenarios",
       " the force rose by half of its peak within fewer than ", std::to_string(kFewestRiseSteps),
       " time steps (fewest: ", short_number(fewest->result.metrics[Metric::peak_rise_steps]), ", scenario ",
       std::to_string(fewest->id),
       "): an impact that the step does not resolve, so the true peak, and the damage, are higher; use a "
       "smaller simulation.time_step_s"});
}

}  // namespace unbruised::studies

#pragma once

/// @file
/// What the rows of a study say together, found out in one pass over them.

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>

#include "core/outcome/outcome.hpp"
#include "studies/results/outcome_counts.hpp"
#include "studies/results/study_rows.hpp"

namespace unbruised::studies {

/// The balances that are looked at, in the order of RowSummary::worst.
inline constexpr std::array kBalances = {Metric::impulse_balance_error, Metric::angular_impulse_balance_error,
                                         Metric::energy_balance_error};

/// The row whose balance has the largest size, the first where several have it; nothing: none has it.
struct WorstRows {
  std::optional<ScenarioRow> of_all, of_held;
};

struct RowSummary {
  OutcomeCounts outcomes;
  /// Of each outcome beside held and not_run the first row.
  std::map<Outcome, ScenarioRow> first_of;
  /// The held row with the shortest cycle, then the least id.
  std::optional<ScenarioRow> best;
  bool has_cycles = false;  ///< a row has a cycle time
  std::array<WorstRows, kBalances.size()> worst;
  /// Rows out of range because energy is not accounted for.
  std::size_t energy_off = 0;
  /// Rows with an impact that the step does not resolve, and the first of those with the fewest steps.
  std::size_t impacts_unresolved = 0;
  std::optional<ScenarioRow> fewest_rise_steps;
  std::string digest;  ///< of digests, 16 hex digits
};

/// Goes through the rows once. Throws RowsFailure. StudyRows::seen() keeps what it finds.
RowSummary summary_of(const StudyRows& rows);

/// Did the force that decides rise by half of its peak within fewer than kFewestRiseSteps steps? Then what rests
/// on the peak is looked at again at half the step.
bool impact_is_unresolved(const ScenarioResult& result);

}  // namespace unbruised::studies

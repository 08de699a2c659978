#pragma once

/// @file
/// The columns of a scenario row beside its inputs and metrics: one list for whoever writes or shows them.

namespace unbruised::studies {

struct ScenarioColumn {
  const char* name;
  const char* units;
  const char* long_name;
};

inline constexpr ScenarioColumn kIdColumn = {"id", "1", "number of the scenario in the study's order"};
inline constexpr ScenarioColumn kOutcomeColumn = {"outcome", "", "how the scenario ended"};
inline constexpr ScenarioColumn kCauseColumn = {"cause", "", "what decided the outcome"};
inline constexpr ScenarioColumn kOutcomeTimeColumn = {"outcome_time_s", "s",
                                                      "first crossing of the limit that decided the outcome"};

}  // namespace unbruised::studies

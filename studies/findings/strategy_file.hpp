#pragma once

/// @file
/// The answer of a study as a strategy file: what is typed into the robot, and what a compare study takes as a
/// candidate.

#include <string>
#include <vector>

#include "core/scenario/scenario.hpp"
#include "studies/config/study.hpp"
#include "studies/results/rows.hpp"

namespace unbruised::studies {

/// The strategy that a study answers with.
struct AnsweredStrategy {
  Scenario scenario;
  std::vector<ColumnInfo> keys;    ///< what was chosen, by searching or from a grid
  std::vector<InputValue> values;  ///< as many
  std::vector<std::string> says;   ///< what is said about it: its tolerance, what it holds over; one line each
};

/// All [strategy] keys of the answer below a comment with the study, its config and its results.
/// @param digest of the results, 16 hex digits
std::string strategy_toml(const Study& study, const AnsweredStrategy& answer, const std::string& digest);

/// Puts the file's text into the attribute `strategy_toml` of the table `best`, which is made from the answer's
/// keys where the kind has none.
void add_strategy(std::vector<ResultTable>& tables, const AnsweredStrategy& answer, const std::string& toml);

}  // namespace unbruised::studies

#pragma once

/// @file
/// What the searches of a study found, before it is made into tables.

#include <optional>
#include <string>
#include <vector>

#include "optimizer/search.hpp"
#include "studies/execution/executor.hpp"
#include "studies/findings/strategy_judge.hpp"
#include "studies/scenarios/product_sample.hpp"

namespace unbruised::studies {

/// One search as it is planned and as it ended.
struct SearchRecord {
  std::string purpose;  ///< "" of plain multistart, else "anchor of ...", "point 3"
  std::vector<double> start;
  optimizer::SearchResult result;
};

/// A second look at the best strategy.
struct Check {
  std::string name;  ///< "as found", "half the time step", "finer mesh", "every particle", "other products"
  std::string what;  ///< "simulation.time_step_s = 0.0005"; empty: nothing differs
  Candidate candidate;
};

struct SearchFindings {
  std::vector<Candidate> candidates;   ///< by place
  std::vector<SearchRecord> searches;  ///< by number; those that never began are missing
  std::vector<Check> checks;           ///< none where nothing is feasible
  std::vector<Candidate> front_again;  ///< pareto: points_on_impacts of the front at half the time step
  std::optional<ProductSample> products;
  bool interrupted = false;
  LaneUse searching;            ///< how full the lanes were while the searches ran, checks not counted
  double search_seconds = 0.0;  ///< until the answer was there, before it was checked
};

}  // namespace unbruised::studies

#pragma once

/// @file
/// What a study will cost as a whole, for `check`, and for the time left that `run` shows from the first step on.

#include <cstddef>

#include "core/simulation/simulation.hpp"
#include "studies/config/study.hpp"
#include "studies/execution/progress.hpp"

namespace unbruised::studies {

struct StudyCost {
  double scenarios = 0.0;  ///< of a search: at most; of a window study: about
  std::size_t groups = 0;  ///< factor keys among the scenarios known beforehand
  ModelSize least{};       ///< the smallest and the largest model, by freedoms
  ModelSize most{};
  double steps_each = 0.0;     ///< time steps of a scenario, on average
  double longest_run_s = 0.0;  ///< simulated time
  double memory_bytes = 0.0;
  double disk_bytes = 0.0;
  double seconds = 0.0;  ///< on that many threads, without factoring; a factor of two either way
  int threads = 1;
};

/// @param threads > 0
StudyCost study_cost(const Study& study, int threads);
/// The same in the words of progress.
ProgressPlan progress_plan(const Study& study, const StudyCost& cost);

}  // namespace unbruised::studies

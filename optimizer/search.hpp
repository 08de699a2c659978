#pragma once

/// @file
/// One search from one start: NLopt behind a small interface. The way it takes is a function of problem, options and
/// seed alone.

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "optimizer/algorithm.hpp"
#include "optimizer/problem.hpp"

namespace unbruised::optimizer {

struct SearchOptions {
  Algorithm algorithm = Algorithm::cobyla;
  /// Inside MLSL and AUGLAG; none: default_local (algorithm.hpp)
  std::optional<Algorithm> local;
  /// In the variables' own units; empty: the middle of the box.
  std::vector<double> start;
  std::uint64_t seed = 1;
  /// > 0; points evaluated at most, those of finite differences included
  std::size_t evaluations_most = 200;
  /// > 0, < 1; a search ends when its steps get smaller than this part of each variable's range
  double tolerance = 1e-3;
  /// > 0; first step as part of the range
  double initial_step = 0.2;
  /// > 0; step of finite differences as part of the range
  double gradient_step = 1e-4;
  /// Central differences cost 2n + 1 points, forward ones n + 1.
  bool central_differences = false;
};

enum class Termination {
  converged,     ///< steps or improvements fell below the tolerance
  budget_spent,  ///< evaluations_most
  stopped,       ///< the evaluator said so
  stalled,       ///< round-off, or failures in most of the last evaluations
  refused,       ///< the algorithm cannot take the problem
};

struct SearchResult {
  std::vector<double> best;  ///< the best point *recorded*: least objective among feasible, else least violated
  Evaluation at_best;
  bool feasible = false;
  double violation = std::numeric_limits<double>::infinity();  ///< largest constraint at `best`, <= 0 when feasible
  Termination termination = Termination::refused;
  std::string sentence;  ///< why it ended, for people
  std::size_t evaluations = 0;
  std::size_t generations = 0;
};

/// Searches on the unit cube of the problem's space. What an algorithm is told is always finite: an objective that is not
/// becomes one worse than any seen before, a constraint that is not becomes broken by a fixed amount. An exception of the
/// evaluator comes out unchanged.
SearchResult search(const Problem& problem, const SearchOptions& options);

}  // namespace unbruised::optimizer

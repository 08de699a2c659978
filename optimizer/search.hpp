#pragma once

/// @file
/// One search from one start: NLopt behind a small interface. The way it takes is a function of problem, options
/// and seed alone.

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
  /// Inside MLSL and AUGLAG; none: default_local (algorithm.hpp), BOBYQA or, with one variable, SBPLX
  std::optional<Algorithm> local;
  /// In the variables' own units, put into the box; empty: the middle of the box. DIRECT_L has no use for it, and
  /// BOBYQA first moves it onto a wall or a first step away from it.
  std::vector<double> start;
  std::uint64_t seed = 1;
  /// > 0; points evaluated at most, those of finite differences included
  std::size_t evaluations_most = 200;
  /// > 0, < 1; a local search ends when its steps get smaller than this part of each variable's range. Global ones
  /// go on until the budget is spent: that two good points are close to each other says nothing about the rest of
  /// the box.
  double tolerance = 1e-3;
  /// > 0, <= 1; first step of derivative-free algorithms as part of the range; BOBYQA takes 0.5 at most
  double initial_step = 0.2;
  /// >= 0; an algorithm is told c + margin in place of a constraint c (but 0 where c is 0). The border is
  /// approached from outside by many algorithms: without a margin the point they converge to is broken by 1e-10 as
  /// often as not, and the best point that is not may be far away.
  double constraint_margin = 1e-6;
  /// > 0, <= 0.25; step of finite differences as part of the range (gradient.hpp says how to choose it)
  double gradient_step = 1e-4;
  /// Central differences cost 2n + 1 points, forward ones n + 1.
  bool central_differences = false;
};

enum class Termination {
  converged,     ///< steps or improvements fell below the tolerance
  budget_spent,  ///< evaluations_most
  stopped,       ///< the evaluator said so
  stalled,       ///< round-off, circles, or more than half of the last 200 evaluations not finite
  refused,       ///< the algorithm cannot take the problem
};

struct SearchResult {
  std::vector<double> best;  ///< the best point *recorded*: least objective among feasible, else least violated
  Evaluation at_best;
  bool feasible = false;
  /// Largest constraint at `best`, <= 0 when feasible, 0 without constraints; infinite where numbers are missing
  double violation = std::numeric_limits<double>::infinity();
  Termination termination = Termination::refused;
  std::string sentence;  ///< why it ended, for people
  std::size_t evaluations = 0;
  std::size_t generations = 0;
};

/// Searches on the unit cube of the problem's space; objective and constraints are not scaled.
///
/// What an algorithm is told is always finite (ledger.hpp says what): an objective that is not finite becomes one
/// worse than any seen, a constraint that is not becomes broken. A point counts as feasible when all of its own
/// numbers are finite and no constraint is > 0; the margin plays no part in that.
///
/// SLSQP, MMA and CCSAQ are begun again from the best point until that moves by less than the tolerance: NLopt's own
/// tests end them too early, above all where they begin outside the constraints.
///
/// The path is a function of problem, options and seed, in whichever thread it runs. No point is evaluated twice.
/// An exception of the evaluator comes out unchanged, and the evaluator is not called again. Options or answers
/// that break the rules of these headers are std::invalid_argument or std::logic_error.
SearchResult search(const Problem& problem, const SearchOptions& options);

}  // namespace unbruised::optimizer

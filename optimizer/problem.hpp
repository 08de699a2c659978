#pragma once

/// @file
/// What a search is asked to solve: minimise f(x) over a box subject to c_i(x) <= 0, known through evaluations
/// only.

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "optimizer/search_space.hpp"

namespace unbruised::optimizer {

/// What one point is worth. Numbers that are not finite are replaced before an algorithm sees them (search.hpp).
struct Evaluation {
  double objective = 0.0;
  std::vector<double> constraints;  ///< met when <= 0; as many as Problem::constraint_count
};

/// A point to evaluate, in the variables' own units, and which question of its search it is.
struct Question {
  std::vector<double> point;
  std::size_t generation = 0;  ///< counts the calls of the evaluator from 0
  std::size_t index = 0;       ///< inside the generation
};

/// Answers all questions of one generation, in their order; nothing: the search is to stop. More than one question
/// at a time comes from finite differences: the point itself, then its neighbours. May block; called from the
/// thread that runs the search.
using Evaluator = std::function<std::optional<std::vector<Evaluation>>(const std::vector<Question>&)>;

struct Problem {
  SearchSpace space;
  std::size_t constraint_count = 0;
  Evaluator evaluate;
};

}  // namespace unbruised::optimizer

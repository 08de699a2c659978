#pragma once

/// @file
/// What one search has asked and learned: the only one that calls the evaluator. Knows no algorithm.

#include <cstddef>
#include <deque>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "optimizer/gradient.hpp"
#include "optimizer/problem.hpp"
#include "optimizer/search.hpp"

namespace unbruised::optimizer {

/// What an algorithm is told about a point of the unit cube; all of it finite.
struct Answer {
  double objective = 0.0;
  std::vector<double> constraints;
  std::vector<std::vector<double>> gradient;  ///< [objective, then constraints][variable]; empty: not wanted
};

/// What an algorithm asks for at a point.
enum class Wanted { values, values_and_gradients };

/// Asks for every point once, keeps the budget and the best point, and decides when a search must not go on.
///
/// Told in place of numbers that do not exist: for an objective, the worst seen and as much again as the
/// objectives seen differ; for a constraint, the most it was ever broken by, at least 1. A difference quotient
/// with such a number is zero: no slope is known there, and one made of penalties would drown the others.
class Ledger {
 public:
  /// Keeps references to both. With gradients each new point is asked together with its neighbours, as one
  /// generation.
  Ledger(const Problem& problem, const SearchOptions& options, Wanted wanted);

  /// What is known about a point, asked for where nothing is. Once the search has ended, or when an exception of
  /// the evaluator or its misuse comes out of here, nobody is asked any more.
  const Answer& at(std::span<const double> unit);

  /// Something finite for an algorithm that has not yet seen that the search has ended.
  [[nodiscard]] const Answer& last_words() const { return last_words_; }

  [[nodiscard]] bool has_ended() const { return has_ended_; }
  [[nodiscard]] const SearchResult& result() const { return result_; }
  /// SearchResult::best on the unit cube; empty before the first answer.
  [[nodiscard]] const std::vector<double>& best_unit() const { return best_unit_; }

 private:
  std::optional<Answer> learn(std::span<const double> unit);
  std::optional<std::vector<Evaluation>> ask(const std::vector<std::vector<double>>& points);
  [[nodiscard]] Answer answer_from(const std::vector<std::vector<double>>& points,
                                   const std::vector<Evaluation>& evaluations) const;
  void record(const std::vector<double>& unit, const Evaluation& evaluation);
  void learn_range(const Evaluation& evaluation);
  [[nodiscard]] std::vector<double> told(const Evaluation& evaluation) const;
  [[nodiscard]] double objective_penalty() const;
  [[nodiscard]] bool mostly_failing() const;
  std::nullopt_t end(Termination termination, std::string sentence);

  const Problem& problem_;
  const SearchOptions& options_;
  const Wanted wanted_;
  const Differences differences_;
  std::unordered_map<std::string, Answer> memo_;  ///< by the bits of the point in its own units
  Answer last_words_;
  std::size_t known_in_a_row_ = 0;
  std::deque<bool> recent_;  ///< of the last evaluations: was all of it finite?
  std::optional<double> best_seen_;
  std::optional<double> worst_seen_;
  std::vector<double> most_broken_;  ///< by constraint
  bool has_ended_ = false;
  std::vector<double> best_unit_;
  SearchResult result_;
};

}  // namespace unbruised::optimizer

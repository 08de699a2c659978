#pragma once

/// @file
/// Problems with minima in closed form, and what the tests of the search share.

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "optimizer/search.hpp"

namespace unbruised::optimizer::testing {

using Point = std::vector<double>;
using Function = std::function<Evaluation(const Point&)>;

struct KnownProblem {
  std::string name;
  SearchSpace space;
  std::size_t constraint_count = 0;
  Point start;
  double minimum = 0.0;
  double multipliers = 0.0;  ///< sum of the Lagrange multipliers: what a unit of margin costs
  double slope = 0.0;        ///< |grad f| at the minimum: what a step that stops short of the border costs
  double range = 1.0;        ///< largest of the variables
  Function function;
};

inline SearchSpace box(std::size_t variables, double lower, double upper) {
  std::vector<Variable> all;
  for (std::size_t k = 0; k < variables; ++k) {
    std::string name = "x";
    all.push_back({name.append(std::to_string(k)), "1", lower, upper, Scale::linear});
  }
  return SearchSpace(std::move(all));
}

inline double square(double x) { return x * x; }

/// Rosenbrock (1960), the banana valley.
inline KnownProblem rosenbrock() {
  return {.name = "Rosenbrock",
          .space = box(2, -2.0, 3.0),
          .start = {-1.2, 1.0},
          .range = 5.0,
          .function = [](const Point& x) {
            return Evaluation{100.0 * square(x[1] - x[0] * x[0]) + square(1.0 - x[0]), {}};
          }};
}

/// Branin (1972): three equal minima of 10 / (8 pi).
inline KnownProblem branin() {
  constexpr double pi = std::numbers::pi;
  return {.name = "Branin",
          .space = SearchSpace({{"x0", "1", -5.0, 10.0, Scale::linear}, {"x1", "1", 0.0, 15.0, Scale::linear}}),
          .start = {2.5, 7.5},
          .minimum = 10.0 / (8.0 * pi),
          .range = 15.0,
          .function = [](const Point& x) {
            const double inner = x[1] - 5.1 / (4.0 * pi * pi) * x[0] * x[0] + 5.0 / pi * x[0] - 6.0;
            return Evaluation{square(inner) + 10.0 * (1.0 - 1.0 / (8.0 * pi)) * std::cos(x[0]) + 10.0, {}};
          }};
}

/// Six-hump camel back (Dixon and Szego 1978): the two lowest humps are at -1.0316284535.
inline KnownProblem camel() {
  return {.name = "six-hump camel",
          .space = box(2, -2.0, 2.5),
          .start = {2.0, 2.0},
          .minimum = -1.031628453489877,
          .range = 4.5,
          .function = [](const Point& x) {
            const double a = x[0] * x[0];
            const double b = x[1] * x[1];
            return Evaluation{(4.0 - 2.1 * a + a * a / 3.0) * a + x[0] * x[1] + (-4.0 + 4.0 * b) * b, {}};
          }};
}

/// Rastrigin (1974): a minimum near every integer, 0 at the origin. The box is not centred on it.
inline KnownProblem rastrigin() {
  return {.name = "Rastrigin",
          .space = box(2, -4.12, 6.12),
          .start = {4.0, -3.0},
          .range = 10.24,
          .function = [](const Point& x) {
            double sum = 0.0;
            for (const double v : x) sum += 10.0 + v * v - 10.0 * std::cos(2.0 * std::numbers::pi * v);
            return Evaluation{sum, {}};
          }};
}

// Hock and Schittkowski (1981), Test Examples for Nonlinear Programming Codes: those with inequalities only. Upper
// bounds are ours where they have none, and do not bind.

/// HS 24: -1 at (3, sqrt 3); grad f = (0, -sqrt 3), multipliers sqrt(3) / 2, 0, 1/2.
inline KnownProblem hs24() {
  return {.name = "HS24",
          .space = box(2, 0.0, 5.0),
          .constraint_count = 3,
          .start = {1.0, 0.5},
          .minimum = -1.0,
          .multipliers = 0.5 * (std::sqrt(3.0) + 1.0),
          .slope = std::sqrt(3.0),
          .range = 5.0,
          .function = [](const Point& x) {
            const double r = std::sqrt(3.0);
            return Evaluation{(square(x[0] - 3.0) - 9.0) * x[1] * x[1] * x[1] / (27.0 * r),
                              {x[1] - x[0] / r, -x[0] - r * x[1], x[0] + r * x[1] - 6.0}};
          }};
}

/// HS 35 (Beale): 1/9 at (4/3, 7/9, 4/9); grad f = -(2, 2, 4) / 9.
inline KnownProblem hs35() {
  return {.name = "HS35",
          .space = box(3, 0.0, 3.0),
          .constraint_count = 1,
          .start = {0.5, 0.5, 0.5},
          .minimum = 1.0 / 9.0,
          .multipliers = 2.0 / 9.0,
          .slope = 0.55,
          .range = 3.0,
          .function = [](const Point& x) {
            return Evaluation{9.0 - 8.0 * x[0] - 6.0 * x[1] - 4.0 * x[2] + 2.0 * x[0] * x[0] + 2.0 * x[1] * x[1] +
                                  x[2] * x[2] + 2.0 * x[0] * x[1] + 2.0 * x[0] * x[2],
                              {x[0] + x[1] + 2.0 * x[2] - 3.0}};
          }};
}

/// HS 43 (Rosen and Suzuki): -44 at (0, 1, 2, -1); grad f = (-5, -3, -13, 5), multipliers 1, 0, 2.
inline KnownProblem hs43() {
  return {.name = "HS43",
          .space = box(4, -5.0, 5.0),
          .constraint_count = 3,
          .start = {0.0, 0.0, 0.0, 0.0},
          .minimum = -44.0,
          .multipliers = 3.0,
          .slope = 15.1,
          .range = 10.0,
          .function = [](const Point& x) {
            const double a = x[0] * x[0];
            const double b = x[1] * x[1];
            const double c = x[2] * x[2];
            const double d = x[3] * x[3];
            return Evaluation{
                a + b + 2.0 * c + d - 5.0 * x[0] - 5.0 * x[1] - 21.0 * x[2] + 7.0 * x[3],
                {a + b + c + d + x[0] - x[1] + x[2] - x[3] - 8.0, a + 2.0 * b + c + 2.0 * d - x[0] - x[3] - 10.0,
                 2.0 * a + b + c + 2.0 * x[0] - x[1] - x[3] - 5.0}};
          }};
}

/// HS 76 (Murtagh and Sargent): -103/22 at (3, 23, 0, 6) / 11; grad f = (-5, -10, 14, -5) / 11, the first
/// constraint's multiplier 5/11 and the bound of x2 active.
inline KnownProblem hs76() {
  return {.name = "HS76",
          .space = box(4, 0.0, 4.0),
          .constraint_count = 3,
          .start = {0.5, 0.5, 0.5, 0.5},
          .minimum = -103.0 / 22.0,
          .multipliers = 5.0 / 11.0,
          .slope = 1.7,
          .range = 4.0,
          .function = [](const Point& x) {
            return Evaluation{x[0] * x[0] + 0.5 * x[1] * x[1] + x[2] * x[2] + 0.5 * x[3] * x[3] - x[0] * x[2] +
                                  x[2] * x[3] - x[0] - 3.0 * x[1] + x[2] - x[3],
                              {x[0] + 2.0 * x[1] + x[2] + x[3] - 5.0, 3.0 * x[0] + x[1] + 2.0 * x[2] - x[3] - 4.0,
                               1.5 - x[1] - 4.0 * x[2]}};
          }};
}

/// Answers every question with the function.
inline Evaluator answering(Function function) {
  return [function = std::move(function)](const std::vector<Question>& questions) {
    std::vector<Evaluation> answers;
    for (const Question& question : questions) answers.push_back(function(question.point));
    return std::optional(answers);
  };
}

inline Problem problem_of(const KnownProblem& known) {
  return {known.space, known.constraint_count, answering(known.function)};
}

/// A fixed number in [-1, 1] for every point, as irregular as the last digits of a simulation.
inline double noise_at(const Point& x) {
  std::uint64_t h = 0x9e3779b97f4a7c15U;
  for (const double value : x) {
    h = (h ^ std::bit_cast<std::uint64_t>(value)) * 0xbf58476d1ce4e5b9U;
    h ^= h >> 29U;
    h *= 0x94d049bb133111ebU;
    h ^= h >> 32U;
  }
  return static_cast<double>(h >> 11U) * 0x1p-52 - 1.0;
}

}  // namespace unbruised::optimizer::testing

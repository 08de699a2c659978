// Every algorithm on problems whose minima are known in closed form.

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "tests/optimizer/known_problems.hpp"

namespace unbruised::optimizer {
namespace {

using namespace testing;

struct Way {
  Algorithm algorithm;
  std::optional<Algorithm> local;
};

std::string name_of(const Way& way) {
  std::string name(info_of(way.algorithm).name);
  return way.local ? name.append(" with ").append(info_of(*way.local).name) : name;
}

SearchOptions options_of(const Way& way, const KnownProblem& known) {
  SearchOptions options;
  options.algorithm = way.algorithm;
  options.local = way.local;
  options.start = known.start;
  options.tolerance = 1e-6;
  options.evaluations_most = 3000;
  // The best step of central differences in exact arithmetic: (3 x 2e-16)^(1/3) is 1e-5.
  options.gradient_step = 1e-5;
  options.central_differences = true;
  return options;
}

std::string described(const KnownProblem& known, const Way& way, const SearchResult& result) {
  return known.name + " by " + name_of(way) + ": " + std::to_string(result.evaluations) + " evaluations, " +
         result.sentence;
}

/// The recorded best is a real point of the problem: its numbers are those of the function there.
void expect_real_point(const KnownProblem& known, const SearchResult& result) {
  EXPECT_EQ(known.function(result.best).objective, result.at_best.objective);
  EXPECT_LE(result.violation, 0.0);
  EXPECT_TRUE(result.feasible);
}

TEST(KnownMinima, OfSmoothValleysAreFoundByLocalAlgorithms) {
  // Steps end at 1e-6 of the range, and objectives are flat to second order: half the curvature (250 at most)
  // times (1e-6 x 15)^2 is 3e-8. Branin is reached from its middle, which leads to one of the three equal minima.
  for (const KnownProblem& known : {branin(), camel()}) {
    for (const Way& way : {Way{Algorithm::bobyqa, {}}, Way{Algorithm::sbplx, {}}, Way{Algorithm::neldermead, {}},
                           Way{Algorithm::slsqp, {}}, Way{Algorithm::mma, {}}, Way{Algorithm::ccsaq, {}},
                           Way{Algorithm::auglag, {}}, Way{Algorithm::auglag, Algorithm::slsqp}}) {
      KnownProblem from_near = known;
      if (known.name == "six-hump camel") from_near.start = {0.4, -0.9};  // in the valley of the lowest hump
      const SearchResult result = search(problem_of(from_near), options_of(way, from_near));
      EXPECT_LT(result.at_best.objective - known.minimum, 3e-8) << described(known, way, result);
      EXPECT_EQ(result.termination, Termination::converged) << described(known, way, result);
      expect_real_point(known, result);
    }
  }
}

TEST(KnownMinima, OfTheBananaValleyAreFoundByThoseThatModelItsCurvature) {
  const KnownProblem known = rosenbrock();
  for (const Way& way : {Way{Algorithm::bobyqa, {}}, Way{Algorithm::sbplx, {}}, Way{Algorithm::neldermead, {}},
                         Way{Algorithm::auglag, {}}, Way{Algorithm::auglag, Algorithm::neldermead}}) {
    const SearchResult result = search(problem_of(known), options_of(way, known));
    // Half the larger curvature, 1002 / 2, times (1e-6 x 5)^2.
    EXPECT_LT(result.at_best.objective, 1.3e-8) << described(known, way, result);
    EXPECT_EQ(result.termination, Termination::converged);
    expect_real_point(known, result);
  }
}

TEST(KnownMinima, OfConstrainedProblemsAreFoundFromInsideByThoseThatTakeConstraints) {
  for (const KnownProblem& known : {hs24(), hs35(), hs43(), hs76()}) {
    for (const Way& way :
         {Way{Algorithm::cobyla, {}}, Way{Algorithm::slsqp, {}}, Way{Algorithm::mma, {}},
          Way{Algorithm::ccsaq, {}}, Way{Algorithm::auglag, {}}, Way{Algorithm::auglag, Algorithm::slsqp}}) {
      const SearchOptions options = options_of(way, known);
      const SearchResult result = search(problem_of(known), options);
      const double gap = result.at_best.objective - known.minimum;
      // To first order: the margin times the multipliers, and a last step that ends short of the border.
      const double allowed =
          known.multipliers * options.constraint_margin + known.slope * known.range * options.tolerance;
      EXPECT_LT(gap, allowed) << described(known, way, result);
      EXPECT_GT(gap, -1e-12) << described(known, way, result);  // a feasible point is none better than the minimum
      expect_real_point(known, result);
    }
  }
}

TEST(KnownMinima, OfConvexProblemsAreFoundFromAnyStart) {
  // Most of the starts break constraints. MMA and CCSAQ, left to their own test of convergence, end far away from a third
  // to a half of them; with a tight tolerance they may creep from there until any budget is spent.
  struct Case {
    Algorithm algorithm;
    double tolerance;
    double steps;  ///< from the border at most, to first order
  };
  std::mt19937_64 random(4711);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  for (const KnownProblem& known : {hs35(), hs43(), hs76()}) {
    for (int trial = 0; trial < 20; ++trial) {
      std::vector<double> unit(known.space.size());
      for (double& u : unit) u = part(random);
      for (const Case& each : {Case{Algorithm::cobyla, 1e-6, 1.0}, Case{Algorithm::slsqp, 1e-6, 1.0},
                               Case{Algorithm::mma, 1e-3, 10.0}, Case{Algorithm::ccsaq, 1e-3, 10.0}}) {
        const Way way{each.algorithm, {}};
        SearchOptions options = options_of(way, known);
        options.start = known.space.from_unit(unit);
        options.tolerance = each.tolerance;
        const SearchResult result = search(problem_of(known), options);
        const double allowed = known.multipliers * options.constraint_margin +
                               known.slope * known.range * each.tolerance * each.steps;
        EXPECT_LT(result.at_best.objective - known.minimum, allowed)
            << described(known, way, result) << ", trial " << trial;
        EXPECT_TRUE(result.feasible);
      }
    }
  }
}

TEST(KnownMinima, AmongManyAreFoundByGlobalAlgorithms) {
  struct Case {
    Way way;
    double allowed;
  };
  // DIRECT_L, CRS2_LM and MLSL close in on the best basin; ISRES and ESCH scatter: they must be in it, where the
  // next minimum of Rastrigin's function is higher by 1, of the camel by 0.8.
  const double in_the_basin = 0.5;
  for (const KnownProblem& known : {branin(), camel(), rastrigin()}) {
    for (const Case& each :
         {Case{{Algorithm::direct_l, {}}, 1e-6}, Case{{Algorithm::crs2_lm, {}}, 1e-6},
          Case{{Algorithm::mlsl, {}}, 1e-6}, Case{{Algorithm::mlsl, Algorithm::slsqp}, 1e-6},
          Case{{Algorithm::mlsl, Algorithm::cobyla}, 1e-3}, Case{{Algorithm::isres, {}}, in_the_basin},
          Case{{Algorithm::esch, {}}, in_the_basin}}) {
      const SearchResult result = search(problem_of(known), options_of(each.way, known));
      EXPECT_LT(result.at_best.objective - known.minimum, each.allowed) << described(known, each.way, result);
      EXPECT_EQ(result.termination, Termination::budget_spent) << described(known, each.way, result);
      expect_real_point(known, result);
    }
  }
}

TEST(KnownMinima, OfRastriginAreFoundByControlledRandomSearchFromNearlyAllSeeds) {
  const KnownProblem known = rastrigin();
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    SearchOptions options = options_of({Algorithm::crs2_lm, {}}, known);
    options.seed = seed;
    options.tolerance = 1e-3;
    options.evaluations_most = 1000;
    found += search(problem_of(known), options).at_best.objective < 0.01 ? 1 : 0;
  }
  // 94 in a hundred are usual. It would be every second one if it stopped as soon as two good points are closer
  // than the tolerance, as NLopt's own test of x would have it.
  EXPECT_GE(found, 40);
}

TEST(KnownMinima, OfAConstrainedProblemAreApproachedByIsres) {
  const KnownProblem known = hs35();
  SearchOptions options = options_of({Algorithm::isres, {}}, known);
  options.evaluations_most = 20000;
  const SearchResult result = search(problem_of(known), options);
  // An evolution strategy: a hundredth of the range of the objective over the box, 9 - 1/9.
  EXPECT_LT(result.at_best.objective - known.minimum, 0.09) << result.sentence;
  expect_real_point(known, result);
}

TEST(KnownMinima, OfOneVariableOnALogScaleAreWhereTheClosedFormSays) {
  // (g + a) / sqrt(a) is least at a = g, 2 sqrt(g): the quickest rest-to-rest lift under gravity.
  const double g = 9.81;
  const SearchSpace space({{"acceleration", "m/s2", 0.1, 300.0, Scale::log}});
  const Problem problem{space, 0, answering([g](const Point& x) {
                          return Evaluation{(g + x[0]) / std::sqrt(x[0]), {}};
                        })};
  for (const Algorithm algorithm :
       {Algorithm::cobyla, Algorithm::sbplx, Algorithm::neldermead, Algorithm::slsqp, Algorithm::mma,
        Algorithm::ccsaq, Algorithm::auglag, Algorithm::mlsl, Algorithm::direct_l, Algorithm::crs2_lm}) {
    SearchOptions options;
    options.algorithm = algorithm;
    options.start = {1.0};
    options.tolerance = 1e-4;
    options.evaluations_most = 300;
    options.central_differences = true;
    options.gradient_step = 1e-3;
    const SearchResult result = search(problem, options);
    // In t = ln a the function is 2 sqrt(g) cosh((t - ln g) / 2). Steps of 1e-4 of ln(3000) = 8 are 8e-4 in t; an
    // algorithm may stop a few of them away.
    EXPECT_NEAR(std::log(result.best[0] / g), 0.0, 5e-3) << info_of(algorithm).name << ": " << result.sentence;
    EXPECT_NEAR(result.at_best.objective, 2.0 * std::sqrt(g), std::sqrt(g) * 0.25 * 5e-3 * 5e-3);
  }
}

TEST(KnownMinima, WithNoiseOfTheSimulatorsSizeCostNeitherAccuracyNorTime) {
  const double noise = 1e-9;
  for (const KnownProblem& known : {branin(), hs24(), hs35(), hs76()}) {
    const bool constrained = known.constraint_count > 0;
    KnownProblem noisy = known;
    noisy.function = [&known, noise](const Point& x) {
      Evaluation evaluation = known.function(x);
      evaluation.objective += noise * noise_at(x);
      for (double& c : evaluation.constraints) c += noise * noise_at(x);
      return evaluation;
    };
    for (const Algorithm algorithm : {Algorithm::cobyla, Algorithm::bobyqa, Algorithm::sbplx,
                                      Algorithm::neldermead, Algorithm::slsqp, Algorithm::mma, Algorithm::ccsaq}) {
      if (constrained && !info_of(algorithm).takes_constraints) continue;
      SearchOptions options = options_of({algorithm, {}}, known);
      options.tolerance = 1e-3;
      options.gradient_step = 1e-3;
      const SearchResult result = search(problem_of(noisy), options);
      // A search with tolerance 1e-3 ends within some 10 of its steps, to first order at a border and to second in
      // the open; the noise is far below both.
      const double allowed = constrained ? known.slope * known.range * options.tolerance * 10.0 : 0.05;
      EXPECT_LT(result.at_best.objective - known.minimum, allowed) << described(known, {algorithm, {}}, result);
      EXPECT_EQ(result.termination, Termination::converged) << described(known, {algorithm, {}}, result);
      EXPECT_LT(result.evaluations, 300U) << described(known, {algorithm, {}}, result);
    }
  }
}

}  // namespace
}  // namespace unbruised::optimizer

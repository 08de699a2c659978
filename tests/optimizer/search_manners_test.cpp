// What every algorithm owes its caller, whatever it finds: budget, repeatability, refusals, stops, exceptions.

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "optimizer/nlopt_search.hpp"
#include "tests/optimizer/known_problems.hpp"

namespace unbruised::optimizer {
namespace {

using namespace testing;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Way {
  Algorithm algorithm;
  std::optional<Algorithm> local;
};

/// All algorithms, and those that run another with one of each kind.
std::vector<Way> all_ways() {
  std::vector<Way> ways;
  for (const AlgorithmInfo& info : algorithm_table()) {
    ways.push_back({info.algorithm, {}});
    if (!info.needs_local) continue;
    for (const Algorithm local : {Algorithm::cobyla, Algorithm::sbplx, Algorithm::slsqp, Algorithm::ccsaq}) {
      ways.push_back({info.algorithm, local});
    }
  }
  return ways;
}

std::string name_of(const Way& way) {
  std::string name(info_of(way.algorithm).name);
  return way.local ? name.append(" with ").append(info_of(*way.local).name) : name;
}

bool takes_constraints(const Way& way) { return info_of(way.algorithm).takes_constraints; }

SearchOptions options_of(const Way& way, const KnownProblem& known) {
  SearchOptions options;
  options.algorithm = way.algorithm;
  options.local = way.local;
  options.start = known.start;
  options.evaluations_most = 150;
  options.tolerance = 1e-5;
  return options;
}

/// A problem that suits the way: with constraints where it takes them.
KnownProblem problem_for(const Way& way) { return takes_constraints(way) ? hs43() : rastrigin(); }

/// Every point a search asks for, in order.
std::vector<Point> path_of(const Problem& problem, const SearchOptions& options) {
  std::vector<Point> path;
  Problem watched = problem;
  watched.evaluate = [&](const std::vector<Question>& questions) {
    for (const Question& question : questions) path.push_back(question.point);
    return problem.evaluate(questions);
  };
  search(watched, options);
  return path;
}

TEST(SearchManners, TheBudgetIsNeverExceeded) {
  for (const Way& way : all_ways()) {
    const KnownProblem known = problem_for(way);
    for (const std::size_t budget : {1U, 2U, 3U, 4U, 5U, 17U, 150U}) {
      SearchOptions options = options_of(way, known);
      options.evaluations_most = budget;
      options.tolerance = 1e-12;
      std::size_t evaluated = 0;
      std::size_t generations = 0;
      Problem problem = problem_of(known);
      problem.evaluate = [&, inner = problem.evaluate](const std::vector<Question>& questions) {
        EXPECT_EQ(questions.front().generation, generations++) << name_of(way);
        evaluated += questions.size();
        return inner(questions);
      };
      const SearchResult result = search(problem, options);
      EXPECT_LE(evaluated, budget) << name_of(way);
      EXPECT_EQ(result.evaluations, evaluated) << name_of(way);
      EXPECT_EQ(result.generations, generations) << name_of(way);
      EXPECT_FALSE(result.sentence.empty());
    }
  }
}

TEST(SearchManners, NoPointIsEvaluatedTwiceButAsANeighbour) {
  for (const Way& way : all_ways()) {
    const bool gradient = info_of(way.local.value_or(way.algorithm)).uses_gradient;
    if (gradient) continue;  // a neighbour may become a point of its own
    const KnownProblem known = problem_for(way);
    const std::vector<Point> path = path_of(problem_of(known), options_of(way, known));
    EXPECT_EQ(std::set<Point>(path.begin(), path.end()).size(), path.size()) << name_of(way);
  }
}

TEST(SearchManners, GradientAlgorithmsAskPointAndNeighboursTogether) {
  for (const Way& way : {Way{Algorithm::slsqp, {}}, Way{Algorithm::mma, {}}, Way{Algorithm::ccsaq, {}},
                         Way{Algorithm::auglag, Algorithm::slsqp}}) {
    const KnownProblem known = hs43();
    for (const bool central : {false, true}) {
      SearchOptions options = options_of(way, known);
      options.central_differences = central;
      Problem problem = problem_of(known);
      problem.evaluate = [&, inner = problem.evaluate](const std::vector<Question>& questions) {
        EXPECT_EQ(questions.size(), central ? 9U : 5U);
        for (std::size_t i = 0; i < questions.size(); ++i) EXPECT_EQ(questions[i].index, i);
        return inner(questions);
      };
      EXPECT_GT(search(problem, options).generations, 5U) << name_of(way);
    }
  }
}

TEST(SearchManners, TheSameSeedTakesTheSameWay) {
  for (const Way& way : all_ways()) {
    const KnownProblem known = problem_for(way);
    const SearchOptions options = options_of(way, known);
    const std::vector<Point> path = path_of(problem_of(known), options);
    EXPECT_EQ(path_of(problem_of(known), options), path) << name_of(way);
  }
}

TEST(SearchManners, AnotherSeedTakesAnotherWayWhereTheTableSaysSo) {
  for (const Way& way : all_ways()) {
    const KnownProblem known = problem_for(way);
    SearchOptions options = options_of(way, known);
    const std::vector<Point> path = path_of(problem_of(known), options);
    // The second differs in the upper half of its bits only.
    for (const std::uint64_t seed : {2ULL, 1ULL + (7ULL << 40U)}) {
      options.seed = seed;
      EXPECT_EQ(path_of(problem_of(known), options) != path, info_of(way.algorithm).is_random)
          << name_of(way) << ", seed " << seed;
    }
  }
}

TEST(SearchManners, EightThreadsTakeTheSameWaysAsOne) {
  const std::vector<Way> ways = all_ways();
  const auto paths_from_seed = [&ways](std::uint64_t seed) {
    std::vector<std::vector<Point>> paths;
    for (const Way& way : ways) {
      const KnownProblem known = problem_for(way);
      SearchOptions options = options_of(way, known);
      options.seed = seed;
      paths.push_back(path_of(problem_of(known), options));
    }
    return paths;
  };
  std::vector<std::vector<std::vector<Point>>> together(8);
  std::vector<std::thread> threads;
  for (std::size_t t = 0; t < together.size(); ++t) {
    threads.emplace_back([&, t] { together[t] = paths_from_seed(t); });
  }
  for (std::thread& thread : threads) thread.join();
  for (std::size_t t = 0; t < together.size(); ++t) {
    const auto alone = paths_from_seed(t);
    for (std::size_t i = 0; i < ways.size(); ++i) {
      EXPECT_EQ(together[t][i], alone[i]) << name_of(ways[i]) << ", seed " << t;
    }
  }
}

TEST(SearchManners, ScaleOfTheObjectiveIsNoMatterToDerivativeFreeAlgorithms) {
  // A region without values included: what is told there follows the objectives seen. A power of two changes no
  // digit.
  for (const Way& way : {Way{Algorithm::sbplx, {}}, Way{Algorithm::neldermead, {}}, Way{Algorithm::direct_l, {}},
                         Way{Algorithm::crs2_lm, {}}, Way{Algorithm::esch, {}}, Way{Algorithm::isres, {}}}) {
    const auto path_at_scale = [&](double scale) {
      KnownProblem known = rastrigin();
      known.function = [scale, inner = known.function](const Point& x) {
        return Evaluation{x[0] + x[1] > 2.0 ? kNan : scale * inner(x).objective, {}};
      };
      known.start = {-3.0, 1.0};
      return path_of(problem_of(known), options_of(way, known));
    };
    EXPECT_EQ(path_at_scale(0x1p-40), path_at_scale(1.0)) << name_of(way);
  }
}

TEST(SearchManners, RegionsWithoutNumbersDoNotLeadAstray) {
  for (const double missing : {kNan, kInfinity, -kInfinity}) {
    // A bowl with its bottom 0.05 away from where nothing exists.
    KnownProblem bowl{
        .name = "bowl", .space = box(2, -2.0, 3.0), .start = {-1.0, 1.0}, .function = [missing](const Point& x) {
          const double height = square(x[0] - 0.5) + square(x[1] - 0.5);
          return Evaluation{x[0] + x[1] > 1.05 ? missing : height, {}};
        }};
    for (const Way& way : all_ways()) {
      SearchOptions options = options_of(way, bowl);
      options.evaluations_most = 1000;
      const SearchResult result = search(problem_of(bowl), options);
      EXPECT_TRUE(result.feasible) << name_of(way);
      // Steps end at 1e-5 x 5 for local algorithms; ISRES and ESCH scatter by a hundredth of the box.
      const bool scatters = way.algorithm == Algorithm::isres || way.algorithm == Algorithm::esch;
      EXPECT_LT(result.at_best.objective, scatters ? square(0.05 * 5.0) : 1e-6)
          << name_of(way) << ": " << result.sentence;
    }
  }
}

TEST(SearchManners, ConstraintsWithoutNumbersCountAsBroken) {
  for (const Way& way : all_ways()) {
    if (!takes_constraints(way)) continue;
    KnownProblem known = hs35();
    known.function = [inner = known.function](const Point& x) {
      Evaluation evaluation = inner(x);
      if (x[0] > 2.0) evaluation.constraints[0] = kNan;
      if (x[1] > 2.5) evaluation.constraints[0] = -kInfinity;
      return evaluation;
    };
    SearchOptions options = options_of(way, known);
    options.evaluations_most = 1000;
    const SearchResult result = search(problem_of(known), options);
    EXPECT_TRUE(result.feasible) << name_of(way);
    // ISRES scatters; the others end within some 10 steps of 1e-5 x 3 along a slope of 0.55, or of differences of
    // 1e-4.
    const double allowed = way.algorithm == Algorithm::isres ? 0.3 : 1e-3;
    EXPECT_LT(result.at_best.objective - known.minimum, allowed) << name_of(way) << ": " << result.sentence;
  }
}

TEST(SearchManners, ProblemsWithoutAnyNumberStallAfterTwoHundred) {
  for (const Way& way : all_ways()) {
    const KnownProblem known = problem_for(way);
    Problem nothing = problem_of(known);
    nothing.evaluate = answering([&](const Point&) {
      return Evaluation{kNan, std::vector<double>(known.constraint_count, kNan)};
    });
    SearchOptions options = options_of(way, known);
    options.evaluations_most = 10000;
    const SearchResult result = search(nothing, options);
    EXPECT_LE(result.evaluations, 204U) << name_of(way);  // a generation of finite differences more
    EXPECT_FALSE(result.feasible);
    EXPECT_EQ(result.violation, kInfinity);
    EXPECT_EQ(result.best.size(), known.space.size());
  }
}

TEST(SearchManners, EvaluatorThatSaysStopIsNotAskedAgain) {
  for (const Way& way : all_ways()) {
    const KnownProblem known = problem_for(way);
    for (const int last : {0, 1, 7}) {
      Problem problem = problem_of(known);
      int calls = 0;
      problem.evaluate = [&, inner = problem.evaluate](
                             const std::vector<Question>& questions) -> std::optional<std::vector<Evaluation>> {
        if (calls++ == last) return std::nullopt;
        return inner(questions);
      };
      const SearchResult result = search(problem, options_of(way, known));
      EXPECT_EQ(result.termination, Termination::stopped) << name_of(way);
      EXPECT_EQ(result.sentence, "the search was stopped from outside");
      EXPECT_EQ(calls, last + 1) << name_of(way);
      EXPECT_EQ(result.generations, static_cast<std::size_t>(last));
      EXPECT_EQ(result.best.empty(), last == 0);
    }
  }
}

TEST(SearchManners, ExceptionsOfTheEvaluatorComeOutUnchanged) {
  struct Odd {
    int number;
  };
  for (const Way& way : all_ways()) {
    const KnownProblem known = problem_for(way);
    for (const int last : {0, 1, 7}) {
      Problem problem = problem_of(known);
      int calls = 0;
      problem.evaluate = [&, inner = problem.evaluate](const std::vector<Question>& questions) {
        if (calls++ == last) throw Odd{last};
        return inner(questions);
      };
      try {
        search(problem, options_of(way, known));
        ADD_FAILURE() << name_of(way) << " swallowed it";
      } catch (const Odd& odd) {
        EXPECT_EQ(odd.number, last);
      }
      EXPECT_EQ(calls, last + 1) << name_of(way);
    }
  }
}

TEST(SearchManners, UnsuitableProblemsAreRefusedWithTheReasonAndNobodyIsAsked) {
  Problem problem = problem_of(hs35());
  problem.evaluate = [](const std::vector<Question>&) -> std::optional<std::vector<Evaluation>> {
    ADD_FAILURE() << "asked";
    return std::nullopt;
  };
  for (const AlgorithmInfo& info : algorithm_table()) {
    if (info.takes_constraints) continue;
    SearchOptions options;
    options.algorithm = info.algorithm;
    const SearchResult result = search(problem, options);
    EXPECT_EQ(result.termination, Termination::refused);
    EXPECT_EQ(result.sentence, why_unsuitable(info.algorithm, std::nullopt, 3, 1));
    EXPECT_TRUE(result.best.empty());
  }
}

TEST(SearchManners, OptionsOutsideTheirBoundsAreErrorsOfTheProgram) {
  const KnownProblem known = branin();
  const auto with = [&](const std::function<void(SearchOptions&)>& change) {
    SearchOptions options;
    change(options);
    return search(problem_of(known), options);
  };
  EXPECT_THROW(with([](SearchOptions& o) { o.start = {1.0}; }), std::invalid_argument);
  EXPECT_THROW(with([](SearchOptions& o) { o.start = {1.0, kNan}; }), std::invalid_argument);
  EXPECT_THROW(with([](SearchOptions& o) { o.evaluations_most = 0; }), std::invalid_argument);
  EXPECT_THROW(with([](SearchOptions& o) { o.tolerance = 0.0; }), std::invalid_argument);
  EXPECT_THROW(with([](SearchOptions& o) { o.tolerance = 1.0; }), std::invalid_argument);
  EXPECT_THROW(with([](SearchOptions& o) { o.initial_step = kNan; }), std::invalid_argument);
  EXPECT_THROW(with([](SearchOptions& o) { o.initial_step = 1.1; }), std::invalid_argument);
  EXPECT_THROW(with([](SearchOptions& o) { o.constraint_margin = -1e-9; }), std::invalid_argument);
  EXPECT_THROW(with([](SearchOptions& o) { o.gradient_step = 0.3; }), std::invalid_argument);
  EXPECT_THROW(search(Problem{known.space, 0, nullptr}, {}), std::invalid_argument);
}

TEST(SearchManners, StartsOutsideTheBoxAndOnItsWallsAndLargeStepsAreFine) {
  for (const Way& way : all_ways()) {
    const KnownProblem known = problem_for(way);
    for (const double start : {-100.0, 100.0}) {
      for (const double step : {1e-3, 0.5, 1.0}) {
        SearchOptions options = options_of(way, known);
        options.start.assign(known.space.size(), start);
        options.initial_step = step;
        const SearchResult result = search(problem_of(known), options);
        EXPECT_NE(result.termination, Termination::refused) << name_of(way) << ": " << result.sentence;
        for (std::size_t k = 0; k < result.best.size(); ++k) {
          EXPECT_GE(result.best[k], known.space.variables()[k].lower);
          EXPECT_LE(result.best[k], known.space.variables()[k].upper);
        }
      }
    }
  }
}

TEST(SearchManners, WithoutAStartASearchBeginsInTheMiddle) {
  const KnownProblem known = branin();
  SearchOptions options;
  options.algorithm = Algorithm::neldermead;
  EXPECT_EQ(path_of(problem_of(known), options).front(), (Point{2.5, 7.5}));
}

TEST(SearchManners, EveryReturnCodeHasAMeaningAndASentenceOfItsOwn) {
  const std::vector<std::pair<int, Termination>> codes = {
      {1, Termination::converged},     // NLOPT_SUCCESS
      {2, Termination::converged},     // NLOPT_STOPVAL_REACHED
      {3, Termination::converged},     // NLOPT_FTOL_REACHED
      {4, Termination::converged},     // NLOPT_XTOL_REACHED
      {5, Termination::budget_spent},  // NLOPT_MAXEVAL_REACHED
      {6, Termination::budget_spent},  // NLOPT_MAXTIME_REACHED
      {-1, Termination::stalled},      // NLOPT_FAILURE
      {-2, Termination::refused},      // NLOPT_INVALID_ARGS
      {-3, Termination::stalled},      // NLOPT_OUT_OF_MEMORY
      {-4, Termination::stalled},      // NLOPT_ROUNDOFF_LIMITED
      {-5, Termination::stopped},      // NLOPT_FORCED_STOP
  };
  std::set<std::string> sentences;
  for (const auto& [code, termination] : codes) {
    EXPECT_EQ(ending_of(code).termination, termination) << code;
    sentences.insert(ending_of(code).sentence);
  }
  EXPECT_EQ(sentences.size(), codes.size());
  EXPECT_EQ(ending_of(-99).termination, Termination::stalled);
}

}  // namespace
}  // namespace unbruised::optimizer

#include "optimizer/ledger.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/optimizer/known_problems.hpp"

namespace unbruised::optimizer {
namespace {

using testing::answering;
using testing::Point;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A problem of one variable in [0, 1], so that units and the unit cube are the same.
Problem problem(std::size_t constraints, testing::Function function) {
  return {testing::box(1, 0.0, 1.0), constraints, answering(std::move(function))};
}

double objective_at(Ledger& ledger, double x) { return ledger.at(Point{x}).objective; }

TEST(Ledger, AsksForEveryPointOnce) {
  int calls = 0;
  const Problem counted = problem(0, [&](const Point& x) {
    ++calls;
    return Evaluation{x[0], {}};
  });
  const SearchOptions options;
  Ledger ledger(counted, options, Wanted::values);
  EXPECT_EQ(objective_at(ledger, 0.25), 0.25);
  EXPECT_EQ(objective_at(ledger, 0.5), 0.5);
  EXPECT_EQ(objective_at(ledger, 0.25), 0.25);
  EXPECT_EQ(calls, 2);
  EXPECT_EQ(ledger.result().evaluations, 2U);
  EXPECT_EQ(ledger.result().generations, 2U);
}

TEST(Ledger, TellsAnObjectiveWorseThanAnySeenWhereThereIsNone) {
  for (const double missing : {kNan, kInfinity, -kInfinity}) {
    const Problem holed = problem(0, [&](const Point& x) {
      return Evaluation{x[0] > 0.5 ? missing : 3.0 - 10.0 * x[0], {}};
    });
    const SearchOptions options;
    Ledger ledger(holed, options, Wanted::values);
    EXPECT_EQ(objective_at(ledger, 0.9), 1e6);  // nothing is known yet
    objective_at(ledger, 0.2);
    EXPECT_EQ(objective_at(ledger, 0.8), 2.0);  // the worst, and its own size again
    objective_at(ledger, 0.0);
    objective_at(ledger, 0.1);
    EXPECT_EQ(objective_at(ledger, 0.7), 5.0);  // the worst, 3, and as much again as they differ
    EXPECT_EQ(objective_at(ledger, 0.8), 2.0);  // what was told stays
    EXPECT_EQ(ledger.result().best, Point{0.2});
  }
}

TEST(Ledger, PenaltyStaysFiniteBesideTheLargestNumbers) {
  const double most = std::numeric_limits<double>::max();
  const Problem huge = problem(0, [&](const Point& x) {
    return Evaluation{x[0] > 0.5 ? kNan : (x[0] > 0.2 ? most : -most), {}};
  });
  const SearchOptions options;
  Ledger ledger(huge, options, Wanted::values);
  objective_at(ledger, 0.1);
  objective_at(ledger, 0.3);
  EXPECT_TRUE(std::isfinite(objective_at(ledger, 0.9)));
}

TEST(Ledger, TellsAMissingConstraintAsBrokenAsItEverWas) {
  const Problem holed = problem(2, [](const Point& x) {
    return Evaluation{1.0, {x[0] > 0.5 ? kNan : 7.0 - x[0], x[0] > 0.6 ? -kInfinity : -1.0}};
  });
  SearchOptions options;
  options.constraint_margin = 0.0;
  Ledger ledger(holed, options, Wanted::values);
  EXPECT_EQ(ledger.at(Point{0.7}).constraints, (std::vector<double>{1.0, 1.0}));
  EXPECT_EQ(ledger.at(Point{0.0}).constraints, (std::vector<double>{7.0, -1.0}));
  EXPECT_EQ(ledger.at(Point{0.8}).constraints, (std::vector<double>{7.0, 1.0}));
}

TEST(Ledger, TellsConstraintsWithTheMarginButExactZeroAsItIs) {
  const Problem plain = problem(1, [](const Point& x) { return Evaluation{1.0, {x[0] - 0.5}}; });
  SearchOptions options;
  options.constraint_margin = 0.125;
  Ledger ledger(plain, options, Wanted::values);
  EXPECT_EQ(ledger.at(Point{0.25}).constraints[0], -0.125);
  EXPECT_EQ(ledger.at(Point{0.5}).constraints[0], 0.0);
  EXPECT_TRUE(ledger.result().feasible);
  EXPECT_EQ(ledger.at(Point{0.75}).constraints[0], 0.375);
}

TEST(Ledger, BestIsTheLeastFeasibleOneElseTheLeastViolatedNeverOneWithoutNumbers) {
  const Problem mixed = problem(1, [](const Point& x) {
    if (x[0] < 0.1) return Evaluation{kNan, {-5.0}};  // met, but worth nothing
    if (x[0] < 0.2) return Evaluation{-9.0, {kNan}};
    return Evaluation{x[0], {0.5 - x[0]}};
  });
  const SearchOptions options;
  Ledger ledger(mixed, options, Wanted::values);
  const auto best_after = [&](double x) {
    ledger.at(Point{x});
    return ledger.result().best[0];
  };
  EXPECT_EQ(best_after(0.05), 0.05);  // the only one
  EXPECT_EQ(ledger.result().violation, kInfinity);
  EXPECT_EQ(best_after(0.15), 0.05);
  EXPECT_EQ(best_after(0.3), 0.3);
  EXPECT_FALSE(ledger.result().feasible);
  EXPECT_EQ(best_after(0.4), 0.4);
  EXPECT_EQ(best_after(0.9), 0.9);
  EXPECT_TRUE(ledger.result().feasible);
  EXPECT_EQ(best_after(0.45), 0.9);
  EXPECT_EQ(best_after(0.6), 0.6);
  EXPECT_EQ(best_after(0.7), 0.6);
  EXPECT_EQ(ledger.result().at_best.objective, 0.6);
  EXPECT_EQ(ledger.result().violation, 0.5 - 0.6);
}

TEST(Ledger, AsksPointAndNeighboursAsOneGeneration) {
  std::vector<std::size_t> sizes;
  Problem square = problem(1, [](const Point& x) { return Evaluation{x[0] * x[0], {3.0 * x[0] - 1.0}}; });
  square.evaluate = [&, inner = square.evaluate](const std::vector<Question>& questions) {
    for (std::size_t i = 0; i < questions.size(); ++i) {
      EXPECT_EQ(questions[i].generation, sizes.size());
      EXPECT_EQ(questions[i].index, i);
    }
    sizes.push_back(questions.size());
    return inner(questions);
  };
  SearchOptions options;
  options.gradient_step = 0.125;
  options.central_differences = true;
  Ledger ledger(square, options, Wanted::values_and_gradients);
  const Answer& answer = ledger.at(Point{0.5});
  EXPECT_EQ(answer.gradient,
            (std::vector<std::vector<double>>{{1.0}, {3.0}}));  // exact: all are sums of powers of two
  ledger.at(Point{0.25});
  EXPECT_EQ(sizes, (std::vector<std::size_t>{3, 3}));
  EXPECT_EQ(ledger.result().evaluations, 6U);
}

TEST(Ledger, ADifferenceWithAMissingNumberIsFlat) {
  const Problem holed = problem(1, [](const Point& x) {
    return Evaluation{x[0] > 0.5 ? kNan : x[0], {x[0] < 0.2 ? kInfinity : x[0]}};
  });
  SearchOptions options;
  options.gradient_step = 0.125;
  Ledger ledger(holed, options, Wanted::values_and_gradients);
  EXPECT_EQ(ledger.at(Point{0.25}).gradient, (std::vector<std::vector<double>>{{1.0}, {1.0}}));
  EXPECT_EQ(ledger.at(Point{0.5}).gradient, (std::vector<std::vector<double>>{{0.0}, {1.0}}));
  EXPECT_EQ(ledger.at(Point{0.125}).gradient, (std::vector<std::vector<double>>{{1.0}, {0.0}}));
  EXPECT_EQ(ledger.at(Point{0.75}).gradient, (std::vector<std::vector<double>>{{0.0}, {1.0}}));
}

TEST(Ledger, EndsBeforeAGenerationThatTheBudgetDoesNotCover) {
  const Problem plain = problem(0, [](const Point& x) { return Evaluation{x[0], {}}; });
  SearchOptions options;
  options.evaluations_most = 5;
  Ledger ledger(plain, options, Wanted::values_and_gradients);
  ledger.at(Point{0.1});
  ledger.at(Point{0.2});
  EXPECT_FALSE(ledger.has_ended());
  ledger.at(Point{0.3});
  EXPECT_TRUE(ledger.has_ended());
  EXPECT_EQ(ledger.result().evaluations, 4U);
  EXPECT_EQ(ledger.result().termination, Termination::budget_spent);
  EXPECT_EQ(ledger.result().sentence, "the budget of 5 evaluations is spent");
}

TEST(Ledger, EndsWhenMoreThanHalfOfTheLastTwoHundredAreNotFinite) {
  int calls = 0;
  const Problem failing = problem(0, [&](const Point&) { return Evaluation{++calls <= 150 ? 1.0 : kNan, {}}; });
  SearchOptions options;
  options.evaluations_most = 10000;
  Ledger ledger(failing, options, Wanted::values);
  for (int i = 0; i < 1000; ++i) ledger.at(Point{i / 1000.0});
  // 101 of the last 200: those after the first 150.
  EXPECT_EQ(calls, 251);
  EXPECT_EQ(ledger.result().termination, Termination::stalled);
  EXPECT_EQ(ledger.result().sentence, "more than half of the last 200 evaluations have no finite values");
}

TEST(Ledger, EndsWhenOnlyKnownPointsAreAskedFor) {
  const Problem plain = problem(0, [](const Point& x) { return Evaluation{x[0], {}}; });
  const SearchOptions options;
  Ledger ledger(plain, options, Wanted::values);
  for (int i = 0; i < 1001; ++i) ledger.at(Point{0.5});
  EXPECT_FALSE(ledger.has_ended());
  ledger.at(Point{0.5});
  EXPECT_EQ(ledger.result().termination, Termination::stalled);
  EXPECT_EQ(ledger.result().sentence, "the algorithm goes round in circles over known points");
}

TEST(Ledger, EndsAtAPointThatIsNotANumber) {
  const Problem plain = problem(0, [](const Point& x) { return Evaluation{x[0], {}}; });
  const SearchOptions options;
  Ledger ledger(plain, options, Wanted::values);
  EXPECT_TRUE(std::isfinite(objective_at(ledger, kNan)));
  EXPECT_EQ(ledger.result().termination, Termination::stalled);
  EXPECT_EQ(ledger.result().evaluations, 0U);
}

TEST(Ledger, AsksNobodyAfterAnException) {
  int calls = 0;
  const Problem throwing = problem(0, [&](const Point&) -> Evaluation {
    ++calls;
    throw std::runtime_error("no");
  });
  const SearchOptions options;
  Ledger ledger(throwing, options, Wanted::values);
  EXPECT_THROW(ledger.at(Point{0.5}), std::runtime_error);
  EXPECT_TRUE(std::isfinite(objective_at(ledger, 0.6)));
  EXPECT_EQ(calls, 1);
}

TEST(Ledger, RefusesAnswersThatDoNotFitTheQuestions) {
  const SearchOptions options;
  const Problem short_of_constraints = problem(2, [](const Point&) { return Evaluation{1.0, {0.0}}; });
  EXPECT_THROW(Ledger(short_of_constraints, options, Wanted::values).at(Point{0.5}), std::logic_error);
  Problem silent = problem(0, [](const Point&) { return Evaluation{}; });
  silent.evaluate = [](const std::vector<Question>&) {
    return std::optional<std::vector<Evaluation>>(std::in_place);
  };
  EXPECT_THROW(Ledger(silent, options, Wanted::values).at(Point{0.5}), std::logic_error);
}

}  // namespace
}  // namespace unbruised::optimizer

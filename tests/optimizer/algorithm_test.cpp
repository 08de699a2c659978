#include "optimizer/algorithm.hpp"

#include <set>

#include <gtest/gtest.h>

namespace unbruised::optimizer {
namespace {

std::string refusal(Algorithm algorithm, std::optional<Algorithm> local, std::size_t variables,
                    std::size_t constraints) {
  return why_unsuitable(algorithm, local, variables, constraints);
}

TEST(Algorithms, AreFoundByTheirNamesAndOnlyByThem) {
  std::set<std::string_view> names;
  for (const AlgorithmInfo& info : algorithm_table()) {
    EXPECT_EQ(algorithm_named(info.name), info.algorithm);
    EXPECT_EQ(info_of(info.algorithm).name, info.name);
    EXPECT_FALSE(info.meaning.empty());
    names.insert(info.name);
  }
  EXPECT_EQ(names.size(), 13U);
  EXPECT_EQ(algorithm_named("cobyla"), std::nullopt);
  EXPECT_EQ(algorithm_named(""), std::nullopt);
}

TEST(Algorithms, SayThatTheyCannotTakeConstraintsAndWhichCan) {
  const std::string rest = " cannot take constraints; COBYLA, ISRES, AUGLAG, SLSQP, MMA and CCSAQ can";
  for (const AlgorithmInfo& info : algorithm_table()) {
    const std::string expected = info.takes_constraints ? "" : std::string(info.name) + rest;
    EXPECT_EQ(refusal(info.algorithm, std::nullopt, 2, 1), expected);
    EXPECT_EQ(refusal(info.algorithm, std::nullopt, 2, 0), "");
  }
}

TEST(Algorithms, SayThatBobyqaNeedsTwoVariablesAloneAndInsideAnother) {
  const std::string expected =
      "BOBYQA needs at least two variables; COBYLA, SBPLX, NELDERMEAD, SLSQP, MMA and CCSAQ take one";
  EXPECT_EQ(refusal(Algorithm::bobyqa, std::nullopt, 1, 0), expected);
  EXPECT_EQ(refusal(Algorithm::mlsl, Algorithm::bobyqa, 1, 0), expected);
  EXPECT_EQ(refusal(Algorithm::mlsl, Algorithm::bobyqa, 2, 0), "");
  EXPECT_EQ(refusal(Algorithm::mlsl, std::nullopt, 1, 0), "");
}

TEST(Algorithms, SayWhichCanRunInsideAnotherAndWhichRunOne) {
  EXPECT_EQ(refusal(Algorithm::mlsl, Algorithm::direct_l, 2, 0),
            "DIRECT_L cannot run inside MLSL; COBYLA, BOBYQA, SBPLX, NELDERMEAD, SLSQP, MMA and CCSAQ can");
  EXPECT_EQ(refusal(Algorithm::auglag, Algorithm::auglag, 2, 1),
            "AUGLAG cannot run inside AUGLAG; COBYLA, BOBYQA, SBPLX, NELDERMEAD, SLSQP, MMA and CCSAQ can");
  EXPECT_EQ(refusal(Algorithm::cobyla, Algorithm::sbplx, 2, 0),
            "COBYLA runs no local algorithm; MLSL and AUGLAG do");
}

TEST(Algorithms, NeedAVariable) {
  for (const AlgorithmInfo& info : algorithm_table()) {
    EXPECT_EQ(refusal(info.algorithm, std::nullopt, 0, 0), "there is no variable to search over");
  }
}

TEST(Algorithms, HaveADefaultInsideThatSuitsEveryNumberOfVariables) {
  for (std::size_t n = 1; n < 5; ++n) {
    EXPECT_EQ(refusal(Algorithm::mlsl, default_local(n), n, 0), "");
    EXPECT_EQ(refusal(Algorithm::auglag, default_local(n), n, 3), "");
  }
}

}  // namespace
}  // namespace unbruised::optimizer

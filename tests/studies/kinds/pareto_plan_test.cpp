#include "studies/kinds/pareto_plan.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/studies/kinds/search_testing.hpp"

namespace unbruised::studies::testing {
namespace {

Study front_study(const std::string& seed) {
  return study_of("[study]\nname = \"test\"\nkind = \"pareto\"\nseed = " + seed +
                  "\n[search]\nobjectives = [\"cycle_time_s\", \"peak_finger_force_N\", \"slip_max_m\"]\n"
                  "algorithm = \"COBYLA\"\npoints = 4\nstarts = 1\n"
                  "[[variable]]\nkey = \"strategy.grip_force_N\"\nfrom = 1.0\nto = 4.0\n" +
                  kFormulaCell);
}

/// What the searches for the points of the front think of one strategy: it shows where they look.
std::vector<double> looks_of(const std::string& seed) {
  const Study study = front_study(seed);
  const StrategyJudge judge(study);
  std::vector<Candidate> known(3);
  known[0].objectives = {1.0, 2.0, 3.0};
  known[1].objectives = {2.0, 1.0, 3.0};
  known[2].objectives = {3.0, 2.0, 1.0};
  for (Candidate& candidate : known) {
    candidate.values = {2.0};
    candidate.violation = -1.0;
  }
  std::vector<double> looks;
  for (const PlannedSearch& plan : plan_points(study, judge, known, {{2.0}})) {
    for (const double constraint : plan.worth(known[0], 0.0).constraints) looks.push_back(constraint);
  }
  return looks;
}

TEST(ParetoPlan, LooksForAFrontOfThreeObjectivesWhereTheSeedOfTheStudySays) {
  ASSERT_FALSE(looks_of("1").empty());
  EXPECT_EQ(looks_of("1"), looks_of("1"));
  EXPECT_NE(looks_of("1"), looks_of("2"));
}

}  // namespace
}  // namespace unbruised::studies::testing

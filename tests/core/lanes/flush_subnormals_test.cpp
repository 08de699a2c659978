#include "core/lanes/flush_subnormals.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "core/simulation/simulation.hpp"
#include "tests/core/simulation/scenes.hpp"

namespace unbruised {
namespace {

using namespace testing;

/// Half of the least normal number, computed when it is called.
double half_of_least() {
  volatile double least = std::numeric_limits<double>::min();
  return 0.5 * least;
}

TEST(FlushSubnormals, TakesThemForZeroWhileItLivesAndNoLonger) {
  EXPECT_GT(half_of_least(), 0.0);
  {
    const FlushSubnormals flush;
    EXPECT_EQ(half_of_least(), 0.0);
    const FlushSubnormals again;
    EXPECT_EQ(half_of_least(), 0.0);
    volatile double subnormal = std::numeric_limits<double>::denorm_min();
    EXPECT_EQ(0x1p60 * subnormal, 0.0) << "operands too";
    volatile double least = std::numeric_limits<double>::min();
    EXPECT_EQ(1.0 * least, least) << "normal numbers are as ever";
  }
  EXPECT_GT(half_of_least(), 0.0);
}

TEST(FlushSubnormals, OfASimulationLeavesTheCallersArithmeticAlone) {
  const Scenario scenario = small_box();
  std::string error;
  const auto model = Model::build(scenario, error);
  ASSERT_TRUE(model) << error;
  LaneSimulation lanes(model);
  lanes.load(0, scenario);
  lanes.step();
  EXPECT_GT(half_of_least(), 0.0);
}

}  // namespace
}  // namespace unbruised

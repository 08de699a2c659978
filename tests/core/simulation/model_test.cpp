// The door of the simulator: what a model is for, and what it refuses.

#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/core/simulation/scenes.hpp"

namespace unbruised {
namespace {

using namespace testing;

TEST(LaneSimulation, RefusesAScenarioOfAnotherFactorKey) {
  const Scenario scenario = small_box();
  Scenario stiffer = scenario;
  lattice_of(stiffer).youngs_modulus_Pa *= 2.0;
  LaneSimulation simulation(build(scenario));
  EXPECT_THROW(simulation.load(0, stiffer), std::logic_error);
  EXPECT_FALSE(simulation.busy(0));
  simulation.load(0, scenario);
  EXPECT_TRUE(simulation.busy(0));
  EXPECT_THROW(simulation.load(0, scenario), std::logic_error) << "the lane is busy";
}

}  // namespace
}  // namespace unbruised

// The door of the simulator: what a model is for, and what it refuses.

#include <stdexcept>

#include <gtest/gtest.h>

#include "benchmarks/cube512_scene.hpp"
#include "core/simulation/model_parts.hpp"
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
}

// 3 x 3 particles on each side; what cannot be met costs nothing.
TEST(Model, AsksParticlesOfTheBottomOnlyWhereThereIsASupport) {
  Scenario scenario = small_box();
  const std::size_t side = 9;
  EXPECT_EQ(build(scenario)->contact_candidate_count(), 3 * side);
  EXPECT_EQ(model_size(scenario).contact_candidate_count, 3 * side);
  scenario.cell.support = false;
  EXPECT_EQ(build(scenario)->contact_candidate_count(), 2 * side);
  EXPECT_EQ(model_size(scenario).contact_candidate_count, 2 * side);
}

// Half of the memory, where it is most of the model.
TEST(Model, KeepsTheValuesOfAFactorOnce) {
  const auto large = build(benchmarks::cube512_scene(1e-3)), small = build(small_box());
  const SupernodalFactor &in_single = large->parts().body.factor, &in_double = small->parts().body.factor;
  EXPECT_GE(in_single.single_value.size(), in_single.entry_count);
  EXPECT_EQ(in_single.value.capacity(), 0U);
  EXPECT_GE(in_double.value.size(), in_double.entry_count);
  EXPECT_EQ(in_double.single_value.capacity(), 0U);
}

TEST(LaneSimulation, RefusesALaneThatIsBusyOrDoesNotExistAndATraceThatComesLate) {
  const Scenario scenario = small_box();
  LaneSimulation simulation(build(scenario));
  simulation.load(0, scenario);
  EXPECT_THROW(simulation.load(0, scenario), std::logic_error) << "the lane is busy";
  EXPECT_THROW(simulation.load(lane_count(), scenario), std::logic_error) << "there is no such lane";
  EXPECT_THROW((void)simulation.busy(-1), std::logic_error);
  Trace trace;
  EXPECT_THROW(simulation.record(1, &trace), std::logic_error) << "nothing runs there";
  simulation.step();
  EXPECT_THROW(simulation.record(0, &trace), std::logic_error) << "it has begun";
}

}  // namespace
}  // namespace unbruised

// One pick of a block with the simulator's own library: a scenario is plain data, SI units.
//
// examples/CMakeLists.txt builds it; include paths begin with the house.

#include <cstdio>
#include <memory>
#include <string>

#include "core/scenario/rules.hpp"
#include "core/simulation/simulation.hpp"

int main() {
  using namespace unbruised;
  Scenario scenario;
  auto& block = std::get<LatticeParameters>(scenario.product);
  block.shape = Shape::box;
  block.size_m = {0.04, 0.04, 0.04};
  block.cell_size_m = 0.02;
  block.mass_kg = 0.1;
  block.youngs_modulus_Pa = 1e6;
  block.friction = 0.6;
  scenario.gripper = ParallelJawParameters{};
  scenario.strategy.grip_force_N = 3.0;
  scenario.simulation.time_step_s = 1e-3;
  for (const Violation& broken : validate(scenario)) {
    std::printf("%s = %s: %s\n", broken.field.c_str(), broken.value.c_str(), broken.rule.c_str());
  }

  std::string error;
  const std::shared_ptr<const Model> model = Model::build(scenario, error);
  if (!model) {
    std::printf("%s\n", error.c_str());
    return 1;
  }
  const ScenarioResult result = simulate(model, scenario, nullptr);
  std::printf("%s after %.2f s, margin %.2f\n", std::string(outcome_word(result.outcome)).c_str(),
              result.metrics[Metric::cycle_time_s], result.metrics[Metric::friction_margin_min]);
  return result.outcome == Outcome::held ? 0 : 1;
}

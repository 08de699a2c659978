#include "core/simulation/simulation.hpp"

namespace unbruised {

ScenarioResult simulate(const std::shared_ptr<const Model>& model, const Scenario& scenario, Trace* trace) {
  LevelSimulation simulation(model);
  simulation.load(0, scenario);
  simulation.record(0, trace);
  while (simulation.busy(0)) simulation.step();
  return simulation.finished().front().result;
}

}  // namespace unbruised

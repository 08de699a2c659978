#include "studies/estimate/contact_steps.hpp"

#include "studies/estimate/cost_estimate.hpp"
#include "studies/estimate/known_scenarios.hpp"
#include "studies/findings/summary.hpp"

namespace unbruised::studies {

ContactSteps fewest_contact_steps(const Study& study) {
  const ScenarioSet set = known_scenarios(study);
  ContactSteps fewest;
  std::size_t at = 0;
  for (std::size_t id = 0; id < set.count; ++id) {
    const Scenario scenario = set.scenario(id);
    const double contact_s = contact_time_s(scenario);
    const double steps = contact_s / scenario.simulation.time_step_s;
    if (steps >= fewest.steps) continue;
    fewest.steps = steps;
    fewest.contact_s = contact_s;
    at = id;
  }
  if (set.count > 0) fewest.where = inputs_text(set.columns, set.inputs(at));
  return fewest;
}

}  // namespace unbruised::studies

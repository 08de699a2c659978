#include "core/scenario/body_modes.hpp"

#include "core/scenario/gripper.hpp"
#include "core/scenario/relaxation.hpp"

namespace unbruised {
std::string_view needs_full_body_because(const Scenario& scenario) {
  const auto* lattice = std::get_if<LatticeParameters>(&scenario.product);
  if (lattice == nullptr) return "only lattices have modes";
  if (flows(*lattice)) return "the product flows under every force";
  if (scenario.strategy.repeat > 1) return "the marks of one handling are within the product when the next begins";
  if (has_range_sensors(scenario)) return "range sensors see all of the product's surface";
  return {};
}

int mode_count(const Scenario& scenario) {
  const SimulationParameters& simulation = scenario.simulation;
  const bool by_modes = simulation.body == ProductBody::modes && needs_full_body_because(scenario).empty();
  return by_modes ? simulation.mode_count : 0;
}

}  // namespace unbruised

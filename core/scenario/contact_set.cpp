#include "core/scenario/contact_set.hpp"

#include "core/scenario/gripper.hpp"
#include "core/scenario/palm_stops.hpp"
#include "core/scenario/product.hpp"

namespace unbruised {

ContactSet contact_set(const Scenario& scenario) {
  if (!std::holds_alternative<LatticeParameters>(scenario.product)) return ContactSet::pads_and_support;
  if (scenario.simulation.contact_set != ContactSet::automatic) return scenario.simulation.contact_set;
  const bool falls = starts_in_the_air(scenario.product) && scenario.cell.support;
  const bool turned = (lands_otherwise(scenario) || hangs_off_centre(scenario)) && scenario.cell.support;
  return falls || turned || lists_fingers(scenario) || !scenario.cell.surface.empty()
             ? ContactSet::whole_surface
             : ContactSet::pads_and_support;
}

bool stands_on_its_bottom(const Scenario& scenario) {
  return std::holds_alternative<LatticeParameters>(scenario.product) && scenario.cell.support &&
         contact_set(scenario) == ContactSet::pads_and_support;
}

}  // namespace unbruised

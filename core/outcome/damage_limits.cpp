#include "core/outcome/damage_limits.hpp"

#include "core/scenario/product.hpp"

namespace unbruised {

bool can_yield(const Scenario& scenario) { return can_yield(scenario.product); }

bool can_act(const DamageLimit& limit, const Scenario& scenario) {
  switch (limit.needs) {
    case DamageNeeds::yield:
      return can_yield(scenario);
    case DamageNeeds::yield_or_flow:
      return can_yield(scenario) || can_flow(scenario.product);
    case DamageNeeds::gripper:
      return has_gripper(scenario);
    case DamageNeeds::contact_and_yield:
      return can_yield(scenario) && (has_gripper(scenario) || scenario.cell.support);
  }
  return false;
}

std::vector<const DamageLimit*> active_damage_limits(const Scenario& scenario) {
  std::vector<const DamageLimit*> active;
  for (const DamageLimit& limit : kDamageLimits) {
    if (bound_of(limit, scenario.limits) && can_act(limit, scenario)) active.push_back(&limit);
  }
  return active;
}

}  // namespace unbruised

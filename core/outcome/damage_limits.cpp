#include "core/outcome/damage_limits.hpp"

#include "core/scenario/product.hpp"

namespace unbruised {

bool can_yield(const Scenario& scenario) { return can_yield(scenario.product); }

bool can_act(const DamageLimit& limit, const Scenario& scenario) {
  const bool needs_gripper = limit.needs != DamageNeeds::yield;
  const bool needs_yield = limit.needs != DamageNeeds::gripper;
  return (!needs_gripper || has_gripper(scenario)) && (!needs_yield || can_yield(scenario));
}

std::vector<const DamageLimit*> active_damage_limits(const Scenario& scenario) {
  std::vector<const DamageLimit*> active;
  for (const DamageLimit& limit : kDamageLimits) {
    if (bound_of(limit, scenario.limits) && can_act(limit, scenario)) active.push_back(&limit);
  }
  return active;
}

}  // namespace unbruised

#include "core/outcome/damage_limits.hpp"

#include <algorithm>
#include <variant>

namespace unbruised {

bool can_yield(const Scenario& scenario) {
  if (const auto* lattice = std::get_if<LatticeParameters>(&scenario.product)) {
    return lattice->yield_stress_Pa.has_value();
  }
  const std::vector<NetworkSpring>& springs = std::get<NetworkParameters>(scenario.product).spring;
  return std::any_of(springs.begin(), springs.end(),
                     [](const NetworkSpring& spring) { return spring.yield_force_N.has_value(); });
}

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

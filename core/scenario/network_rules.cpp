#include <algorithm>
#include <string>

#include "core/scenario/rule_tables.hpp"
#include "core/scenario/words.hpp"

namespace unbruised {
namespace {

const NetworkParameters* network_of(const Scenario& s) { return std::get_if<NetworkParameters>(&s.product); }

std::string path_in(const char* list, std::size_t i, const char* key) {
  return "product." + std::string(list) + "[" + std::to_string(i) + "]." + key;
}

std::string counted(std::size_t count) {
  return "there are " + std::to_string(count) + " particles, counted from 0";
}

bool is_wall(const NetworkParticle& p) { return p.fixed[0] && p.fixed[1] && p.fixed[2]; }

void is_not_gripped(const Scenario& s, Violations& out) {
  if (network_of(s) == nullptr || !has_gripper(s)) return;
  out.push_back({"gripper", "", "a network cannot be gripped in this version; remove [gripper]"});
}

void something_moves(const Scenario& s, Violations& out) {
  const auto* network = network_of(s);
  if (network == nullptr) return;
  const auto& all = network->particle;
  if (all.empty()) {
    out.push_back({"product.particle", "", "a network needs particles"});
  } else if (std::all_of(all.begin(), all.end(), is_wall)) {
    out.push_back(
        {"product.particle[0].fixed", "", "every particle is fixed in all three freedoms: nothing can move"});
  }
}

void masses_given(const Scenario& s, Violations& out) {
  const auto* network = network_of(s);
  for (std::size_t i = 0; network != nullptr && i < network->particle.size(); ++i) {
    const NetworkParticle& p = network->particle[i];
    if (p.mass_kg > 0.0 || is_wall(p)) continue;
    out.push_back(
        {path_in("particle", i, "mass_kg"), spelled(p.mass_kg), "must be > 0 unless all freedoms are fixed"});
  }
}

void springs_join_places(const Scenario& s, Violations& out) {
  const auto* network = network_of(s);
  for (std::size_t i = 0; network != nullptr && i < network->spring.size(); ++i) {
    const auto [a, b] = network->spring[i].between;
    const auto count = static_cast<int>(network->particle.size());
    const std::string value = "[" + std::to_string(a) + ", " + std::to_string(b) + "]";
    const auto place = [&](int at) { return network->particle[static_cast<std::size_t>(at)].position_m; };
    if (a >= count || b >= count) {
      out.push_back({path_in("spring", i, "between"), value, counted(network->particle.size())});
    } else if (a == b || place(a) == place(b)) {
      out.push_back({path_in("spring", i, "between"), value, "must join two particles at different places"});
    }
  }
}

void hardening_has_yield(const Scenario& s, Violations& out) {
  const auto* network = network_of(s);
  for (std::size_t i = 0; network != nullptr && i < network->spring.size(); ++i) {
    const NetworkSpring& spring = network->spring[i];
    if (spring.hardening_ratio == 0.0 || spring.yield_force_N) continue;
    out.push_back({path_in("spring", i, "hardening_ratio"), spelled(spring.hardening_ratio),
                   "not used without yield_force_N"});
  }
}

void yield_has_stiffness(const Scenario& s, Violations& out) {
  const auto* network = network_of(s);
  for (std::size_t i = 0; network != nullptr && i < network->spring.size(); ++i) {
    const NetworkSpring& spring = network->spring[i];
    if (!spring.yield_force_N || spring.stiffness_N_m > 0.0) continue;
    out.push_back({path_in("spring", i, "yield_force_N"), spelled(*spring.yield_force_N),
                   "needs a stiffness_N_m > 0: a spring without stiffness never reaches it"});
  }
}

void loads_have_particles(const Scenario& s, Violations& out) {
  const auto* network = network_of(s);
  for (std::size_t i = 0; network != nullptr && i < network->load.size(); ++i) {
    const NetworkLoad& load = network->load[i];
    if (load.particle < static_cast<int>(network->particle.size())) continue;
    out.push_back(
        {path_in("load", i, "particle"), std::to_string(load.particle), counted(network->particle.size())});
  }
}

void loads_are_lists(const Scenario& s, Violations& out) {
  const auto* network = network_of(s);
  for (std::size_t i = 0; network != nullptr && i < network->load.size(); ++i) {
    const NetworkLoad& load = network->load[i];
    if (load.time_s.empty() || load.time_s.size() != load.force_N.size()) {
      out.push_back(
          {path_in("load", i, "force_N"), "",
           "must have as many entries as time_s (" + std::to_string(load.time_s.size()) + "), at least one"});
    }
    if (!std::is_sorted(load.time_s.begin(), load.time_s.end())) {
      out.push_back({path_in("load", i, "time_s"), "", "must not decrease"});
    }
  }
}

}  // namespace

std::vector<Rule> network_rules() {
  return {
      {{"gripper", "product.kind"}, "", is_not_gripped},
      {{"product.particle[].fixed"}, "not all particles in all three", something_moves},
      {{"product.particle[].mass_kg", "product.particle[].fixed"},
       "> 0 unless all three freedoms are fixed",
       masses_given},
      {{"product.spring[].between", "product.particle[].position_m"},
       "two particles at different places",
       springs_join_places},
      {{"product.spring[].hardening_ratio", "product.spring[].yield_force_N"},
       "goes with yield_force_N",
       hardening_has_yield},
      {{"product.spring[].yield_force_N", "product.spring[].stiffness_N_m"},
       "needs a stiffness > 0",
       yield_has_stiffness},
      {{"product.load[].particle"}, "a particle of the network", loads_have_particles},
      {{"product.load[].force_N", "product.load[].time_s"},
       "as many as time_s, which does not decrease",
       loads_are_lists},
  };
}

}  // namespace unbruised

#include <cmath>
#include <functional>
#include <string>

#include "core/scenario/relaxation.hpp"
#include "core/scenario/rule_tables.hpp"
#include "core/scenario/words.hpp"

namespace unbruised {
namespace {

constexpr std::size_t kMostBranches = 6;

/// What a product or one spring says of its relaxation, and where.
struct Written {
  std::string path;  ///< "product."
  const std::vector<double>&modulus, &time_s;
  PronyFrom from;
  bool flow, recovery, recovery_damping;  ///< which of the three keys of Burgers are there
  std::string first, second, third;       ///< what they are called
  double stiffness;
};

using Visit = std::function<void(const Written&)>;

void of_lattice(const Scenario& s, const Visit& visit) {
  const auto* p = std::get_if<LatticeParameters>(&s.product);
  if (p == nullptr) return;
  visit({"product.", p->prony_modulus, p->prony_time_s, p->prony_from, p->burgers_flow_time_s.has_value(),
         p->burgers_recovery_modulus.has_value(), p->burgers_recovery_time_s.has_value(), "burgers_flow_time_s",
         "burgers_recovery_modulus", "burgers_recovery_time_s", p->youngs_modulus_Pa});
}

void of_springs(const Scenario& s, const Visit& visit) {
  const auto* network = std::get_if<NetworkParameters>(&s.product);
  for (std::size_t i = 0; network != nullptr && i < network->spring.size(); ++i) {
    const NetworkSpring& p = network->spring[i];
    visit({"product.spring[" + std::to_string(i) + "].", p.prony_modulus, p.prony_time_s, p.prony_from,
           p.burgers_flow_N_s_m.has_value(), p.burgers_recovery_N_m.has_value(),
           p.burgers_recovery_N_s_m.has_value(), "burgers_flow_N_s_m", "burgers_recovery_N_m",
           "burgers_recovery_N_s_m", p.stiffness_N_m});
  }
}

void lists_match(const Written& w, Violations& out) {
  const std::size_t moduli = w.modulus.size(), times = w.time_s.size();
  if (moduli != times) {
    out.push_back({w.path + "prony_time_s", std::to_string(times) + " times",
                   "must be as many as prony_modulus = " + std::to_string(moduli)});
  } else if (times > kMostBranches) {
    out.push_back({w.path + "prony_time_s", std::to_string(times) + " times",
                   "must be " + std::to_string(kMostBranches) + " times at most"});
  }
}

void shares_fit(const Written& w, Violations& out) {
  double sum = 0.0;
  std::vector<RelaxationBranch> branches;
  for (const double share : w.modulus) {
    sum += share;
    branches.push_back({share, 1.0});
  }
  if (sum > 1.0 + 1e-9) {
    out.push_back({w.path + "prony_modulus", "",
                   "must not add up to more than the modulus, 1; they add up to " + for_people(sum)});
  } else if (!branches.empty() && w.from == PronyFrom::long_term && long_term_share(branches) == 0.0) {
    out.push_back({w.path + "prony_modulus", "",
                   "must add up to less than 1 with prony_from = \"long term\": nothing would be left in the long "
                   "term"});
  }
}

void from_has_branches(const Written& w, Violations& out) {
  if (w.from == PronyFrom::instantaneous || !w.modulus.empty()) return;
  out.push_back({w.path + "prony_from", "\"long term\"", "not used without prony_modulus"});
}

void burgers_complete(const Written& w, Violations& out) {
  if (w.flow == w.recovery && w.recovery == w.recovery_damping) return;
  const std::string& missing = !w.flow ? w.first : !w.recovery ? w.second : w.third;
  out.push_back(
      {w.path + missing, "", "missing; a Burgers model needs " + w.first + ", " + w.second + " and " + w.third});
}

void one_model(const Written& w, Violations& out) {
  if (!w.flow || w.modulus.empty()) return;
  out.push_back({w.path + w.first, "", "excludes prony_modulus; give one of them"});
}

void has_stiffness(const Written& w, Violations& out) {
  if (w.stiffness > 0.0 || (!w.flow && w.modulus.empty())) return;
  out.push_back({w.path + (w.flow ? w.first : "prony_modulus"), "",
                 "needs a stiffness_N_m > 0: a spring without stiffness has nothing that fades"});
}

template <auto for_each, auto check>
void each(const Scenario& s, Violations& out) {
  for_each(s, [&out](const Written& written) { check(written, out); });
}

}  // namespace

std::vector<Rule> relaxation_rules() {
  return {
      {{"product.prony_time_s", "product.prony_modulus"},
       "as many as prony_modulus, six at most",
       each<of_lattice, lists_match>},
      {{"product.prony_modulus", "product.prony_from"},
       "sum <= 1, < 1 with prony_from = \"long term\"",
       each<of_lattice, shares_fit>},
      {{"product.prony_from", "product.prony_modulus"},
       "goes with prony_modulus",
       each<of_lattice, from_has_branches>},
      {{"product.burgers_flow_time_s", "product.burgers_recovery_modulus", "product.burgers_recovery_time_s"},
       "all three keys of Burgers, or none",
       each<of_lattice, burgers_complete>},
      {{"product.burgers_flow_time_s", "product.prony_modulus"},
       "not together with prony_modulus",
       each<of_lattice, one_model>},
      {{"product.spring[].prony_time_s", "product.spring[].prony_modulus"},
       "as many as prony_modulus, six at most",
       each<of_springs, lists_match>},
      {{"product.spring[].prony_modulus", "product.spring[].prony_from"},
       "sum <= 1, < 1 with prony_from = \"long term\"",
       each<of_springs, shares_fit>},
      {{"product.spring[].prony_from", "product.spring[].prony_modulus"},
       "goes with prony_modulus",
       each<of_springs, from_has_branches>},
      {{"product.spring[].burgers_flow_N_s_m", "product.spring[].burgers_recovery_N_m",
        "product.spring[].burgers_recovery_N_s_m"},
       "all three keys of Burgers, or none",
       each<of_springs, burgers_complete>},
      {{"product.spring[].burgers_flow_N_s_m", "product.spring[].prony_modulus"},
       "not together with prony_modulus",
       each<of_springs, one_model>},
      {{"product.spring[].prony_modulus", "product.spring[].burgers_flow_N_s_m", "product.spring[].stiffness_N_m"},
       "needs a stiffness > 0",
       each<of_springs, has_stiffness>},
  };
}

}  // namespace unbruised

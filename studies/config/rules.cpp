#include "studies/config/rules.hpp"

#include <algorithm>
#include <cmath>

#include "core/outcome/damage_limits.hpp"

namespace unbruised::studies {
namespace {

using Rule = std::optional<Broken>;

const LatticeParameters* lattice_of(const Scenario& s) { return std::get_if<LatticeParameters>(&s.product); }

Rule at_most(const char* key, double value, const char* other, double bound) {
  if (value <= bound) return std::nullopt;
  return Broken{key, spelled(value), "must be <= " + std::string(other) + " = " + spelled(bound)};
}

Rule plasticity_complete(const Scenario& s, const StudySettings& /*settings*/) {
  const auto* p = lattice_of(s);
  if (p == nullptr || p->yield_stress_Pa.has_value() == p->tangent_modulus_Pa.has_value()) return std::nullopt;
  return p->yield_stress_Pa ? Broken{"product.tangent_modulus_Pa", "", "missing; yield_stress_Pa needs it"}
                            : Broken{"product.tangent_modulus_Pa", spelled(*p->tangent_modulus_Pa),
                                     "not used without yield_stress_Pa"};
}

Rule tangent_below_modulus(const Scenario& s, const StudySettings& /*settings*/) {
  const auto* p = lattice_of(s);
  if (p == nullptr || !p->tangent_modulus_Pa || *p->tangent_modulus_Pa < p->youngs_modulus_Pa) return std::nullopt;
  return Broken{"product.tangent_modulus_Pa", spelled(*p->tangent_modulus_Pa),
                "must be < product.youngs_modulus_Pa = " + spelled(p->youngs_modulus_Pa)};
}

Rule loss_complete(const Scenario& s, const StudySettings& /*settings*/) {
  const auto* p = lattice_of(s);
  if (p == nullptr || p->loss_ratio.has_value() == p->at_frequency_Hz.has_value()) return std::nullopt;
  return p->loss_ratio
             ? Broken{"product.at_frequency_Hz", "", "missing; loss_ratio needs it"}
             : Broken{"product.at_frequency_Hz", spelled(*p->at_frequency_Hz), "not used without loss_ratio"};
}

Rule cells_fit(const Scenario& s, const StudySettings& /*settings*/) {
  const auto* p = lattice_of(s);
  if (p == nullptr) return std::nullopt;
  constexpr double kMostCells = 1e6;
  const double smallest = *std::min_element(p->size_m.begin(), p->size_m.end());
  if (p->cell_size_m > 0.5 * smallest) {
    return Broken{"product.cell_size_m", spelled(p->cell_size_m),
                  "must be <= half the smallest extent of product.size_m = " + spelled(0.5 * smallest)};
  }
  double cells = 1.0;
  for (const double extent : p->size_m) cells *= std::round(extent / p->cell_size_m);
  if (cells <= kMostCells) return std::nullopt;
  return Broken{"product.cell_size_m", spelled(p->cell_size_m), "makes more than 1,000,000 cells"};
}

Rule sphere_is_round(const Scenario& s, const StudySettings& /*settings*/) {
  const auto* p = lattice_of(s);
  if (p == nullptr || p->shape != Shape::sphere) return std::nullopt;
  if (p->size_m[0] == p->size_m[1] && p->size_m[1] == p->size_m[2]) return std::nullopt;
  return Broken{"product.size_m", "", "a sphere has three equal extents; else write shape = \"ellipsoid\""};
}

Rule contact_force_small(const Scenario& s, const StudySettings& settings) {
  if (!s.gripper) return std::nullopt;
  const bool window = settings.kind == StudyKind::window;
  return at_most("strategy.contact_force_N", s.strategy.contact_force_N,
                 window ? "window.from_N" : "strategy.grip_force_N",
                 window ? settings.window.from_N : s.strategy.grip_force_N);
}

Rule force_in_reach(const Scenario& s, const StudySettings& settings) {
  if (!s.gripper) return std::nullopt;
  const bool window = settings.kind == StudyKind::window;
  return at_most(window ? "window.to_N" : "strategy.grip_force_N",
                 window ? settings.window.to_N : s.strategy.grip_force_N, "gripper.max_force_N",
                 s.gripper->max_force_N);
}

Rule approach_speed_in_reach(const Scenario& s, const StudySettings& /*settings*/) {
  if (!s.gripper) return std::nullopt;
  return at_most("strategy.approach_speed_m_s", s.strategy.approach_speed_m_s, "gripper.max_speed_m_s",
                 s.gripper->max_speed_m_s);
}

Rule release_speed_in_reach(const Scenario& s, const StudySettings& /*settings*/) {
  if (!s.gripper) return std::nullopt;
  return at_most("strategy.release_speed_m_s", s.strategy.release_speed_m_s, "gripper.max_speed_m_s",
                 s.gripper->max_speed_m_s);
}

Rule place_below_lift(const Scenario& s, const StudySettings& /*settings*/) {
  const CellParameters& c = s.cell;
  if (!s.gripper || c.lift_height_m <= 0.0 || c.place_height_m < c.lift_height_m) return std::nullopt;
  return Broken{"cell.place_height_m", spelled(c.place_height_m),
                "must be < cell.lift_height_m = " + spelled(c.lift_height_m)};
}

Rule duration_known(const Scenario& s, const StudySettings& /*settings*/) {
  if (s.gripper) return std::nullopt;
  if (!s.simulation.duration_s)
    return Broken{"simulation.duration_s", "", "missing; a study without [gripper] needs it"};
  if (*s.simulation.duration_s >= s.simulation.time_step_s) return std::nullopt;
  return Broken{"simulation.duration_s", spelled(*s.simulation.duration_s),
                "must be >= simulation.time_step_s = " + spelled(s.simulation.time_step_s)};
}

Rule trace_interval_long(const Scenario& s, const StudySettings& /*settings*/) {
  const SimulationParameters& p = s.simulation;
  if (!p.trace_interval_s || *p.trace_interval_s >= p.time_step_s) return std::nullopt;
  return Broken{"simulation.trace_interval_s", spelled(*p.trace_interval_s),
                "must be >= simulation.time_step_s = " + spelled(p.time_step_s)};
}

Rule window_ordered(const Scenario& /*scenario*/, const StudySettings& settings) {
  if (settings.kind != StudyKind::window || settings.window.from_N < settings.window.to_N) return std::nullopt;
  return Broken{"window.from_N", spelled(settings.window.from_N),
                "must be < window.to_N = " + spelled(settings.window.to_N)};
}

/// The limits that are set but can never act, "limits.permanent_set_m, limits.plastic_strain".
std::string idle_limits(const Scenario& s) {
  std::string never;
  for (const DamageLimit& limit : kDamageLimits) {
    if (!bound_of(limit, s.limits) || can_act(limit, s)) continue;
    never += (never.empty() ? "" : ", ") + std::string(limit.key);
  }
  return never;
}

/// An answer that says "undamaged" where nothing could ever have been damaged is no answer.
Rule damage_can_show(const Scenario& s, const StudySettings& settings) {
  const bool is_judged = s.gripper && s.limits.damage == DamageJudging::judged;
  if (!judges_damage(settings.kind) || !is_judged || !active_damage_limits(s).empty()) return std::nullopt;
  const std::string idle = idle_limits(s);
  const std::string ways =
      idle.empty() ? "give a limit in [limits], e.g. limits.finger_force_N or, with product.yield_stress_Pa, "
                     "limits.contact_yield_ratio = 1"
                   : "give product.yield_stress_Pa, or a limit that needs none (limits.finger_force_N, "
                     "limits.peak_pressure_Pa)";
  return Broken{
      "limits.damage", "\"judged\"",
      (idle.empty() ? std::string("there is no limit of damage, so nothing could ever count as damaged: ")
                    : idle + " can never act without a yield stress, so nothing could ever count as "
                             "damaged: ") +
          ways + ", or write limits.damage = \"not considered\" and get answers about holding alone"};
}

std::string path_of(const char* list, std::size_t i, const char* key) {
  return "product." + std::string(list) + "[" + std::to_string(i) + "]." + key;
}

void check_particles(const NetworkParameters& network, std::vector<Broken>& out) {
  for (std::size_t i = 0; i < network.particle.size(); ++i) {
    const NetworkParticle& p = network.particle[i];
    const bool wall = p.fixed[0] && p.fixed[1] && p.fixed[2];
    if (p.mass_kg > 0.0 || wall) continue;
    out.push_back(
        {path_of("particle", i, "mass_kg"), spelled(p.mass_kg), "must be > 0 unless all freedoms are fixed"});
  }
}

void check_springs(const NetworkParameters& network, std::vector<Broken>& out) {
  const auto count = static_cast<int>(network.particle.size());
  for (std::size_t i = 0; i < network.spring.size(); ++i) {
    const auto [a, b] = network.spring[i].between;
    const std::string value = "[" + std::to_string(a) + ", " + std::to_string(b) + "]";
    const std::string path = path_of("spring", i, "between");
    if (a >= count || b >= count) {
      out.push_back({path, value, "there are " + std::to_string(count) + " particles, counted from 0"});
    } else if (a == b || network.particle[static_cast<std::size_t>(a)].position_m ==
                             network.particle[static_cast<std::size_t>(b)].position_m) {
      out.push_back({path, value, "must join two particles at different places"});
    }
    if (network.spring[i].hardening_ratio > 0.0 && !network.spring[i].yield_force_N) {
      out.push_back({path_of("spring", i, "hardening_ratio"), spelled(network.spring[i].hardening_ratio),
                     "not used without yield_force_N"});
    }
  }
}

void check_loads(const NetworkParameters& network, std::vector<Broken>& out) {
  const auto count = static_cast<int>(network.particle.size());
  for (std::size_t i = 0; i < network.load.size(); ++i) {
    const NetworkLoad& load = network.load[i];
    if (load.particle >= count) {
      out.push_back({path_of("load", i, "particle"), std::to_string(load.particle),
                     "there are " + std::to_string(count) + " particles, counted from 0"});
    }
    if (load.time_s.empty() || load.time_s.size() != load.force_N.size()) {
      out.push_back(
          {path_of("load", i, "force_N"), "",
           "must have as many entries as time_s (" + std::to_string(load.time_s.size()) + "), at least one"});
    }
    if (!std::is_sorted(load.time_s.begin(), load.time_s.end())) {
      out.push_back({path_of("load", i, "time_s"), "", "must not decrease"});
    }
  }
}

/// Everything that decides whether a limit of damage can act.
std::vector<std::string_view> damage_keys() {
  std::vector<std::string_view> keys = {"limits.damage", "product.yield_stress_Pa",
                                        "product.spring[].yield_force_N"};
  for (const DamageLimit& limit : kDamageLimits) keys.push_back(limit.key);
  return keys;
}

}  // namespace

const std::vector<CrossRule>& cross_rules() {
  static const std::vector<CrossRule> rules = {
      {{"product.yield_stress_Pa", "product.tangent_modulus_Pa"}, plasticity_complete},
      {{"product.tangent_modulus_Pa", "product.youngs_modulus_Pa"}, tangent_below_modulus},
      {{"product.loss_ratio", "product.at_frequency_Hz"}, loss_complete},
      {{"product.cell_size_m", "product.size_m"}, cells_fit},
      {{"product.shape", "product.size_m"}, sphere_is_round},
      {{"strategy.contact_force_N", "strategy.grip_force_N", "window.from_N"}, contact_force_small},
      {{"strategy.grip_force_N", "gripper.max_force_N", "window.to_N"}, force_in_reach},
      {{"strategy.approach_speed_m_s", "gripper.max_speed_m_s"}, approach_speed_in_reach},
      {{"strategy.release_speed_m_s", "gripper.max_speed_m_s"}, release_speed_in_reach},
      {{"cell.place_height_m", "cell.lift_height_m"}, place_below_lift},
      {{"simulation.duration_s", "simulation.time_step_s"}, duration_known},
      {{"simulation.trace_interval_s", "simulation.time_step_s"}, trace_interval_long},
      {{"window.from_N", "window.to_N"}, window_ordered},
      {damage_keys(), damage_can_show},
  };
  return rules;
}

std::vector<Broken> broken_network_rules(const NetworkParameters& network) {
  std::vector<Broken> out;
  if (network.particle.empty()) out.push_back({"product.particle", "", "a network needs particles"});
  check_particles(network, out);
  check_springs(network, out);
  check_loads(network, out);
  return out;
}

std::vector<std::string> doubts(const Scenario& scenario) {
  std::vector<std::string> out;
  if (scenario.gripper && scenario.gripper->stroke_m <= scenario.cell.approach_gap_m) {
    out.emplace_back("gripper.stroke_m <= cell.approach_gap_m: the fingers never reach the product");
  }
  const auto* p = lattice_of(scenario);
  const std::string never = idle_limits(scenario);
  if (!never.empty()) {
    out.push_back(never + (can_yield(scenario) ? ": never exceeded without a gripper"
                                               : ": never exceeded, the product has no yield stress"));
  }
  if (scenario.gripper && p != nullptr && p->friction == 0.0) {
    out.emplace_back("product.friction is 0: no grip force can hold the product");
  }
  return out;
}

}  // namespace unbruised::studies

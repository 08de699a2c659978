#include "studies/runner/verdict.hpp"

#include <array>
#include <optional>
#include <utility>

namespace unbruised::studies {
namespace {

bool ended_early(Outcome outcome) {
  return outcome == Outcome::diverged || outcome == Outcome::out_of_range || outcome == Outcome::not_run;
}

bool exceeds_a_damage_limit(const Metrics& metrics, const LimitParameters& limits) {
  const std::array<std::pair<Metric, std::optional<double>>, 7> rules = {{
      {Metric::permanent_set_max_m, limits.permanent_set_m},
      {Metric::plastic_strain_max, limits.plastic_strain},
      {Metric::bruised_volume_m3, limits.bruised_volume_m3},
      {Metric::peak_pressure_Pa, limits.peak_pressure_Pa},
      {Metric::absorbed_energy_J, limits.absorbed_energy_J},
      {Metric::peak_finger_force_N, limits.finger_force_N},
      {Metric::contact_yield_ratio_max, limits.contact_yield_ratio},
  }};
  for (const auto& [metric, limit] : rules) {
    if (limit && metrics[metric] > *limit) return true;
  }
  return false;
}

}  // namespace

Verdict holds(const Metrics& metrics, Outcome outcome, const LimitParameters& limits) {
  if (outcome == Outcome::not_grasped || outcome == Outcome::dropped || outcome == Outcome::slipped) {
    return Verdict::no;
  }
  if (metrics[Metric::slip_max_m] > limits.slip_m) return Verdict::no;
  return ended_early(outcome) ? Verdict::unknown : Verdict::yes;
}

Verdict undamaged(const Metrics& metrics, Outcome outcome, const LimitParameters& limits) {
  if (outcome == Outcome::damaged || exceeds_a_damage_limit(metrics, limits)) return Verdict::no;
  return ended_early(outcome) ? Verdict::unknown : Verdict::yes;
}

}  // namespace unbruised::studies

#pragma once

/// @file
/// The one table of limits: which key of [limits] bounds which metric, which outcome it decides, and what a limit
/// of damage needs to be able to act at all.

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "core/outcome/outcome.hpp"
#include "core/scenario/scenario.hpp"

namespace unbruised {

/// What must be there for the metric of a limit to rise.
enum class DamageNeeds {
  yield,              ///< a yield stress, or a spring with a yield force
  yield_or_flow,      ///< or a modulus of which nothing is left in the long term: else nothing deforms for good
  gripper,            ///< fingers that press
  contact_and_yield,  ///< fingers or a support
};

struct DamageLimit {
  Metric metric;
  std::optional<double> LimitParameters::*limit;
  DamageNeeds needs;
  std::string_view key;    ///< "limits.permanent_set_m"
  std::string_view rule;   ///< kept while true: "permanent_set_max_m <= limits.permanent_set_m"
  std::string_view cause;  ///< of `damaged`: "permanent_set_max_m > limits.permanent_set_m"
};

/// `limits.contact_yield_ratio` of a study that does not write it, where a yield stress is known: the other limits
/// wait for cells to flow, which comes late below a small patch (docs/theory.md, "First yield").
inline constexpr double kUsualContactYieldRatio = 1.0;

inline constexpr std::array<DamageLimit, 7> kDamageLimits = {{
    {Metric::permanent_set_max_m, &LimitParameters::permanent_set_m, DamageNeeds::yield_or_flow,
     "limits.permanent_set_m", "permanent_set_max_m <= limits.permanent_set_m",
     "permanent_set_max_m > limits.permanent_set_m"},
    {Metric::plastic_strain_max, &LimitParameters::plastic_strain, DamageNeeds::yield, "limits.plastic_strain",
     "plastic_strain_max <= limits.plastic_strain", "plastic_strain_max > limits.plastic_strain"},
    {Metric::bruised_volume_m3, &LimitParameters::bruised_volume_m3, DamageNeeds::yield,
     "limits.bruised_volume_m3", "bruised_volume_m3 <= limits.bruised_volume_m3",
     "bruised_volume_m3 > limits.bruised_volume_m3"},
    {Metric::peak_pressure_Pa, &LimitParameters::peak_pressure_Pa, DamageNeeds::gripper, "limits.peak_pressure_Pa",
     "peak_pressure_Pa <= limits.peak_pressure_Pa", "peak_pressure_Pa > limits.peak_pressure_Pa"},
    {Metric::absorbed_energy_J, &LimitParameters::absorbed_energy_J, DamageNeeds::yield,
     "limits.absorbed_energy_J", "absorbed_energy_J <= limits.absorbed_energy_J",
     "absorbed_energy_J > limits.absorbed_energy_J"},
    {Metric::peak_finger_force_N, &LimitParameters::finger_force_N, DamageNeeds::gripper, "limits.finger_force_N",
     "peak_finger_force_N <= limits.finger_force_N", "peak_finger_force_N > limits.finger_force_N"},
    {Metric::contact_yield_ratio_max, &LimitParameters::contact_yield_ratio, DamageNeeds::contact_and_yield,
     "limits.contact_yield_ratio", "contact_yield_ratio_max <= limits.contact_yield_ratio",
     "contact_yield_ratio_max > limits.contact_yield_ratio"},
}};

/// A limit that decides `slipped`. It is always set, and damage is none of its business.
struct SlipLimit {
  Metric metric;
  double LimitParameters::*limit;
  std::string_view key, rule, cause;  ///< as of a DamageLimit
};

inline constexpr std::array<SlipLimit, 2> kSlipLimits = {{
    {Metric::slip_max_m, &LimitParameters::slip_m, "limits.slip_m", "slip_max_m <= limits.slip_m",
     "slip_max_m > limits.slip_m"},
    {Metric::slip_max_rad, &LimitParameters::slip_rad, "limits.slip_rad", "slip_max_rad <= limits.slip_rad",
     "slip_max_rad > limits.slip_rad"},
}};

/// A limit that decides `misplaced`. Damage is none of its business either.
struct PlaceLimit {
  Metric metric;
  std::optional<double> LimitParameters::*limit;
  std::string_view key, rule, cause;
};

inline constexpr std::array<PlaceLimit, 2> kPlaceLimits = {{
    {Metric::place_error_m, &LimitParameters::place_error_m, "limits.place_error_m",
     "place_error_m <= limits.place_error_m", "place_error_m > limits.place_error_m"},
    {Metric::place_attitude_rad, &LimitParameters::place_attitude_rad, "limits.place_attitude_rad",
     "place_attitude_rad <= limits.place_attitude_rad", "place_attitude_rad > limits.place_attitude_rad"},
}};

/// Does the product stand, in the end, where it may not?
inline bool exceeds(const Metrics& metrics, const PlaceLimit& place, const LimitParameters& limits) {
  const std::optional<double>& bound = limits.*(place.limit);
  return bound && metrics[place.metric] > *bound;
}

/// Did the product slip further than it may?
inline bool exceeds(const Metrics& metrics, const SlipLimit& slip, const LimitParameters& limits) {
  return metrics[slip.metric] > limits.*(slip.limit);
}

/// The bound that a run is judged by; none where the limit is absent or damage is not considered.
constexpr std::optional<double> bound_of(const DamageLimit& limit, const LimitParameters& limits) {
  return limits.damage == DamageJudging::not_considered ? std::nullopt : limits.*(limit.limit);
}

/// Is this limit exceeded, and judged?
inline bool exceeds(const Metrics& metrics, const DamageLimit& limit, const LimitParameters& limits) {
  const std::optional<double> bound = bound_of(limit, limits);
  return bound && metrics[limit.metric] > *bound;
}

/// Can the product of this scenario keep a deformation?
bool can_yield(const Scenario& scenario);
/// Is there anything that could ever make the metric of this limit rise?
bool can_act(const DamageLimit& limit, const Scenario& scenario);
/// The limits that are set, are considered and can act. None: whether the product is damaged is not looked at.
std::vector<const DamageLimit*> active_damage_limits(const Scenario& scenario);

}  // namespace unbruised

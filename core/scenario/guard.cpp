#include "core/scenario/guard.hpp"

#include <algorithm>
#include <cmath>

#include "core/scenario/opening.hpp"
#include "core/scenario/pad_face.hpp"
#include "core/scenario/pad_meeting.hpp"
#include "core/scenario/product.hpp"

namespace unbruised {
namespace {

/// From a pad's face to the place of the product that it meets first.
std::optional<double> way_to_touch_m(const Scenario& scenario) {
  const auto meeting = pad_meeting(scenario);
  const auto extents_m = shape_extents_m(scenario.product);
  if (!meeting || !extents_m) return std::nullopt;
  if (has_shaped_pads(scenario)) return approach_gap_m(scenario);
  return approach_gap_m(scenario) + meeting->depth_share * (*extents_m)[0];
}

}  // namespace

std::array<double, 3> ray_start_m(const Scenario& scenario, const ParallelJawParameters& jaw) {
  return {-opened_half_m(scenario) - jaw.range.depth_m, scenario.cell.grip_offset_m + jaw.range.offset_m[0],
          scenario.cell.grip_height_m + jaw.range.offset_m[1]};
}

std::optional<RayAtStart> ray_at_start(const Scenario& scenario) {
  const auto* jaw = parallel_jaw(scenario);
  const auto shape = true_shape(scenario.product);
  const auto way_m = way_to_touch_m(scenario);
  if (jaw == nullptr || !jaw->range.maximum_m || !shape || !way_m) return std::nullopt;
  const auto hit = shape->first_hit(ray_start_m(scenario, *jaw), {1.0, 0.0, 0.0});
  if (!hit) return std::nullopt;
  return RayAtStart{hit->distance_m, hit->distance_m - *way_m};
}

PlannedApproach planned_approach(const Scenario& scenario) {
  const StrategyParameters& s = scenario.strategy;
  const double way_m = way_to_touch_m(scenario).value_or(approach_gap_m(scenario));
  const double fast = s.approach_speed_m_s, slow = s.guard_speed_m_s;
  const auto ray = ray_at_start(scenario);
  if (s.guard != GuardKind::range || !s.guard_range_m || !ray) return {way_m / fast, fast};
  const double guarded_m = std::clamp(*s.guard_range_m - ray->touch_distance_m, 0.0, way_m);
  const double free_s = (way_m - guarded_m) / fast;
  const double brake_m_s2 = s.contact_force_N / jaw_of(scenario).finger_mass_kg;
  const double left = fast * fast - 2.0 * brake_m_s2 * guarded_m;
  if (left >= slow * slow) {
    const double touch = std::sqrt(left);
    return {free_s + 2.0 * guarded_m / (fast + touch), touch};
  }
  const double braking_m = 0.5 * (fast * fast - slow * slow) / brake_m_s2;
  return {free_s + (fast - slow) / brake_m_s2 + (guarded_m - braking_m) / slow, slow};
}

}  // namespace unbruised

#include "core/scenario/opening.hpp"

#include <algorithm>

#include "core/scenario/finger_axes.hpp"
#include "core/scenario/gripper.hpp"
#include "core/scenario/pad_meeting.hpp"
#include "core/scenario/product.hpp"
#include "core/scenario/vectors.hpp"

namespace unbruised {
namespace {

/// How far the product reaches from the middle of the grip towards the finger that it comes nearest to.
std::optional<double> reach_to_fingers_m(const Scenario& scenario, const ParallelJawParameters& jaw) {
  std::optional<double> furthest;
  for (const FingerParameters& finger : jaw.finger) {
    const auto reach = reach_to_finger_m(scenario, finger);
    if (reach) furthest = std::max(*reach, furthest.value_or(*reach));
  }
  return furthest;
}

}  // namespace

std::optional<double> reach_to_finger_m(const Scenario& scenario, const FingerParameters& finger) {
  const std::array<double, 3> way = finger_axes(finger)[2];
  const auto reach = shape_reach_m(scenario.product, {-way[0], -way[1], -way[2]});
  if (!reach) return std::nullopt;
  std::array<double, 3> from_product = finger.offset_m;
  from_product[1] += scenario.cell.grip_offset_m;
  from_product[2] += scenario.cell.grip_height_m;
  return *reach + dot(way, from_product);
}

std::optional<double> half_width_m(const Scenario& scenario) {
  const auto* jaw = parallel_jaw(scenario);
  if (jaw != nullptr && !jaw->finger.empty()) return reach_to_fingers_m(scenario, *jaw);
  const auto extents_m = shape_extents_m(scenario.product);
  return extents_m ? std::optional(0.5 * (*extents_m)[0]) : std::nullopt;
}

double approach_gap_m(const Scenario& scenario) {
  if (scenario.cell.approach_gap_m) return *scenario.cell.approach_gap_m;
  const auto half = half_width_m(scenario);
  const auto opening = opening_m(scenario.gripper);
  return opening && half ? gap_in_opening_m(*opening, 2.0 * *half, scenario) : kUsualApproachGap_m;
}

double gap_in_opening_m(double opening_m, double width_m, const Scenario& scenario) {
  return 0.5 * (opening_m - width_m) - pad_reach_m(scenario);
}

double opened_half_m(const Scenario& scenario) {
  const auto half = half_width_m(scenario);
  return approach_gap_m(scenario) + (half ? *half + pad_reach_m(scenario) : 0.0);
}

}  // namespace unbruised

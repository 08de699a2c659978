#include "core/scenario/opening.hpp"

#include "core/scenario/gripper.hpp"
#include "core/scenario/pad_meeting.hpp"
#include "core/scenario/product.hpp"

namespace unbruised {

double approach_gap_m(const Scenario& scenario) {
  if (scenario.cell.approach_gap_m) return *scenario.cell.approach_gap_m;
  const auto extents_m = shape_extents_m(scenario.product);
  const auto opening = opening_m(scenario.gripper);
  return opening && extents_m ? gap_in_opening_m(*opening, (*extents_m)[0], scenario) : kUsualApproachGap_m;
}

double gap_in_opening_m(double opening_m, double width_m, const Scenario& scenario) {
  return 0.5 * (opening_m - width_m) - pad_reach_m(scenario);
}

double opened_half_m(const Scenario& scenario) {
  const auto extents_m = shape_extents_m(scenario.product);
  return approach_gap_m(scenario) + (extents_m ? 0.5 * (*extents_m)[0] + pad_reach_m(scenario) : 0.0);
}

}  // namespace unbruised

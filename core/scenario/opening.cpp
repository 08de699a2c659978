#include "core/scenario/opening.hpp"

#include "core/scenario/gripper.hpp"
#include "core/scenario/product.hpp"

namespace unbruised {

double approach_gap_m(const Scenario& scenario) {
  if (scenario.cell.approach_gap_m) return *scenario.cell.approach_gap_m;
  const auto extents_m = shape_extents_m(scenario.product);
  const auto opening = opening_m(scenario.gripper);
  return opening && extents_m ? 0.5 * (*opening - (*extents_m)[0]) : kUsualApproachGap_m;
}

double opened_half_m(const Scenario& scenario) {
  const auto extents_m = shape_extents_m(scenario.product);
  return approach_gap_m(scenario) + (extents_m ? 0.5 * (*extents_m)[0] : 0.0);
}

}  // namespace unbruised

#include "core/scenario/opening.hpp"

#include "core/scenario/product.hpp"

namespace unbruised {

double approach_gap_m(const Scenario& scenario) {
  if (scenario.cell.approach_gap_m) return *scenario.cell.approach_gap_m;
  const auto extents_m = shape_extents_m(scenario.product);
  const auto* jaw = parallel_jaw(scenario);
  const bool has_opening = jaw != nullptr && jaw->opening_m && extents_m;
  return has_opening ? 0.5 * (*jaw->opening_m - (*extents_m)[0]) : kUsualApproachGap_m;
}

}  // namespace unbruised

#include "core/scenario/opening.hpp"

namespace unbruised {

double approach_gap_m(const Scenario& scenario) {
  if (scenario.cell.approach_gap_m) return *scenario.cell.approach_gap_m;
  const auto* lattice = std::get_if<LatticeParameters>(&scenario.product);
  const auto* jaw = parallel_jaw(scenario);
  const bool has_opening = jaw != nullptr && jaw->opening_m && lattice != nullptr;
  return has_opening ? 0.5 * (*jaw->opening_m - lattice->size_m[0]) : kUsualApproachGap_m;
}

}  // namespace unbruised

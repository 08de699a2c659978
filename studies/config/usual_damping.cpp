#include "studies/config/usual_damping.hpp"

#include <variant>

namespace unbruised::studies {

void give_usual_layer_damping(Scenario& scenario) {
  if (!std::holds_alternative<LatticeParameters>(scenario.product)) return;
  scenario.cell.support_relaxation_time_s = kUsualRelaxationTime_s;
  for (CellSurfaceParameters& surface : scenario.cell.surface) surface.relaxation_time_s = kUsualRelaxationTime_s;
  if (auto* jaw = parallel_jaw(scenario)) jaw->pad_relaxation_time_s = kUsualRelaxationTime_s;
}

void give_usual_product_damping(Scenario& scenario) {
  auto* lattice = std::get_if<LatticeParameters>(&scenario.product);
  if (lattice == nullptr || lattice->relaxation_time_s || lattice->loss_ratio || lattice->at_frequency_Hz) return;
  lattice->loss_ratio = kUsualLossRatio;
  lattice->at_frequency_Hz = kUsualLossFrequency_Hz;
}

}  // namespace unbruised::studies

#include "core/scenario/pad_lattice.hpp"

#include <stdexcept>

#include "core/scenario/lattice_cells.hpp"

namespace unbruised {

bool has_lattice_pads(const ParallelJawParameters& jaw) { return jaw.pad.kind == PadKind::lattice; }

bool has_lattice_pads(const Scenario& scenario) {
  const auto* jaw = parallel_jaw(scenario);
  return jaw != nullptr && has_lattice_pads(*jaw);
}

LatticeParameters pad_lattice(const ParallelJawParameters& jaw) {
  if (!jaw.pad.cell_size_m) throw std::invalid_argument("pad_lattice: gripper.pad.cell_size_m is missing");
  LatticeParameters pad;
  pad.size_m = {jaw.pad_thickness_m, jaw.pad_size_m[0], jaw.pad_size_m[1]};
  pad.cell_size_m = *jaw.pad.cell_size_m;
  pad.density_kg_m3 = jaw.pad.density_kg_m3;
  pad.youngs_modulus_Pa = jaw.pad_modulus_Pa;
  pad.poisson_ratio = jaw.pad_poisson_ratio;
  pad.relaxation_time_s = jaw.pad_relaxation_time_s;
  return pad;
}

double pad_mass_kg(const ParallelJawParameters& jaw) {
  return has_lattice_pads(jaw) ? lattice_mass_kg(pad_lattice(jaw)) : 0.0;
}

double pad_springs_N_m3(const ParallelJawParameters& jaw) {
  const double springs_N_m3 = jaw.pad_modulus_Pa / jaw.pad_thickness_m;
  return has_lattice_pads(jaw) ? kPadSkin * springs_N_m3 : springs_N_m3;
}

}  // namespace unbruised

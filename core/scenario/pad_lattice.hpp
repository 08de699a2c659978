#pragma once

/// @file
/// Pads that are bodies of their own (gripper.pad.kind = "lattice"): what follows from their parameters alone.

#include "core/scenario/scenario.hpp"

namespace unbruised {

bool has_lattice_pads(const ParallelJawParameters& jaw);
/// Without a gripper there are none.
bool has_lattice_pads(const Scenario& scenario);

/// A pad as a body: its thickness along x, its face at the high end; cell_size_m has to be given.
LatticeParameters pad_lattice(const ParallelJawParameters& jaw);

/// Of one pad; 0 where it is a layer.
double pad_mass_kg(const ParallelJawParameters& jaw);

/// A contact with such a pad has a thin skin for its layer, as stiff in shear as other layers are: E / thickness
/// times this. The pad is by so much softer than it should be; contacts without a layer of their own would leave
/// particles between two others of the pad without a force that is theirs alone (docs/theory.md, "Pads that are
/// bodies").
inline constexpr double kPadSkin = 100.0;

/// Stiffness per area in which a contact with a pad is pressed in [N/m3]: of a layer E / thickness.
double pad_springs_N_m3(const ParallelJawParameters& jaw);

}  // namespace unbruised

#pragma once

/// @file
/// Energies of one lane, part by part.

namespace unbruised {

/// Elastic energy and energy of motion of one lane, the elastic one from the present plastic strains [J].
struct StoredEnergy {
  double total = 0;
  // Its parts.
  double kinetic = 0, elastic = 0, hardening = 0;  ///< of the product
  double layers = 0, fingers = 0;                  ///< fingers with pads that are bodies
  double mount = 0;                                ///< of what a sensor carries, and of its spring
};

/// Where the energy of one lane has gone since load, by cause [J].
struct Dissipated {
  double damping = 0, plastic_flow = 0;  ///< of the product: damping and relaxation; hardening is not lost
  double layer_viscosity = 0, friction = 0, layers_left = 0;
  double gripper = 0;  ///< guides, end stop, locks and pads that are bodies
  double mount = 0;    ///< a sensor's spring
};

/// What has been put into one lane since load, by source [J].
struct WorkDone {
  double gravity = 0;
  double palm = 0;      ///< on the product
  double surfaces = 0;  ///< of the cell that move: a belt
  double drives = 0;    ///< and the palm's acceleration, on the fingers; gravity on pads that are bodies
  double mount = 0;     ///< weight and the path's acceleration, on what a sensor carries
};

}  // namespace unbruised

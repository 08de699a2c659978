#pragma once

/// @file
/// One side of a lattice product against a layer, in closed form: what a contact's time and effort are estimated
/// from.

#include "core/scenario/scenario.hpp"

namespace unbruised {

struct LayeredFace {
  double youngs_modulus_Pa;
  double poisson_ratio;
  double half_depth_m;  ///< from the face to the product's middle plane
  bool is_flat;
  double flat_area_m2;
  double radius_m;             ///< of a curved face
  double largest_patch_m2;     ///< that the layer gives a curved face
  double layer_per_area_Pa_m;  ///< E / thickness

  /// What the layer touches under a force [m2]; of a curved face Hertz's circle.
  [[nodiscard]] double patch_m2(double force_N) const;
  /// Layer and product in series under a force [N/m].
  [[nodiscard]] double stiffness_N_m(double force_N) const;

 private:
  [[nodiscard]] double hertz_depth_m(double force_N) const;
  [[nodiscard]] double plane_strain_modulus_Pa() const;
};

LayeredFace side_at_pad(const LatticeParameters& product, const ParallelJawParameters& gripper,
                        const CellParameters& cell);
LayeredFace side_at_support(const LatticeParameters& product, const CellParameters& cell);

}  // namespace unbruised

#pragma once

/// @file
/// One side of a lattice product against a layer, in closed form: the layer that a scenario begins with, and what
/// a contact's time and effort are estimated from.

#include "core/contact/rubber_layer.hpp"
#include "core/scenario/scenario.hpp"

namespace unbruised {

struct LayeredFace {
  double youngs_modulus_Pa;
  double poisson_ratio;
  double half_depth_m;  ///< from the face to the product's middle plane
  bool is_flat;
  double flat_area_m2;
  double radius_m;          ///< of a curved face
  double largest_patch_m2;  ///< that the layer gives a curved face
  FaceLayer layer;

  /// What the layer touches under a force [m2]; of a curved face Hertz's circle.
  [[nodiscard]] double patch_m2(double force_N) const;
  /// Layer alone under a force [N/m].
  [[nodiscard]] double layer_N_m(double force_N) const {
    return layer.stiffness_N_m3(force_N) * patch_m2(force_N);
  }
  /// Layer and product in series under a force [N/m].
  [[nodiscard]] double stiffness_N_m(double force_N) const;

 private:
  [[nodiscard]] double hertz_depth_m(double force_N) const;
  [[nodiscard]] double plane_strain_modulus_Pa() const;
};

LayeredFace side_at_pad(const LatticeParameters& product, const ParallelJawParameters& gripper,
                        const CellParameters& cell);
LayeredFace side_at_support(const LatticeParameters& product, const CellParameters& cell);

/// The layers of a pad and of the support under the faces of a scenario's product; of a network springs.
FaceLayer layer_at_pad(const Scenario& scenario);
FaceLayer layer_at_support(const Scenario& scenario);
/// Stiffness per area with which a scenario is simulated: of a pad under the grip force, of the support under the
/// weight [N/m3].
double pad_layer_N_m3(const Scenario& scenario, const FaceLayer& layer);
double support_layer_N_m3(const Scenario& scenario, const FaceLayer& layer);

}  // namespace unbruised

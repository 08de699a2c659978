#pragma once

/// @file
/// A body by its slowest modes (docs/theory.md, "Modes"): u = S y + G f. The modes S move as the equations of
/// motion say, y'' + tau omega^2 y' + omega^2 y = S' (forces). What they leave out has no mass: G, the static give
/// of the body without them, answers to the contact forces as their own damping lets it, f + tau f' = contact
/// forces. Statics are exact whatever the number of modes, and with all of them everything is.

#include <optional>
#include <span>
#include <vector>

#include "core/algebra/lane_dense.hpp"
#include "core/body/body_model.hpp"
#include "core/body/mode_shapes.hpp"
#include "core/body/turning_modes.hpp"
#include "core/integration/wilson_theta.hpp"
#include "core/scenario/product_frame.hpp"

namespace unbruised {

inline constexpr std::size_t kStrainRows = 9;

/// Read-only once built; for steps of any length.
struct ModalBasis {
  ModeShapes modes;
  std::vector<int> node;   ///< particles that can be touched, ascending
  DenseMatrix at_nodes;    ///< S there, [3 x nodes, modes]
  DenseMatrix from_nodes;  ///< its transpose
  DenseMatrix rest;        ///< G there, symmetric [3 x nodes, 3 x nodes; m/N]
  /// Of the cells at these nodes, kStrainRows each: mean strain (Voigt, tensor shears) and rotation [rad].
  DenseMatrix strain_of_modes;
  DenseMatrix strain_of_rest;           ///< per contact force
  std::optional<TurningBasis> turning;  ///< of a body in a floating frame

  [[nodiscard]] std::size_t node_freedoms() const { return 3 * node.size(); }
};

/// @param deforming how many modes beside the rigid ones
/// @param node particles that can be touched, ascending
/// @throws std::invalid_argument where the modes cannot be found
ModalBasis modal_basis(const BodyModel& body, std::size_t deforming, std::vector<int> node,
                       ProductFrame frame = ProductFrame::upright);

/// Stiffness of a step over the instantaneous one, 1 + tau a1; of a body whose stiffness fades less than 1 by what
/// it has faded at t + theta dt.
double viscous_share(const BodyModel& body, const WilsonTheta& wilson);

/// a0 + omega^2 times that, of each mode.
std::vector<double> effective_square_1_s2(const ModalBasis& basis, const BodyModel& body,
                                          const WilsonTheta& wilson);

/// How far the nodes move, within a step, under forces on each other, as blocks (NodeCompliance::block).
std::vector<double> modal_compliance(const ModalBasis& basis, const BodyModel& body, const WilsonTheta& wilson);

/// Of the static give along the axis under a force on these nodes that is spread evenly, the part which the modes
/// leave out. @param which indices into `node`
double share_left_out(const ModalBasis& basis, std::span<const int> which, std::size_t axis);

/// G f of every particle, [3n], for up to kLanes f. @param force_N rows of `node` each
std::vector<std::vector<double>> rest_shapes(const ModalBasis& basis, const BodyModel& body,
                                             std::span<const std::vector<double>> force_N);

}  // namespace unbruised

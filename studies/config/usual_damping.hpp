#pragma once

/// @file
/// The damping of what a study leaves open. Nothing real bounces for ever, and what does halves a grip window; so
/// lattice products, pads, supports and listed surfaces lose energy unless a study says 0. Networks are written
/// out one by one and stay as written.

#include "core/scenario/scenario.hpp"

namespace unbruised::studies {

/// Silicone and natural rubber lose 0.1 to 0.3 at 10 to 100 Hz (published ranges of tan delta); for fruit it is an
/// assumption, the same as in the library's products. 50 Hz is a contact of 10 ms. A ball that loses so much comes
/// back from a rigid floor with 0.74 of its speed (tests/reference-data/restitution_linear_dashpot.csv, zeta =
/// 0.1).
inline constexpr double kUsualLossRatio = 0.2;
inline constexpr double kUsualLossFrequency_Hz = 50.0;
/// The same as a relaxation time, loss_ratio / (2 pi frequency), rounded.
inline constexpr double kUsualRelaxationTime_s = 6.4e-4;

/// To pads, support and listed surfaces of a lattice product; before the study's own values are written.
void give_usual_layer_damping(Scenario& scenario);
/// To a lattice product that has no damping at all, not even 0; after they are.
void give_usual_product_damping(Scenario& scenario);

}  // namespace unbruised::studies

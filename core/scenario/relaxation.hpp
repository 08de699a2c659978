#pragma once

/// @file
/// How the stiffness of a product fades while it is held deformed: a generalized Maxwell model,
/// E(t) = E_0 [g_inf + sum g_i exp(-t / tau_i)], g_inf = 1 - sum g_i (docs/theory.md, "Relaxation and creep").

#include <span>
#include <vector>

#include "core/scenario/product_parameters.hpp"

namespace unbruised {

/// A spring and a dashpot in series.
struct RelaxationBranch {
  double share;   ///< g_i of the instantaneous modulus
  double time_s;  ///< tau_i
};

/// As they are written, or those of the same Burgers model; empty: elastic.
std::vector<RelaxationBranch> relaxation_branches(const LatticeParameters& product);
std::vector<RelaxationBranch> relaxation_branches(const NetworkSpring& spring);

/// A spring k1 in series with a dashpot c1 and with a spring k2 beside a dashpot c2, as two branches of k1.
/// @param flow_time_s c1 / k1 > 0
/// @param recovery_share k2 / k1 > 0
/// @param recovery_time_s c2 / k2 > 0
std::vector<RelaxationBranch> burgers_branches(double flow_time_s, double recovery_share, double recovery_time_s);

/// g_inf; exactly 0 where the branches take all of the modulus but for rounding: then it flows without end.
double long_term_share(std::span<const RelaxationBranch> branches);

/// E_0, with which the product answers at once.
double instantaneous_modulus_Pa(const LatticeParameters& product);
/// The same of a part of it, a layer or a skin, whose modulus is written as that of the product is: all fade
/// alike.
double instantaneous_modulus_Pa(const LatticeParameters& product, double youngs_modulus_Pa);
double instantaneous_stiffness_N_m(const NetworkSpring& spring);

/// Does any part of it flow under a force for as long as that lasts, and keep it?
bool flows(const LatticeParameters& product);
bool flows(const NetworkParameters& product);

}  // namespace unbruised

#pragma once

/// @file
/// Assembly of a product that is written out as particles, springs, dampers and loads.

#include <array>
#include <limits>
#include <vector>

#include "core/algebra/block_matrix.hpp"
#include "core/scenario/relaxation.hpp"
#include "core/scenario/scenario.hpp"

namespace unbruised {

/// A spring along its line at rest; elongation e = direction . (u_b - u_a).
struct SpringGeometry {
  int a = 0;
  int b = 0;
  /// Unit vector from a to b.
  std::array<double, 3> direction{0.0, 0.0, 0.0};
  double stiffness = 0.0;    ///< [N/m]
  double rest_length = 0.0;  ///< [m]
  /// Longer than its rest length by this where it is mounted, [m]; negative: it is compressed.
  double initial_elongation = 0.0;
  /// |force| at first yield [N]; infinite for an elastic spring.
  double yield_force = std::numeric_limits<double>::infinity();
  /// Yield force grows by hardening_ratio x stiffness x plastic elongation.
  double hardening_ratio = 0.0;
  /// Of its stiffness, which is the instantaneous one.
  std::vector<RelaxationBranch> branch;
  /// Share of its stiffness with which it has a say in where the network comes to rest.
  double rest_share = 1.0;

  [[nodiscard]] bool flows() const { return !branch.empty() && long_term_share(branch) == 0.0; }
};

/// Does any spring have a yield force?
bool can_yield(const std::vector<SpringGeometry>& springs);
/// Does the stiffness of any spring fade?
bool can_relax(const std::vector<SpringGeometry>& springs);

/// M u'' + C u' + K u = f(t) + rest_force, M = diag(mass_kg) per particle. Fixed freedoms are marked, not removed.
struct NetworkSystem {
  using SpringGeometry = unbruised::SpringGeometry;

  std::vector<std::array<double, 3>> position_m;
  std::vector<double> mass_kg;
  std::vector<std::array<bool, 3>> fixed;
  /// K and C share one pattern; C holds explicit zeros where springs have no damper.
  BlockMatrix K;
  BlockMatrix C;
  /// Size 3 n: k (distance - rest length) n pulls a towards b, and b towards a.
  std::vector<double> rest_force_N;
  /// As in the parameters, one for one.
  std::vector<SpringGeometry> springs;
};

/// The four blocks +-c n n^T of one spring or damper.
void add_axial(BlockMatrixBuilder& builder, const SpringGeometry& spring, double coefficient);

/// K = sum k n n^T, C = sum c n n^T over the springs, geometrically linear about the given positions.
/// @throws std::invalid_argument for a spring whose ends coincide, are one particle, or do not exist.
NetworkSystem build_network(const NetworkParameters& parameters);

/// sum factor(spring) k n n^T, in the pattern of K. @param factor takes a SpringGeometry
template <class Factor>
BlockMatrix spring_matrix(std::size_t particle_count, const std::vector<SpringGeometry>& springs,
                          const Factor& factor) {
  BlockMatrixBuilder builder(static_cast<int>(particle_count));
  for (const SpringGeometry& spring : springs) add_axial(builder, spring, factor(spring) * spring.stiffness);
  return builder.build();
}

/// Which value a load has at the very time of a jump.
enum class JumpSide {
  left,   ///< the limit from earlier times
  right,  ///< the limit from later times; the value that belongs to the time itself
};

/// Forces of all loads at a time, size 3 n: linear between a load's points, constant before the first and
/// after the last; loads on one particle add.
/// @throws std::invalid_argument for a load without points, of unequal lengths, or on no particle.
std::vector<double> network_load_N(const NetworkParameters& parameters, double time_s,
                                   JumpSide side = JumpSide::right);

}  // namespace unbruised

#pragma once

/// @file
/// The free vibrations of a body that nothing holds, K s = omega^2 M s: its six rigid motions and the slowest
/// modes in which it deforms.

#include <array>
#include <cstddef>
#include <vector>

#include "core/body/body_model.hpp"

namespace unbruised {

inline constexpr std::size_t kRigidModes = 6;

struct ModeShapes {
  /// Of each mode; the first six, along x, y, z and about three axes through the centre of mass, are 0 [1/s2].
  std::vector<double> square_1_s2;
  /// shape[3n x mode + freedom], s' M s = 1 [kg^-1/2].
  std::vector<double> shape;
  std::array<std::array<double, 3>, 3> turn{};  ///< rotation vectors of the last three rigid ones [rad kg^-1/2]
  /// How many of the last are no modes, but what is left of the even stretches of the body (see `add_stretches`).
  std::size_t stretches = 0;
  double residual = 0.0;  ///< largest |K s - omega^2 M s| / |omega^2 M s| in the norm of M^-1, of deforming modes

  [[nodiscard]] std::size_t count() const { return square_1_s2.size(); }
  [[nodiscard]] std::size_t mode_count() const { return count() - stretches; }
  [[nodiscard]] const double* of(std::size_t mode) const { return shape.data() + mode * (shape.size() / count()); }
};

/// By block Krylov vectors of (K + shift M)^-1 M with the factor that statics have, and a Rayleigh-Ritz step;
/// bodies of which half or more of all modes are asked for by a dense solve.
/// @param deforming of the modes that deform; fewer come back where the body has no more
/// @throws std::invalid_argument where they do not converge
ModeShapes slowest_modes(const BodyModel& body, std::size_t deforming);

/// Adds what modes cannot carry of e_a X_b + e_b X_a, up to six shapes that know nothing of each other and of the
/// modes, neither by M nor by K. With them a body that has turned is carried to the last bit, and so is what its
/// spin pulls at it with, to first order.
void add_stretches(const BodyModel& body, ModeShapes& modes);

}  // namespace unbruised

#pragma once

/// @file
/// A pad that is a body: a box of particles, its back bonded to the finger, its face towards the product. One for
/// both pads, which are mirror images, and for all lanes. Its own x is the direction in which its finger closes.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/body/body_model.hpp"
#include "core/body/node_compliance.hpp"
#include "core/integration/wilson_theta.hpp"
#include "core/scenario/scenario.hpp"

namespace unbruised {

struct PadBody {
  BodyModel body;
  std::vector<int> face;                         ///< its particles, ascending along z, then y
  std::array<std::vector<double>, 2> place_m{};  ///< of their columns and rows, from the middle of the face
  NodeCompliance compliance;                     ///< of the face
  /// A^-1 M n, [3n]: how far the body stays behind within a step per acceleration of its back along x.
  std::vector<double> lag;
  /// What of its mass the finger feels within a step, m - a0 n' M A^-1 M n [kg].
  double felt_mass_kg = 0.0;

  [[nodiscard]] std::size_t columns() const { return place_m[0].size(); }
};

/// @return nothing, with `error` set, when the matrix cannot be factored
std::optional<PadBody> build_pad(const ParallelJawParameters& jaw, const WilsonTheta& wilson, std::string& error);

}  // namespace unbruised

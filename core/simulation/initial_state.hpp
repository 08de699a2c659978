#pragma once

/// @file
/// The state a scenario starts from.

#include <array>
#include <vector>

#include "core/body/body_lanes.hpp"
#include "core/simulation/model_parts.hpp"

namespace unbruised {

/// Where the product is at t = 0, and on what it lies.
struct InitialState {
  BodyState body;
  const StaticRest* rest = nullptr;  ///< null: on nothing. Valid until the next one is asked for
};

/// Gives initial states of one model; keeps the last static rest, which the scenarios of a study usually share.
class InitialStates {
 public:
  explicit InitialStates(const Model::Parts& model) : model_(model) {}

  /// Lattices start at rest on their support, or in free fall where there is none; networks as they are written.
  /// @param plastic_load_N of what yields as it is mounted, [3 x particles]
  InitialState of(const Scenario& scenario, const std::vector<double>& plastic_load_N);

 private:
  InitialState of_lattice(const LatticeParameters& lattice, const CellParameters& cell);
  [[nodiscard]] BodyState of_network(const NetworkParameters& network, const Scenario& scenario,
                                     const std::vector<double>& plastic_load_N) const;

  const Model::Parts& model_;
  StaticRest rest_;
  std::array<double, 2> rest_key_{-1.0, -1.0};  ///< gravity and layer stiffness of `rest_`
};

}  // namespace unbruised

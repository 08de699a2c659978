#pragma once

/// @file
/// The state a scenario starts from.

#include <array>
#include <vector>

#include "core/body/body_state.hpp"
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

  /// Solids start at rest on their support, or in free fall where there is none or they begin turned, high or
  /// spinning; networks as they are written.
  /// @param plastic_load_N of what yields as it is mounted, [3 x particles]
  /// @param worn_N of what has flowed since in former handlings, likewise; empty: there were none
  InitialState of(const Scenario& scenario, const std::vector<double>& plastic_load_N,
                  const std::vector<double>& worn_N = {});

 private:
  void lay_down_or_drop(const Scenario& scenario, const std::vector<double>& worn_N, InitialState& state);
  /// Fills the accelerations from the balance of all forces.
  void accelerate(const Scenario& scenario, const std::vector<double>& plastic_load_N, BodyState& state) const;

  static constexpr std::array<double, 2> kNobodys{-1.0, -1.0};

  const Model::Parts& model_;
  StaticRest rest_;
  std::array<double, 2> rest_key_ = kNobodys;  ///< gravity and layer stiffness of `rest_`
};

}  // namespace unbruised

#include "core/simulation/initial_state.hpp"

#include <span>

#include "core/body/launch.hpp"
#include "core/body/rigid_motion.hpp"
#include "core/contact/layered_face.hpp"
#include "core/scenario/conveyor.hpp"
#include "core/scenario/product.hpp"

namespace unbruised {
namespace {

/// Gives a product that stands on a belt the belt's speed.
void ride_along(const ConveyorParameters& conveyor, BodyState& state) {
  const std::array<double, 2> direction = belt_direction(conveyor);
  const double speed_m_s = belt_start_speed_m_s(conveyor);
  for (std::size_t i = 0; i < state.velocity_m_s.size(); ++i) {
    if (i % 3 < 2) state.velocity_m_s[i] += direction[i % 3] * speed_m_s;
  }
}

}  // namespace

InitialState InitialStates::of(const Scenario& scenario, const std::vector<double>& plastic_load_N,
                               const std::vector<double>& worn_N) {
  const BodyModel& body = model_.body;
  InitialState state{written_state(scenario.product, body), nullptr};
  if (!worn_N.empty()) {
    std::vector<double> shape = body.statics->free_shape(worn_N);
    if (!body.is_anchored()) remove_rigid_motion(body.position_m, shape);
    for (std::size_t i = 0; i < shape.size(); ++i) state.body.displacement_m[i] += shape[i];
  }
  if (body.is_solid) {
    launch(scenario.product, body, state.body);
    lay_down_or_drop(scenario, worn_N, state);
  } else if (scenario.simulation.initial_acceleration == InitialAcceleration::consistent) {
    std::vector<double> load_N = plastic_load_N;
    for (std::size_t i = 0; i < worn_N.size(); ++i) load_N[i] += worn_N[i];
    accelerate(scenario, load_N, state.body);
  }
  return state;
}

void InitialStates::lay_down_or_drop(const Scenario& scenario, const std::vector<double>& worn_N,
                                     InitialState& state) {
  const CellParameters& cell = scenario.cell;
  const double down = -cell.gravity_m_s2[2];
  const bool rests = cell.support && down > 0.0 && !starts_in_the_air(scenario.product);
  if (rests) {
    const std::array<double, 2> key = {down, support_layer_N_m3(scenario, layer_at_support(scenario))};
    if (!worn_N.empty()) {
      rest_ = model_.rest->under_gravity(key[0], key[1], worn_N);
      rest_key_ = kNobodys;
    } else if (key != rest_key_) {
      rest_ = model_.rest->under_gravity(key[0], key[1]);
      rest_key_ = key;
    }
    state.body.displacement_m = rest_.displacement_m;
    state.rest = &rest_;
    ride_along(cell.conveyor, state.body);
  }
  for (std::size_t i = 0; i < state.body.acceleration_m_s2.size(); ++i) {
    const std::size_t axis = i % 3;
    state.body.acceleration_m_s2[i] += rests && axis == 2 ? 0.0 : cell.gravity_m_s2[axis];
  }
}

/// M a = f - C v - K u, with what springs that yield as they are mounted keep.
void InitialStates::accelerate(const Scenario& scenario, const std::vector<double>& plastic_load_N,
                               BodyState& state) const {
  const BodyModel& body = model_.body;
  const std::vector<double> load = written_load_N(scenario.product, body, 0.0);
  std::vector<double> elastic(load.size()), damping(load.size());
  multiply(body.K, std::span<const double>(state.displacement_m), std::span<double>(elastic));
  multiply(body.C, std::span<const double>(state.velocity_m_s), std::span<double>(damping));
  for (std::size_t i = 0; i < load.size(); ++i) {
    if (body.slot[i] < 0) continue;
    const double force = load[i] + body.rest_force_N[i] + plastic_load_N[i] - elastic[i] - damping[i];
    state.acceleration_m_s2[i] = force / body.mass_kg[i / 3] + scenario.cell.gravity_m_s2[i % 3];
  }
}

}  // namespace unbruised

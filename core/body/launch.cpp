#include "core/body/launch.hpp"

#include <utility>

#include "core/body/steady_spin.hpp"
#include "core/scenario/attitude.hpp"
#include "core/scenario/product.hpp"
#include "core/scenario/true_shape.hpp"

namespace unbruised {
namespace {

/// Turns places, velocities and accelerations about the centre of mass at rest.
void turn(const Attitude& attitude, const BodyModel& body, BodyState& state) {
  for (std::size_t p = 0; p < body.particle_count; ++p) {
    std::array<double, 3> X{}, y{}, v{}, a{};
    for (std::size_t d = 0; d < 3; ++d) {
      X[d] = body.position_m[p][d] - body.center_of_mass_m[d];
      y[d] = X[d] + state.displacement_m[3 * p + d];
      v[d] = state.velocity_m_s[3 * p + d];
      a[d] = state.acceleration_m_s2[3 * p + d];
    }
    y = turned(attitude, y);
    v = turned(attitude, v);
    a = turned(attitude, a);
    for (std::size_t d = 0; d < 3; ++d) {
      state.displacement_m[3 * p + d] = y[d] - X[d];
      state.velocity_m_s[3 * p + d] = v[d];
      state.acceleration_m_s2[3 * p + d] = a[d];
    }
  }
}

void launch_solid(const LatticeParameters& product, const BodyModel& body, BodyState& state) {
  if (!starts_in_the_air(product)) return;
  const std::vector<double> zero(state.displacement_m.size(), 0.0);
  BodyState launched{state.displacement_m, zero, zero, product.initial_rotation_rad};
  const Attitude attitude = attitude_of(product.initial_rotation_rad), back = inverse(attitude);
  const bool is_turned = product.initial_rotation_rad != std::array<double, 3>{};
  add_steady_spin(body, turned(back, product.initial_spin_rad_s), launched);
  if (is_turned) turn(attitude, body, launched);
  const double below_center_m = TrueShape(product).reach_m(turned(back, {0.0, 0.0, -1.0}));
  const double lift_m = product.initial_height_m + below_center_m - body.center_m()[2];
  for (std::size_t i = 0; i < zero.size(); ++i) {
    launched.displacement_m[i] += i % 3 == 2 ? lift_m : 0.0;
    launched.velocity_m_s[i] += state.velocity_m_s[i];
  }
  state = std::move(launched);
}

void launch_solid(const NetworkParameters&, const BodyModel&, BodyState&) {}

}  // namespace

void launch(const ProductParameters& product, const BodyModel& body, BodyState& state) {
  std::visit([&](const auto& kind) { launch_solid(kind, body, state); }, product);
}

}  // namespace unbruised

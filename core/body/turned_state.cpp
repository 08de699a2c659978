#include "core/body/turned_state.hpp"

#include "core/scenario/attitude.hpp"

namespace unbruised {

void turn_state(const BodyModel& body, const std::array<double, 3>& rotation_rad, BodyState& state) {
  if (rotation_rad == std::array<double, 3>{}) return;
  const Attitude attitude = attitude_of(rotation_rad);
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
  state.rotation_rad = rotation_rad;
}

}  // namespace unbruised

#include "core/body/turned_state.hpp"

namespace unbruised {

Rotation::Rotation(const std::array<double, 3>& vector_rad)
    : vector_rad_(vector_rad), R_(Eigen::Matrix3d::Identity()) {
  const Eigen::Map<const Eigen::Vector3d> vector(vector_rad_.data());
  if (!vector.isZero(0.0)) R_ = Eigen::AngleAxisd(vector.norm(), vector.normalized()).toRotationMatrix();
}

std::array<double, 3> Rotation::times(const Eigen::Matrix3d& matrix, const std::array<double, 3>& vector) {
  const Eigen::Vector3d turned = matrix * Eigen::Map<const Eigen::Vector3d>(vector.data());
  return {turned[0], turned[1], turned[2]};
}

void turn_state(const BodyModel& body, const Rotation& turn, BodyState& state) {
  if (turn.vector_rad() == std::array<double, 3>{}) return;
  for (std::size_t p = 0; p < body.particle_count; ++p) {
    std::array<double, 3> X{}, y{}, v{}, a{};
    for (std::size_t d = 0; d < 3; ++d) {
      X[d] = body.position_m[p][d] - body.center_of_mass_m[d];
      y[d] = X[d] + state.displacement_m[3 * p + d];
      v[d] = state.velocity_m_s[3 * p + d];
      a[d] = state.acceleration_m_s2[3 * p + d];
    }
    y = turn.of(y);
    v = turn.of(v);
    a = turn.of(a);
    for (std::size_t d = 0; d < 3; ++d) {
      state.displacement_m[3 * p + d] = y[d] - X[d];
      state.velocity_m_s[3 * p + d] = v[d];
      state.acceleration_m_s2[3 * p + d] = a[d];
    }
  }
  state.rotation_rad = turn.vector_rad();
}

}  // namespace unbruised

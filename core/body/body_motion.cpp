#include "core/body/body_motion.hpp"

namespace unbruised {

OuterForces BodyMotion::outer_forces(std::span<const int> particles, std::span<const int> active,
                                     const LaneArray& force) const {
  OuterForces outer;
  const FrameLanes* turning = frame();
  if (turning == nullptr) return outer;
  for (const int index : active) {
    const auto i = static_cast<std::size_t>(index), p = static_cast<std::size_t>(particles[i]);
    outer.add(to_lanes(turning->rest_place_m(p)) + get_vector(u_theta_, p), get_vector(force, i));
  }
  return outer;
}

void BodyMotion::take_sums_of(const FrameLanes& frame, double total_mass_kg) {
  mass_a_ = frame.mass_acceleration_N().at;
  mass_u_ = (Lane(total_mass_kg) * frame.center_motion_m()).at;
}

void turn_to_world(const FrameLanes& frame, int lane, BodyState& state) {
  const auto of_particle = [](const std::vector<double>& rows, std::size_t p) {
    return to_lanes(std::array<double, 3>{rows[3 * p], rows[3 * p + 1], rows[3 * p + 2]});
  };
  for (std::size_t p = 0; 3 * p < state.displacement_m.size(); ++p) {
    const std::array<LaneVector, 3> along = {frame.displacement_m(p, of_particle(state.displacement_m, p)),
                                             frame.to_world(of_particle(state.velocity_m_s, p)),
                                             frame.to_world(of_particle(state.acceleration_m_s2, p))};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      state.displacement_m[3 * p + axis] = along[0][axis][lane];
      state.velocity_m_s[3 * p + axis] = along[1][axis][lane];
      state.acceleration_m_s2[3 * p + axis] = along[2][axis][lane];
    }
  }
}

}  // namespace unbruised

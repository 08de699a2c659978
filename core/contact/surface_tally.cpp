#include "core/contact/surface_tally.hpp"

namespace unbruised {

void SurfaceTally::clear_lane(int lane) {
  for (Lane* value : {&normal, &closed, &sliding, &travel}) value->set(lane, 0.0);
  for (Lane& value : tangent) value.set(lane, 0.0);
  for (Lane& value : first) value.set(lane, 0.0);
  for (Lane& value : second) value.set(lane, 0.0);
  for (Lane& value : torque) value.set(lane, 0.0);
}

std::array<Lane, 3> SurfaceTally::force(int surface) const {
  return along_axes(surface, normal, tangent[0], tangent[1]);
}

void SurfaceTally::add_moments(const ContactCandidate& candidate, const Lane& normal_force,
                               const Lane& penetration) {
  const Lane y(candidate.place_m[0]), z(candidate.place_m[1]);
  Lane m1[2] = {y, z};
  Lane m2[3] = {y * y, z * z, y * z};
  if (!candidate.flat) {
    // The force sits where the places touch, in proportion to their depth.
    Lane sum(0.0), firsts[2] = {0.0, 0.0}, seconds[3] = {0.0, 0.0, 0.0};
    for (int q = 0; q < kReliefPlaces; ++q) {
      const Lane depth = max0(penetration - Lane(candidate.relief_m[static_cast<std::size_t>(q)]));
      const auto offset = relief_offset(q);
      const Lane yq(candidate.place_m[0] + offset[0] * candidate.extent_m[0]);
      const Lane zq(candidate.place_m[1] + offset[1] * candidate.extent_m[1]);
      sum += depth;
      firsts[0] += depth * yq;
      firsts[1] += depth * zq;
      seconds[0] += depth * yq * yq;
      seconds[1] += depth * zq * zq;
      seconds[2] += depth * yq * zq;
    }
    const Mask spread = sum > Lane(1e-12);
    const Lane inverse = Lane(1.0) / max(sum, Lane(1e-12));
    for (int i = 0; i < 2; ++i) m1[i] = select(spread, firsts[i] * inverse, m1[i]);
    for (int i = 0; i < 3; ++i) m2[i] = select(spread, seconds[i] * inverse, m2[i]);
  }
  for (std::size_t i = 0; i < 2; ++i) first[i] += normal_force * m1[i];
  for (std::size_t i = 0; i < 3; ++i) second[i] += normal_force * m2[i];
}

void SurfaceTally::add_torque(const std::array<Lane, 3>& arm, const std::array<Lane, 3>& force_at,
                              const Mask& running) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    torque[i] += select(running, arm[j] * force_at[k] - arm[k] * force_at[j], Lane(0.0));
  }
}

}  // namespace unbruised

#include "core/contact/surface_tally.hpp"

namespace unbruised {
namespace {

/// Of the force over the places of a curved contact.
struct PlaceMoments {
  std::array<Lane, 2> mean, square;
  Lane product;
};

/// The force sits where the places touch, in proportion to their depth; nowhere deep, at the particle.
PlaceMoments place_moments(const ContactCandidate& candidate, const PressedPiece& piece) {
  const Lane y(candidate.tributary[0].place_m), z(candidate.tributary[1].place_m);
  PlaceMoments m{{y, z}, {y * y, z * z}, y * z};
  if (candidate.flat) return m;
  Lane sum(0.0), product(0.0);
  std::array<Lane, 2> first{Lane(0.0), Lane(0.0)}, second{Lane(0.0), Lane(0.0)};
  for (int q = 0; q < kReliefPlaces; ++q) {
    Lane depth = max0(piece.penetration - piece.cover.relief(candidate.relief_m, q));
    if (!piece.cover.is_full()) depth *= piece.cover.weight(q);
    const auto offset = place_offset_m(candidate, q);
    const std::array<Lane, 2> place = {y + Lane(offset[0]), z + Lane(offset[1])};
    sum += depth;
    product += depth * place[0] * place[1];
    for (std::size_t t = 0; t < 2; ++t) {
      first[t] += depth * place[t];
      second[t] += depth * place[t] * place[t];
    }
  }
  const Mask spread = sum > Lane(1e-12);
  const Lane inverse = Lane(1.0) / max(sum, Lane(1e-12));
  for (std::size_t t = 0; t < 2; ++t) {
    m.mean[t] = select(spread, first[t] * inverse, m.mean[t]);
    m.square[t] = select(spread, second[t] * inverse, m.square[t]);
  }
  m.product = select(spread, product * inverse, m.product);
  return m;
}

}  // namespace

void SurfaceTally::clear_lane(int lane) {
  for (Lane* value : {&normal, &closed, &sliding, &deepest_Pa}) value->set(lane, 0.0);
  for (Lane& value : tangent) value.set(lane, 0.0);
  for (Lane& value : first) value.set(lane, 0.0);
  for (Lane& value : second) value.set(lane, 0.0);
  for (Lane& value : torque) value.set(lane, 0.0);
}

std::array<Lane, 3> SurfaceTally::force(int surface) const {
  return along_axes(surface, normal, tangent[0], tangent[1]);
}

void SurfaceTally::add_moments(const ContactCandidate& candidate, const Lane& normal_force,
                               const PressedPiece& piece) {
  const PlaceMoments places = place_moments(candidate, piece);
  std::array<Lane, 2> mean, square;
  for (std::size_t t = 0; t < 2; ++t) {
    const Tributary& along = candidate.tributary[t];
    const Lane place(along.place_m), offset = piece.mean_m[t];
    const bool by_places = along.has_places();
    mean[t] = by_places ? places.mean[t] : place + offset;
    square[t] = by_places ? places.square[t] : place * (place + Lane(2.0) * offset) + piece.mean_square_m2[t];
  }
  const bool joint = candidate.tributary[0].has_places() && candidate.tributary[1].has_places();
  const Lane product = joint ? places.product : mean[0] * mean[1];
  for (std::size_t t = 0; t < 2; ++t) {
    first[t] += normal_force * mean[t];
    second[t] += normal_force * square[t];
  }
  second[2] += normal_force * product;
}

void SurfaceTally::add_place(const Lane& normal_force, const std::array<Lane, 2>& at, double extent_m) {
  for (std::size_t t = 0; t < 2; ++t) {
    first[t] += normal_force * at[t];
    second[t] += normal_force * (at[t] * at[t] + Lane(extent_m * extent_m / 12.0));
  }
  second[2] += normal_force * at[0] * at[1];
}

void SurfaceTally::add_torque(const std::array<Lane, 3>& arm, const std::array<Lane, 3>& force_at,
                              const Mask& running) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    torque[i] += select(running, arm[j] * force_at[k] - arm[k] * force_at[j], Lane(0.0));
  }
}

}  // namespace unbruised

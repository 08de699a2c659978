#include "core/contact/tributary.hpp"

namespace unbruised {
namespace {

/// Of a cell: rounding leaves 1e-16.
constexpr double kLeastWeight = 1e-9;

/// Integrals of weight x s^power over a window, s in cells from the particle.
struct Moments {
  std::array<Lane, 3> of{Lane(0.0), Lane(0.0), Lane(0.0)};
};

Lane clipped(const Lane& value, const Lane& low, const Lane& high) { return min(max(value, low), high); }

/// Of the hat function from its lower end to s.
Moments below(const std::array<int, 2>& cells, const Lane& s) {
  const Lane lower(cells[0] > 0 ? 1.0 : 0.0), upper(cells[1] > 0 ? 1.0 : 0.0);
  const Lane at = clipped(s, Lane(-1.0), Lane(1.0));
  const Lane a = min(at, Lane(0.0)), b = max0(at);  // weight 1 + a over [-1, 0], 1 - b over [0, 1]
  const Lane a2 = a * a, b2 = b * b;
  return {{lower * (Lane(0.5) + a + Lane(0.5) * a2) + upper * (b - Lane(0.5) * b2),
           lower * (a2 * (Lane(0.5) + a * Lane(1.0 / 3.0)) - Lane(1.0 / 6.0)) +
               upper * b2 * (Lane(0.5) - b * Lane(1.0 / 3.0)),
           lower * (a * a2 * (Lane(1.0 / 3.0) + Lane(0.25) * a) + Lane(1.0 / 12.0)) +
               upper * b * b2 * (Lane(1.0 / 3.0) - Lane(0.25) * b)}};
}

Moments flat_moments(const std::array<int, 2>& cells, const Stretch& window) {
  const Moments low = below(cells, window.low), high = below(cells, window.high);
  Moments sum;
  for (std::size_t i = 0; i < sum.of.size(); ++i) sum.of[i] = high.of[i] - low.of[i];
  return sum;
}

/// Of a particle that lies `inside` cells within the edge, or beyond it. Calibrated with the stiffness of a block
/// of 5 to 12 cells between pads of 1.2 to 4 cells half across, hard and soft, at any place of the edge between
/// two particles: finite elements are met within 3.5 % (docs/validation.md, "Pads smaller than the face"). A
/// particle a cell beyond carries nothing.
Lane edge_softness(const Lane& inside) {
  constexpr double kLinear = 1.7, kSquare = 1.75, kReach = 0.355, kNone = 1e-3;
  const Lane u = max(Lane(1.0) + min(inside, Lane(0.0)), Lane(kNone));
  const Lane beyond = Lane(1.0) / (u * (Lane(kLinear) + Lane(kSquare) * u));
  const Lane within = Lane(1.0 / (kLinear + kSquare)) * max0(Lane(1.0) - inside * Lane(1.0 / kReach));
  return select(inside > Lane(0.0), within, beyond);
}

/// Beside both edges of what is covered. An edge less than a cell from the rim of the face counts in proportion:
/// beyond the rim there is no body to sag.
/// @param covered in cells from the particle
Lane softness_beside(const std::array<int, 2>& cells, const Stretch& covered) {
  const std::array<Lane, 2> inside = {-covered.low, covered.high};
  Lane sum(0.0);
  for (std::size_t side = 0; side < 2; ++side) {
    const Lane face_beyond = clipped(Lane(cells[side]) - inside[side], Lane(0.0), Lane(1.0));
    sum += face_beyond * edge_softness(inside[side]);
  }
  return sum;
}

Stretch in_cells(const Tributary& piece, const Stretch& stretch, const Lane& moved) {
  const Lane place = Lane(piece.place_m) + moved, inverse(1.0 / piece.extent_m);
  return {(stretch.low - place) * inverse, (stretch.high - place) * inverse};
}

CoveredPiece curved_piece(const Stretch& s) {
  CoveredPiece piece;
  const Lane places(kReliefSide);
  const Lane low = (s.low + Lane(0.5)) * places, high = (s.high + Lane(0.5)) * places;
  Lane sum(0.0);
  for (int k = 0; k < kReliefSide; ++k) {
    const Lane to = clipped(high - Lane(k), Lane(0.0), Lane(1.0)),
               from = clipped(low - Lane(k), Lane(0.0), Lane(1.0));
    sum += piece.place[static_cast<std::size_t>(k)] = max0(to - from);
  }
  piece.share = sum * Lane(1.0 / kReliefSide);
  return piece;
}

/// What of the hat function lies over each place, mean 1.
void weigh_places(const std::array<int, 2>& cells, const Stretch& s, const Lane& whole, CoveredPiece& piece) {
  const Lane inverse = Lane(kReliefSide) / max(whole, Lane(kLeastWeight));
  for (int k = 0; k < kReliefSide; ++k) {
    const Lane from(2.0 * k / kReliefSide - 1.0), to(2.0 * (k + 1) / kReliefSide - 1.0);
    const Stretch place{clipped(s.low, from, to), clipped(s.high, from, to)};
    piece.place[static_cast<std::size_t>(k)] = flat_moments(cells, place).of[0] * inverse;
  }
}

}  // namespace

Lane Tributary::weight_m(const Stretch& window, const Lane& moved) const {
  const Stretch w = in_cells(*this, window, moved);
  const Lane half(0.5);
  if (curved) return max0(clipped(w.high, -half, half) - clipped(w.low, -half, half)) * Lane(extent_m);
  return flat_moments(cells, w).of[0] * Lane(extent_m);
}

CoveredPiece Tributary::covered_by(const Stretch& covered, const Lane& moved) const {
  const Stretch s = in_cells(*this, covered, moved);
  if (curved) return curved_piece(s);
  const Moments m = flat_moments(cells, s);
  CoveredPiece piece;
  piece.place.fill(Lane(1.0));
  // Next to nothing is nothing: it has no middle.
  const Mask some = m.of[0] > Lane(kLeastWeight);
  const Lane weight = select(some, m.of[0], Lane(0.0));
  const Lane inverse = select(some, Lane(extent_m) / max(weight, Lane(kLeastWeight)), Lane(0.0));
  piece.share = weight * Lane(extent_m / full_weight_m(*this));
  piece.mean_m = m.of[1] * inverse;
  piece.mean_square_m2 = m.of[2] * inverse * Lane(extent_m);
  piece.softness = select(some, softness_beside(cells, s), Lane(0.0));
  if (sampled) weigh_places(cells, s, m.of[0], piece);
  return piece;
}

}  // namespace unbruised

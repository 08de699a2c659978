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

/// What a particle carries besides its hat function in the cell that the surface's upper edge lies in. With the
/// cell's lower particle A, its upper B, the one below A' and s from A: A takes 1 - s + 2 m s, B takes s (1 - m),
/// A' takes -m s.
struct EdgeRole {
  double lower_particle;     ///< A, in cells from this particle
  double share;              ///< of m s
  std::array<int, 2> cells;  ///< that the face must have below and above this particle
};
constexpr std::array<EdgeRole, 3> kEdgeRoles = {{{0.0, 2.0, {1, 1}}, {-1.0, -1.0, {2, 0}}, {1.0, -1.0, {0, 2}}}};

/// @param window, covered in cells from the particle
void add_upper_edge(const std::array<int, 2>& cells, const Stretch& window, const Stretch& covered, double mirror,
                    Moments& sum) {
  for (const EdgeRole& role : kEdgeRoles) {
    if (cells[0] < role.cells[0] || cells[1] < role.cells[1]) continue;
    const Lane r(role.lower_particle), t = covered.high - r;
    // A and A' have to lie under the surface.
    const Mask cut = (t > Lane(0.0)) & (t < Lane(1.0)) & (r - covered.low >= Lane(1.0));
    if (none(cut)) continue;
    const Lane part = min(Lane(1.0), Lane(2.0) * (Lane(1.0) - t));
    const Lane share = select(cut, Lane(role.share) * part, Lane(0.0));
    const Lane from = clipped(window.low - r, Lane(0.0), t), to = clipped(window.high - r, Lane(0.0), t);
    const Lane from2 = from * from, to2 = to * to;
    const Lane s1 = Lane(0.5) * (to2 - from2), s2 = Lane(1.0 / 3.0) * (to2 * to - from2 * from),
               s3 = Lane(0.25) * (to2 * to2 - from2 * from2);
    sum.of[0] += share * s1;
    sum.of[1] += Lane(mirror) * share * (s2 + r * s1);
    sum.of[2] += share * (s3 + Lane(2.0) * r * s2 + r * r * s1);
  }
}

Stretch mirrored(const Stretch& s) { return {-s.high, -s.low}; }

Moments flat_moments(const std::array<int, 2>& cells, const Stretch& window, const Stretch& covered) {
  const Moments low = below(cells, window.low), high = below(cells, window.high);
  Moments sum;
  for (std::size_t i = 0; i < sum.of.size(); ++i) sum.of[i] = high.of[i] - low.of[i];
  add_upper_edge(cells, window, covered, 1.0, sum);
  add_upper_edge({cells[1], cells[0]}, mirrored(window), mirrored(covered), -1.0, sum);
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

}  // namespace

Lane Tributary::weight_m(const Stretch& window, const Stretch& covered, const Lane& moved) const {
  const Stretch w = in_cells(*this, window, moved);
  const Lane half(0.5);
  if (curved) return max0(clipped(w.high, -half, half) - clipped(w.low, -half, half)) * Lane(extent_m);
  return flat_moments(cells, w, in_cells(*this, covered, moved)).of[0] * Lane(extent_m);
}

CoveredPiece Tributary::covered_by(const Stretch& covered, const Lane& moved) const {
  const Stretch s = in_cells(*this, covered, moved);
  if (curved) return curved_piece(s);
  const Moments m = flat_moments(cells, s, s);
  CoveredPiece piece;
  piece.place.fill(Lane(1.0));
  // Next to nothing is nothing: it has no middle.
  const Mask some = m.of[0] > Lane(kLeastWeight);
  const Lane weight = select(some, m.of[0], Lane(0.0));
  const Lane inverse = select(some, Lane(extent_m) / max(weight, Lane(kLeastWeight)), Lane(0.0));
  piece.share = weight * Lane(extent_m / full_weight_m(*this));
  piece.mean_m = m.of[1] * inverse;
  piece.mean_square_m2 = m.of[2] * inverse * Lane(extent_m);
  return piece;
}

}  // namespace unbruised

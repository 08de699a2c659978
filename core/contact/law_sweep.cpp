#include "core/contact/contact_sweep.hpp"
#include "core/contact/layer_law.hpp"

namespace unbruised {

namespace {

/// Of the depth to which a candidate is sought, and at most so many looks: a law may be a hundred times as steep
/// beyond a kink as before it.
constexpr double kNearEnough = 1e-12;
constexpr int kMostLooks = 80;

}  // namespace

/// The root of p + compliance N(p) = unloaded, by Newton between places that are known to be too shallow and too
/// deep, and by their middle where that leads out of them.
Lane ContactSweep::force_by_law(std::size_t c, const Lane& unloaded, const Lane& compliance,
                                const Mask& lanes) const {
  const ContactCandidate& candidate = model_.candidate[c];
  const SurfaceLane& surface = surfaces_[candidate.surface];
  const Lane& rate_slope = rate_slope_[candidate.surface];
  const Lane layer = layer_.get(c), viscous = viscous_.get(c);
  const PlaceCover cover = contacts_.cover(c);
  const auto law_at = [&](const Lane& p) {
    return curved_layer_law(candidate, p, rate_slope * p - viscous, rate_slope, cover, surface.curve);
  };
  const Lane least = contacts_.least_relief(c);
  Lane shallow = min(least, unloaded), deep = unloaded;
  Lane p = max(shallow, min(deep, contacts_.penetration_theta.get(c)));
  const Lane enough = Lane(kNearEnough) * max(deep - shallow, Lane(1e-9));
  Mask open = lanes & (unloaded > least);
  for (int look = 0; look < kMostLooks && any(open); ++look) {
    const LayerLaw law = law_at(p);
    const Lane excess = p + compliance * layer * law.force - unloaded;
    deep = select(excess > Lane(0.0), p, deep);
    shallow = select(excess > Lane(0.0), shallow, p);
    const Lane newton = p - excess / (Lane(1.0) + compliance * layer * max0(law.slope));
    const Mask inside = (newton > shallow) & (newton < deep);
    const Lane next = select(inside, newton, Lane(0.5) * (shallow + deep));
    open = open & (abs(next - p) > enough);
    p = select(open, next, p);
  }
  return layer * law_at(p).force;
}

}  // namespace unbruised

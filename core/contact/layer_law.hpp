#pragma once

/// @file
/// The law of a compliant layer between a particle and a surface, over the places of the particle's tributary
/// rectangle: in lanes for the contact solve, and as a secant for the static state.

#include "core/contact/contact_model.hpp"
#include "core/contact/place_cover.hpp"
#include "core/lanes/lane.hpp"
#include "core/surface/layer_curve.hpp"

namespace unbruised {

/// A layer over its tributary places, per unit of stiffness: force and its slope over the penetration p.
/// With depths d_q = p - relief_q and rate = tau p', force = (1/Q) sum_q [d_q > 0] (d_q + clamp(rate, -d_q, d_q)):
/// the viscous part is never larger than the elastic one, so that the force is continuous where a place touches
/// and never pulls. @param rate_slope d rate / d p
/// A layer with a law of its own has e(d) / d times that.
struct LayerLaw {
  Lane force{0.0}, slope{0.0};

  [[gnu::always_inline]] void add_place(const Lane& depth, const Lane& rate, const Lane& rate_slope) {
    const Lane d = max0(depth);
    const Lane viscous = max(-d, min(d, rate));
    const Lane viscous_slope = select(rate >= d, Lane(1.0), select(rate <= -d, Lane(-1.0), rate_slope));
    force += d + viscous;
    slope += select(depth > Lane(0.0), Lane(1.0) + viscous_slope, Lane(0.0));
  }
  void add_place(const Lane& depth, const Lane& rate, const Lane& rate_slope, const LayerCurve& curve) {
    // e(d) / d of a straight layer's: continuous where the law has a kink.
    const Lane d = max(depth, Lane(1e-300)), secant = curve.at(d) / d;
    LayerLaw straight;
    straight.add_place(depth, rate, rate_slope);
    force += secant * straight.force;
    slope += (curve.slope(d) - secant) / d * straight.force + secant * straight.slope;
  }
};

/// The same where the surface's layer has a law of its own.
inline LayerLaw curved_layer_law(const ContactCandidate& candidate, const Lane& p, const Lane& rate,
                                 const Lane& rate_slope, const PlaceCover& cover, const LayerCurve& curve) {
  LayerLaw law;
  if (candidate.flat) {
    law.add_place(p, rate, rate_slope, curve);
    return law;
  }
  for (int q = 0; q < kReliefPlaces; ++q) {
    LayerLaw place;
    place.add_place(p - cover.relief(candidate.relief_m, q), rate, rate_slope, curve);
    const Lane weight = cover.is_full() ? Lane(1.0) : cover.weight(q);
    law.force += weight * place.force;
    law.slope += weight * place.slope;
  }
  law.force *= Lane(1.0 / kReliefPlaces);
  law.slope *= Lane(1.0 / kReliefPlaces);
  return law;
}

/// @param cover of the candidate's places
inline LayerLaw layer_law(const ContactCandidate& candidate, const Lane& p, const Lane& rate,
                          const Lane& rate_slope, const PlaceCover& cover) {
  LayerLaw law;
  if (candidate.flat) {
    law.add_place(p, rate, rate_slope);
    return law;
  }
  if (cover.is_full()) {
    for (const double relief : candidate.relief_m) law.add_place(p - Lane(relief), rate, rate_slope);
  } else {
    for (int q = 0; q < kReliefPlaces; ++q) {
      LayerLaw place;
      place.add_place(p - cover.relief(candidate.relief_m, q), rate, rate_slope);
      law.force += cover.weight(q) * place.force;
      law.slope += cover.weight(q) * place.slope;
    }
  }
  law.force *= Lane(1.0 / kReliefPlaces);
  law.slope *= Lane(1.0 / kReliefPlaces);
  return law;
}

/// Mean square of the depths of the tributary places: twice what they store per stiffness.
inline Lane squared_depth(const ContactCandidate& candidate, const Lane& p, const PlaceCover& cover,
                          const LayerCurve& curve) {
  const auto square = [&curve](const Lane& d) { return curve.any() ? curve.twice_energy(d) : d * d; };
  if (candidate.flat) return square(max0(p));
  Lane squares(0.0);
  for (int q = 0; q < kReliefPlaces; ++q) {
    const Lane depth = max0(p - cover.relief(candidate.relief_m, q));
    squares += square(depth) * (cover.is_full() ? Lane(1.0) : cover.weight(q));
  }
  return squares * Lane(1.0 / kReliefPlaces);
}

/// Layer of one candidate at penetration p: stiffness of the touching places and their mean relief, so that
/// N = stiffness (p - relief).
struct LayerSecant {
  double stiffness = 0;
  double relief = 0;
  int touching = 0;
};

inline LayerSecant layer_at(const ContactCandidate& candidate, double layer_stiffness_N_m3, double penetration_m) {
  LayerSecant secant;
  double sum = 0.0;
  for (double relief : candidate.relief_m) {
    if (penetration_m <= relief) continue;
    ++secant.touching;
    sum += relief;
  }
  if (secant.touching == 0) return secant;
  secant.stiffness = normal_stiffness_N_m(candidate, layer_stiffness_N_m3) * secant.touching / kReliefPlaces;
  secant.relief = sum / secant.touching;
  return secant;
}

}  // namespace unbruised

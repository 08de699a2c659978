#include "core/scenario/pad_law.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/scenario/words.hpp"

namespace unbruised {

double PadLaw::force_N(double depth_m) const {
  double force = 0.0;
  for (std::size_t i = kMostLawTerms; i-- > 0;) force = (force + term_N[i]) * depth_m;
  for (std::size_t j = 0; j < knot_m.size(); ++j) force += slope_N_m[j] * std::max(0.0, depth_m - knot_m[j]);
  return force;
}

double PadLaw::slope_at_N_m(double depth_m) const {
  double slope = 0.0;
  for (std::size_t i = kMostLawTerms; i-- > 0;) slope = slope * depth_m + static_cast<double>(i + 1) * term_N[i];
  for (std::size_t j = 0; j < knot_m.size(); ++j) slope += depth_m > knot_m[j] ? slope_N_m[j] : 0.0;
  return slope;
}

double PadLaw::depth_m(double wanted_N) const {
  double low = 0.0, high = 1e-6;
  while (force_N(high) < wanted_N && high < 1.0) high *= 2.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (force_N(middle) < wanted_N ? low : high) = middle;
  }
  return high;
}

std::optional<PadLaw> pad_law(const PadParameters& pad) {
  PadLaw law;
  if (!pad.law_coefficients.empty()) {
    std::copy_n(pad.law_coefficients.begin(), std::min(kMostLawTerms, pad.law_coefficients.size()),
                law.term_N.begin());
    return law;
  }
  if (pad.law_depth_m.size() < 2) return std::nullopt;
  double before = 0.0;
  for (std::size_t i = 1; i < pad.law_depth_m.size(); ++i) {
    const double slope =
        (pad.law_force_N[i] - pad.law_force_N[i - 1]) / (pad.law_depth_m[i] - pad.law_depth_m[i - 1]);
    if (i == 1) law.term_N[0] = slope;
    if (i > 1) {
      law.knot_m.push_back(pad.law_depth_m[i - 1]);
      law.slope_N_m.push_back(slope - before);
    }
    before = slope;
  }
  return law;
}

double reference_depth_m(const ParallelJawParameters& jaw) { return 0.1 * jaw.pad_thickness_m; }

namespace {

std::optional<LawFlaw> flaw_of_points(const PadParameters& pad) {
  if (pad.law_depth_m.size() > kMostLawPoints) {
    return LawFlaw{"gripper.pad.law_depth_m", "must be " + std::to_string(kMostLawPoints) + " depths at most"};
  }
  if (pad.law_depth_m.front() != 0.0 || pad.law_force_N.front() != 0.0) {
    return LawFlaw{"gripper.pad.law_depth_m", "must begin with no force at no depth, (0, 0)"};
  }
  const auto rises = [](const std::vector<double>& list) {
    return std::adjacent_find(list.begin(), list.end(), std::greater_equal<>()) == list.end();
  };
  if (!rises(pad.law_depth_m)) return LawFlaw{"gripper.pad.law_depth_m", "must rise from point to point"};
  if (!rises(pad.law_force_N)) {
    return LawFlaw{"gripper.pad.law_force_N", "must rise from point to point: a tip resists more, the deeper"};
  }
  return std::nullopt;
}

}  // namespace

std::optional<LawFlaw> law_flaw(const ParallelJawParameters& jaw) {
  const PadParameters& pad = jaw.pad;
  if (pad.law_coefficients.empty()) return flaw_of_points(pad);
  if (pad.law_coefficients.size() > kMostLawTerms) {
    return LawFlaw{"gripper.pad.law_coefficients",
                   "must be " + std::to_string(kMostLawTerms) + " coefficients at most"};
  }
  const PadLaw law = *pad_law(pad);
  constexpr int kPlaces = 200;
  for (int i = 1; i <= kPlaces; ++i) {
    const double depth_m = jaw.pad_thickness_m * i / kPlaces;
    if (law.slope_at_N_m(depth_m) > 0.0) continue;
    return LawFlaw{"gripper.pad.law_coefficients",
                   "must make a force that rises over gripper.pad_thickness_m: it falls at a depth of " +
                       for_people(depth_m) + " m"};
  }
  return std::nullopt;
}

}  // namespace unbruised

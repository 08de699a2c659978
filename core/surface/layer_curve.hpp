#pragma once

/// @file
/// A layer whose pressure is not proportional to its depth, per lane: by a measured law
/// (core/scenario/pad_law.hpp).

#include <array>
#include <vector>

#include "core/lanes/lane.hpp"
#include "core/scenario/pad_law.hpp"

namespace unbruised {

/// Pressure = stiffness per area x e(d); e(d) = d where a lane has no law.
class LayerCurve {
 public:
  /// Has any lane a law?
  [[nodiscard]] bool any() const { return lanes_ > 0; }
  /// Which ones?
  [[nodiscard]] const Mask& lanes() const { return has_; }
  /// Forgets the law of a lane.
  void clear(int lane) {
    if (has_[lane]) --lanes_;
    has_.set(lane, false);
    for (std::size_t i = 0; i < kMostLawTerms; ++i) term_[i].set(lane, i == 0 ? 1.0 : 0.0);
    for (Knot& knot : knot_) knot.slope.set(lane, 0.0);
  }
  /// @param force_per_depth_N_m of the pad at e(d) = d
  void set(int lane, const PadLaw& law, double force_per_depth_N_m) {
    clear(lane);
    ++lanes_;
    has_.set(lane, true);
    for (std::size_t i = 0; i < kMostLawTerms; ++i) term_[i].set(lane, law.term_N[i] / force_per_depth_N_m);
    if (knot_.size() < law.knot_m.size()) knot_.resize(law.knot_m.size());
    for (std::size_t j = 0; j < law.knot_m.size(); ++j) {
      knot_[j].depth.set(lane, law.knot_m[j]);
      knot_[j].slope.set(lane, law.slope_N_m[j] / force_per_depth_N_m);
    }
  }

  /// e(d). @param d >= 0
  [[nodiscard]] Lane at(const Lane& d) const {
    Lane e(0.0);
    for (std::size_t i = kMostLawTerms; i-- > 0;) e = (e + term_[i]) * d;
    for (const Knot& knot : knot_) e += knot.slope * max0(d - knot.depth);
    return e;
  }
  /// e'(d).
  [[nodiscard]] Lane slope(const Lane& d) const {
    Lane slope(0.0);
    for (std::size_t i = kMostLawTerms; i-- > 0;) slope = slope * d + Lane(static_cast<double>(i + 1)) * term_[i];
    for (const Knot& knot : knot_) slope += select(d > knot.depth, knot.slope, Lane(0.0));
    return slope;
  }
  /// 2 x the integral of e from 0 to d: of e(d) = d the square of d.
  [[nodiscard]] Lane twice_energy(const Lane& d) const {
    Lane sum(0.0);
    for (std::size_t i = kMostLawTerms; i-- > 0;)
      sum = sum * d + Lane(2.0 / static_cast<double>(i + 2)) * term_[i];
    sum *= d * d;
    for (const Knot& knot : knot_) {
      const Lane past = max0(d - knot.depth);
      sum += knot.slope * past * past;
    }
    return sum;
  }

 private:
  struct Knot {
    Lane depth{0.0}, slope{0.0};
  };
  std::array<Lane, kMostLawTerms> term_{Lane(1.0), Lane(0.0), Lane(0.0), Lane(0.0)};
  std::vector<Knot> knot_;
  Mask has_{false};
  int lanes_ = 0;
};

}  // namespace unbruised

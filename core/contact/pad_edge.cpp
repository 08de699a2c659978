#include "core/contact/pad_edge.hpp"

#include <algorithm>
#include <cmath>

namespace unbruised {
namespace {

constexpr double kLeastLambda = 0.3162277660168379;
constexpr double kStepsPerDecade = 2.0;

}  // namespace

// Both tables are of the half-space under a square pad, by tests/reference/press_pad.py.

PadEdge PadEdge::of_flat(double poisson_ratio) {
  // At a Poisson ratio of 0.35; at 0.25 it is 1.10, at 0.45 0.92 of that.
  constexpr std::array<double, kSteps> kTable = {0.684, 0.821, 1.064, 1.367, 1.642, 1.777};
  constexpr double kSlope = -0.91, kTableRatio = 0.35;
  PadEdge edge;
  const double factor = 1.0 + kSlope * (poisson_ratio - kTableRatio);
  for (std::size_t i = 0; i < kSteps; ++i) edge.peak_[i] = factor * kTable[i];
  return edge;
}

PadEdge PadEdge::of_strip() {
  PadEdge edge;
  edge.peak_ = {1.289, 1.341, 1.488, 1.690, 1.855, 1.928};
  return edge;
}

double PadEdge::at(double lambda) const {
  const double place = kStepsPerDecade * std::log10(std::max(lambda, kLeastLambda) / kLeastLambda);
  const double clamped = std::min(place, static_cast<double>(kSteps - 1));
  const auto low = std::min(static_cast<std::size_t>(clamped), kSteps - 2);
  return peak_[low] + (clamped - static_cast<double>(low)) * (peak_[low + 1] - peak_[low]);
}

}  // namespace unbruised

#include "core/scenario/true_shape.hpp"

#include <cmath>

namespace unbruised {

TrueShape::TrueShape(const LatticeParameters& parameters) : size_m_(parameters.size_m) {
  round_.fill(parameters.shape != Shape::box);
  if (parameters.shape == Shape::cylinder) round_[static_cast<std::size_t>(parameters.axis)] = false;
}

int TrueShape::curvatures(std::size_t axis) const {
  if (!round_[axis]) return 0;
  int count = 0;
  for (std::size_t d = 0; d < 3; ++d) count += d != axis && round_[d] ? 1 : 0;
  return count;
}

double TrueShape::half_chord_m(std::size_t axis, const std::array<double, 3>& place_m) const {
  double rest = 1.0;
  for (std::size_t d = 0; d < 3; ++d) {
    if (d != axis && round_[d]) rest -= 4.0 * place_m[d] * place_m[d] / (size_m_[d] * size_m_[d]);
  }
  if (rest < 0.0) return -1.0;
  return 0.5 * size_m_[axis] * (round_[axis] ? std::sqrt(rest) : 1.0);
}

}  // namespace unbruised

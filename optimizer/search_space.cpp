#include "optimizer/search_space.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace unbruised::optimizer {

SearchSpace::SearchSpace(std::vector<Variable> variables) : variables_(std::move(variables)) {
  for (const Variable& variable : variables_) {
    if (!(variable.lower < variable.upper) || !std::isfinite(variable.upper - variable.lower)) {
      throw std::invalid_argument(variable.name + ": lower must be < upper, and the range finite");
    }
    if (variable.scale == Scale::log &&
        (variable.lower <= 0.0 || !std::isfinite(variable.upper / variable.lower))) {
      throw std::invalid_argument(variable.name + ": a log scale needs lower > 0, and a finite ratio");
    }
  }
}

std::vector<double> SearchSpace::from_unit(std::span<const double> unit) const {
  std::vector<double> point(size());
  for (std::size_t k = 0; k < size(); ++k) {
    const Variable& v = variables_[k];
    const double t = std::clamp(unit[k], 0.0, 1.0);
    if (t == 0.0 || t == 1.0) {
      point[k] = t == 0.0 ? v.lower : v.upper;
      continue;
    }
    const double inside =
        v.scale == Scale::log ? v.lower * std::pow(v.upper / v.lower, t) : v.lower + t * (v.upper - v.lower);
    point[k] = std::clamp(inside, v.lower, v.upper);
  }
  return point;
}

std::vector<double> SearchSpace::to_unit(std::span<const double> point) const {
  std::vector<double> unit(size());
  for (std::size_t k = 0; k < size(); ++k) {
    const Variable& v = variables_[k];
    const double inside = std::clamp(point[k], v.lower, v.upper);
    const double t = v.scale == Scale::log ? std::log(inside / v.lower) / std::log(v.upper / v.lower)
                                           : (inside - v.lower) / (v.upper - v.lower);
    unit[k] = std::clamp(t, 0.0, 1.0);
  }
  return unit;
}

}  // namespace unbruised::optimizer

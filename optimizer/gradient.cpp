#include "optimizer/gradient.hpp"

#include <cmath>
#include <cstddef>

namespace unbruised::optimizer {
namespace {

/// First and second step along one variable, as signed multiples of the step that stay inside [0, 1].
struct Steps {
  double first;
  double second;
};

Steps steps_at(double x, double step) {
  if (x + step > 1.0) return {-step, -2.0 * step};
  if (x - step < 0.0) return {step, 2.0 * step};
  return {step, -step};
}

std::vector<double> moved(std::span<const double> unit, std::size_t k, double by) {
  std::vector<double> point(unit.begin(), unit.end());
  point[k] += by;
  return point;
}

}  // namespace

std::vector<std::vector<double>> difference_points(std::span<const double> unit, double step,
                                                   Differences differences) {
  const bool central = differences == Differences::central;
  std::vector<std::vector<double>> points = {{unit.begin(), unit.end()}};
  for (std::size_t k = 0; k < unit.size(); ++k) {
    const Steps steps = steps_at(unit[k], step);
    points.push_back(moved(unit, k, steps.first));
    if (central) points.push_back(moved(unit, k, steps.second));
  }
  return points;
}

std::vector<std::vector<double>> difference_quotients(const std::vector<std::vector<double>>& points,
                                                      const std::vector<std::vector<double>>& values,
                                                      Differences differences) {
  const bool central = differences == Differences::central;
  const std::size_t n = points[0].size();
  const std::size_t m = values[0].size();
  std::vector<std::vector<double>> gradient(m, std::vector<double>(n));
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t p = central ? 1 + 2 * k : 1 + k;
    // The step that was really made, after rounding.
    const double h1 = points[p][k] - points[0][k];
    for (std::size_t i = 0; i < m; ++i) {
      const double d1 = values[p][i] - values[0][i];
      if (!central) {
        gradient[i][k] = d1 / h1;
        continue;
      }
      // Slope at 0 of the parabola through 0, h1 and h2.
      const double h2 = points[p + 1][k] - points[0][k];
      const double d2 = values[p + 1][i] - values[0][i];
      gradient[i][k] = (d1 * h2 / h1 - d2 * h1 / h2) / (h2 - h1);
    }
  }
  return gradient;
}

}  // namespace unbruised::optimizer

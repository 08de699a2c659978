#pragma once

/// @file
/// Gradients by finite differences whose points are asked together, so that they share lanes.
///
/// With noise e in the values (convergence of the contact solve, about 1e-9 of a metric) and derivatives of order
/// one on the unit cube, the error of a forward difference is h |f''| / 2 + 2 e / h: least at h = 2 sqrt(e), about
/// 6e-5; of a central one h^2 |f'''| / 6 + e / h: least at h = (3 e)^(1/3), about 1.4e-3.
/// tests/optimizer/gradient_test.cpp measures both against Richardson's extrapolation.

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace unbruised::optimizer {

/// Values of several functions at several points of the unit cube: [point][function].
using VectorFunction = std::function<std::vector<std::vector<double>>(const std::vector<std::vector<double>>&)>;

/// The points that a gradient at `unit` needs, the point itself first. Steps turn inwards where they would leave
/// the cube.
std::vector<std::vector<double>> difference_points(std::span<const double> unit, double step, bool central);

/// Derivatives [function][variable] from the values at `difference_points`. Near a wall the central formula
/// becomes the three-point one-sided one of the same order.
std::vector<std::vector<double>> difference_quotients(const std::vector<std::vector<double>>& points,
                                                      const std::vector<std::vector<double>>& values,
                                                      bool central);

/// Reference for tests: central differences at h, h/2, h/4, ... extrapolated to h = 0 (Richardson 1911).
/// @param unit at least `step` away from the walls
std::vector<std::vector<double>> richardson_gradient(const VectorFunction& function, std::span<const double> unit,
                                                     double step, int levels);

}  // namespace unbruised::optimizer

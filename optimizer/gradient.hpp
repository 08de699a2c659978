#pragma once

/// @file
/// Gradients by finite differences whose points are asked together, so that they share lanes.
///
/// With noise e in the values (convergence of the contact solve, about 1e-9 of a metric) and derivatives of order
/// one on the unit cube, the error of a forward difference is h |f''| / 2 + 2 e / h: least at h = 2 sqrt(e), about
/// 6e-5; of a central one h^2 |f'''| / 6 + e / h: least at h = (3 e)^(1/3), about 1.4e-3. A search with forward
/// differences ends where the difference is zero, about h / 2 away from where the derivative is; in a curved
/// valley that is far (Rosenbrock's by SLSQP at h = 1e-4: 1e-2 above the minimum; with central ones at 1e-3:
/// 1e-5).
///
/// tests/optimizer/gradient_test.cpp measures both formulas, and Richardson's extrapolation, against exact
/// gradients.

#include <cstddef>
#include <span>
#include <vector>

namespace unbruised::optimizer {

/// Which neighbours of a point its difference quotients are made from: one in each variable, or two.
enum class Differences { forward, central };

/// The points that a gradient at `unit` needs, the point itself first. Steps turn inwards where they would leave
/// the cube.
std::vector<std::vector<double>> difference_points(std::span<const double> unit, double step,
                                                   Differences differences);

/// Derivatives [function][variable] from the values at `difference_points`. Near a wall the central formula
/// becomes the three-point one-sided one of the same order.
std::vector<std::vector<double>> difference_quotients(const std::vector<std::vector<double>>& points,
                                                      const std::vector<std::vector<double>>& values,
                                                      Differences differences);

}  // namespace unbruised::optimizer

#pragma once

/// @file
/// What the residuals of a least-squares fit and their derivatives say of its parameters; and predictions by
/// linear regression.

#include <cstddef>
#include <span>
#include <vector>

namespace unbruised::studies {

/// The linear model of residuals r(p + d) = r + J d, with J' J = V diag(values) V'.
struct LinearFit {
  std::vector<double> step;     ///< d = -(J' J)^-1 J' r, Gauss and Newton's way to the least sum of squares
  double predicted_drop = 0.0;  ///< of the sum of squares by that step
  double residual_variance =
      0.0;  ///< s^2 = r' r / (points - parameters); NaN without a point more than parameters
  std::vector<double> standard_error;   ///< sqrt(s^2 (J' J)^-1) on the diagonal; infinite where nothing is told
  std::vector<double> singular_values;  ///< of J, descending
  std::vector<double> weakest;          ///< of length one: the direction that the residuals tell least about
};

/// @param J [point][parameter]; @param r as many as points
LinearFit linear_fit(const std::vector<std::vector<double>>& J, std::span<const double> r);

/// A predicted number and the interval in which a new one lies.
struct Prediction {
  double value = 0.0;
  double low = 0.0;
  double high = 0.0;
};
/// Of each row what a linear regression with intercept on all other rows predicts, with Student's interval of a
/// new row. NaN where fewer than two rows more than coefficients are left, or where x of the others does not vary.
/// @param x [row][variable] @param y as many as rows
std::vector<Prediction> leave_one_out(const std::vector<std::vector<double>>& x, std::span<const double> y,
                                      double confidence);

}  // namespace unbruised::studies

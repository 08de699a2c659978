// Linear fits and what is predicted of a row by all others.

#include "studies/statistics/least_squares.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "studies/statistics/scores.hpp"

namespace unbruised::studies {
namespace {

TEST(LinearFits, OfALineHaveTheTextbooksErrors) {
  // Residuals at d = 0 of y = p0 + p1 x with y = 1, 3, 4, 6 at x = 0, 1, 2, 3: slope 1.6, intercept 1.1.
  const std::vector<std::vector<double>> J = {{1, 0}, {1, 1}, {1, 2}, {1, 3}};
  const std::vector<double> r = {-1.0, -3.0, -4.0, -6.0};
  const LinearFit fit = linear_fit(J, r);
  EXPECT_NEAR(fit.step[0], 1.1, 1e-13);
  EXPECT_NEAR(fit.step[1], 1.6, 1e-13);
  EXPECT_NEAR(fit.predicted_drop, 62.0 - 0.2,
              1e-12);  // squares before less those of the residuals 0.1 0.3 0.3 0.1
  // Errors take the residuals they are given: s^2 = 62 / 2, of the slope s^2 / sum (x - 1.5)^2 = s^2 / 5.
  EXPECT_NEAR(fit.standard_error[1], std::sqrt(31.0 / 5.0), 1e-12);
  EXPECT_NEAR(fit.standard_error[0], std::sqrt(31.0 * (0.25 + 2.25 / 5.0)), 1e-12);
  EXPECT_NEAR(fit.singular_values[0] * fit.singular_values[1], std::sqrt(20.0), 1e-12);  // det J'J = 4 x 14 - 36
}

TEST(LinearFits, NameTheCombinationThatIsNotTold) {
  const std::vector<std::vector<double>> J = {{1, 1, 0}, {2, 2, 1}, {3, 3, 0}, {1, 1, 5}};
  const LinearFit fit = linear_fit(J, std::vector<double>{1.0, 2.0, 3.5, 0.0});
  EXPECT_NEAR(fit.singular_values[2], 0.0, 1e-7);
  EXPECT_NEAR(std::abs(fit.weakest[0]), std::sqrt(0.5), 1e-9);
  EXPECT_NEAR(fit.weakest[0] + fit.weakest[1], 0.0, 1e-9);
  EXPECT_NEAR(fit.weakest[2], 0.0, 1e-9);
  EXPECT_TRUE(std::isinf(fit.standard_error[0]));
  EXPECT_TRUE(std::isinf(fit.standard_error[1]));
  EXPECT_TRUE(std::isfinite(fit.standard_error[2]));
}

TEST(LeaveOneOut, PredictsByTheResidualOverOneLessItsLeverage) {
  // The residual of a left-out row is e / (1 - h) of the regression on all rows (Allen 1974).
  const std::vector<std::vector<double>> x = {{0.0}, {1.0}, {2.0}, {3.0}, {7.0}};
  const std::vector<double> y = {1.0, 2.5, 2.8, 4.4, 7.0};
  const std::vector<Prediction> found = leave_one_out(x, y, 0.95);
  double mean_x = 0.0, mean_y = 0.0, xx = 0.0, xy = 0.0;
  for (std::size_t i = 0; i < 5; ++i) {
    mean_x += x[i][0] / 5.0;
    mean_y += y[i] / 5.0;
  }
  for (std::size_t i = 0; i < 5; ++i) {
    xx += (x[i][0] - mean_x) * (x[i][0] - mean_x);
    xy += (x[i][0] - mean_x) * (y[i] - mean_y);
  }
  for (std::size_t i = 0; i < 5; ++i) {
    const double e = y[i] - mean_y - xy / xx * (x[i][0] - mean_x);
    const double h = 0.2 + (x[i][0] - mean_x) * (x[i][0] - mean_x) / xx;
    EXPECT_NEAR(y[i] - found[i].value, e / (1.0 - h), 1e-12);
    EXPECT_NEAR(found[i].high - found[i].value, found[i].value - found[i].low, 1e-12);
  }
}

TEST(LeaveOneOut, OfAConstantHasTheIntervalOfANewDraw) {
  // Without slope to speak of (x = -1, 1 in turn, y symmetric): half width t s sqrt(1 + 1/n + ...) by hand for row
  // 0.
  const std::vector<std::vector<double>> x = {{1.0}, {-1.0}, {1.0}, {-1.0}, {1.0}};
  const std::vector<double> y = {0.0, 1.0, 1.0, -1.0, -1.0};
  const std::vector<Prediction> found = leave_one_out(x, y, 0.9);
  // Rows 1 to 4: means 0 at either x, squares 4 over 4 - 2; leverage of the mean of two: 1 / 2.
  EXPECT_NEAR(found[0].value, 0.0, 1e-13);
  EXPECT_NEAR(found[0].high, student_score(2.0, 0.9) * std::sqrt(2.0 * 1.5), 1e-12);
}

TEST(LeaveOneOut, OfTooFewOrConstantRowsIsNothing) {
  EXPECT_TRUE(
      std::isnan(leave_one_out({{1.0}, {2.0}, {3.0}, {4.0}}, std::vector<double>{1, 2, 3, 4}, 0.95)[0].value));
  const std::vector<std::vector<double>> same(6, {2.0});
  EXPECT_TRUE(std::isnan(leave_one_out(same, std::vector<double>{1, 2, 3, 4, 5, 6}, 0.95)[0].value));
}

}  // namespace
}  // namespace unbruised::studies

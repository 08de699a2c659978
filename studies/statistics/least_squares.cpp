#include "studies/statistics/least_squares.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "studies/statistics/scores.hpp"
#include "studies/statistics/spectrum.hpp"

namespace unbruised::studies {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Eigenvalues of J' J below this part of the largest are the square of round-off.
constexpr double kSmallestPart = 1e-13;

/// J' J
std::vector<double> normal_matrix(const std::vector<std::vector<double>>& J, std::size_t n) {
  std::vector<double> A(n * n, 0.0);
  for (const std::vector<double>& row : J) {
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) A[i * n + j] += row[i] * row[j];
    }
  }
  return A;
}

/// J' r
std::vector<double> normal_side(const std::vector<std::vector<double>>& J, std::span<const double> r,
                                std::size_t n) {
  std::vector<double> side(n, 0.0);
  for (std::size_t p = 0; p < J.size(); ++p) {
    for (std::size_t i = 0; i < n; ++i) side[i] += J[p][i] * r[p];
  }
  return side;
}

double dot(std::span<const double> a, std::span<const double> b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

/// J' J by its eigenvectors; directions without an eigenvalue are left out.
class Inverse {
 public:
  Inverse(const std::vector<std::vector<double>>& J, std::size_t n)
      : n_(n), spectrum_(symmetric_spectrum(normal_matrix(J, n), n)) {
    const double largest = *std::max_element(spectrum_.values.begin(), spectrum_.values.end());
    least_ = kSmallestPart * largest;
  }

  [[nodiscard]] bool tells(std::size_t k) const { return spectrum_.values[k] > least_; }
  [[nodiscard]] bool tells_all() const {
    for (std::size_t k = 0; k < n_; ++k) {
      if (!tells(k)) return false;
    }
    return true;
  }
  [[nodiscard]] double value(std::size_t k) const { return std::max(0.0, spectrum_.values[k]); }
  [[nodiscard]] std::vector<double> direction(std::size_t k) const {
    std::vector<double> v;
    for (std::size_t i = 0; i < n_; ++i) v.push_back(spectrum_.vectors[i * n_ + k]);
    return v;
  }
  /// a' (J' J)^-1 b
  [[nodiscard]] double form(std::span<const double> a, std::span<const double> b) const {
    double sum = 0.0;
    for (std::size_t k = 0; k < n_; ++k) {
      if (!tells(k)) continue;
      const std::vector<double> v = direction(k);
      sum += dot(v, a) * dot(v, b) / spectrum_.values[k];
    }
    return sum;
  }
  [[nodiscard]] std::vector<double> times(std::span<const double> b) const {
    std::vector<double> out(n_, 0.0);
    for (std::size_t k = 0; k < n_; ++k) {
      if (!tells(k)) continue;
      const std::vector<double> v = direction(k);
      const double part = dot(v, b) / spectrum_.values[k];
      for (std::size_t i = 0; i < n_; ++i) out[i] += part * v[i];
    }
    return out;
  }

 private:
  std::size_t n_;
  Spectrum spectrum_;
  double least_ = 0.0;
};

std::vector<double> with_intercept(const std::vector<double>& row) {
  std::vector<double> longer(row.size() + 1, 1.0);
  std::copy(row.begin(), row.end(), longer.begin() + 1);
  return longer;
}

}  // namespace

LinearFit linear_fit(const std::vector<std::vector<double>>& J, std::span<const double> r) {
  const std::size_t n = J.front().size();
  const Inverse inverse(J, n);
  const std::vector<double> side = normal_side(J, r, n);
  LinearFit fit;
  fit.step = inverse.times(side);
  for (double& d : fit.step) d = -d;
  fit.predicted_drop = inverse.form(side, side);
  fit.residual_variance = J.size() > n ? dot(r, r) / static_cast<double>(J.size() - n) : kNaN;
  for (std::size_t i = 0; i < n; ++i) {
    std::vector<double> unit(n, 0.0);
    unit[i] = 1.0;
    double untold = 0.0;
    for (std::size_t k = 0; k < n; ++k) {
      if (!inverse.tells(k)) untold = std::max(untold, std::abs(inverse.direction(k)[i]));
    }
    const bool is_told = untold < 1e-6;
    fit.standard_error.push_back(is_told ? std::sqrt(fit.residual_variance * inverse.form(unit, unit))
                                         : kInfinity);
  }
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return inverse.value(a) > inverse.value(b); });
  for (const std::size_t k : order) fit.singular_values.push_back(std::sqrt(inverse.value(k)));
  fit.weakest = inverse.direction(order.back());
  return fit;
}

std::vector<Prediction> leave_one_out(const std::vector<std::vector<double>>& x, std::span<const double> y,
                                      double confidence) {
  std::vector<Prediction> out;
  for (std::size_t left_out = 0; left_out < x.size(); ++left_out) {
    std::vector<std::vector<double>> rows;
    std::vector<double> minus_y;
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (i == left_out) continue;
      rows.push_back(with_intercept(x[i]));
      minus_y.push_back(-y[i]);
    }
    const std::vector<double> own = with_intercept(x[left_out]);
    if (rows.size() < own.size() + 2) {
      out.push_back({kNaN, kNaN, kNaN});
      continue;
    }
    const Inverse inverse(rows, own.size());
    if (!inverse.tells_all()) {
      out.push_back({kNaN, kNaN, kNaN});
      continue;
    }
    const LinearFit fit = linear_fit(rows, minus_y);
    const double value = dot(fit.step, own);
    double squares = 0.0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const double error = minus_y[i] + dot(fit.step, rows[i]);
      squares += error * error;
    }
    const auto freedom = static_cast<double>(rows.size() - own.size());
    const double half =
        student_score(freedom, confidence) * std::sqrt(squares / freedom * (1.0 + inverse.form(own, own)));
    out.push_back({value, value - half, value + half});
  }
  return out;
}

}  // namespace unbruised::studies

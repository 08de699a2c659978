#include "studies/statistics/correlation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "studies/statistics/spectrum.hpp"

namespace unbruised::studies {
namespace {

/// Of the matrix that is looked for: room for rounding to thousandths.
constexpr double kNearestEigenvalue = 1e-3;
constexpr int kProjectionsMost = 1000;
constexpr double kProjected = 1e-10;

std::vector<double> numbers_of(const CorrelationMatrix& matrix) {
  std::vector<double> numbers;
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    for (std::size_t j = 0; j < matrix.size(); ++j) numbers.push_back(matrix.at(i, j));
  }
  return numbers;
}

/// The nearest matrix without eigenvalues below `least`.
std::vector<double> lifted(const std::vector<double>& A, std::size_t n, double least) {
  const Spectrum spectrum = symmetric_spectrum(A, n);
  std::vector<double> out(n * n, 0.0);
  for (std::size_t k = 0; k < n; ++k) {
    const double d = std::max(least, spectrum.values[k]);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) {
        out[i * n + j] += d * spectrum.vectors[i * n + k] * spectrum.vectors[j * n + k];
      }
    }
  }
  return out;
}

/// Higham's algorithm 3.3: Dykstra's correction for the cone, none for the diagonal.
std::vector<double> nearest(std::vector<double> Y, std::size_t n) {
  std::vector<double> correction(n * n, 0.0);
  for (int step = 0; step < kProjectionsMost; ++step) {
    std::vector<double> R = Y;
    for (std::size_t i = 0; i < n * n; ++i) R[i] -= correction[i];
    std::vector<double> X = lifted(R, n, kNearestEigenvalue);
    for (std::size_t i = 0; i < n * n; ++i) correction[i] = X[i] - R[i];
    for (std::size_t i = 0; i < n; ++i) X[i * n + i] = 1.0;
    double moved = 0.0;
    for (std::size_t i = 0; i < n * n; ++i) moved = std::max(moved, std::abs(X[i] - Y[i]));
    Y = std::move(X);
    if (moved < kProjected) break;
  }
  return Y;
}

std::vector<double> ranks_of(std::span<const double> values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  std::vector<double> ranks(values.size());
  for (std::size_t first = 0; first < order.size();) {
    std::size_t end = first;
    while (end < order.size() && values[order[end]] == values[order[first]]) ++end;
    for (std::size_t i = first; i < end; ++i) ranks[order[i]] = 0.5 * static_cast<double>(first + end - 1);
    first = end;
  }
  return ranks;
}

}  // namespace

CorrelationMatrix::CorrelationMatrix(std::size_t size) : size_(size), values_(size * size, 0.0) {
  for (std::size_t i = 0; i < size; ++i) values_[i * size + i] = 1.0;
}

void CorrelationMatrix::set(std::size_t i, std::size_t j, double value) {
  values_[i * size_ + j] = value;
  values_[j * size_ + i] = value;
}

double normal_correlation(double rank) { return 2.0 * std::sin(std::numbers::pi * rank / 6.0); }

double rank_correlation(double normal) { return 6.0 / std::numbers::pi * std::asin(0.5 * normal); }

CorrelationMatrix normal_correlations(const CorrelationMatrix& ranks) {
  CorrelationMatrix normal(ranks.size());
  for (std::size_t i = 0; i < ranks.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) normal.set(i, j, normal_correlation(ranks.at(i, j)));
  }
  return normal;
}

double least_eigenvalue(const CorrelationMatrix& matrix) {
  const Spectrum spectrum = symmetric_spectrum(numbers_of(matrix), matrix.size());
  return *std::min_element(spectrum.values.begin(), spectrum.values.end());
}

std::vector<double> cholesky(const CorrelationMatrix& matrix) {
  const std::size_t n = matrix.size();
  std::vector<double> L(n * n, 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      double rest = matrix.at(i, j);
      for (std::size_t k = 0; k < j; ++k) rest -= L[i * n + k] * L[j * n + k];
      L[i * n + j] = i == j ? std::sqrt(std::max(rest, 0.0)) : rest / L[j * n + j];
    }
  }
  return L;
}

CorrelationMatrix nearest_ranks(const CorrelationMatrix& ranks) {
  const std::size_t n = ranks.size();
  const std::vector<double> normal = nearest(numbers_of(normal_correlations(ranks)), n);
  for (double part = 1.0;; part *= 0.999) {
    CorrelationMatrix rounded(n);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const double rank = rank_correlation(std::clamp(part * normal[i * n + j], -1.0, 1.0));
        rounded.set(i, j, std::round(1000.0 * rank) / 1000.0);
      }
    }
    if (least_eigenvalue(normal_correlations(rounded)) > kLeastEigenvalue) return rounded;
  }
}

double spearman(std::span<const double> a, std::span<const double> b) {
  const std::vector<double> x = ranks_of(a);
  const std::vector<double> y = ranks_of(b);
  const double middle = 0.5 * (static_cast<double>(a.size()) - 1.0);
  double xx = 0.0, yy = 0.0, xy = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    xx += (x[i] - middle) * (x[i] - middle);
    yy += (y[i] - middle) * (y[i] - middle);
    xy += (x[i] - middle) * (y[i] - middle);
  }
  return xx > 0.0 && yy > 0.0 ? xy / std::sqrt(xx * yy) : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace unbruised::studies

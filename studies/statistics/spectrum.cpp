#include "studies/statistics/spectrum.hpp"

#include <cmath>
#include <limits>
#include <utility>

namespace unbruised::studies {
namespace {

/// Sweeps of Jacobi's rotations; a dozen make a hundred numbers diagonal to the last bit.
constexpr int kSweepsMost = 40;

/// Rotates rows and columns p and q of A, and columns p and q of V, so that A(p, q) is zero.
void rotate(std::vector<double>& A, std::vector<double>& V, std::size_t n, std::size_t p, std::size_t q) {
  const double apq = A[p * n + q];
  if (apq == 0.0) return;
  const double theta = 0.5 * (A[q * n + q] - A[p * n + p]) / apq;
  const double t = std::copysign(1.0, theta) / (std::abs(theta) + std::sqrt(theta * theta + 1.0));
  const double c = 1.0 / std::sqrt(t * t + 1.0);
  const double s = t * c;
  const auto turn = [c, s](double& x, double& y) {
    const double old = x;
    x = c * old - s * y;
    y = s * old + c * y;
  };
  for (std::size_t k = 0; k < n; ++k) turn(A[k * n + p], A[k * n + q]);
  for (std::size_t k = 0; k < n; ++k) turn(A[p * n + k], A[q * n + k]);
  for (std::size_t k = 0; k < n; ++k) turn(V[k * n + p], V[k * n + q]);
}

}  // namespace

Spectrum symmetric_spectrum(std::vector<double> A, std::size_t size) {
  const std::size_t n = size;
  std::vector<double> V(n * n, 0.0);
  for (std::size_t i = 0; i < n; ++i) V[i * n + i] = 1.0;
  for (int sweep = 0; sweep < kSweepsMost; ++sweep) {
    double beside = 0.0;
    for (std::size_t p = 0; p < n; ++p) {
      for (std::size_t q = p + 1; q < n; ++q) beside += A[p * n + q] * A[p * n + q];
    }
    if (beside < std::numeric_limits<double>::min()) break;
    for (std::size_t p = 0; p < n; ++p) {
      for (std::size_t q = p + 1; q < n; ++q) rotate(A, V, n, p, q);
    }
  }
  Spectrum out{{}, std::move(V)};
  for (std::size_t i = 0; i < n; ++i) out.values.push_back(A[i * n + i]);
  return out;
}

}  // namespace unbruised::studies

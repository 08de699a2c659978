#pragma once

/// @file
/// Rank correlations of random properties: from Spearman's coefficients to the Gaussian copula that has them.

#include <cstddef>
#include <span>
#include <vector>

namespace unbruised::studies {

/// A symmetric matrix with ones on its diagonal.
class CorrelationMatrix {
 public:
  explicit CorrelationMatrix(std::size_t size);
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] double at(std::size_t i, std::size_t j) const { return values_[i * size_ + j]; }
  /// Of a pair, i != j.
  void set(std::size_t i, std::size_t j, double value);

 private:
  std::size_t size_;
  std::vector<double> values_;  ///< [size][size]
};

/// Pearson's correlation of two normal numbers whose ranks are correlated by `rank`: 2 sin(pi rank / 6).
double normal_correlation(double rank);
/// Its inverse, 6 asin(normal / 2) / pi.
double rank_correlation(double normal);
/// Each pair of the matrix through normal_correlation.
CorrelationMatrix normal_correlations(const CorrelationMatrix& ranks);

double least_eigenvalue(const CorrelationMatrix& matrix);
/// Least eigenvalue of a matrix whose numbers can be drawn: below it some combination of them is fixed to six
/// digits by the others.
inline constexpr double kLeastEigenvalue = 1e-6;

/// The lower triangle L of L L' = matrix, [size][size]. @param matrix its least eigenvalue is > 0
std::vector<double> cholesky(const CorrelationMatrix& matrix);

/// Rank correlations in thousandths that can be drawn and are nearest to `ranks`, which cannot: the nearest normal
/// correlations in Frobenius' norm by alternating projections (Higham 2002), put inside the border by what the
/// rounding needs.
CorrelationMatrix nearest_ranks(const CorrelationMatrix& ranks);

/// Spearman's coefficient: the correlation of the ranks, equal values sharing the mean of theirs. NaN where either
/// is constant or fewer than two.
double spearman(std::span<const double> a, std::span<const double> b);

}  // namespace unbruised::studies

#pragma once

/// @file
/// How the random keys of a study are drawn together: from numbers of designs in the unit cube to values.

#include <cstddef>
#include <functional>
#include <vector>

#include "studies/config/study.hpp"

namespace unbruised::studies {

/// Independent keys take one number each, through their quantile functions. Correlated ones take theirs through a
/// Gaussian copula: u -> z = Phi^-1(u), y = L z, Phi(y) -> quantile, with L L' their normal correlations; keys
/// that change the factored matrix come first in L, so that their values need no number of the others. Keys of
/// data that share their rows take one number together. Such a number is shared by a factor group when one of its
/// keys changes the factored matrix.
class JointLaw {
 public:
  explicit JointLaw(const Study& study);

  /// Numbers that a factor group shares.
  [[nodiscard]] std::size_t shared_numbers() const { return shared_numbers_; }
  /// Numbers that each product has of its own.
  [[nodiscard]] std::size_t own_numbers() const { return own_numbers_; }

  using Number = std::function<double(std::size_t place)>;
  /// The values of one product, in the order of the keys. @param shared, own 0 < number < 1 at each place
  [[nodiscard]] std::vector<double> draw(const Number& shared, const Number& own) const;

 private:
  struct Source {
    bool is_shared = false;
    std::size_t place = 0;
  };
  /// A correlated key and its row of L.
  struct CopulaRow {
    std::size_t key = 0;
    std::vector<double> weights;  ///< of this row and those before it
  };

  void place_numbers();
  void place_copula(const std::vector<RankCorrelation>& correlations);

  std::vector<RandomVariable> randoms_;
  std::vector<Source> sources_;  ///< of each key
  std::vector<CopulaRow> copula_;
  std::size_t shared_numbers_ = 0;
  std::size_t own_numbers_ = 0;
};

}  // namespace unbruised::studies

#pragma once

/// @file
/// Fitted values of many specimens as a population to draw from.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "studies/config/study.hpp"
#include "studies/findings/specimen_fit.hpp"
#include "studies/statistics/correlation.hpp"

namespace unbruised::studies {

/// One fitted key over the specimens, on its own scale (of the logarithm for keys fitted on a log scale).
struct FittedKey {
  std::string key;
  bool is_log = false;
  double mean = 0.0;       ///< of the key itself
  double deviation = 0.0;  ///< of the key itself: what the specimens differ by, less what their fits are unsure of
  double scatter = 0.0;    ///< of the fitted values on the fit's scale, parts of the range
  double error = 0.0;      ///< root mean square of their standard errors, likewise
};

struct Population {
  std::vector<std::size_t> specimens;  ///< whose curve tells all keys: places in the fits
  std::vector<FittedKey> keys;         ///< empty without such specimens
  /// Rank correlations that can be drawn; from four specimens on.
  std::optional<CorrelationMatrix> ranks;
};

/// A curve tells a key whose standard error is below this part of its range.
inline constexpr double kToldError = 0.5;

Population population_of(const Study& study, const std::vector<SpecimenFit>& fits);

/// The mean product as a file, with a [[random]] block for each key that differs and the [[correlation]] blocks
/// between them. Of one specimen the product alone.
std::string population_toml(const Study& study, const Population& population);

}  // namespace unbruised::studies

#pragma once

/// @file
/// What a calibration found for one specimen.

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace unbruised::studies {

/// What stops an interval: the growth of the sum of squares, the range of the key, or nothing that was found.
enum class EndKind { found, range, unsettled };

struct IntervalEnd {
  double unit = std::numeric_limits<double>::quiet_NaN();
  EndKind kind = EndKind::unsettled;
};

/// Of one key, on the scale of the fit.
struct KeyInterval {
  IntervalEnd low, high;
};

/// Points and errors are on the scale of the fit, where each key's range is 0 to 1 (evenly, or in the logarithm).
struct SpecimenFit {
  std::string specimen;
  bool is_fitted = false;                 ///< some scenario gave a curve
  std::vector<double> unit;               ///< the best point
  std::vector<double> unit_error;         ///< standard errors by Gauss and Newton; infinite where nothing is told
  std::vector<KeyInterval> intervals;     ///< by their profile
  std::vector<double> values, low, high;  ///< the best point and the intervals in the keys' own units
  std::vector<double> simulated;          ///< at the points of the measured curve
  double rms_residual = std::numeric_limits<double>::quiet_NaN();  ///< in the measured unit
  std::vector<double> singular_values;                             ///< of the derivatives of the curve, descending
  std::vector<double> weakest;                                     ///< direction that the curve tells least about
  double weakest_error = 0.0;                                      ///< standard error along it; 1: the whole range
  std::size_t scenarios = 0;
};

}  // namespace unbruised::studies

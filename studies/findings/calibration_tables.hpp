#pragma once

/// @file
/// What a calibration leaves: values of each specimen, the population, predictions, and a product file.

#include <string>
#include <vector>

#include "studies/config/study.hpp"
#include "studies/findings/specimen_fit.hpp"
#include "studies/results/rows.hpp"

namespace unbruised::studies {

struct Calibration {
  /// calibration, calibration_curve, population, population_correlation (docs/results.md)
  std::vector<ResultTable> tables;
  std::vector<std::string> warnings;
  std::string product_toml;  ///< empty where no specimen is told
};

/// @param fits of the study's curves, in their order
Calibration calibration_of(const Study& study, const std::vector<SpecimenFit>& fits);

}  // namespace unbruised::studies

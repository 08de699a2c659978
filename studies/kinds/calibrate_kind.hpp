#pragma once

/// @file
/// calibrate: keys are fitted to measured curves, specimen by specimen.

#include "studies/kinds/kind_table.hpp"

namespace unbruised::studies {

KindAnswer run_calibrate(const KindInput& input);

/// Points that the fits may ask for, at most.
std::size_t curves_at_most(const Study& study);
/// The input columns of its rows: the keys that are fitted.
std::vector<ColumnInfo> fitted_columns(const Study& study);
/// The scenario with the keys of a row.
std::optional<Scenario> scenario_of_fit(const Study& study, const ScenarioRow& row);
/// The study's scenario where the fits start.
ScenarioSet first_of_fits(const Study& study);

}  // namespace unbruised::studies

#pragma once

/// @file
/// The four ways in which kinds come by their scenarios.

#include "studies/kinds/kind_table.hpp"

namespace unbruised::studies {

/// simulate, sweep, sample, compare, sensitivity: all are known beforehand.
extern const ScenarioFamily kFixedScenarios;
/// window: grip forces are asked for at every point of the grid.
extern const ScenarioFamily kAskedForces;
/// optimize, robust, pareto: searches ask.
extern const ScenarioFamily kAskedQuestions;
/// calibrate: fits ask.
extern const ScenarioFamily kAskedCurves;

}  // namespace unbruised::studies

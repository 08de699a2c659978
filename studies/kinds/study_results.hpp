#pragma once

/// @file
/// What a study writes into results.h5 beside what its kind finds.

#include <string>
#include <vector>

#include "studies/config/study.hpp"
#include "studies/results/rows.hpp"
#include "studies/results/run_directory.hpp"

namespace unbruised::studies {

/// results.h5 of a study that is not finished: scenarios not run yet are rows too where they are known beforehand,
/// what the kind finds beside is missing.
ResultsContent unfinished_content(const Study& study, const RunDirectory& run, std::vector<std::string> warnings);

enum class ResultsState { complete, unfinished };
/// What the root of a results file says about this study.
ResultsMeta results_meta(const Study& study, std::vector<std::string> warnings, ResultsState state);

}  // namespace unbruised::studies

#pragma once

/// @file
/// How much memory a study will take and how much there is, so that one too large is refused before it begins.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/simulation/simulation.hpp"
#include "studies/config/study.hpp"

namespace unbruised::studies {

/// Memory of rows: where their kind knows its scenarios beforehand some tens of bytes each.
double estimated_rows_bytes(StudyKind kind, double row_count, std::size_t input_count);

/// Memory of the models that are worked with at a time, and of the lanes of all threads.
/// @param groups the size of each model; the largest are taken to run together. @param threads > 0
double estimated_run_bytes(std::vector<ModelSize> groups, int threads);

/// Says that `needed_bytes` are more than there are, with both figures; nothing when they are not.
std::optional<std::string> too_much_memory(const std::string& study_name, double needed_bytes);

/// Says that so many particles may touch that no model is built with them; nothing where it is.
/// @param largest of a study's models
std::optional<std::string> too_many_may_touch(const std::string& study_name, const ModelSize& largest);

/// The same for a study as it will be run, without building a model that does not fit: of large lattices the
/// particles are counted by their volume first.
std::optional<std::string> too_much_memory(const Study& study, int threads);

}  // namespace unbruised::studies

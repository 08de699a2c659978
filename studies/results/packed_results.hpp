#pragma once

/// @file
/// What a reading process tells its parent, as bytes: a summary, a trace, rows, or the error.

#include <string>
#include <string_view>

#include "core/outcome/trace.hpp"
#include "studies/results/expected.hpp"
#include "studies/results/results_file.hpp"

namespace unbruised::studies {

std::string packed(Expected<ResultsSummary> answer);
std::string packed(Expected<Trace> answer);
std::string packed(Expected<std::vector<ScenarioRow>> answer);
/// Back again; io where the bytes are none of `packed`.
template <class T>
Expected<T> unpacked(std::string_view bytes);
extern template Expected<ResultsSummary> unpacked(std::string_view bytes);
extern template Expected<Trace> unpacked(std::string_view bytes);
extern template Expected<std::vector<ScenarioRow>> unpacked(std::string_view bytes);

}  // namespace unbruised::studies

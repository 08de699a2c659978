#pragma once

/// @file
/// Scenarios without a run directory: many in lanes, or one with its trace.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <pybind11/pybind11.h>

#include "python/bindings/source.hpp"

namespace unbruised::python {

/// One scenario per row, each what the study says about a single scenario with the row's `key=value` on top.
/// @param progress called with (done, total) now and then; may be None
/// @return arrays.hpp, `columns_of`. Throws ConfigError with the first row that breaks a rule.
pybind11::dict evaluate(const Source& source, const std::vector<std::vector<std::string>>& rows, int threads,
                        const pybind11::object& progress);

/// One scenario with its trace. @param id of a study whose scenarios are numbered; else that of `evaluate`
/// @return "result" as above, "signals" as arrays.hpp, `signals_of`
pybind11::dict simulate(const Source& source, const std::vector<std::string>& sets,
                        std::optional<std::uint64_t> id, bool keep_motion);

}  // namespace unbruised::python

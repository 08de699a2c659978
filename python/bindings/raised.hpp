#pragma once

/// @file
/// What went wrong, as Python's exceptions (python/unbruised/_errors.py).

#include <cstddef>
#include <optional>
#include <string>

#include "studies/config/study.hpp"
#include "studies/results/expected.hpp"

namespace unbruised::python {

/// Throws ConfigError with all lines. @param row of what was to be evaluated
[[noreturn]] void raise(const studies::ConfigError& error, std::optional<std::size_t> row = std::nullopt);
/// Throws RunError.
[[noreturn]] void raise(const studies::ResultsError& error);
/// Throws RunError where a study does not fit on this machine.
[[noreturn]] void raise_refusal(const std::string& sentence);

}  // namespace unbruised::python

#pragma once

/// @file
/// A study checked, and run on its run directory as `unbruised run` does.

#include <string>
#include <vector>

#include <pybind11/pybind11.h>

#include "python/bindings/source.hpp"

namespace unbruised::python {

/// What `unbruised check` says, by name.
pybind11::dict check(const Source& source, const std::vector<std::string>& sets, int threads);

struct RunSettings {
  std::string directory;
  int threads = 1;
  bool fresh = false;
};
/// Runs or continues a study. @param progress called with (done, total, text) now and then; may be None
/// @return "digest", "lines", "warnings", "notes", "run_now", "seconds". Throws ConfigError, RunError; what a
/// signal raises once all that was run is safe.
pybind11::dict run(const Source& source, const std::vector<std::string>& sets, const RunSettings& settings,
                   const pybind11::object& progress);

}  // namespace unbruised::python

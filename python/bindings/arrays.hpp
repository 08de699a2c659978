#pragma once

/// @file
/// Results as numpy's arrays in plain dictionaries, which python/unbruised/_results.py gives names and units.

#include <string>
#include <utility>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include "core/outcome/outcome.hpp"
#include "core/outcome/trace.hpp"

namespace unbruised::python {

/// An array that owns the numbers of a vector; nothing is copied.
template <class T>
pybind11::array_t<T> array_of(std::vector<T> values, const std::vector<pybind11::ssize_t>& extents) {
  auto* kept = new std::vector<T>(std::move(values));
  const pybind11::capsule owner(kept, [](void* held) { delete static_cast<std::vector<T>*>(held); });
  return pybind11::array_t<T>(extents, kept->data(), owner);
}

/// "outcome", "outcome_word", "cause", "outcome_time_s", "digest", and "metrics" by name: an entry per result.
pybind11::dict columns_of(const std::vector<ScenarioResult>& results);
/// A dictionary by name of (dimensions, array, units, long name); "contact_events" has its columns likewise.
pybind11::dict signals_of(Trace trace);
/// (name, units, long name) of every metric.
pybind11::list metric_table();

}  // namespace unbruised::python

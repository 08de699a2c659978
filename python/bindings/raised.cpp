#include "python/bindings/raised.hpp"

#include <string_view>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

namespace unbruised::python {
namespace {

namespace py = pybind11;

template <class... Arguments>
[[noreturn]] void throw_as(const char* name, Arguments&&... arguments) {
  const py::object type = py::module_::import("unbruised._errors").attr(name);
  const py::object instance = type(std::forward<Arguments>(arguments)...);
  PyErr_SetObject(type.ptr(), instance.ptr());
  throw py::error_already_set();
}

std::string_view word_of(studies::ResultsErrorKind kind) {
  using enum studies::ResultsErrorKind;
  switch (kind) {
    case io:
      return "io";
    case busy:
      return "busy";
    case finished:
      return "finished";
    case other_config:
      return "other_config";
    case other_build:
      return "other_build";
    case foreign:
      return "foreign";
    case not_built:
      return "not_built";
    case damaged:
      break;
  }
  return "damaged";
}

}  // namespace

void raise(const studies::ConfigError& error, std::optional<std::size_t> row) {
  throw_as("ConfigError", error.messages, row);
}

void raise(const studies::ResultsError& error) {
  throw_as("RunError", error.message, std::string(word_of(error.kind)));
}

void raise_refusal(const std::string& sentence) { throw_as("RunError", sentence, std::string("refused")); }

}  // namespace unbruised::python

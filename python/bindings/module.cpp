// The module `unbruised._unbruised`; python/unbruised/_unbruised.pyi says what is in it.

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "python/bindings/arrays.hpp"
#include "python/bindings/evaluation.hpp"
#include "python/bindings/source.hpp"
#include "python/bindings/study_run.hpp"
#include "studies/config/library.hpp"
#include "studies/config/schema.hpp"
#include "studies/execution/build_info.hpp"
#include "studies/execution/machine.hpp"

namespace py = pybind11;
using namespace unbruised;

namespace {

using Sets = std::vector<std::string>;

/// What the study of a source resolves to, by name.
py::dict facts(const python::Source& source, const Sets& sets) {
  const studies::Study study = source.study(sets);
  py::dict said;
  said["name"] = study.name();
  said["kind"] = std::string(studies::study_kind_word(study.kind()));
  said["description"] = study.description();
  said["resolved_toml"] = study.resolved_toml();
  said["warnings"] = study.warnings();
  said["is_time_step_chosen"] = study.is_time_step_chosen();
  said["time_step_s"] = study.scenario(0).simulation.time_step_s;
  return said;
}

/// The keys of a scenario's table, "strategy.grip_force_N" without "strategy.".
std::vector<std::string> keys_of(const std::string& table) {
  std::vector<std::string> names;
  for (const studies::KeySpec& spec : studies::key_table()) {
    const std::string_view path = spec.path;
    if (path.starts_with(table + ".")) names.emplace_back(path.substr(table.size() + 1));
  }
  return names;
}

}  // namespace

PYBIND11_MODULE(_unbruised, module) {
  module.doc() = "The simulator and its studies, as the package `unbruised` sees them.";
  module.attr("__version__") = studies::program_version();
  py::class_<python::Source>(module, "Source")
      .def(py::init([](const std::string& file, const std::optional<std::string>& text) {
             return python::Source::of(file, text);
           }),
           py::arg("file"), py::arg("text") = py::none())
      .def_property_readonly("file", [](const python::Source& source) { return source.file.string(); })
      .def_property_readonly("root", [](const python::Source& source) { return source.root.string(); });
  module.def("facts", &facts, py::arg("source"), py::arg("sets"));
  module.def("check", &python::check, py::arg("source"), py::arg("sets"), py::arg("threads"));
  module.def(
      "run",
      [](const python::Source& source, const Sets& sets, const std::string& directory, int threads, bool fresh,
         const py::object& progress) {
        return python::run(source, sets, {directory, threads, fresh}, progress);
      },
      py::arg("source"), py::arg("sets"), py::arg("directory"), py::arg("threads"), py::arg("fresh"),
      py::arg("progress"));
  module.def("evaluate", &python::evaluate, py::arg("source"), py::arg("rows"), py::arg("threads"),
             py::arg("progress"));
  module.def("simulate", &python::simulate, py::arg("source"), py::arg("sets"), py::arg("scenario"),
             py::arg("keep_motion"));
  module.def("metric_table", &python::metric_table);
  module.def("keys_of", &keys_of, py::arg("table"));
  module.def("explain", &studies::explain_key, py::arg("key"));
  module.def("nearest", &studies::nearest, py::arg("word"), py::arg("known"));
  module.def("usable_cores", [] { return studies::usable_cores(); });
  module.def("numeric_build", &studies::numeric_build);
}

#include "python/bindings/source.hpp"

#include <string>

#include <pybind11/pybind11.h>

#include "python/bindings/raised.hpp"
#include "studies/config/locations.hpp"
#include "studies/config/study_part.hpp"

namespace unbruised::python {
namespace {

namespace fs = std::filesystem;

/// The prefix below which this module is installed as lib/python3/dist-packages/unbruised.
fs::path module_prefix() {
  const auto package = pybind11::module_::import("unbruised").attr("__path__").cast<pybind11::list>();
  fs::path folder = fs::path(package[0].cast<std::string>());
  for (int level = 0; level < 4; ++level) folder = folder.parent_path();
  return folder;
}

}  // namespace

Source Source::of(const std::string& file, const std::optional<std::string>& text) {
  const fs::path prefix = module_prefix();
  if (text) return {file.empty() ? "the study's text" : file, text, studies::config_root_for(file, prefix)};
  const fs::path found = studies::study_file(file, prefix);
  return {found, std::nullopt, studies::config_root_for(found, prefix)};
}

fs::path Source::folder() const { return file.has_parent_path() ? file.parent_path() : fs::path("."); }

studies::StudyOrError Source::read(const std::vector<std::string>& sets) const {
  return text ? studies::read_study_text(*text, file.string(), sets, folder(), root)
              : studies::read_study(file, sets, root);
}

studies::StudyOrError Source::read_single(const std::vector<std::string>& sets) const {
  return text ? studies::read_single_scenario_text(*text, file.string(), sets, folder(), root)
              : studies::read_single_scenario(file, sets, root);
}

studies::Study Source::study(const std::vector<std::string>& sets) const {
  studies::StudyOrError read_now = read(sets);
  if (!read_now) raise(read_now.error());
  return *std::move(read_now);
}

}  // namespace unbruised::python

#include "studies/cli/locations.hpp"

#include <system_error>
#include <vector>

namespace unbruised::studies {
namespace {

namespace fs = std::filesystem;

bool holds_library(const fs::path& folder) {
  std::error_code error;
  return fs::is_directory(folder / "products", error) || fs::is_directory(folder / "grippers", error);
}

}  // namespace

fs::path config_root_for(const fs::path& study) {
  std::vector<fs::path> candidates;
  std::error_code error;
  if (!study.empty()) {
    const fs::path folder = fs::absolute(study, error).lexically_normal().parent_path();
    for (fs::path parent = folder; parent.has_relative_path(); parent = parent.parent_path()) {
      if (parent.filename() == "configs") candidates.push_back(parent);
    }
    candidates.push_back(folder / "configs");
  }
  candidates.push_back(fs::current_path(error) / "configs");
  for (const fs::path& candidate : candidates) {
    if (holds_library(candidate)) return candidate;
  }
  return UNBRUISED_CONFIG_ROOT;
}

}  // namespace unbruised::studies

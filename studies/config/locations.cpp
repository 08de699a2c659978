#include "studies/config/locations.hpp"

#include <cstdlib>
#include <string>
#include <system_error>
#include <vector>

namespace unbruised::studies {
namespace {

namespace fs = std::filesystem;

bool holds_library(const fs::path& folder) {
  std::error_code error;
  return fs::is_directory(folder / "products", error) || fs::is_directory(folder / "grippers", error);
}

bool is_file(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

/// The value of a variable of the environment as a folder; empty: it has none.
fs::path folder_of(const char* variable) {
  const char* value = std::getenv(variable);
  return value == nullptr ? fs::path{} : fs::path(value);
}

/// Folders that belong to no study, in the order in which they are looked into.
std::vector<fs::path> common_roots(const fs::path& prefix) {
  std::vector<fs::path> roots = {folder_of("UNBRUISED_CONFIGS")};
  std::error_code error;
  roots.push_back(fs::current_path(error) / "configs");
  if (const fs::path data = folder_of("XDG_DATA_HOME"); !data.empty()) {
    roots.push_back(data / "unbruised" / "configs");
  } else if (const fs::path home = folder_of("HOME"); !home.empty()) {
    roots.push_back(home / ".local" / "share" / "unbruised" / "configs");
  }
  roots.push_back(prefix / "share" / "unbruised" / "configs");
  roots.emplace_back(UNBRUISED_CONFIG_ROOT);
  std::erase_if(roots, [](const fs::path& root) { return !holds_library(root); });
  return roots;
}

}  // namespace

fs::path program_prefix() {
  std::error_code error;
  return fs::read_symlink("/proc/self/exe", error).parent_path().parent_path();
}

fs::path config_root_for(const fs::path& study, const fs::path& prefix) {
  std::vector<fs::path> candidates;
  std::error_code error;
  if (!study.empty()) {
    const fs::path folder = fs::absolute(study, error).lexically_normal().parent_path();
    for (fs::path parent = folder; parent.has_relative_path(); parent = parent.parent_path()) {
      if (parent.filename() == "configs") candidates.push_back(parent);
    }
    candidates.push_back(folder / "configs");
  }
  for (const fs::path& candidate : candidates) {
    if (holds_library(candidate)) return candidate;
  }
  const std::vector<fs::path> common = common_roots(prefix);
  return common.empty() ? UNBRUISED_CONFIG_ROOT : common.front();
}

fs::path study_file(const fs::path& named, const fs::path& prefix) {
  if (is_file(named) || named.is_absolute()) return named;
  fs::path below = named;  // as `unbruised list` and the documentation name it
  if (below.begin() != below.end() && *below.begin() == "configs") below = named.lexically_relative("configs");
  for (const fs::path& root : common_roots(prefix)) {
    if (is_file(root / below)) return root / below;
  }
  return named;
}

}  // namespace unbruised::studies

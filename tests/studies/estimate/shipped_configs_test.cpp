// The studies that ship pass `check` without a warning, or say in a comment which one they have and why.

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "studies/estimate/warnings.hpp"
#include "tests/places.hpp"

namespace unbruised::studies {
namespace {

namespace fs = std::filesystem;

fs::path config_root() { return fs::path(UNBRUISED_SOURCE_DIR) / "configs"; }

/// What stands behind "# check warns: " in a file: words of the warning, then a colon and the reason.
std::vector<std::string> explained_in(const fs::path& file) {
  const std::string begin = "# check warns: ";
  std::vector<std::string> explained;
  std::ifstream lines(file);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with(begin)) continue;
    line.erase(0, begin.size());
    explained.push_back(line.substr(0, line.find(':')));
  }
  return explained;
}

bool any_has(const std::vector<std::string>& texts, const std::string& words) {
  for (const std::string& text : texts) {
    if (text.find(words) != std::string::npos) return true;
  }
  return false;
}

bool any_is_part_of(const std::vector<std::string>& words, const std::string& text) {
  for (const std::string& each : words) {
    if (text.find(each) != std::string::npos) return true;
  }
  return false;
}

TEST(ShippedConfigs, PassCheckWithoutWarningsOrSayWhyInTheFile) {
  std::size_t studies = 0;
  for (const auto& entry : fs::recursive_directory_iterator(config_root())) {
    const std::string folder = entry.path().parent_path().filename().string();
    if (entry.path().extension() != ".toml" || folder == "products" || folder == "grippers" ||
        folder == "strategies") {
      continue;
    }
    const StudyOrError read = read_study(entry.path(), {}, config_root());
    ASSERT_TRUE(read.has_value()) << entry.path();
    ++studies;
    const std::vector<std::string> explained = explained_in(entry.path());
    const std::vector<std::string> warnings = study_warnings(*read);
    for (const std::string& warning : warnings) {
      EXPECT_TRUE(any_is_part_of(explained, warning)) << entry.path() << "\n  " << warning;
    }
    for (const std::string& words : explained) {
      EXPECT_TRUE(any_has(warnings, words)) << entry.path() << ": no warning says \"" << words << "\" any more";
    }
  }
  EXPECT_GE(studies, 18U);
}

}  // namespace
}  // namespace unbruised::studies

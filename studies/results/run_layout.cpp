#include "studies/results/run_layout.hpp"

#include <algorithm>
#include <system_error>
#include <variant>

#include "studies/results/digest.hpp"
#include "studies/text/joined.hpp"

namespace unbruised::studies {

namespace fs = std::filesystem;

std::vector<fs::path> journal_files(const fs::path& directory) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(directory / "journal", error)) {
    if (entry.path().extension() == ".jrnl") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

fs::path hash_path(const fs::path& results) {
  fs::path path = results;
  path += ".sha256";
  return path;
}

std::string hash_line(std::string_view sha256_hex_digits) { return joined({sha256_hex_digits, "  results.h5\n"}); }

bool same_row(const ScenarioRow& a, const ScenarioRow& b) {
  const auto same_input = [](const InputValue& left, const InputValue& right) {
    const auto* x = std::get_if<double>(&left);
    const auto* y = std::get_if<double>(&right);
    return left == right || (x != nullptr && y != nullptr && *x != *x && *y != *y);
  };
  return result_digest(a.result) == result_digest(b.result) && a.result.cause == b.result.cause &&
         std::equal(a.inputs.begin(), a.inputs.end(), b.inputs.begin(), b.inputs.end(), same_input);
}

}  // namespace unbruised::studies

#include "studies/cli/measured.hpp"

#include <algorithm>
#include <memory>
#include <string>

#include "studies/config/measured_data.hpp"
#include "studies/config/problems.hpp"
#include "studies/results/durable_files.hpp"

namespace unbruised::studies {

Expected<MeasuredForces> read_measured_forces(const std::filesystem::path& path) {
  const auto text = read_text_file(path);
  if (!text) return text.error();
  Problems problems;
  MeasuredForces measured;
  measured.file = path.filename().string();
  const Origin whole{std::make_shared<const std::string>(path.string()), 0, 1};
  measured.rupture_N = column_numbers(*text, "rupture_force_N", "--measured", whole.file, whole.rank, problems);
  if (problems.empty() && *std::min_element(measured.rupture_N.begin(), measured.rupture_N.end()) <= 0.0) {
    problems.add(whole, "rupture_force_N", "must be above 0");
  }
  if (problems.empty()) return measured;
  std::string lines;
  for (const std::string& line : problems.lines()) lines += (lines.empty() ? "" : "\n") + line;
  return ResultsError{ResultsErrorKind::foreign, lines, {}};
}

}  // namespace unbruised::studies

#include "studies/report/page_rows.hpp"

#include <algorithm>

#include "studies/findings/summary.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

/// Multiples of the golden ratio lie evenly in 0 to 1, those of ids that are some apart too: of a grid every value
/// of every key is met, which each hundredth id would not do.
bool is_chosen(std::uint64_t id, std::size_t most, std::size_t count) {
  constexpr std::uint64_t kGoldenRatio = 0x9E3779B97F4A7C15U;  // times 2^64
  constexpr double kWhole = 18446744073709551616.0;            // 2^64
  return static_cast<double>(id * kGoldenRatio) / kWhole * static_cast<double>(count) < static_cast<double>(most);
}

}  // namespace

std::vector<ScenarioRow> page_rows(const StudyRows& rows, const std::vector<std::uint64_t>& ids,
                                   std::size_t most) {
  if (rows.size() <= most) return rows.held();
  const std::optional<ScenarioRow> best = best_row(rows);
  std::vector<ScenarioRow> shown;
  for (const ScenarioRow& row : rows) {
    if ((best && row.id == best->id) || std::ranges::count(ids, row.id) > 0 ||
        is_chosen(row.id, most, rows.size())) {
      shown.push_back(row);
    }
  }
  return shown;
}

std::string page_rows_note(std::size_t shown, std::size_t all) {
  if (shown == all) return {};
  return joined({"the page shows ", with_thousands(shown), " of ", with_thousands(all),
                 " scenarios, chosen evenly, with the best one and those in motion: its charts and counts are of "
                 "these; results.h5 has all of them"});
}

}  // namespace unbruised::studies

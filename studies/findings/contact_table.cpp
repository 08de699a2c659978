#include "studies/findings/contact_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "studies/findings/table_text.hpp"
#include "studies/findings/trace_curves.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

using Kind = ContactEvent::Kind;

/// What one surface has seen so far.
struct SurfaceRecord {
  std::array<double, kContactEventWords.size()> count{};
  double first_s = kAbsent, last_s = kAbsent, longest_s = 0.0;
  double closed = 0.0, closed_since_s = 0.0;

  void add(const ContactEvent& event) {
    ++count[static_cast<std::size_t>(event.kind)];
    if (event.kind == Kind::make && closed++ == 0.0) {
      closed_since_s = event.time_s;
      if (std::isnan(first_s)) first_s = event.time_s;
    }
    if (event.kind == Kind::break_ && --closed == 0.0) part(event.time_s);
  }
  /// Nothing touches it any more, or the run ends.
  void part(double time_s) {
    last_s = time_s;
    longest_s = std::max(longest_s, time_s - closed_since_s);
  }
};

/// "9 makes", "1 make"
std::string counted(double count, std::string_view word) {
  return joined({with_thousands(static_cast<unsigned long long>(count)), " ", word, count == 1.0 ? "" : "s"});
}

}  // namespace

std::optional<ResultTable> contact_table(const Trace& trace) {
  if (trace.events.empty() || trace.time_s.empty()) return std::nullopt;
  std::map<int, SurfaceRecord> surfaces;
  for (const ContactEvent& event : trace.events) surfaces[event.surface].add(event);
  std::vector<std::string> names;
  std::array<std::vector<double>, kContactEventWords.size()> counts;
  std::vector<double> first, last, longest;
  for (auto& [surface, record] : surfaces) {
    if (record.closed > 0.0) record.part(trace.time_s.back());
    names.push_back(surface_word(trace, surface));
    for (std::size_t kind = 0; kind < counts.size(); ++kind) counts[kind].push_back(record.count[kind]);
    first.push_back(record.first_s);
    last.push_back(record.last_s);
    longest.push_back(record.longest_s);
  }
  ResultTable table{.name = kContactTable, .row = "touched", .columns = {}, .attributes = {}};
  table.columns.push_back({"surface", "", "surface that was touched", std::move(names)});
  for (std::size_t kind = 0; kind < counts.size(); ++kind) {
    table.columns.push_back({joined({kContactEventWords[kind], "_count"}), "1",
                             joined({kContactEventWords[kind], " events of the contact state register"}),
                             std::move(counts[kind])});
  }
  table.columns.push_back({"first_contact_s", "s", "when something touched it first", std::move(first)});
  table.columns.push_back({"last_contact_s", "s", "until when something touched it", std::move(last)});
  table.columns.push_back(
      {"longest_contact_s", "s", "longest stretch in which something touched it", std::move(longest)});
  return table;
}

std::vector<std::string> contact_lines(const std::vector<ResultTable>& tables) {
  std::vector<std::string> lines;
  const ResultTable* table = find_table(tables, kContactTable);
  for (std::size_t row = 0; table != nullptr && row < row_count(*table); ++row) {
    const auto seconds = [&](std::string_view column) {
      return joined({short_number(number_in(*table, column, row)), " s"});
    };
    lines.push_back(joined({"contacts of ", text_in(*table, "surface", row), ": ",
                            comma_list(kContactEventWords,
                                       [&](std::string_view word) {
                                         return counted(number_in(*table, joined({word, "_count"}), row), word);
                                       }),
                            "; touched from ", seconds("first_contact_s"), " to ", seconds("last_contact_s"),
                            ", at longest for ", seconds("longest_contact_s")}));
  }
  return lines;
}

}  // namespace unbruised::studies

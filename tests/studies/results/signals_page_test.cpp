// docs/results.md names every signal of a trace with its unit and dimensions.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/simulation/trace_row.hpp"
#include "studies/text/joined.hpp"
#include "tests/core/simulation/scenes.hpp"
#include "tests/places.hpp"

namespace unbruised::studies {
namespace {

struct PageRow {
  std::string units;
  std::string dimensions;
};

/// Rows of the table of signals: | `name` | units | dimensions | what |
std::map<std::string, PageRow> page_rows() {
  std::ifstream page(UNBRUISED_SOURCE_DIR "/docs/results.md");
  const std::regex row(R"(^\| `([A-Za-z0-9_]+)` \| ([^|]+) \| ([a-z, ]*)\| (.+) \|$)");
  std::map<std::string, PageRow> rows;
  std::smatch match;
  bool in_table = false;
  for (std::string line; std::getline(page, line);) {
    if (line.starts_with("### ")) in_table = line == "### Signals";
    if (!in_table || !std::regex_match(line, match, row)) continue;
    std::string dimensions = match[3];
    while (!dimensions.empty() && dimensions.back() == ' ') dimensions.pop_back();
    rows[match[1]] = {match[2], dimensions};
  }
  return rows;
}

/// One that can yield, turn, be gripped and measured.
Scenario with_everything() {
  Scenario scenario = unbruised::testing::small_box();
  LatticeParameters& product = unbruised::testing::lattice_of(scenario);
  product.yield_stress_Pa = 800.0;
  product.tangent_modulus_Pa = 5e4;
  scenario.sensor.at = SensorMount::wrist;
  jaw_of(scenario).range.maximum_m = 0.1;
  scenario.simulation.contact_set = ContactSet::whole_surface;
  return scenario;
}

TEST(SignalsPage, NamesEverySignalWithItsUnitAndDimensions) {
  Trace trace;
  start_trace({{0.0, 0.0, 0.0}}, with_everything(), trace);
  EXPECT_GE(trace.signals.size(), 30U);
  const std::map<std::string, PageRow> rows = page_rows();
  for (const TraceSignal& signal : trace.signals) {
    const auto row = rows.find(signal.name);
    ASSERT_NE(row, rows.end()) << signal.name << " has no row in docs/results.md, Signals";
    EXPECT_EQ(row->second.units, signal.units) << signal.name;
    EXPECT_EQ(row->second.dimensions, comma_list(signal.dimensions)) << signal.name;
  }
}

TEST(SignalsPage, NamesNoSignalThatThereIsNot) {
  std::string source;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(UNBRUISED_SOURCE_DIR "/core")) {
    if (entry.path().extension() != ".cpp") continue;
    std::ostringstream text;
    text << std::ifstream(entry.path()).rdbuf();
    source += text.str();
  }
  for (const auto& [name, row] : page_rows()) {
    EXPECT_NE(source.find(joined({"\"", name, "\""})), std::string::npos) << name;
  }
}

}  // namespace
}  // namespace unbruised::studies

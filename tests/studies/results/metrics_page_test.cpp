#include <fstream>
#include <regex>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/outcome/outcome.hpp"
#include "tests/places.hpp"

namespace unbruised {
namespace {

struct PageRow {
  std::string name;
  std::string units;
};

// Rows of the table in docs/metrics.md: | `name` | units | definition |
std::vector<PageRow> page_rows() {
  std::ifstream page(UNBRUISED_SOURCE_DIR "/docs/metrics.md");
  const std::regex row(R"(^\| `([A-Za-z0-9_]+)` \| ([^|]+) \| (.+) \|$)");
  std::vector<PageRow> rows;
  std::smatch match;
  for (std::string line; std::getline(page, line);) {
    if (std::regex_match(line, match, row)) rows.push_back({match[1], match[2]});
  }
  return rows;
}

TEST(MetricsPage, NamesEveryMetricInTheOrderOfTheTableWithItsUnit) {
  const auto rows = page_rows();
  ASSERT_EQ(rows.size(), kMetricCount);
  for (std::size_t m = 0; m < kMetricCount; ++m) {
    EXPECT_EQ(rows[m].name, kMetricTable[m].name);
    EXPECT_EQ(rows[m].units, kMetricTable[m].units) << rows[m].name;
    EXPECT_EQ(static_cast<std::size_t>(kMetricTable[m].metric), m) << rows[m].name;
  }
}

}  // namespace
}  // namespace unbruised

// Which scenarios the page of a large study shows.

#include "studies/report/page_rows.hpp"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

namespace unbruised::studies {
namespace {

std::vector<ScenarioRow> rows_of(std::size_t count) {
  std::vector<ScenarioRow> rows(count);
  for (std::size_t i = 0; i < count; ++i) rows[i].id = i;
  return rows;
}

TEST(PageRows, AllOfThemWhereTheyAreFew) {
  EXPECT_EQ(page_rows(rows_of(100), {}, 100).size(), 100U);
  EXPECT_EQ(page_rows_note(100, 100), "");
}

TEST(PageRows, OfManyAboutAsManyAsItHoldsAndEveryValueOfAGrid) {
  constexpr std::size_t kCount = 100000, kMost = 1000;
  const auto shown = page_rows(rows_of(kCount), {}, kMost);
  EXPECT_NEAR(static_cast<double>(shown.size()), kMost, 5.0);  // evenly: not the 30 by which chance would miss it
  for (const std::uint64_t period : {10U, 50U, 100U}) {        // a grid whose last key has so many values
    std::set<std::uint64_t> met;
    for (const ScenarioRow& row : shown) met.insert(row.id % period);
    EXPECT_EQ(met.size(), period);
  }
  EXPECT_EQ(page_rows_note(shown.size(), kCount).find("of 100,000 scenarios"),
            std::string("the page shows 1,000 ").size());
}

TEST(PageRows, WithTheBestOneAndThoseInMotion) {
  auto rows = rows_of(10000);
  for (ScenarioRow& row : rows) row.result.outcome = Outcome::dropped;
  const auto with = [](const std::vector<ScenarioRow>& shown, std::uint64_t id) {
    return std::ranges::count(shown, id, &ScenarioRow::id) == 1;
  };
  const auto shown = page_rows(rows, {}, 10);
  std::uint64_t left_out = 1;
  while (with(shown, left_out)) ++left_out;
  EXPECT_TRUE(with(page_rows(rows, {left_out}, 10), left_out));
  rows[left_out].result.outcome = Outcome::held;
  rows[left_out].result.metrics[Metric::cycle_time_s] = 1.0;
  EXPECT_TRUE(with(page_rows(rows, {}, 10), left_out));
}

}  // namespace
}  // namespace unbruised::studies

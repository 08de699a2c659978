#include "studies/results/rows.hpp"

#include <algorithm>

namespace unbruised::studies {

void number_placed_rows(std::vector<ScenarioRow>& rows) {
  std::sort(rows.begin(), rows.end(), [](const ScenarioRow& a, const ScenarioRow& b) { return a.id < b.id; });
  std::uint64_t number = 0;
  for (ScenarioRow& row : rows) number_placed_row(row, number++);
}

void number_placed_row(ScenarioRow& row, std::uint64_t number) {
  row.place = search_place(row.id);
  row.id = number;
}

std::uint64_t journal_id(const ScenarioRow& row) { return row.place ? journal_id(*row.place) : row.id; }

}  // namespace unbruised::studies

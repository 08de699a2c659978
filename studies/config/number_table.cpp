#include "studies/config/number_table.hpp"

#include <algorithm>
#include <cmath>

#include "studies/text/joined.hpp"

namespace unbruised::studies {

bool NumberTable::read_header(const std::vector<std::vector<std::string>>& groups) {
  if (!csv_.next()) return false;
  columns_ = csv_.cells();
  start_ = csv_.origin();
  std::size_t known = 0;
  for (const auto& group : groups) {
    const auto there = static_cast<std::size_t>(
        std::ranges::count_if(group, [&](const std::string& column) { return has(column); }));
    if (there != 0 && there != group.size()) return false;
    known += there;
  }
  return known == columns_.size();
}

bool NumberTable::has(const std::string& column) const { return std::ranges::count(columns_, column) == 1; }

bool NumberTable::next() {
  if (!csv_.next()) return false;
  failed_ = true;
  const std::vector<std::string>& cells = csv_.cells();
  if (cells.size() != columns_.size()) {
    problems_.add(csv_.origin(), key_,
                  joined({"a row must have ", std::to_string(columns_.size()), " cells, not ",
                          std::to_string(cells.size())}));
    return false;
  }
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const auto value = cell_number(cells[i]);
    if (!value || !std::isfinite(*value)) {
      problems_.add(csv_.origin(), columns_[i], cells[i], "must be a number");
      return false;
    }
    row_[columns_[i]] = *value;
  }
  failed_ = false;
  return true;
}

double NumberTable::number(const std::string& column) const {
  const auto found = row_.find(column);
  return found == row_.end() ? 0.0 : found->second;
}

}  // namespace unbruised::studies

#pragma once

/// @file
/// The one reader of CSV texts: rows of trimmed cells that know their lines.

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "studies/config/document.hpp"

namespace unbruised::studies {

/// The rows of a CSV file, but for empty ones and comments. Spreadsheets may begin it with a byte order mark.
class CsvRows {
 public:
  CsvRows(std::string_view content, std::shared_ptr<const std::string> file, int rank);
  /// Goes on to the next row. @return false: there is none
  bool next();
  [[nodiscard]] const std::vector<std::string>& cells() const { return cells_; }
  [[nodiscard]] const Origin& origin() const { return origin_; }

 private:
  std::string_view rest_;
  std::vector<std::string> cells_;
  Origin origin_;
};

/// The number of a cell, also where a spreadsheet wrote "+0"; nothing where it is none.
std::optional<double> cell_number(const std::string& cell);

}  // namespace unbruised::studies

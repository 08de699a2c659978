#pragma once

/// @file
/// CSV files that hold numbers alone, under columns that go together.

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "studies/config/csv_rows.hpp"
#include "studies/config/problems.hpp"

namespace unbruised::studies {

class NumberTable {
 public:
  /// @param key that names the file, for what is said of it
  NumberTable(std::string_view content, const std::shared_ptr<const std::string>& file, int rank,
              std::string_view key, Problems& problems)
      : csv_(content, file, rank), start_{file, rank, 1}, key_(key), problems_(problems) {}

  /// Reads the first line. @return false: a column is in none of these groups, stands there twice, or others of
  /// its group are missing
  bool read_header(const std::vector<std::vector<std::string>>& groups);
  [[nodiscard]] bool has(const std::string& column) const;
  /// Goes on to the next row. @return false: there is none, or it is none of finite numbers, which is a problem
  bool next();
  /// Of the row, where there is such a column; else 0.
  [[nodiscard]] double number(const std::string& column) const;
  /// Has a row been a problem?
  [[nodiscard]] bool failed() const { return failed_; }
  [[nodiscard]] const Origin& start() const { return start_; }
  [[nodiscard]] const Origin& origin() const { return csv_.origin(); }

 private:
  CsvRows csv_;
  Origin start_;
  std::string_view key_;
  Problems& problems_;
  std::vector<std::string> columns_;
  std::map<std::string, double> row_;
  bool failed_ = false;
};

}  // namespace unbruised::studies

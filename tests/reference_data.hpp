#pragma once

/// @file
/// Reads the tables of tests/reference-data.

#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/places.hpp"

namespace unbruised::testing {

using TableRow = std::map<std::string, std::string>;

inline std::vector<TableRow> read_table(const std::string& name) {
  std::ifstream file(std::string(UNBRUISED_SOURCE_DIR) + "/tests/reference-data/" + name);
  EXPECT_TRUE(file.good()) << name;
  const auto split = [](const std::string& line) {
    std::vector<std::string> fields;
    std::stringstream stream(line.substr(0, line.find('\r')));
    for (std::string field; std::getline(stream, field, ',');) fields.push_back(field);
    return fields;
  };
  std::string line;
  while (std::getline(file, line) && line.starts_with('#')) continue;  // where it is from
  const std::vector<std::string> head = split(line);
  std::vector<TableRow> rows;
  while (std::getline(file, line)) {
    const std::vector<std::string> fields = split(line);
    TableRow row;
    for (std::size_t i = 0; i < fields.size() && i < head.size(); ++i) row[head[i]] = fields[i];
    rows.push_back(row);
  }
  EXPECT_FALSE(rows.empty()) << name;
  return rows;
}

inline double number(const TableRow& row, const std::string& name) { return std::stod(row.at(name)); }

}  // namespace unbruised::testing

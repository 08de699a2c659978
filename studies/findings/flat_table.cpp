#include "studies/findings/flat_table.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <utility>
#include <variant>

#include "core/outcome/outcome.hpp"
#include "studies/findings/table_text.hpp"
#include "studies/results/scenario_columns.hpp"
#include "studies/results/window_columns.hpp"
#include "studies/text/joined.hpp"

namespace unbruised::studies {
namespace {

using Numbers = std::vector<double>;
using Texts = std::vector<std::string>;

template <class Rows, class Value>
ResultColumn column(std::string name, std::string_view units, std::string_view long_name, const Rows& rows,
                    Value value) {
  std::vector<decltype(value(*rows.begin()))> values;
  values.reserve(rows.size());
  for (const auto& row : rows) values.push_back(value(row));
  return {std::move(name), std::string(units), std::string(long_name), std::move(values)};
}

/// Fewer digits do not give the same number back.
std::string all_digits(double value) {
  if (std::isnan(value)) return {};
  std::array<char, 32> text{};
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} ? std::string(text.data(), end) : std::string();
}

bool holds_text(std::size_t i, const auto& rows) {
  for (const auto& row : rows) {
    if (i < row.inputs.size() && std::holds_alternative<std::string>(row.inputs[i])) return true;
  }
  return false;
}

double number_of(const InputValue& value) {
  const auto* number = std::get_if<double>(&value);
  return number == nullptr ? kAbsent : *number;
}

std::string text_of(const InputValue& value) {
  const auto* text = std::get_if<std::string>(&value);
  return text == nullptr ? all_digits(number_of(value)) : *text;
}

template <class Rows>
void add_inputs(ResultTable& table, const std::vector<ColumnInfo>& infos, const Rows& rows) {
  for (std::size_t i = 0; i < infos.size(); ++i) {
    const ColumnInfo& info = infos[i];
    const auto input = [i](const auto& row) {
      return i < row.inputs.size() ? row.inputs[i] : InputValue(kAbsent);
    };
    table.columns.push_back(holds_text(i, rows) ? column(info.key, info.units, info.long_name, rows,
                                                         [&](const auto& row) { return text_of(input(row)); })
                                                : column(info.key, info.units, info.long_name, rows,
                                                         [&](const auto& row) { return number_of(input(row)); }));
  }
}

std::string cell_text(const ResultColumn& column, std::size_t row) {
  if (const auto* numbers = std::get_if<Numbers>(&column.values)) return all_digits((*numbers)[row]);
  const std::string& text = std::get<Texts>(column.values)[row];
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char letter : text) quoted += letter == '"' ? std::string("\"\"") : std::string(1, letter);
  return quoted + "\"";
}

template <class Cell>
std::string line_of(const ResultTable& table, const Cell& cell) {
  return joined({separated(table.columns, ",", cell), "\n"});
}

std::string header_line(const ResultTable& table) {
  return line_of(table, [](const ResultColumn& column) { return column.name; });
}

std::string lines_of(const ResultTable& table) {
  std::string text;
  for (std::size_t row = 0; row < row_count(table); ++row) {
    text += line_of(table, [row](const ResultColumn& column) { return cell_text(column, row); });
  }
  return text;
}

/// A row per scenario: id, outcome, cause, outcome_time_s, varied keys, metrics. Units are part of the names.
template <class Rows>
ResultTable scenario_table(const std::vector<ColumnInfo>& inputs, const Rows& rows) {
  ResultTable table{.name = "scenarios", .row = "scenario", .columns = {}, .attributes = {}};
  const auto add = [&](const ScenarioColumn& info, const auto& value) {
    table.columns.push_back(column(info.name, info.units, info.long_name, rows, value));
  };
  add(kIdColumn, [](const ScenarioRow& row) { return static_cast<double>(row.id); });
  add(kOutcomeColumn, [](const ScenarioRow& row) { return std::string(outcome_word(row.result.outcome)); });
  add(kCauseColumn, [](const ScenarioRow& row) { return row.result.cause; });
  add(kOutcomeTimeColumn, [](const ScenarioRow& row) { return row.result.outcome_time_s; });
  add_inputs(table, inputs, rows);
  for (const MetricInfo& info : kMetricTable) {
    table.columns.push_back(column(std::string(info.name), info.units, info.long_name, rows,
                                   [&](const ScenarioRow& row) { return row.result.metrics[info.metric]; }));
  }
  return table;
}

}  // namespace

ResultTable window_as_table(const WindowTable& window) {
  ResultTable table{.name = "window", .row = "combination", .columns = {}, .attributes = {}};
  add_inputs(table, window.inputs, window.rows);
  for (const WindowNumber& number : kWindowNumbers) {
    table.columns.push_back(column(number.name, number.units, number.long_name, window.rows,
                                   [&](const WindowRow& row) { return row.*number.value; }));
  }
  for (const WindowFlag& flag : kWindowFlags) {
    table.columns.push_back(column(flag.name, "1", flag.long_name, window.rows,
                                   [&](const WindowRow& row) { return row.*flag.value ? 1.0 : 0.0; }));
  }
  for (const WindowText& text : kWindowTexts) {
    table.columns.push_back(
        column(text.name, "", text.long_name, window.rows, [&](const WindowRow& row) { return row.*text.value; }));
  }
  return table;
}

std::vector<std::string> table_names_of(const StudyTables& tables) {
  std::vector<std::string> names = {"scenarios"};
  if (tables.window) names.emplace_back("window");
  for (const ResultTable& table : tables.found) names.push_back(table.name);
  return names;
}

ResultTable table_called(const StudyTables& tables, const std::string& name) {
  if (name == "scenarios") return scenario_table(tables.inputs, tables.rows);
  if (name == "window" && tables.window) return window_as_table(*tables.window);
  const ResultTable* found = find_table(tables.found, name);
  return found == nullptr ? ResultTable{} : *found;
}

std::string csv_text(const ResultTable& table) { return header_line(table) + lines_of(table); }

std::size_t csv_in_pieces(const StudyTables& tables, const std::string& name,
                          const std::function<void(std::string_view)>& look) {
  if (name != "scenarios" || tables.rows.empty()) {
    const ResultTable table = table_called(tables, name);
    look(csv_text(table));
    return table.columns.size();
  }
  std::size_t columns = 0;
  for (std::size_t first = 0; first < tables.rows.size();) {
    const RowBlock block = tables.rows.block(first);
    const auto rows = block.rows.first(std::min(block.rows.size(), kRowsAtATime));
    const ResultTable table = scenario_table(tables.inputs, rows);
    if (first == 0) look(header_line(table));
    look(lines_of(table));
    columns = table.columns.size();
    first += rows.size();
  }
  return columns;
}

}  // namespace unbruised::studies

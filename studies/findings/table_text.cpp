#include "studies/findings/table_text.hpp"

#include <variant>

#include "studies/findings/summary.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

const ResultColumn* find_column(const ResultTable& table, std::string_view name) {
  for (const ResultColumn& column : table.columns) {
    if (column.name == name) return &column;
  }
  return nullptr;
}

std::string assignment(const std::string& key, double value) {
  return joined({key_leaf(key), " = ", short_number(value)});
}

}  // namespace

std::string values_text(const std::vector<SearchVariable>& variables, std::span<const double> values) {
  std::vector<std::string> texts;
  for (std::size_t k = 0; k < values.size(); ++k) texts.push_back(assignment(variables[k].key, values[k]));
  return comma_list(texts);
}

const ResultTable* find_table(const std::vector<ResultTable>& tables, std::string_view name) {
  for (const ResultTable& table : tables) {
    if (table.name == name) return &table;
  }
  return nullptr;
}

std::size_t row_count(const ResultTable& table) {
  if (table.columns.empty()) return 0;
  return std::visit([](const auto& values) { return values.size(); }, table.columns.front().values);
}

double number_in(const ResultTable& table, std::string_view column, std::size_t row) {
  const ResultColumn* found = find_column(table, column);
  const auto* numbers = found == nullptr ? nullptr : std::get_if<std::vector<double>>(&found->values);
  return numbers == nullptr || row >= numbers->size() ? kAbsent : (*numbers)[row];
}

std::string text_in(const ResultTable& table, std::string_view column, std::size_t row) {
  const ResultColumn* found = find_column(table, column);
  const auto* texts = found == nullptr ? nullptr : std::get_if<std::vector<std::string>>(&found->values);
  return texts == nullptr || row >= texts->size() ? std::string() : (*texts)[row];
}

std::optional<double> number_attribute(const ResultTable& table, std::string_view name) {
  for (const auto& [key, value] : table.attributes) {
    if (key == name && std::holds_alternative<double>(value)) return std::get<double>(value);
  }
  return std::nullopt;
}

std::string text_attribute(const ResultTable& table, std::string_view name) {
  for (const auto& [key, value] : table.attributes) {
    if (key == name && std::holds_alternative<std::string>(value)) return std::get<std::string>(value);
  }
  return "";
}

std::vector<std::string> key_texts(const ResultTable& table, std::size_t row) {
  std::vector<std::string> texts;
  for (const ResultColumn& column : table.columns) {
    if (column.name.find('.') == std::string::npos) continue;
    const std::string word = text_in(table, column.name, row);
    texts.push_back(word.empty() ? assignment(column.name, number_in(table, column.name, row))
                                 : joined({key_leaf(column.name), " = ", word}));
  }
  return texts;
}

std::string keys_text(const ResultTable& table, std::size_t row) { return comma_list(key_texts(table, row)); }

}  // namespace unbruised::studies

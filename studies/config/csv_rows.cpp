#include "studies/config/csv_rows.hpp"

#include <charconv>
#include <system_error>
#include <utility>

namespace unbruised::studies {
namespace {

std::string trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\"");
  if (first == std::string_view::npos) return "";
  return std::string(text.substr(first, text.find_last_not_of(" \t\r\"") - first + 1));
}

std::vector<std::string> cells_of(std::string_view line) {
  std::vector<std::string> cells;
  while (true) {
    const std::size_t comma = line.find(',');
    cells.push_back(trimmed(line.substr(0, comma)));
    if (comma == std::string_view::npos) return cells;
    line.remove_prefix(comma + 1);
  }
}

/// Spreadsheets begin "CSV UTF-8" with the bytes EF BB BF.
std::string_view without_byte_order_mark(std::string_view content) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  return content.starts_with(kMark) ? content.substr(kMark.size()) : content;
}

}  // namespace

CsvRows::CsvRows(std::string_view content, std::shared_ptr<const std::string> file, int rank)
    : rest_(without_byte_order_mark(content)), origin_{std::move(file), rank, 0} {}

bool CsvRows::next() {
  while (!rest_.empty()) {
    const std::size_t end = rest_.find('\n');
    const std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    ++origin_.line;
    if (trimmed(line).empty() || line.front() == '#') continue;
    cells_ = cells_of(line);
    return true;
  }
  return false;
}

std::optional<double> cell_number(const std::string& cell) {
  double number = 0.0;
  // from_chars takes no plus.
  const bool has_plus = cell.size() > 1 && cell[0] == '+' && cell[1] != '-' && cell[1] != '+';
  const char* begin = cell.data() + (has_plus ? 1 : 0);
  const auto [end, error] = std::from_chars(begin, cell.data() + cell.size(), number);
  if (error != std::errc() || end != cell.data() + cell.size()) return std::nullopt;
  return number;
}

}  // namespace unbruised::studies

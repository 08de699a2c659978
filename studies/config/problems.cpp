#include "studies/config/problems.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "studies/config/schema.hpp"

namespace unbruised::studies {
namespace {

constexpr std::size_t kShownOfKey = 160;
constexpr std::size_t kShownOfValue = 80;

std::string shortened(std::string_view text, std::size_t most) {
  if (text.size() <= most) return std::string(text);
  std::size_t end = most;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;  // whole characters only
  return std::string(text.substr(0, end)) + "...";
}

/// Words of a file can hold anything; a terminal must not obey them.
std::string printable(std::string text) {
  for (char& letter : text) {
    const auto byte = static_cast<unsigned char>(letter);
    if (byte < 0x20 || byte == 0x7F) letter = '?';
  }
  return text;
}

}  // namespace

void Problems::add(const Origin& origin, std::string_view key, std::string_view rule) {
  all_.push_back({origin, shortened(key, kShownOfKey) + ": " + std::string(rule)});
}

void Problems::add(const Origin& origin, std::string_view key, const std::string& value, std::string_view rule) {
  all_.push_back(
      {origin, shortened(key, kShownOfKey) + " = " + shortened(value, kShownOfValue) + ": " + std::string(rule)});
}

std::vector<std::string> Problems::lines() const {
  std::vector<Problem> sorted = all_;
  std::stable_sort(sorted.begin(), sorted.end(), [](const Problem& a, const Problem& b) {
    return std::pair(a.origin.rank, a.origin.line) < std::pair(b.origin.rank, b.origin.line);
  });
  std::vector<std::string> out;
  std::set<std::string> seen;
  for (const Problem& problem : sorted) {
    std::string line = printable(problem.origin.text() + ": " + problem.text);
    if (seen.insert(line).second) out.push_back(std::move(line));
  }
  return out;
}

std::string unknown_key_rule(const std::string& path) {
  const std::string near = nearest(path, key_patterns());
  if (near.empty()) return "unknown key";
  const Unit* unit = unit_of(near);
  const std::string stem = unit == nullptr ? near : near.substr(0, near.size() - unit->suffix.size());
  const bool other_unit = unit != nullptr && path.starts_with(stem) && path != near;
  return "unknown key; did you mean '" + near + "'?" +
         (other_unit ? " (its unit is " + std::string(unit->display) + ")" : "");
}

std::string table_header(std::string table) {
  return table.ends_with("[]") ? "[[" + table.substr(0, table.size() - 2) + "]]" : "[" + table + "]";
}

std::string unknown_table_rule(const std::string& path) {
  const std::string wanted = pattern_of(path);
  for (const std::string& table : table_names()) {
    if (wanted + "[]" == table || wanted == table + "[]") return "wrong brackets; write " + table_header(table);
  }
  const std::string near = pattern_of(nearest(path, table_names()));
  return near.empty() ? "unknown table" : "unknown table; did you mean " + table_header(near) + "?";
}

}  // namespace unbruised::studies

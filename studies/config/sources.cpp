#include "studies/config/sources.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <memory>

namespace unbruised::studies {
namespace {

constexpr std::array<std::string_view, 2> kSourceTables = {"product.source.", "gripper.source."};

/// The key that "product.source.mass_kg" speaks of: "product.mass_kg"; of "product.source.limits": "limits".
std::string key_of_source(std::string_view path) {
  const std::string_view table = path.substr(0, path.find('.'));
  const std::string_view local = path.substr(path.find('.', table.size() + 1) + 1);
  if (local == "limits" || local.starts_with("limits.")) return std::string(local);
  return std::string(table) + "." + std::string(local);
}

/// Does setting `path` replace a value that a source for `key` speaks of?
bool replaces(std::string_view path, const std::string& key) {
  return path == key || path.starts_with(key + "[") || path.starts_with(key + ".");
}

bool is_replaced(const Entry& source, const std::vector<Entry>& entries) {
  const std::string key = key_of_source(source.path);
  return std::any_of(entries.begin(), entries.end(),
                     [&](const Entry& entry) { return replaces(entry.path, key); });
}

bool is_number_or_numbers(const Value& value) {
  if (value.kind != Value::Kind::array) return value.is_number();
  return !value.items.empty() &&
         std::all_of(value.items.begin(), value.items.end(), [](const Value& item) { return item.is_number(); });
}

bool is_value(std::string_view path) {
  if (is_source(path) || path.find('[') != std::string_view::npos) return false;
  return path.starts_with("product.") || path.starts_with("gripper.") || path.starts_with("limits.");
}

/// A zero that nobody gave a source switches something off; there is nothing to measure.
bool is_switched_off(const ValueSource& value) {
  if (value.standing != Standing::unsourced) return false;
  if (value.value.kind != Value::Kind::array) return value.value.number == 0.0;
  return std::all_of(value.value.items.begin(), value.value.items.end(),
                     [](const Value& item) { return item.number == 0.0; });
}

/// "assumed: a medium fruit" and the like: what nobody can look up.
bool says_assumed(std::string_view source) {
  constexpr std::array<std::string_view, 3> kWords = {"assumed", "from memory", "numerical choice"};
  return std::ranges::any_of(kWords, [source](std::string_view word) { return source.starts_with(word); });
}

std::vector<ValueSource> values_of(const Document& document) {
  std::map<std::string, std::string> sources;
  for (const Entry& entry : document.entries) {
    if (is_source(entry.path)) sources.emplace(key_of_source(entry.path), entry.value.text);
  }
  std::vector<ValueSource> values;
  for (const Entry& entry : document.entries) {
    if (!is_value(entry.path) || !is_number_or_numbers(entry.value)) continue;
    auto source = sources.find(entry.path);
    if (source == sources.end() && entry.path.starts_with("limits.")) source = sources.find("limits");
    ValueSource value{.key = entry.path, .value = entry.value, .source = {}, .standing = Standing::unsourced};
    if (source != sources.end()) {
      value.source = source->second;
      value.standing = says_assumed(value.source) ? Standing::assumed : Standing::cited;
    }
    if (!is_switched_off(value)) values.push_back(std::move(value));
  }
  return values;
}

std::vector<std::string> varied_files_of(const Document& document) {
  std::vector<std::string> keys;
  for (const Entry& entry : document.entries) {
    const bool is_key = entry.path.starts_with("vary[") && entry.path.ends_with("].key");
    if (is_key && entry.value.text.ends_with(".use")) keys.push_back(entry.value.text);
  }
  return keys;
}

}  // namespace

bool is_source(std::string_view path) {
  return std::any_of(kSourceTables.begin(), kSourceTables.end(),
                     [&](std::string_view table) { return path.starts_with(table); });
}

std::vector<Entry> sources_in_use(const std::vector<Entry>& library, const std::vector<Entry>& own,
                                  const std::vector<Entry>& study, const std::vector<Entry>& command_line) {
  std::map<std::string, Entry> found;
  for (const Entry& source : library) {
    if (is_source(source.path) && !is_replaced(source, study) && !is_replaced(source, command_line)) {
      found.emplace(source.path, source);
    }
  }
  for (const Entry& source : own) {
    if (is_source(source.path) && !is_replaced(source, command_line)) found.insert_or_assign(source.path, source);
  }
  std::vector<Entry> sources;
  for (const auto& [path, source] : found) {
    if (source.value.kind == Value::Kind::text) sources.push_back(source);
  }
  return sources;
}

std::string_view standing_word(Standing standing) {
  switch (standing) {
    case Standing::assumed:
      return "assumed";
    case Standing::cited:
      return "cited";
    case Standing::unsourced:
      break;
  }
  return "unsourced";
}

ConfigSources config_sources(std::string_view resolved_toml) {
  constexpr int kNoRank = 0;
  const Document document =
      parse_document(resolved_toml, std::make_shared<const std::string>("config.toml"), kNoRank);
  return {.values = values_of(document), .varied_files = varied_files_of(document)};
}

}  // namespace unbruised::studies

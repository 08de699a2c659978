#pragma once

/// @file
/// Building messages.

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace unbruised::studies {

/// The parts one after the other.
inline std::string joined(std::initializer_list<std::string_view> parts) {
  std::string text;
  for (const std::string_view part : parts) text.append(part);
  return text;
}

/// "a or b or c": what `spell` makes of every item, with the separator between them.
template <class Items, class Spell>
std::string separated(const Items& items, std::string_view separator, Spell spell) {
  std::string text;
  std::string_view before;
  for (const auto& item : items) {
    text.append(before).append(spell(item));
    before = separator;
  }
  return text;
}
inline std::string separated(const std::vector<std::string>& parts, std::string_view separator) {
  return separated(parts, separator, [](const std::string& part) -> const std::string& { return part; });
}

/// "a, b, c"
inline std::string comma_list(const std::vector<std::string>& parts) { return separated(parts, ", "); }
template <class Items, class Spell>
std::string comma_list(const Items& items, Spell spell) {
  return separated(items, ", ", spell);
}

/// Puts a part behind those that stand in `list`, with the separator between them; an empty part adds nothing.
inline void add_part(std::string& list, std::string_view separator, std::string_view part) {
  if (!list.empty() && !part.empty()) list.append(separator);
  list.append(part);
}

/// "a, b or c" with `last` = "or".
inline std::string listed(const std::vector<std::string>& words, std::string_view last) {
  if (words.size() < 2) return comma_list(words);
  const std::vector<std::string> first(words.begin(), words.end() - 1);
  return joined({comma_list(first), " ", last, " ", words.back()});
}
/// The same of words in quotation marks.
inline std::string listed_quoted(std::vector<std::string> words, std::string_view last) {
  for (std::string& word : words) word = joined({"\"", word, "\""});
  return listed(words, last);
}

}  // namespace unbruised::studies

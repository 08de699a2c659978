#include "studies/cli/commands.hpp"
#include "studies/config/schema.hpp"
#include "studies/findings/summary.hpp"
#include "studies/goals/vocabulary.hpp"
#include "studies/text/joined.hpp"

namespace unbruised::studies {
namespace {

/// Keys as answers print them, without their table: "grip_force_N".
std::optional<std::string> explain_leaf(const std::string& leaf) {
  std::vector<std::string> found;
  for (const std::string& key : key_patterns()) {
    if (key_leaf(key) == leaf) found.push_back(explain_key(key).value_or(""));
  }
  if (found.empty()) return std::nullopt;
  return separated(found, "\n");
}

std::optional<std::string> explanation_of(const std::string& word) {
  if (auto text = explain_key(word)) return text;
  if (auto text = explain_word(word)) return text;
  return explain_leaf(word);
}

std::string nearest_word(const std::string& word) {
  std::vector<std::string> known = vocabulary();
  const std::vector<std::string>& tables = table_names();
  known.insert(known.end(), tables.begin(), tables.end());
  for (const std::string& key : key_patterns()) {
    known.push_back(key);
    known.push_back(key_leaf(key));
  }
  return nearest(word, known);
}

}  // namespace

int explain_command(const std::optional<std::string>& word) {
  if (!word) {
    print_line(explain_all());
    for (const char* all : {"metrics", "outcomes", "goals"}) print_line(explain_word(all).value_or(""));
    return kExitDone;
  }
  if (const std::optional<std::string> text = explanation_of(*word)) {
    print_line(*text);
    return kExitDone;
  }
  const std::string near = nearest_word(*word);
  print_error(joined({"unknown word '", *word, "'",
                      near.empty() ? "; `unbruised explain` lists all keys, metrics, outcomes and words of goals"
                                   : joined({"; did you mean '", near, "'?"})}));
  return kExitInput;
}

}  // namespace unbruised::studies

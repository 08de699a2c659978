#include "studies/config/sorted_text.hpp"

#include <algorithm>

#include "studies/config/schema.hpp"
#include "studies/config/sources.hpp"

namespace unbruised::studies {
namespace {

bool is_text_key(const KeyAddress& address) {
  if (address.spec == nullptr) return false;
  const KeyType type = address.spec->type;
  return type == KeyType::text || type == KeyType::choice;
}

class Sorting {
 public:
  Sorting(const Document& document, Problems& problems) : document_(document), problems_(problems) {}

  SortedText run(const std::vector<std::string>& sets) {
    for (const std::string& set : sets) add_set(set);
    sort_tables();
    sort_entries();
    return std::move(out_);
  }

 private:
  void add_set(const std::string& set) {
    const std::size_t equals = set.find('=');
    if (equals == std::string::npos || equals == 0) {
      problems_.add(Origin{}, set, "must be key=value");
      return;
    }
    const auto trimmed = [](std::string text) {
      text.erase(0, text.find_first_not_of(' '));
      return text.substr(0, text.find_last_not_of(' ') + 1);
    };
    const std::string path = trimmed(set.substr(0, equals));
    const std::string literal = trimmed(set.substr(equals + 1));
    KeyAddress address = find_key(path);
    if (address.spec == nullptr) address = find_strategy_key(path);
    std::vector<Value> parsed = parse_literal(literal);
    const bool is_text = !parsed.empty() && parsed[0].kind == Value::Kind::text;
    if ((is_text_key(address) && !is_text) || literal == "none") parsed = {text_value(literal)};
    if (parsed.empty()) {
      if (address.spec == nullptr) {
        problems_.add(Origin{}, path, literal, unknown_key_rule(path));
      } else {
        problems_.add(Origin{}, path, literal,
                      check_value(*address.spec, text_value(literal), address.elements.size()).value_or(""));
      }
      return;
    }
    sets_.push_back({path, parsed[0], {}});
  }

  /// Finds unknown tables and remembers where the known ones start.
  void sort_tables() {
    for (const Entry& table : document_.tables) {
      std::string pattern = pattern_of(table.path);
      // A candidate has the tables of [strategy].
      if (pattern.starts_with("candidate[].")) pattern = "strategy" + pattern.substr(pattern.find('.'));
      out_.tables.emplace(table.path, table.origin);
      if (table.path.starts_with("vary[")) out_.vary_tables.push_back(table);
      if (is_of_block(table.path)) out_.block_tables.push_back(table);
      if (pattern.starts_with("vary[].variant[]") || under_unknown(table.path)) continue;
      if (pattern == "product.source" || pattern == "gripper.source") continue;
      if (std::find(table_names().begin(), table_names().end(), pattern) != table_names().end()) continue;
      unknown_tables_.push_back(table.path);
      if (const KeyAddress key = find_key(table.path); key.spec != nullptr) {
        problems_.add(table.origin, table.path, check_value(*key.spec, Value{}, key.elements.size()).value_or(""));
      } else if (pattern == "product.spring[].burgers") {
        problems_.add(table.origin, table.path, "Burgers springs are not in this version");
      } else {
        problems_.add(table.origin, "[" + table.path + "]", unknown_table_rule(table.path));
      }
    }
  }

  [[nodiscard]] bool under_unknown(const std::string& path) const {
    return std::any_of(unknown_tables_.begin(), unknown_tables_.end(), [&](const std::string& table) {
      return path.starts_with(table + ".") || path.starts_with(table + "[");
    });
  }

  static bool is_descriptive(const std::string& path) {
    for (const std::string_view table : {"product.", "gripper."}) {
      if (!path.starts_with(table)) continue;
      const std::string_view local = std::string_view(path).substr(table.size());
      return local == "name" || local == "description" || local.starts_with("source.");
    }
    return false;
  }

  /// The table or list of tables of that name; empty when there is none.
  static std::string table_called(const std::string& path) {
    for (const std::string& table : table_names()) {
      if (table == path || table == path + "[]") return table;
    }
    return "";
  }

  void sort_entries() {
    for (const Entry& entry : document_.entries) {
      if (under_unknown(entry.path)) continue;
      if (entry.path.starts_with("vary[")) {
        out_.vary_entries.push_back(entry);
      } else if (is_of_block(entry.path)) {
        out_.block_entries.push_back(entry);
      } else if (is_descriptive(entry.path)) {
        if (entry.value.kind != Value::Kind::text) {
          problems_.add(entry.origin, entry.path, spelled(entry.value), "must be a string");
        } else if (is_source(entry.path)) {
          out_.own_sources.push_back(entry);
        }
      } else if (const std::string table = table_called(entry.path); !table.empty()) {
        problems_.add(entry.origin, entry.path, spelled(entry.value),
                      "must be a table; write " + table_header(table));
      } else {
        out_.study.push_back(entry);
        refuse_other_kinds(entry);
      }
    }
    for (const Entry& entry : sets_) {
      auto& list = entry.path.starts_with("vary") ? out_.vary_entries
                   : is_of_block(entry.path)      ? out_.block_entries
                                                  : out_.command_line;
      list.push_back(entry);
    }
    for (const Entry& entry : out_.command_line) refuse_other_kinds(entry);
  }

  void refuse_other_kinds(const Entry& entry) {
    if (entry.path != "study.kind") return;
    const auto rule = check_value(*find_key(entry.path).spec, entry.value, 0);
    if (!rule) return;
    problems_.add(entry.origin, entry.path, spelled(entry.value), *rule);
    out_.is_other_kind = true;
  }

  const Document& document_;
  Problems& problems_;
  std::vector<Entry> sets_;
  std::vector<std::string> unknown_tables_;
  SortedText out_;
};

}  // namespace

const Entry* SortedText::last(std::string_view path) const {
  const Entry* found = nullptr;
  for (const auto* list : {&study, &command_line}) {
    for (const Entry& entry : *list) {
      if (entry.path == path) found = &entry;
    }
  }
  return found != nullptr && found->value.kind == Value::Kind::text ? found : nullptr;
}

SortedText sort_text(const Document& document, const std::vector<std::string>& sets, Problems& problems) {
  return Sorting(document, problems).run(sets);
}

}  // namespace unbruised::studies

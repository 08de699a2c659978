#include "studies/findings/strategy_file.hpp"

#include <algorithm>
#include <variant>

#include "studies/config/strategy_text.hpp"
#include "studies/results/checksum.hpp"
#include "studies/text/joined.hpp"

namespace unbruised::studies {
namespace {

ResultTable table_of(const AnsweredStrategy& answer) {
  ResultTable table{.name = "best", .row = "best_number", .columns = {}, .attributes = {}};
  for (std::size_t i = 0; i < answer.keys.size(); ++i) {
    ResultColumn column{answer.keys[i].key, answer.keys[i].units, answer.keys[i].long_name, {}};
    if (const auto* number = std::get_if<double>(&answer.values[i])) {
      column.values = std::vector<double>{*number};
    } else {
      column.values = std::vector<std::string>{std::get<std::string>(answer.values[i])};
    }
    table.columns.push_back(std::move(column));
  }
  return table;
}

/// A comment: no line of it ends early.
std::string comment(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return joined({"# ", text, "\n"});
}

}  // namespace

std::string strategy_toml(const Study& study, const AnsweredStrategy& answer, const std::string& digest) {
  std::string text = comment(joined({"What the study ", study.name(), " (kind = ", study_kind_word(study.kind()),
                                     ") answers. A compare study takes this file: [[candidate]] use = \"...\""}));
  for (const std::string& line : answer.says) text += comment(line);
  text += comment(joined({"config sha256 ", sha256_hex(study.resolved_toml())}));
  text += comment(joined({"digest of the results ", digest}));
  text += joined({"name = \"", study.name(), "\"\n"});
  return text + strategy_lines(answer.scenario);
}

void add_strategy(std::vector<ResultTable>& tables, const AnsweredStrategy& answer, const std::string& toml) {
  auto best = std::find_if(tables.begin(), tables.end(), [](const ResultTable& t) { return t.name == "best"; });
  if (best == tables.end()) best = tables.insert(tables.end(), table_of(answer));
  best->attributes.emplace_back("strategy_toml", toml);
}

}  // namespace unbruised::studies

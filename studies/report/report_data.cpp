#include "studies/report/report_data.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include <nlohmann/json.hpp>

#include "core/outcome/outcome.hpp"
#include "studies/findings/claims.hpp"
#include "studies/findings/grip_window.hpp"
#include "studies/findings/summary.hpp"
#include "studies/report/packed_columns.hpp"
#include "studies/report/page_words.hpp"
#include "studies/report/report_trace.hpp"
#include "studies/report/sound.hpp"
#include "studies/results/outcome_colours.hpp"
#include "studies/results/window_columns.hpp"

namespace unbruised::studies {
namespace {

using nlohmann::json;
using Digits = PackedColumns::Digits;

/// From here on metrics are kept with seven digits, which halves the page. results.h5 has them all.
constexpr std::size_t kRowsWithAllDigits = 20000;

json finite_or_null(double value) { return std::isfinite(value) ? json(value) : json(nullptr); }

json column(const std::string& name, const std::string& units, const std::string& long_name, json values) {
  return {{"name", name}, {"units", units}, {"long_name", long_name}, {"values", std::move(values)}};
}

/// A column of inputs: numbers, or texts as soon as one value is a text.
json input_values(PackedColumns& packed, std::size_t rows,
                  const std::function<const InputValue*(std::size_t)>& at) {
  std::vector<double> numbers;
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < rows; ++i) {
    const InputValue* value = at(i);
    const auto* number = value == nullptr ? nullptr : std::get_if<double>(value);
    const auto* text = value == nullptr ? nullptr : std::get_if<std::string>(value);
    numbers.push_back(number == nullptr ? kAbsent : *number);
    if (text != nullptr && texts.empty()) texts.resize(i);
    if (text != nullptr || !texts.empty()) texts.push_back(text == nullptr ? std::string() : *text);
  }
  return texts.empty() ? packed.numbers(numbers) : packed.texts(texts);
}

template <class Row>
json input_columns_of(PackedColumns& packed, const std::vector<ColumnInfo>& infos, const std::vector<Row>& rows) {
  json columns = json::array();
  for (std::size_t i = 0; i < infos.size(); ++i) {
    columns.push_back(column(infos[i].key, infos[i].units, infos[i].long_name,
                             input_values(packed, rows.size(), [&](std::size_t row) -> const InputValue* {
                               return i < rows[row].inputs.size() ? &rows[row].inputs[i] : nullptr;
                             })));
  }
  return columns;
}

template <class Row>
std::vector<double> numbers_of(const std::vector<Row>& rows, const std::function<double(const Row&)>& value) {
  std::vector<double> numbers;
  numbers.reserve(rows.size());
  for (const Row& row : rows) numbers.push_back(value(row));
  return numbers;
}

template <class Row>
std::vector<std::string> texts_of(const std::vector<Row>& rows,
                                  const std::function<std::string(const Row&)>& value) {
  std::vector<std::string> texts;
  texts.reserve(rows.size());
  for (const Row& row : rows) texts.push_back(value(row));
  return texts;
}

json metric_columns(PackedColumns& packed, const std::vector<ScenarioRow>& rows) {
  const Digits digits = rows.size() > kRowsWithAllDigits ? Digits::seven : Digits::all;
  json columns = json::array();
  for (const MetricInfo& info : kMetricTable) {
    const auto values =
        numbers_of<ScenarioRow>(rows, [&](const ScenarioRow& row) { return row.result.metrics[info.metric]; });
    columns.push_back(column(std::string(info.name), std::string(info.units), std::string(info.long_name),
                             packed.numbers(values, digits)));
  }
  return columns;
}

json scenarios(PackedColumns& packed, const ResultsContent& content) {
  const std::vector<ScenarioRow>& rows = content.rows;
  json table = {{"rows", rows.size()}, {"seven_digits", rows.size() > kRowsWithAllDigits}};
  table["id"] = packed.numbers(
      numbers_of<ScenarioRow>(rows, [](const ScenarioRow& row) { return static_cast<double>(row.id); }));
  table["outcome"] = packed.numbers(numbers_of<ScenarioRow>(
      rows, [](const ScenarioRow& row) { return static_cast<double>(static_cast<int>(row.result.outcome)); }));
  table["cause"] =
      packed.texts(texts_of<ScenarioRow>(rows, [](const ScenarioRow& row) { return row.result.cause; }));
  table["outcome_time_s"] = packed.numbers(
      numbers_of<ScenarioRow>(rows, [](const ScenarioRow& row) { return row.result.outcome_time_s; }));
  table["inputs"] = input_columns_of(packed, content.inputs, rows);
  table["metrics"] = metric_columns(packed, rows);
  return table;
}

std::size_t position(const std::vector<WindowRow>& rows, const WindowRow* row) {
  return static_cast<std::size_t>(row - rows.data());
}

/// The window common to all combinations; where some have none, common to the others.
json common(const WindowTable& window) {
  std::vector<WindowRow> with_window;
  std::vector<std::size_t> place;
  for (std::size_t i = 0; i < window.rows.size(); ++i) {
    if (!window.rows[i].exists) continue;
    with_window.push_back(window.rows[i]);
    place.push_back(i);
  }
  if (with_window.empty()) return {{"exists", false}, {"over", 0}, {"of", window.rows.size()}};
  const CommonWindow found = common_window(with_window);
  json text = {{"exists", found.exists}, {"over", with_window.size()}, {"of", window.rows.size()}};
  text["hold_force_N"] = finite_or_null(found.hold_force_N);
  text["damage_force_N"] = finite_or_null(found.damage_force_N);
  text["hold_is_bound"] = found.hold_is_bound;
  text["damage_is_bound"] = found.damage_is_bound;
  if (found.hold_row != nullptr) text["hold_row"] = place[position(with_window, found.hold_row)];
  if (found.damage_row != nullptr) text["damage_row"] = place[position(with_window, found.damage_row)];
  return text;
}

json window_json(PackedColumns& packed, const WindowTable& window) {
  json columns = json::array();
  for (const WindowNumber& number : kWindowNumbers) {
    columns.push_back(column(number.name, number.units, "",
                             packed.numbers(numbers_of<WindowRow>(
                                 window.rows, [&](const WindowRow& row) { return row.*number.value; }))));
  }
  for (const WindowFlag& flag : kWindowFlags) {
    columns.push_back(
        column(flag.name, "1", "", packed.numbers(numbers_of<WindowRow>(window.rows, [&](const WindowRow& row) {
          return row.*flag.value ? 1.0 : 0.0;
        }))));
  }
  for (const WindowText& text : kWindowTexts) {
    columns.push_back(column(
        text.name, "", "",
        packed.texts(texts_of<WindowRow>(window.rows, [&](const WindowRow& row) { return row.*text.value; }))));
  }
  return {{"rows", window.rows.size()},
          {"inputs", input_columns_of(packed, window.inputs, window.rows)},
          {"columns", std::move(columns)},
          {"common", common(window)}};
}

json table_json(PackedColumns& packed, const ResultTable& table) {
  json columns = json::array();
  std::size_t rows = 0;
  for (const ResultColumn& each : table.columns) {
    const auto* numbers = std::get_if<std::vector<double>>(&each.values);
    const auto& texts =
        numbers != nullptr ? std::vector<std::string>{} : std::get<std::vector<std::string>>(each.values);
    rows = std::max(rows, numbers != nullptr ? numbers->size() : texts.size());
    columns.push_back(column(each.name, each.units, each.long_name,
                             numbers != nullptr ? packed.numbers(*numbers) : packed.texts(texts)));
  }
  json attributes = json::object();
  for (const auto& [name, value] : table.attributes) {
    const auto* number = std::get_if<double>(&value);
    attributes[name] = number != nullptr ? finite_or_null(*number) : json(std::get<std::string>(value));
  }
  return {{"name", table.name},
          {"row", table.row},
          {"rows", rows},
          {"columns", std::move(columns)},
          {"attributes", std::move(attributes)}};
}

json study_json(const ResultsContent& content, const ReportContext& context) {
  const ResultsMeta& meta = content.meta;
  return {{"name", meta.study_name},
          {"kind", meta.study_kind},
          {"complete", meta.complete},
          {"damage", meta.damage.empty() ? json(nullptr) : json(meta.damage)},
          {"damage_note", damage_sentence(meta)},
          {"created_utc", meta.created_utc},
          {"unbruised_version", meta.unbruised_version},
          {"compiler", meta.compiler},
          {"instruction_set", meta.instruction_set},
          {"config", meta.config_toml},
          {"config_sha256", meta.config_sha256},
          {"digest", context.digest},
          {"source", context.source},
          {"wanted", context.wanted ? json(*context.wanted) : json(nullptr)},
          {"replay_command", context.replay_command},
          {"summary", context.summary}};
}

/// `text` with every '<', '>' and '&' written as a JSON escape. They occur in the strings of JSON only.
std::string inert_json(const std::string& text) {
  std::string inert;
  inert.reserve(text.size());
  for (const char letter : text) {
    if (letter == '<') {
      inert += "\\u003c";
    } else if (letter == '>') {
      inert += "\\u003e";
    } else if (letter == '&') {
      inert += "\\u0026";
    } else {
      inert += letter;
    }
  }
  return inert;
}

}  // namespace

ReportData report_data(const ResultsContent& content, const ReportContext& context) {
  PackedColumns packed;
  json page = {{"format", 1}, {"study", study_json(content, context)}};
  page["outcome_words"] = kOutcomeWords;
  page["outcome_colours"] = kOutcomeColours;
  page["not_run_colour"] = outcome_colour(Outcome::not_run);
  page["warnings"] = content.meta.warnings;
  page["words"] = page_words();
  page["slip_limits"] = page_slip_limits();
  page["damage_limits"] = page_damage_limits();
  page["sources"] = page_sources(content.meta.config_toml);
  page["scenarios"] = scenarios(packed, content);
  if (const auto best = best_row(content.rows)) {
    const auto place = std::ranges::find(content.rows, best->id, &ScenarioRow::id);
    page["best_row"] = static_cast<std::size_t>(place - content.rows.begin());
  }
  if (content.window != nullptr) page["window"] = window_json(packed, *content.window);
  page["tables"] = json::array();
  for (const ResultTable& table : content.tables) page["tables"].push_back(table_json(packed, table));
  if (content.trace != nullptr && !content.trace->time_s.empty())
    page["trace"] = trace_json(packed, *content.trace);
  if (!context.measured.rupture_N.empty()) {
    page["measured"] = {{"file", context.measured.file}, {"rupture_N", context.measured.rupture_N}};
  }
  page["replays"] = json::array();
  if (!context.replays.empty()) page["sound"] = sound_json(sound_map(context.replays));
  for (const ScenarioReplay& seen : context.replays) {
    const auto row = std::find_if(content.rows.begin(), content.rows.end(),
                                  [&](const ScenarioRow& each) { return each.id == seen.id; });
    const auto at = static_cast<std::size_t>(row - content.rows.begin());
    page["replays"].push_back(
        replay_json(packed, seen, row == content.rows.end() ? std::nullopt : std::optional(at)));
  }
  // ASCII only: U+2028 and whatever else ends a line in a script becomes an escape.
  constexpr int kNoIndent = -1;
  constexpr bool kAsciiOnly = true;
  return {.json = inert_json(page.dump(kNoIndent, ' ', kAsciiOnly, json::error_handler_t::replace)),
          .columns = packed.bytes()};
}

}  // namespace unbruised::studies

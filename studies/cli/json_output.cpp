#include "studies/cli/json_output.hpp"

#include <cmath>
#include <cstddef>
#include <variant>

#include <nlohmann/json.hpp>

#include "core/outcome/outcome.hpp"
#include "studies/execution/machine.hpp"
#include "studies/findings/flat_table.hpp"
#include "studies/findings/rests_on.hpp"
#include "studies/findings/summary.hpp"
#include "studies/findings/table_text.hpp"
#include "studies/kinds/kind_table.hpp"
#include "studies/results/row_summary.hpp"

namespace unbruised::studies {
namespace {

using json = nlohmann::ordered_json;

constexpr const char* kInfoSchema = "unbruised.info/1";
constexpr const char* kInstantSchema = "unbruised.instant/1";
constexpr const char* kCheckSchema = "unbruised.check/1";

json number(double value) { return std::isfinite(value) ? json(value) : json(nullptr); }

json text_or_null(const std::string& text) { return text.empty() ? json(nullptr) : json(text); }

json cell(const ResultColumn& column, std::size_t row) {
  if (const auto* numbers = std::get_if<std::vector<double>>(&column.values)) return number((*numbers)[row]);
  return std::get<std::vector<std::string>>(column.values)[row];
}

/// {"columns": {name: {units, long_name}}, "rows": [{name: value}], "attributes": {name: value}}
json table_json(const ResultTable& table) {
  json columns = json::object();
  for (const ResultColumn& column : table.columns) {
    columns[column.name] = {{"units", column.units}, {"long_name", column.long_name}};
  }
  json rows = json::array();
  for (std::size_t row = 0; row < row_count(table); ++row) {
    json line = json::object();
    for (const ResultColumn& column : table.columns) line[column.name] = cell(column, row);
    rows.push_back(std::move(line));
  }
  json attributes = json::object();
  for (const auto& [name, value] : table.attributes) {
    const auto* value_number = std::get_if<double>(&value);
    attributes[name] = value_number != nullptr ? number(*value_number) : json(std::get<std::string>(value));
  }
  return {{"columns", std::move(columns)}, {"rows", std::move(rows)}, {"attributes", std::move(attributes)}};
}

json by_word(const OutcomeCounts& counts) {
  json texts = json::object();
  for_each_outcome(counts,
                   [&](Outcome outcome, std::size_t count) { texts[std::string(outcome_word(outcome))] = count; });
  return texts;
}

/// By the name of each balance the row that is worst in it; null where no row has it.
json worst_balances(const RowSummary& seen) {
  json worst = json::object();
  for (std::size_t i = 0; i < kBalances.size(); ++i) {
    const std::optional<ScenarioRow>& row = seen.worst[i].of_all;
    worst[std::string(info_of(kBalances[i]).name)] =
        row ? json{{"value", number(row->result.metrics[kBalances[i]])}, {"scenario", row->id}} : json(nullptr);
  }
  return worst;
}

json study_part(const RecordedStudy& recorded) {
  const StudyRows& rows = recorded.tables.rows;
  const std::size_t not_run = rows.seen().outcomes.not_run;
  return {{"name", recorded.meta.study_name},
          {"kind", recorded.meta.study_kind},
          {"complete", recorded.meta.complete},
          {"scenarios_run", rows.size() - not_run},
          {"scenarios_wanted", recorded.meta.complete ? json(rows.size())
                               : recorded.wanted      ? json(*recorded.wanted)
                                                      : json(nullptr)}};
}

json origin_part(const ResultsMeta& meta) {
  return {{"unbruised_version", text_or_null(meta.unbruised_version)},
          {"compiler", text_or_null(meta.compiler)},
          {"instruction_set", text_or_null(meta.instruction_set)},
          {"created_utc", text_or_null(meta.created_utc)},
          {"config_sha256", text_or_null(meta.config_sha256)}};
}

/// What does not stand in UTF-8 becomes U+FFFD.
std::string printed(const json& document) {
  constexpr int kIndent = 2;
  constexpr bool kAsciiOnly = false;
  return document.dump(kIndent, ' ', kAsciiOnly, json::error_handler_t::replace);
}

json size_json(std::size_t least, std::size_t most) { return {{"least", least}, {"most", most}}; }

}  // namespace

std::string info_json(const RecordedStudy& recorded, const std::string& program) {
  const StudyTables& tables = recorded.tables;
  json varied = json::array();
  for (const ColumnInfo& column : tables.inputs) varied.push_back(column.key);
  json found = json::object();
  for (const ResultTable& table : tables.found) found[table.name] = table_json(table);
  const std::string replay = replay_command(recorded, program);
  json document = {{"schema", kInfoSchema},
                   {"study", study_part(recorded)},
                   {"written_by", origin_part(recorded.meta)},
                   {"varied", std::move(varied)},
                   {"warnings", recorded.meta.warnings},
                   {"answer", summary_lines(tables, recorded.meta.study_kind)},
                   {"outcomes", by_word(tables.rows.seen().outcomes)}};
  document["worst_balances"] = worst_balances(tables.rows.seen());
  const ValueCounts counts = value_counts(recorded.meta.config_toml);
  document["rests_on"] = {{"assumed", counts.assumed}, {"unsourced", counts.unsourced}, {"cited", counts.cited}};
  document["window"] = tables.window ? table_json(window_as_table(*tables.window)) : json(nullptr);
  document["tables"] = std::move(found);
  document["has_trace"] = recorded.has_trace;
  document["replay_command"] = text_or_null(replay);
  document["source"] = recorded.source.string();
  document["read_from_journal"] = recorded.from_journal;
  document["notes"] = recorded.notes;
  document["damage"] = recorded.damage;
  document["digest"] = rows_digest(tables.rows);
  return printed(document);
}

std::string instant_json(const TraceInstant& instant, const std::string& source) {
  json signals = json::object();
  for (const TraceSignal& signal : instant.signals) {
    json curves = json::array();
    for (std::size_t entry = 0; entry < signal.values.size(); ++entry) {
      curves.push_back({{"name", curve_name(signal, entry)}, {"value", number(signal.values[entry])}});
    }
    signals[signal.name] = {{"units", signal.units},
                            {"long_name", signal.long_name},
                            {"interpolated", !is_counted(signal)},
                            {"curves", std::move(curves)}};
  }
  return printed({{"schema", kInstantSchema},
                  {"source", source},
                  {"time_s", number(instant.time_s)},
                  {"row_times_s", {number(instant.before_s), number(instant.after_s)}},
                  {"signals", std::move(signals)}});
}

std::string check_json(const Study& study, const StudyCost& cost, const std::vector<std::string>& warnings,
                       const std::vector<std::string>& notes, const std::string& refusal) {
  json document = {{"schema", kCheckSchema},
                   {"valid", true},
                   {"problems", json::array()},
                   {"study", {{"name", study.name()}, {"kind", std::string(study_kind_word(study.kind()))}}},
                   {"warnings", warnings},
                   {"notes", notes},
                   {"refusal", text_or_null(refusal)}};
  document["scenarios"] = {{"count", std::llround(cost.scenarios)},
                           {"exact", has_fixed_scenarios(study.kind())},
                           {"steps_each", number(cost.steps_each)},
                           {"longest_run_s", number(cost.longest_run_s)}};
  document["time_step"] = {{"seconds", number(study.scenario(0).simulation.time_step_s)},
                           {"chosen", study.is_time_step_chosen()}};
  document["factor_groups"] = cost.groups;
  document["particles"] = size_json(cost.least.particle_count, cost.most.particle_count);
  document["may_touch"] = size_json(cost.least.contact_node_count, cost.most.contact_node_count);
  document["freedoms"] = size_json(cost.least.freedom_count, cost.most.freedom_count);
  document["estimate"] = {{"seconds", number(cost.seconds)},
                          {"threads", cost.threads},
                          {"memory_bytes", number(cost.memory_bytes)},
                          {"memory_of_machine_bytes", number(machine_memory_bytes())},
                          {"disk_bytes", number(cost.disk_bytes)}};
  document["config"] = study.resolved_toml();
  return printed(document);
}

std::string check_json_of_problems(const std::vector<std::string>& problems) {
  return printed({{"schema", kCheckSchema}, {"valid", false}, {"problems", problems}});
}

}  // namespace unbruised::studies

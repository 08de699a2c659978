#include "studies/kinds/study_results.hpp"

#include <ctime>
#include <utility>

#include "studies/execution/build_info.hpp"
#include "studies/findings/claims.hpp"
#include "studies/kinds/kind_table.hpp"

namespace unbruised::studies {
namespace {

std::string utc_now() {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  ::gmtime_r(&now, &utc);
  char text[32] = "";
  const std::size_t length = std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return {text, length};
}

}  // namespace

ResultsContent unfinished_content(const Study& study, const RunDirectory& run, std::vector<std::string> warnings) {
  ResultsContent content;
  content.meta = results_meta(study, std::move(warnings), ResultsState::unfinished);
  content.inputs = input_columns(study);
  content.places = row_places(study.kind());
  if (!has_fixed_scenarios(study.kind())) return content;
  const ScenarioSet set = scenario_set(study);
  for (std::uint64_t id = 0; id < set.count; ++id) {
    if (!run.is_done(id)) content.rows.push_back({.id = id, .result = {}, .inputs = set.inputs(id)});
  }
  return content;
}

ResultsMeta results_meta(const Study& study, std::vector<std::string> warnings, ResultsState state) {
  ResultsMeta meta;
  meta.unbruised_version = program_version();
  meta.config_toml = study.resolved_toml();
  meta.study_name = study.name();
  meta.study_kind = study_kind_word(study.kind());
  meta.created_utc = utc_now();
  meta.instruction_set = instruction_set();
  meta.compiler = compiler_and_libraries();
  meta.complete = state == ResultsState::complete;
  meta.warnings = std::move(warnings);
  set_damage(meta, study);
  return meta;
}

}  // namespace unbruised::studies

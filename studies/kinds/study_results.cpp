#include "studies/kinds/study_results.hpp"

#include <algorithm>
#include <ctime>
#include <memory>
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

/// Rows of scenarios that were not run, made as they are gone through.
class RowsNotRun : public RowSource {
 public:
  RowsNotRun(ScenarioSet set, std::vector<std::uint64_t> ids) : set_(std::move(set)), ids_(std::move(ids)) {}

  [[nodiscard]] std::size_t size() const override { return ids_.size(); }

  [[nodiscard]] RowBlock block(std::size_t first) const override {
    auto rows = std::make_shared<std::vector<ScenarioRow>>();
    for (std::size_t at = first; at < std::min(ids_.size(), first + kRowsAtATime); ++at) rows->push_back(row(at));
    return {*rows, rows};
  }

  [[nodiscard]] ScenarioRow row(std::size_t place) const override {
    return {.id = ids_[place], .result = {}, .inputs = set_.inputs(ids_[place])};
  }

 private:
  const ScenarioSet set_;
  const std::vector<std::uint64_t> ids_;
};

}  // namespace

ResultsContent unfinished_content(const Study& study, const RunDirectory& run, std::vector<std::string> warnings) {
  ResultsContent content;
  content.meta = results_meta(study, std::move(warnings), ResultsState::unfinished);
  content.inputs = input_columns(study);
  content.places = row_places(study.kind());
  if (!has_fixed_scenarios(study.kind())) return content;
  ScenarioSet set = scenario_set(study);
  std::vector<std::uint64_t> missing;
  for (std::uint64_t id = 0; id < set.count; ++id) {
    if (!run.is_done(id)) missing.push_back(id);
  }
  if (!missing.empty()) content.stored = std::make_shared<const RowsNotRun>(std::move(set), std::move(missing));
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

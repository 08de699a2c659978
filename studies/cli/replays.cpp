#include "studies/cli/replays.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "core/motion/motion_plan.hpp"
#include "core/simulation/simulation.hpp"
#include "studies/cli/commands.hpp"
#include "studies/cli/interrupt.hpp"
#include "studies/estimate/cost_estimate.hpp"
#include "studies/execution/arm_run.hpp"
#include "studies/execution/lone_run.hpp"
#include "studies/findings/replay_choice.hpp"
#include "studies/kinds/kind_table.hpp"
#include "studies/report/page_rows.hpp"
#include "studies/scenarios/scenario_set.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

/// Replays that nobody asked for take no longer than this, by the estimate of `check`.
constexpr double kLongest_s = 60.0;
constexpr double kTraceRows = 600.0;

struct Planned {
  ChosenReplay chosen;
  Scenario scenario;
};

StudyOrError study_of(const RecordedStudy& recorded) {
  return read_study_text(recorded.meta.config_toml, "config.toml", {}, directory_of(recorded), {});
}

std::optional<Scenario> scenario_of(const Study& study, const RecordedStudy& recorded, std::uint64_t id) {
  if (has_fixed_scenarios(study.kind())) {
    const ScenarioSet set = scenario_set(study);
    return id < set.count ? std::optional(set.scenario(id)) : std::nullopt;
  }
  const std::optional<ScenarioRow> row = recorded_row(recorded, id);
  return row ? scenario_of_row(study, *row) : std::nullopt;
}

double estimated_seconds(const std::vector<Planned>& planned) {
  double longest_s = 0.0;
  std::map<std::string, double> of_key;
  for (const Planned& each : planned) {
    const double lanes = static_cast<double>(core_simulator().lane_count());
    const double alone_s =
        lanes * estimated_steps(each.scenario) * estimated_lane_step_s(each.scenario, model_size(each.scenario));
    double& group_s = of_key[core_simulator().factor_key(each.scenario)];
    group_s = std::max(group_s, alone_s);
  }
  for (const auto& [key, seconds] : of_key) longest_s += seconds;
  return longest_s;
}

/// Scenarios of one factor key beside each other. @return nothing when interrupted
std::optional<std::vector<ScenarioReplay>> run_group(const std::vector<Planned>& group) {
  std::vector<ScenarioReplay> seen(group.size());
  std::vector<Scenario> scenarios;
  std::vector<Recording> kept;
  for (std::size_t i = 0; i < group.size(); ++i) {
    seen[i].id = group[i].chosen.id;
    seen[i].why = group[i].chosen.why;
    seen[i].stage = replay_stage(group[i].scenario);
    seen[i].trace.keeps_motion = false;
    scenarios.push_back(thinned_for_replay(group[i].scenario));
    kept.emplace_back(&seen[i].trace, &seen[i].replay, replay_interval_s(group[i].scenario));
  }
  const auto results = run_side_by_side(core_simulator(), scenarios, kept, &interrupt_requested());
  if (!results) return std::nullopt;
  for (std::size_t i = 0; i < group.size(); ++i) {
    seen[i].result = (*results)[i];
    seen[i].arm_m = arm_links_m(group[i].scenario, seen[i].result, seen[i].replay.time_s);
  }
  return seen;
}

bool is_as_recorded(const RecordedStudy& recorded, const ScenarioReplay& seen) {
  const std::optional<ScenarioRow> row = recorded_row(recorded, seen.id);
  const bool same = !row || row->result.outcome == Outcome::not_run || row->result.outcome == seen.result.outcome;
  if (!same) {
    print_note(
        joined({"scenario ", std::to_string(seen.id), " is not shown: it was ", outcome_word(row->result.outcome),
                ", and this build runs it to ", outcome_word(seen.result.outcome)}));
  }
  return same;
}

}  // namespace

double replay_interval_s(const Scenario& scenario) {
  const double duration_s = planned_end_s(scenario);
  return std::max(duration_s / 130.0, std::min(0.025, duration_s / 40.0));
}

Scenario thinned_for_replay(Scenario scenario) {
  SimulationParameters& simulation = scenario.simulation;
  const double every = std::max(1.0, std::ceil(estimated_steps(scenario) / kTraceRows));
  simulation.trace_interval_s = every * simulation.time_step_s;
  return scenario;
}

std::optional<Scenario> recorded_scenario(const RecordedStudy& recorded, std::uint64_t id) {
  const StudyOrError study = study_of(recorded);
  return study ? scenario_of(*study, recorded, id) : std::nullopt;
}

std::optional<ScenarioReplay> replay_of(const RecordedStudy& recorded, std::uint64_t id) {
  std::optional<Scenario> scenario = recorded_scenario(recorded, id);
  if (!scenario) return std::nullopt;
  auto seen = run_group({{{id, "asked for"}, *std::move(scenario)}});
  if (!seen || seen->front().replay.frame_count() == 0) return std::nullopt;
  return std::move(seen->front());
}

std::vector<ScenarioReplay> replays_of(const RecordedStudy& recorded, const std::vector<std::uint64_t>& asked) {
  const StudyOrError study = study_of(recorded);
  if (!study) return {};
  std::vector<Planned> planned;
  for (ChosenReplay& chosen :
       chosen_replays(recorded.tables.inputs, page_rows(recorded.tables.rows, asked), asked)) {
    std::optional<Scenario> scenario = scenario_of(*study, recorded, chosen.id);
    if (scenario) planned.push_back({chosen, *std::move(scenario)});
  }
  const double seconds = estimated_seconds(planned);
  if (asked.empty() && seconds > kLongest_s) {
    print_note(joined({"nothing is shown in motion: running ", std::to_string(planned.size()),
                       " scenarios again would take about ", duration_text(seconds),
                       "; `unbruised report --scenario ID` shows one"}));
    return {};
  }
  std::map<std::string, std::vector<Planned>> groups;
  for (const Planned& each : planned) {
    std::vector<Planned>& group = groups[core_simulator().factor_key(each.scenario)];
    if (group.size() < static_cast<std::size_t>(core_simulator().lane_count())) group.push_back(each);
  }
  std::vector<ScenarioReplay> all;
  for (const auto& [key, group] : groups) {
    auto seen = run_group(group);
    if (!seen) return {};
    for (ScenarioReplay& each : *seen) {
      if (each.replay.frame_count() > 0 && is_as_recorded(recorded, each)) all.push_back(std::move(each));
    }
  }
  const auto place = [&](const ScenarioReplay& seen) {
    return std::find_if(planned.begin(), planned.end(),
                        [&](const Planned& each) { return each.chosen.id == seen.id; });
  };
  std::sort(all.begin(), all.end(),
            [&](const ScenarioReplay& a, const ScenarioReplay& b) { return place(a) < place(b); });
  return all;
}

}  // namespace unbruised::studies

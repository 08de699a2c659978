#include "studies/kinds/scenario_families.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "studies/kinds/calibrate_kind.hpp"
#include "studies/kinds/search_study.hpp"
#include "studies/kinds/set_kinds.hpp"
#include "studies/kinds/window_findings.hpp"
#include "studies/kinds/window_kind.hpp"
#include "studies/kinds/window_run.hpp"
#include "studies/kinds/window_search.hpp"

namespace unbruised::studies {
namespace {

// -- Known beforehand. -------------------------------------------------------------------------------------------

std::vector<ColumnInfo> set_columns(const Study& study) { return scenario_set(study).columns; }

std::optional<Scenario> scenario_of_set(const Study& study, const ScenarioRow& row) {
  const ScenarioSet set = scenario_set(study);
  if (row.id >= set.count) return std::nullopt;
  return set.scenario(row.id);
}

constexpr StudyParts kScenarioParts = {"scenario", run_scenarios, missing_scenarios};

Evaluations once(const Study& /*study*/, const std::vector<std::size_t>& /*group_of*/) { return {}; }

// -- Forces at every point of a grid. ----------------------------------------------------------------------------

constexpr StudyParts kCombinationParts = {"combination", run_combinations, missing_combinations};

/// Combinations of a window study whose search is rehearsed; more are scaled up.
constexpr std::size_t kRehearsedCombinations = 1000;
/// Two forces at either end of the window that answers a window study, at half the time step: twice the steps.
constexpr double kHalfStepEvaluations = 8.0;

std::vector<ColumnInfo> force_columns(const Study& study) {
  std::vector<ColumnInfo> columns = scenario_set(study).columns;
  add_window_columns(study, columns);
  return columns;
}

std::optional<Scenario> scenario_of_force(const Study& study, const ScenarioRow& row) {
  return scenario_of_window_inputs(study, row.inputs);
}

/// Evaluations of a window study, from a rehearsal with made-up ends inside the range.
Evaluations rehearsed_evaluations(const Study& study, const std::vector<std::size_t>& group_of) {
  const WindowSettings& range = study.window();
  WindowSearchSettings settings = window_search_settings(study, searched_combinations(group_of));
  const std::size_t count = std::min(group_of.size(), kRehearsedCombinations);
  settings.combinations.resize(count);
  const double ratio = range.to_N / range.from_N;
  const double hold_N = range.from_N * std::pow(ratio, 0.37);
  const double damage_N = range.from_N * std::pow(ratio, 0.71);
  double rounds = 1.0;  // the look at half the step
  const ForceEvaluator rehearse = [&](const std::vector<ForceRequest>& requests) {
    rounds += 1.0;
    std::vector<GripSample> answers;
    for (const ForceRequest& request : requests) {
      answers.push_back({.grip_force_N = request.grip_force_N,
                         .holds = request.grip_force_N >= hold_N ? Verdict::yes : Verdict::no,
                         .undamaged = request.grip_force_N <= damage_N ? Verdict::yes : Verdict::no});
    }
    return std::optional(std::move(answers));
  };
  const auto asked = static_cast<double>(search_windows(settings, rehearse).evaluation_count);
  return {.each = asked / static_cast<double>(count) + kHalfStepEvaluations / static_cast<double>(group_of.size()),
          .rounds = rounds};
}

// -- Questions of searches. --------------------------------------------------------------------------------------

/// Products of a search that are looked at to guess what the others are like.
constexpr std::size_t kProbedProducts = 64;

std::optional<Scenario> scenario_of_question(const Study& study, const ScenarioRow& row) {
  return scenario_of_search_inputs(study, row.inputs);
}

ScenarioSet probes(const Study& study) { return search_probes(study, kProbedProducts); }

/// How many of them wait for others is not known beforehand.
Evaluations asked_questions(const Study& study, const std::vector<std::size_t>& group_of) {
  return {.each = static_cast<double>(evaluations_at_most(study)) / static_cast<double>(group_of.size())};
}

// -- Questions of fits. ------------------------------------------------------------------------------------------

/// All fits ask at the same time, most of all for the points of a gradient.
Evaluations asked_curves(const Study& study, const std::vector<std::size_t>& /*group_of*/) {
  const auto scenarios = static_cast<double>(curves_at_most(study));
  const auto together = static_cast<double>(study.calibrate().curves.size() * (2 * study.variables().size() + 1));
  return {.each = scenarios, .rounds = scenarios / together};
}

}  // namespace

const ScenarioFamily kFixedScenarios = {.count = ScenarioCount::exact,
                                        .columns = set_columns,
                                        .scenario_of_row = scenario_of_set,
                                        .known = scenario_set,
                                        .evaluations = once,
                                        .parts = &kScenarioParts};

const ScenarioFamily kAskedForces = {.count = ScenarioCount::about,
                                     .columns = force_columns,
                                     .scenario_of_row = scenario_of_force,
                                     .known = scenario_set,
                                     .evaluations = rehearsed_evaluations,
                                     .places = RowPlaces::forces,
                                     .parts = &kCombinationParts};

const ScenarioFamily kAskedQuestions = {.count = ScenarioCount::at_most,
                                        .columns = search_columns,
                                        .scenario_of_row = scenario_of_question,
                                        .known = probes,
                                        .evaluations = asked_questions,
                                        .places = RowPlaces::questions};

const ScenarioFamily kAskedCurves = {.count = ScenarioCount::at_most,
                                     .columns = fitted_columns,
                                     .scenario_of_row = scenario_of_fit,
                                     .known = first_of_fits,
                                     .evaluations = asked_curves};

}  // namespace unbruised::studies

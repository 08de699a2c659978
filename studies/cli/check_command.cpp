#include <algorithm>
#include <cmath>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/simulation/simulation.hpp"
#include "studies/cli/commands.hpp"
#include "studies/estimate/cost_estimate.hpp"
#include "studies/estimate/known_scenarios.hpp"
#include "studies/estimate/memory_need.hpp"
#include "studies/estimate/warnings.hpp"
#include "studies/findings/summary.hpp"
#include "studies/kinds/search_study.hpp"
#include "studies/kinds/window_search.hpp"
#include "studies/scenarios/scenario_set.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

/// Bytes of a row, in the journal and again in results.h5, beside its metrics and inputs.
constexpr double kRowBytesBesideColumns = 160.0;
/// Combinations of a window study whose search is rehearsed; more are scaled up.
constexpr std::size_t kRehearsedCombinations = 1000;

/// The scenarios of one factor key.
struct GroupCost {
  std::size_t first = 0;  ///< a scenario of the group
  std::size_t count = 0;
  double steps = 0.0;  ///< of all its scenarios
};

struct StudyCost {
  std::vector<GroupCost> groups;
  std::vector<std::size_t> group_of;  ///< of each point of the grid
  std::vector<ModelSize> sizes;       ///< of each group
  double longest_run_s = 0.0;
};

StudyCost cost_of(const ScenarioSet& set) {
  StudyCost cost;
  std::unordered_map<std::string, std::size_t> index_of;
  cost.group_of.reserve(set.count);
  for (std::size_t point = 0; point < set.count; ++point) {
    const Scenario scenario = set.scenario(point);
    const auto [place, is_new] = index_of.try_emplace(factor_key(scenario), cost.groups.size());
    if (is_new) {
      cost.groups.push_back({.first = point});
      cost.sizes.push_back(model_size(scenario));
    }
    GroupCost& group = cost.groups[place->second];
    ++group.count;
    group.steps += estimated_steps(scenario);
    cost.group_of.push_back(place->second);
    cost.longest_run_s = std::max(cost.longest_run_s, simulated_duration_s(scenario));
  }
  return cost;
}

/// Two forces at either end of the window that answers a window study, at half the time step: twice the steps.
constexpr double kHalfStepEvaluations = 8.0;

/// Evaluations per scenario known beforehand: of a window study from a rehearsal with made-up ends inside the
/// range.
double evaluations_per_known(const Study& study, const StudyCost& cost) {
  if (is_search(study.kind())) {
    return static_cast<double>(evaluations_at_most(study)) / static_cast<double>(cost.group_of.size());
  }
  if (study.kind() != StudyKind::window) return 1.0;
  const WindowSettings& range = study.window();
  const std::size_t count = std::min(cost.group_of.size(), kRehearsedCombinations);
  WindowSearchSettings settings{
      .from_N = range.from_N,
      .to_N = range.to_N,
      .tolerance = range.tolerance,
      .factor_group = {cost.group_of.begin(), cost.group_of.begin() + static_cast<std::ptrdiff_t>(count)}};
  const double ratio = range.to_N / range.from_N;
  const double hold_N = range.from_N * std::pow(ratio, 0.37);
  const double damage_N = range.from_N * std::pow(ratio, 0.71);
  const ForceEvaluator rehearse = [&](const std::vector<ForceRequest>& requests) {
    std::vector<GripSample> answers;
    for (const ForceRequest& request : requests) {
      answers.push_back({.grip_force_N = request.grip_force_N,
                         .holds = request.grip_force_N >= hold_N ? Verdict::yes : Verdict::no,
                         .undamaged = request.grip_force_N <= damage_N ? Verdict::yes : Verdict::no});
    }
    return std::optional(std::move(answers));
  };
  return static_cast<double>(search_windows(settings, rehearse).evaluation_count) / static_cast<double>(count) +
         kHalfStepEvaluations / static_cast<double>(cost.group_of.size());
}

double compute_seconds(const StudyCost& cost, double evaluations_each) {
  double seconds = 0.0;
  const double lanes = lane_count();
  for (std::size_t i = 0; i < cost.groups.size(); ++i) {
    const GroupCost& group = cost.groups[i];
    const double evaluations = evaluations_each * static_cast<double>(group.count);
    const double mean_steps = group.steps / static_cast<double>(group.count);
    // Lanes that stay empty cost as much as full ones.
    seconds += std::ceil(evaluations / lanes) * lanes * mean_steps * estimated_lane_step_s(cost.sizes[i]);
  }
  return seconds;
}

double memory_bytes(const StudyCost& cost, int threads) {
  std::vector<double> models;
  double lanes = 0.0;
  for (const ModelSize& size : cost.sizes) {
    models.push_back(estimated_model_bytes(size));
    lanes = std::max(lanes, estimated_lane_bytes(size));
  }
  std::sort(models.begin(), models.end(), std::greater<>());
  models.resize(std::min(models.size(), static_cast<std::size_t>(threads)));
  double bytes = static_cast<double>(threads) * lane_count() * lanes;
  for (const double model : models) bytes += model;
  return bytes;
}

double disk_bytes(const Study& study, const StudyCost& cost, std::size_t inputs, double evaluations) {
  const double columns = static_cast<double>(kMetricCount + inputs + 1) * sizeof(double);
  double bytes = evaluations * 2.0 * (columns + kRowBytesBesideColumns);
  if (study.kind() == StudyKind::simulate && study.scenario_count() == 1) {
    constexpr double kTracedPerParticle = 9.0 * sizeof(double);  // displacement, velocity, acceleration
    const SimulationParameters& simulation = study.scenario(0).simulation;
    const double every = simulation.trace_interval_s.value_or(simulation.time_step_s) / simulation.time_step_s;
    bytes += cost.groups[0].steps / every * kTracedPerParticle * static_cast<double>(cost.sizes[0].particle_count);
  }
  return bytes;
}

void print_sizes(const StudyCost& cost) {
  const auto by_freedoms = [](const ModelSize& a, const ModelSize& b) {
    return a.freedom_count < b.freedom_count;
  };
  const auto [least, most] = std::minmax_element(cost.sizes.begin(), cost.sizes.end(), by_freedoms);
  const auto range = [](std::size_t low, std::size_t high) {
    return low == high ? with_thousands(low) : joined({with_thousands(low), " to ", with_thousands(high)});
  };
  print_line(joined({"groups by factor key: ", with_thousands(cost.groups.size())}));
  print_line(joined({"particles: ", range(least->particle_count, most->particle_count),
                     ", freedoms: ", range(least->freedom_count, most->freedom_count)}));
}

void print_contact(const Study& study) {
  const ContactSteps& fewest = study.fewest_contact_steps();
  if (study.is_time_step_chosen()) {
    print_line(joined({"time step: ", short_number(study.scenario(0).simulation.time_step_s),
                       " s, chosen by the shortest contact"}));
  }
  if (!std::isfinite(fewest.steps)) return;
  print_line(joined({"shortest contact: about ", duration_text(fewest.contact_s), ", ", short_number(fewest.steps),
                     " time steps"}));
}

}  // namespace

int check_command(const StudyArguments& arguments) {
  const std::optional<Study> study = read_or_explain(arguments);
  if (!study) return kExitInput;
  const int threads = thread_count_of(std::nullopt);
  if (const auto refusal = too_much_memory(*study, threads)) {
    print_error(*refusal);
    return kExitInput;
  }
  const ScenarioSet set = known_scenarios(*study);
  const StudyCost cost = cost_of(set);
  const double each = evaluations_per_known(*study, cost);
  const double evaluations = each * static_cast<double>(set.count);

  print_line(joined({study->name(), ": ", study_kind_word(study->kind()), ", valid"}));
  if (study->kind() == StudyKind::window) {
    print_line(joined({"combinations: ", with_thousands(study->scenario_count()), ", scenarios: about ",
                       with_thousands(static_cast<unsigned long long>(std::llround(evaluations)))}));
  } else if (is_search(study->kind())) {
    print_line(joined(
        {"scenarios: at most ", with_thousands(evaluations_at_most(*study)), ", checks of the best included"}));
  } else {
    print_line(joined({"scenarios: ", with_thousands(set.count)}));
  }
  print_sizes(cost);
  const double memory = memory_bytes(cost, threads) + estimated_rows_bytes(evaluations, set.columns.size());
  print_line(joined({"memory: about ", bytes_text(memory), " of ", bytes_text(machine_memory_bytes())}));
  print_line(joined({"disk: about ", bytes_text(disk_bytes(*study, cost, set.columns.size(), evaluations))}));
  const LaneStepRate rate = measured_lane_step_rate();
  print_line(joined({"time: about ", duration_text(compute_seconds(cost, each) / threads), " on ",
                     std::to_string(threads), threads == 1 ? " thread" : " threads", " (up to ",
                     duration_text(cost.longest_run_s), " simulated per scenario; steps x ",
                     short_number(1e9 * rate.seconds_per_factor_entry),
                     " ns per lane and entry of the factor as measured on ", rate.measured_on,
                     ", without factoring; expect a factor of two either way)"}));
  print_contact(*study);
  print_warnings(study_warnings(*study));
  const auto refusal = too_much_memory(study->name(), memory);
  if (refusal) print_error(*refusal);
  return refusal ? kExitInput : kExitDone;
}

}  // namespace unbruised::studies

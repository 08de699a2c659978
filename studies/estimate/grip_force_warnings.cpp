#include "studies/estimate/grip_force_warnings.hpp"

#include <algorithm>
#include <cmath>

#include "studies/config/execution_error.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/key_names.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

/// A force this near to a multiple of the step, in steps, is one.
constexpr double kOnStep = 1e-6;

const SearchVariable* searched_force(const Study& study) {
  const auto& all = study.variables();
  const auto found =
      std::find_if(all.begin(), all.end(), [](const SearchVariable& v) { return v.key == kGripForceKey; });
  return found == all.end() ? nullptr : &*found;
}

/// The forces that are written: swept, of the candidates, or the one.
std::vector<double> written_forces_N(const Study& study) {
  for (const InputColumn& input : study.inputs()) {
    if (input.key == kGripForceKey) return input.numbers;
  }
  std::vector<double> forces_N;
  for (const StrategyCandidate& candidate : study.candidates()) {
    forces_N.push_back(candidate.scenario.strategy.grip_force_N);
  }
  if (forces_N.empty()) forces_N.push_back(study.scenario(0).strategy.grip_force_N);
  return forces_N;
}

void warn_about_least_force(const Study& study, double least_N, std::vector<std::string>& warnings) {
  const SearchVariable* searched = searched_force(study);
  const std::vector<double> written_N = written_forces_N(study);
  const double asked_N =
      searched != nullptr ? searched->from : *std::min_element(written_N.begin(), written_N.end());
  if (asked_N >= least_N) return;
  warnings.push_back(joined({"grip forces down to ", short_number(asked_N),
                             " N are asked for, but the gripper holds no less than gripper.min_force_N = ",
                             short_number(least_N), ": what is said of smaller ones is not for this gripper"}));
}

void warn_about_steps(const Study& study, double step_N, std::vector<std::string>& warnings) {
  if (!(step_N > 0.0)) return;
  const std::string steps =
      joined({"the gripper sets its force in steps of gripper.force_step_N = ", short_number(step_N)});
  if (searched_force(study) != nullptr) {
    warnings.push_back(joined({steps, ", but the search sets any: round the force it finds, and check it again"}));
    return;
  }
  for (const double force_N : written_forces_N(study)) {
    const double in_steps = force_N / step_N;
    if (std::abs(in_steps - std::round(in_steps)) <= kOnStep) continue;
    warnings.push_back(joined({steps, ": ", short_number(force_N), " N cannot be set on it"}));
    return;
  }
}

bool scatters_force(const Study& study) {
  const auto& all = study.randoms();
  return std::any_of(all.begin(), all.end(),
                     [](const RandomVariable& random) { return key_behind(random.key) == kGripForceKey; });
}

void warn_about_accuracy(const Study& study, double accuracy, std::vector<std::string>& warnings) {
  if (!(accuracy > 0.0) || scatters_force(study)) return;
  const std::string given = joined({"gripper.force_accuracy = ", short_number(accuracy)});
  if (is_random(study.kind())) {
    warnings.push_back(joined({given,
                               ", but the study grips every product with exactly the force that is set; let it "
                               "scatter with [[random]] key = \"strategy.grip_force_N\", relative = ",
                               short_number(accuracy)}));
  } else if (is_search(study.kind())) {
    warnings.push_back(joined({given,
                               ", but the search takes the force as exact, and its best may lie at an edge; a "
                               "study of kind \"robust\" can let it scatter"}));
  }
}

}  // namespace

std::vector<std::string> grip_force_warnings(const Study& study) {
  std::vector<std::string> warnings;
  const Scenario scenario = study.scenario(0);
  const auto* jaw = parallel_jaw(scenario);
  if (jaw == nullptr || searches_force(study.kind())) return warnings;
  warn_about_least_force(study, jaw->min_force_N, warnings);
  warn_about_steps(study, jaw->force_step_N, warnings);
  warn_about_accuracy(study, jaw->force_accuracy, warnings);
  return warnings;
}

}  // namespace unbruised::studies

#include <cmath>
#include <string>
#include <vector>

#include "studies/cli/commands.hpp"
#include "studies/cli/json_output.hpp"
#include "studies/estimate/arm_lines.hpp"
#include "studies/estimate/cost_estimate.hpp"
#include "studies/estimate/layer_lines.hpp"
#include "studies/estimate/memory_need.hpp"
#include "studies/estimate/mode_lines.hpp"
#include "studies/estimate/study_cost.hpp"
#include "studies/estimate/warnings.hpp"
#include "studies/execution/machine.hpp"
#include "studies/findings/shown_probability.hpp"
#include "studies/kinds/kind_table.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

std::string range_text(std::size_t low, std::size_t high) {
  return low == high ? with_thousands(low) : joined({with_thousands(low), " to ", with_thousands(high)});
}

std::string scenarios_line(const Study& study, const StudyCost& cost) {
  const std::string count = with_thousands(static_cast<unsigned long long>(std::llround(cost.scenarios)));
  switch (runner_of(study.kind()).scenarios->count) {
    case ScenarioCount::about:
      return joined({"combinations: ", with_thousands(study.scenario_count()), ", scenarios: about ", count});
    case ScenarioCount::at_most:
      return joined(
          {"scenarios: at most ", count,
           fits_curves(study.kind()) ? ", those of intervals included" : ", checks of the best included"});
    case ScenarioCount::exact:
      break;
  }
  return joined({"scenarios: ", count});
}

std::string time_line(const StudyCost& cost) {
  return joined({"time: about ", duration_text(cost.seconds), " on ", std::to_string(cost.threads),
                 cost.threads == 1 ? " thread" : " threads", " (as measured on ",
                 measured_lane_step_rate().measured_on, "; yours may need half or twice that), up to ",
                 duration_text(cost.longest_run_s), " simulated per scenario"});
}

void print_contact(const Study& study) {
  const ContactSteps& fewest = study.fewest_contact_steps();
  if (study.is_time_step_chosen()) {
    print_line(joined({"time step: ", short_number(study.scenario(0).simulation.time_step_s),
                       " s, chosen by the shortest contact"}));
  }
  if (!std::isfinite(fewest.steps)) return;
  print_line(joined({"shortest contact: about ", duration_text(fewest.contact_s), ", ", three_digits(fewest.steps),
                     " time steps"}));
}

void print_check(const Study& study, const StudyCost& cost) {
  print_line(joined({study.name(), ": ", study_kind_word(study.kind()), ", valid"}));
  print_line(scenarios_line(study, cost));
  print_line(joined({"groups by factor key: ", with_thousands(cost.groups)}));
  print_line(joined({"particles: ", range_text(cost.least.particle_count, cost.most.particle_count),
                     ", freedoms: ", range_text(cost.least.freedom_count, cost.most.freedom_count)}));
  print_line(joined({"may touch: ", range_text(cost.least.contact_node_count, cost.most.contact_node_count),
                     " particles, whose compliance takes ", bytes_text(cost.most.compliance_bytes()), " of ",
                     bytes_text(kMostComplianceBytes), " at most"}));
  print_line(
      joined({"memory: about ", bytes_text(cost.memory_bytes), " of ", bytes_text(machine_memory_bytes())}));
  print_line(joined({"disk: about ", bytes_text(cost.disk_bytes)}));
  print_line(time_line(cost));
  print_contact(study);
  for (const std::string& line : arm_lines(study)) print_line(line);
  for (const std::string& line : layer_lines(study)) print_line(line);
  for (const std::string& line : mode_lines(study)) print_line(line);
}

/// Prints what is wrong with a study as one document.
int print_problems(const std::vector<std::string>& problems) {
  print_line(check_json_of_problems(problems));
  return kExitInput;
}

}  // namespace

int check_command(const StudyArguments& arguments, AnswerForm form) {
  const StudyOrError read = read_of(arguments);
  if (!read) {
    if (form == AnswerForm::json) return print_problems(read.error().messages);
    print_problems_of(arguments, read.error());
    return kExitInput;
  }
  const Study& study = *read;
  const int threads = thread_count_of(std::nullopt);
  if (const auto refusal = too_much_memory(study, threads)) {
    if (form == AnswerForm::json) return print_problems({*refusal});
    print_error(*refusal);
    return kExitInput;
  }
  const StudyCost cost = study_cost(study, threads);
  auto refusal = too_much_memory(study.name(), cost.memory_bytes);
  if (!refusal) refusal = too_many_may_touch(study.name(), cost.most);
  const std::vector<std::string> warnings = study_warnings(study);
  const std::vector<std::string> notes = probability_notes(study);
  if (form == AnswerForm::json) {
    print_line(check_json(study, cost, warnings, notes, refusal.value_or("")));
  } else {
    print_check(study, cost);
    for (const std::string& note : notes) print_line(joined({"note: ", note}));
    print_warnings(warnings);
    if (refusal) print_error(*refusal);
  }
  return refusal ? kExitInput : kExitDone;
}

}  // namespace unbruised::studies

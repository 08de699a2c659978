#include "studies/cli/submit_command.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <system_error>

#include <sys/wait.h>

#include "studies/cli/refusals.hpp"
#include "studies/estimate/study_cost.hpp"
#include "studies/results/durable_files.hpp"
#include "studies/scenarios/scenario_set.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

namespace fs = std::filesystem;

/// A task factors the matrices of its groups anew, so few long ones.
constexpr double kTaskSeconds = 3600.0;
/// MaxArraySize of a Slurm as it comes.
constexpr long kUsualArraySize = 1001;
/// Before its limit a task is told to stop, and stops within a step of its lanes.
constexpr int kWarnedBefore_s = 60;
constexpr long kCpusMost = 4096;

struct Jobs {
  fs::path program, study, directory, folder;
  std::string name;
  std::string sets;  ///< " --set ..." for a shell
  long tasks = 1;
};

std::string output_of(const std::string& command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(::popen(command.c_str(), "r"), ::pclose);
  std::string text;
  char buffer[4096];
  while (pipe && std::fgets(buffer, sizeof buffer, pipe.get()) != nullptr) text += buffer;
  return text;
}

std::string word(const fs::path& path) { return shell_word(path.string()); }

std::string option_lines(const SubmitArguments& arguments) {
  std::string lines = joined({"#SBATCH --cpus-per-task=", std::to_string(arguments.cpus), "\n"});
  if (!arguments.partition.empty()) lines += joined({"#SBATCH --partition=", arguments.partition, "\n"});
  return lines;
}

/// A task that is told of its limit lets what is in flight go and is put back into the queue; a task that was
/// killed with its node Slurm puts there itself. What was run stands in the journals.
std::string array_script(const SubmitArguments& arguments, const Jobs& jobs) {
  std::string text = joined({"#!/bin/bash\n#SBATCH --job-name=", jobs.name, "\n#SBATCH --array=1-",
                             std::to_string(jobs.tasks), "\n", option_lines(arguments)});
  if (!arguments.time.empty()) text += joined({"#SBATCH --time=", arguments.time, "\n"});
  text += joined({"#SBATCH --signal=B:TERM@", std::to_string(kWarnedBefore_s),
                  "\n#SBATCH --requeue\n#SBATCH --open-mode=append\n#SBATCH --output=\"",
                  (jobs.folder / "task_%a.log").string(), "\"\n\n"});
  text += joined({word(jobs.program), " run ", word(jobs.study),
                  " --quiet --threads \"$SLURM_CPUS_PER_TASK\" --output ", word(jobs.directory),
                  " --shard \"$SLURM_ARRAY_TASK_ID/", std::to_string(jobs.tasks), "\"", jobs.sets, " &\n"});
  text +=
      "child=$!\n"
      "trap 'stopping=yes; kill -TERM $child' TERM\n"
      "wait $child\n"
      "status=$?\n"
      "if [[ -n ${stopping-} ]]; then\n"
      "  wait $child\n"
      "  scontrol requeue \"${SLURM_ARRAY_JOB_ID}_$SLURM_ARRAY_TASK_ID\"\n"
      "fi\n"
      "exit $status\n";
  return text;
}

std::string merge_script(const SubmitArguments& arguments, const Jobs& jobs) {
  return joined({"#!/bin/bash\n#SBATCH --job-name=", jobs.name, "-merge\n", option_lines(arguments),
                 "#SBATCH --output=\"", (jobs.folder / "merge.log").string(), "\"\n\nexec ", word(jobs.program),
                 " merge ", word(jobs.directory), " --quiet --threads \"$SLURM_CPUS_PER_TASK\"\n"});
}

/// Hands both in: the second when all tasks of the first have ended, however they did.
std::string submit_script(const Jobs& jobs) {
  return joined({"#!/bin/bash\nset -euo pipefail\narray=$(sbatch --parsable ", word(jobs.folder / "array.sh"),
                 ")\nmerge=$(sbatch --parsable --dependency=\"afterany:${array%%;*}\" ",
                 word(jobs.folder / "merge.sh"), ")\necho \"jobs ${array%%;*} (", std::to_string(jobs.tasks),
                 jobs.tasks == 1 ? " task" : " tasks", ") and ${merge%%;*} (merge)\"\n"});
}

MaybeError write_scripts(const SubmitArguments& arguments, const Jobs& jobs) {
  std::error_code failed;
  fs::create_directories(jobs.folder, failed);
  if (failed) {
    return ResultsError{
        ResultsErrorKind::io, joined({"cannot create ", jobs.folder.string(), ": ", failed.message()}), {}};
  }
  if (auto error = write_text_file(jobs.folder / "array.sh", array_script(arguments, jobs))) return error;
  if (auto error = write_text_file(jobs.folder / "merge.sh", merge_script(arguments, jobs))) return error;
  if (auto error = write_text_file(jobs.folder / "submit.sh", submit_script(jobs))) return error;
  fs::permissions(jobs.folder / "submit.sh", fs::perms::owner_exec, fs::perm_options::add, failed);
  return {};
}

/// What is wrong with the numbers of the command line; empty: nothing.
std::string problem_of(const SubmitArguments& arguments, long most_tasks) {
  const auto out_of = [](const char* option, long value, long most) {
    return joined({option, " = ", std::to_string(value), ": must be 1 to ", std::to_string(most)});
  };
  if (!arguments.slurm) return "--slurm is missing: which batch system the jobs are for";
  if (arguments.cpus < 1 || arguments.cpus > kCpusMost) return out_of("--cpus", arguments.cpus, kCpusMost);
  if (arguments.tasks && (*arguments.tasks < 1 || *arguments.tasks > most_tasks)) {
    return out_of("--tasks", *arguments.tasks, most_tasks) + ", as Slurm says (MaxArraySize)";
  }
  const auto is_plain = [](const std::string& text) {
    return std::ranges::all_of(text, [](unsigned char c) {
      return std::isalnum(c) != 0 ||
             std::string_view("-_:,.").find(static_cast<char>(c)) != std::string_view::npos;
    });
  };
  if (!is_plain(arguments.time)) return joined({"--time ", arguments.time, ": must be a time as sbatch takes it"});
  if (!is_plain(arguments.partition)) return joined({"--partition ", arguments.partition, ": must be a name"});
  return {};
}

/// About an hour each on its cores, and never more than parts can have something of.
long usual_tasks(const Study& study, const StudyCost& cost, long cpus, long most) {
  const double hours = cost.seconds * cost.threads / static_cast<double>(cpus) / kTaskSeconds;
  const auto units = static_cast<double>(scenario_set(study).count);
  const double wanted = std::clamp(std::ceil(hours), 1.0, std::max(1.0, units));
  return std::min(static_cast<long>(wanted), most);
}

int hand_in(const Jobs& jobs) {
  std::cout.flush();
  const int status = std::system(word(jobs.folder / "submit.sh").c_str());
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return kExitDone;
  print_error(joined({"sbatch took none of the jobs; ", (jobs.folder / "submit.sh").string(), " tries again"}));
  return exit_status(ResultsErrorKind::io);
}

}  // namespace

long largest_array_task(const std::string& scontrol_config) {
  const std::size_t line = scontrol_config.find("MaxArraySize");
  const std::size_t equals = line == std::string::npos ? line : scontrol_config.find('=', line);
  const long size =
      equals == std::string::npos ? 0 : std::strtol(scontrol_config.c_str() + equals + 1, nullptr, 10);
  return (size > 1 ? size : kUsualArraySize) - 1;
}

int submit_command(const SubmitArguments& arguments) {
  const std::string config = output_of("scontrol show config 2>/dev/null");
  const long most_tasks = largest_array_task(config);
  if (const std::string problem = problem_of(arguments, most_tasks); !problem.empty()) {
    print_error(problem);
    return kExitInput;
  }
  const std::optional<Study> study = read_or_explain(arguments.study);
  if (!study) return kExitInput;
  if (const auto refusal = has_no_parts(*study)) {
    print_error(*refusal);
    return kExitInput;
  }
  const StudyCost cost = study_cost(*study, static_cast<int>(arguments.cpus));
  if (!may_run(*study, cost, static_cast<int>(arguments.cpus))) return kExitInput;
  std::error_code error;
  Jobs jobs;
  jobs.program = fs::read_symlink("/proc/self/exe", error);
  jobs.study = fs::absolute(arguments.study.study, error).lexically_normal();
  jobs.directory = fs::absolute(run_directory_of(*study, arguments.output), error).lexically_normal();
  jobs.folder = jobs.directory.string() + ".slurm";
  jobs.name = joined({"unbruised-", study->name()});
  jobs.tasks = arguments.tasks.value_or(usual_tasks(*study, cost, arguments.cpus, most_tasks));
  for (const std::string& set : arguments.study.sets) jobs.sets += joined({" --set ", shell_word(set)});
  if (auto failed = write_scripts(arguments, jobs)) return report_error(*failed);
  print_line(joined({study->name(), ": ", std::to_string(jobs.tasks), jobs.tasks == 1 ? " task of " : " tasks of ",
                     std::to_string(arguments.cpus), arguments.cpus == 1 ? " core" : " cores", ", each about ",
                     duration_text(std::max(
                         1.0, cost.seconds * cost.threads / static_cast<double>(arguments.cpus * jobs.tasks)))}));
  if (config.empty()) print_note("no scontrol here: the limits are those of a Slurm as it comes");
  for (const char* script : {"array.sh", "merge.sh", "submit.sh"})
    print_line(joined({"wrote ", (jobs.folder / script).string()}));
  if (arguments.now) return hand_in(jobs);
  print_note("hand them in with");
  std::cerr << joined({"  ", word(jobs.folder / "submit.sh"), "\n"});
  return kExitDone;
}

}  // namespace unbruised::studies

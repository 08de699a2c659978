#include "studies/cli/command_options.hpp"

#include <CLI/CLI.hpp>

namespace unbruised::studies {

void add_options(CLI::App& to, ExportArguments& arguments) {
  to.add_option("--format", arguments.format,
                "csv (default); vtkhdf: one scenario in motion, for ParaView; for a controller joint_trajectory "
                "(ROS), urscript, rapid, krl")
      ->type_name("FORMAT");
  to.add_option(
        "--table", arguments.table,
        "scenarios (default), window, best, pareto, ... as `info --json` lists them; path: palm, joints and "
        "gripper over time")
      ->type_name("NAME");
  to.add_option("--joint-names", arguments.joint_names, "of a joint_trajectory, in the order of the arm's joints")
      ->type_name("NAME,...")
      ->delimiter(',');
}

void add_options(CLI::App& to, NewArguments& arguments) {
  to.add_option("--kind", arguments.kind, "window, sweep, optimize, robust, ...")->type_name("KIND")->required();
  to.add_option("--product", arguments.product, "as `use` takes it: unbruised list")
      ->type_name("FILE")
      ->required();
  to.add_option("--gripper", arguments.gripper, "as `use` takes it")->type_name("FILE")->required();
}

void add_options(CLI::App& to, SubmitArguments& arguments) {
  to.add_flag("--slurm", arguments.slurm, "for Slurm, the only one so far");
  to.add_option("--tasks", arguments.tasks, "tasks of the array (default: of about an hour each)")->type_name("N");
  to.add_option("--cpus", arguments.cpus, "cores of a task (default: 8)")->type_name("N");
  to.add_option("--time", arguments.time, "limit of a task, as sbatch takes it; it is run on after it")
      ->type_name("TIME");
  to.add_option("--partition", arguments.partition, "as sbatch takes it")->type_name("NAME");
  to.add_flag("--now", arguments.now, "hand the jobs in, do not only write them");
}

}  // namespace unbruised::studies

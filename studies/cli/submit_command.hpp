#pragma once

/// @file
/// `submit`: the jobs of a study for a batch system, as scripts.

#include <filesystem>
#include <optional>
#include <string>

#include "studies/cli/commands.hpp"

namespace unbruised::studies {

struct SubmitArguments {
  StudyArguments study{};
  std::optional<std::filesystem::path> output{};  ///< run directory
  bool slurm = false;
  std::optional<long> tasks{};
  long cpus = 8;
  std::string time{};
  std::string partition{};
  bool now = false;
};
/// Writes array.sh, merge.sh and submit.sh into `<run directory>.slurm`, and with `now` calls the last.
int submit_command(const SubmitArguments& arguments);

/// Largest number of an array's task that Slurm takes here: MaxArraySize - 1 of `scontrol show config`, or of a
/// Slurm as it comes where there is none.
long largest_array_task(const std::string& scontrol_config);

}  // namespace unbruised::studies

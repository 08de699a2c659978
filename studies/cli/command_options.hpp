#pragma once

/// @file
/// The options of commands that have many of their own.

#include "studies/cli/commands.hpp"
#include "studies/cli/submit_command.hpp"

namespace CLI {
class App;
}

namespace unbruised::studies {

/// What is given goes into the arguments, which must outlive the command.
void add_options(CLI::App& to, ExportArguments& arguments);
void add_options(CLI::App& to, NewArguments& arguments);
void add_options(CLI::App& to, SubmitArguments& arguments);

}  // namespace unbruised::studies

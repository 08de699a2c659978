#pragma once

/// @file
/// The command line: words in, one command called, its exit status out.

#include <string>
#include <vector>

namespace unbruised::studies {

/// Runs the program. Results go to stdout, messages and progress to stderr.
/// @param words the program's name first.
/// @return 0 done; 1 internal error; 2 the input is wrong; 3 finished with diverged scenarios; 4 run directory in
///   use; 5 disk or file failure; 6 results damaged; 130/143 interrupted.
int run_program(const std::vector<std::string>& words);

}  // namespace unbruised::studies

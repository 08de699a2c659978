#pragma once

/// @file
/// Which program wrote a result: version, compiler, instruction set.

#include <string>

namespace unbruised::studies {

std::string program_version();  ///< "0.1.0"
std::string compiler_text();    ///< "GNU 12.2.0"
std::string instruction_set();  ///< widest vector set the kernels were compiled for: "avx512f", "avx2", ...
std::string build_line();       ///< all of them in one line

}  // namespace unbruised::studies

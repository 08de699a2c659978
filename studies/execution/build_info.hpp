#pragma once

/// @file
/// Which program wrote a result: its version, and the numeric build, which is what the bits depend on.

#include <string>

namespace unbruised::studies {

std::string program_version();  ///< "0.1.0"
std::string compiler_text();    ///< "GNU 12.2.0"
/// What decides the bits beside the instruction set, "GNU 12.2.0 -O3 -ffp-contract=off, glibc 2.36 with fma,
/// CHOLMOD 3.0.14": glibc's libm and its choice of code for this CPU are those of the machine that runs the
/// program.
std::string compiler_and_libraries();
std::string instruction_set();  ///< widest vector set the kernels were compiled for: "avx512f", "avx2", ...
/// The numeric build in one line: builds with the same line give the same bits.
std::string numeric_build();
std::string build_line();  ///< program, version and numeric build in one line

}  // namespace unbruised::studies

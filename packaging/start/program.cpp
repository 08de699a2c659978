// What the library of an instruction set shows of the program.

#include "studies/cli/command_line.hpp"

extern "C" __attribute__((visibility("default"))) int unbruised_program(int argc, char** argv) {
  return unbruised::studies::run_program({argv, argv + argc});
}

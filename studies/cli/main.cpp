#include "studies/cli/command_line.hpp"

int main(int argc, char** argv) { return unbruised::studies::run_program({argv, argv + argc}); }

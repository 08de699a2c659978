#include "too_old.hpp"

#include <cstdio>

extern "C" int unbruised_program(int, char**) {
  std::fprintf(stderr, "unbruised: %s\n", kTooOld);
  return 1;
}

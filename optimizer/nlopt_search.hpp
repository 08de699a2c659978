#pragma once

/// @file
/// What the return codes of NLopt mean for a search; the rest of NLopt stays in nlopt_search.cpp.

#include <string>

#include "optimizer/search.hpp"

namespace unbruised::optimizer {

struct Ending {
  Termination termination;
  std::string sentence;
};

/// @param nlopt_result 1 to 6 or -1 to -5; what is none of them counts as a failure
Ending ending_of(int nlopt_result);

}  // namespace unbruised::optimizer

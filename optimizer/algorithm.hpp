#pragma once

/// @file
/// The NLopt algorithms that make sense here, by name, and what each can take.

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace unbruised::optimizer {

enum class Algorithm {
  cobyla,
  bobyqa,
  sbplx,
  neldermead,
  direct_l,
  crs2_lm,
  isres,
  esch,
  mlsl,
  auglag,
  slsqp,
  mma,
  ccsaq,
};

/// One row of the table.
struct AlgorithmInfo {
  Algorithm algorithm;
  std::string_view name;     ///< "COBYLA", as in configs
  std::string_view meaning;  ///< one line
  bool is_global;
  bool uses_gradient;      ///< asks for lockstep finite differences
  bool takes_constraints;  ///< c(x) <= 0
  bool needs_local;        ///< runs a second algorithm inside (MLSL, AUGLAG)
  bool is_random;          ///< its path depends on the seed
};

std::span<const AlgorithmInfo> algorithm_table();
const AlgorithmInfo& info_of(Algorithm algorithm);
std::optional<Algorithm> algorithm_named(std::string_view name);

/// What MLSL and AUGLAG run inside when nothing else is asked for: BOBYQA, with one variable SBPLX.
Algorithm default_local(std::size_t variable_count);

/// Why a problem of this kind cannot be given to the algorithm, and which ones can take it; empty: it can.
/// @param local the algorithm inside MLSL or AUGLAG; none: default_local
std::string why_unsuitable(Algorithm algorithm, std::optional<Algorithm> local, std::size_t variable_count,
                           std::size_t constraint_count);

}  // namespace unbruised::optimizer

#include "optimizer/algorithm.hpp"

#include <array>
#include <utility>

namespace unbruised::optimizer {
namespace {

constexpr std::array<AlgorithmInfo, 13> kTable = {{
    {Algorithm::cobyla, "COBYLA", "local, linear models, takes constraints (Powell 1994)", false, false, true,
     false, false},
    {Algorithm::bobyqa, "BOBYQA", "local, quadratic models (Powell 2009)", false, false, false, false, false},
    {Algorithm::sbplx, "SBPLX", "local, simplex on subspaces (Rowan 1990)", false, false, false, false, false},
    {Algorithm::neldermead, "NELDERMEAD", "local, simplex (Nelder and Mead 1965)", false, false, false, false,
     false},
    {Algorithm::direct_l, "DIRECT_L", "global, dividing rectangles (Gablonsky 2001)", true, false, false, false,
     false},
    {Algorithm::crs2_lm, "CRS2_LM", "global, controlled random search (Kaelo and Ali 2006)", true, false, false,
     false, true},
    {Algorithm::isres, "ISRES", "global, evolution strategy, takes constraints (Runarsson and Yao 2005)", true,
     false, true, false, true},
    {Algorithm::esch, "ESCH", "global, evolutionary (da Silva Santos 2010)", true, false, false, false, true},
    {Algorithm::mlsl, "MLSL", "global, multistart of a local algorithm (Kan and Timmer 1987)", true, false, false,
     true, false},
    {Algorithm::auglag, "AUGLAG", "augmented Lagrangian around a local algorithm, takes constraints (Birgin 2008)",
     false, false, true, true, false},
    {Algorithm::slsqp, "SLSQP", "local, sequential quadratic programming, takes constraints (Kraft 1994)", false,
     true, true, false, false},
    {Algorithm::mma, "MMA", "local, moving asymptotes, takes constraints (Svanberg 2002)", false, true, true,
     false, false},
    {Algorithm::ccsaq, "CCSAQ", "local, conservative quadratic models, takes constraints (Svanberg 2002)", false,
     true, true, false, false},
}};

/// "COBYLA, ISRES and SLSQP" of those for which `can` holds.
template <class Can>
std::string names_of(Can can) {
  std::string text;
  std::string last;
  for (const AlgorithmInfo& info : kTable) {
    if (!can(info)) continue;
    if (!last.empty()) text += (text.empty() ? "" : ", ") + last;
    last = info.name;
  }
  return text.empty() ? last : text + " and " + last;
}

std::string name(Algorithm algorithm) { return std::string(info_of(algorithm).name); }

bool can_be_inside(const AlgorithmInfo& info) { return !info.is_global && !info.needs_local; }

}  // namespace

std::span<const AlgorithmInfo> algorithm_table() { return kTable; }

const AlgorithmInfo& info_of(Algorithm algorithm) { return kTable[static_cast<std::size_t>(algorithm)]; }

std::optional<Algorithm> algorithm_named(std::string_view name) {
  for (const AlgorithmInfo& info : kTable) {
    if (info.name == name) return info.algorithm;
  }
  return std::nullopt;
}

Algorithm default_local(std::size_t variable_count) {
  return variable_count < 2 ? Algorithm::sbplx : Algorithm::bobyqa;
}

std::string why_unsuitable(Algorithm algorithm, std::optional<Algorithm> local, std::size_t variable_count,
                           std::size_t constraint_count) {
  const AlgorithmInfo& info = info_of(algorithm);
  if (variable_count == 0) return "there is no variable to search over";
  if (constraint_count > 0 && !info.takes_constraints) {
    return name(algorithm) + " cannot take constraints; " +
           names_of([](const AlgorithmInfo& other) { return other.takes_constraints; }) + " can";
  }
  if (local && !info.needs_local) {
    return name(algorithm) + " runs no local algorithm; " +
           names_of([](const AlgorithmInfo& other) { return other.needs_local; }) + " do";
  }
  if (local && !can_be_inside(info_of(*local))) {
    return name(*local) + " cannot run inside " + name(algorithm) + "; " + names_of(can_be_inside) + " can";
  }
  const bool uses_bobyqa = algorithm == Algorithm::bobyqa || local == Algorithm::bobyqa;
  if (uses_bobyqa && variable_count < 2) {
    return "BOBYQA needs at least two variables; " + names_of([](const AlgorithmInfo& other) {
             return can_be_inside(other) && other.algorithm != Algorithm::bobyqa;
           }) +
           " take one";
  }
  return "";
}

}  // namespace unbruised::optimizer

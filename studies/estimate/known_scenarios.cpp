#include "studies/estimate/known_scenarios.hpp"

#include "studies/kinds/search_study.hpp"

namespace unbruised::studies {
namespace {

/// Products of a search that are looked at to guess what the others are like.
constexpr std::size_t kProbedProducts = 64;

}  // namespace

ScenarioSet known_scenarios(const Study& study) {
  return is_search(study.kind()) ? search_probes(study, kProbedProducts) : scenario_set(study);
}

}  // namespace unbruised::studies

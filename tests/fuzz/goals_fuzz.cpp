// Objectives, constraints and metric names as they stand in a config. The first byte chooses the context and what
// is read.

#include <array>
#include <cmath>
#include <string>
#include <variant>

#include "studies/goals/goal.hpp"
#include "tests/fuzz/fuzz.hpp"

namespace {

using namespace unbruised;
using namespace unbruised::studies;
using unbruised::fuzz::require;

/// A scenario that was held, and one that diverged before most metrics existed.
const std::array<ScenarioResult, 2>& results() {
  static const std::array<ScenarioResult, 2> both = [] {
    std::array<ScenarioResult, 2> out;
    out[0].outcome = Outcome::held;
    for (double& value : out[0].metrics.values()) value = 0.5;
    out[1].outcome = Outcome::diverged;
    return out;
  }();
  return both;
}

void use(const Objective& goal, GoalContext context) {
  require(!goal.terms.empty(), "an objective has a term");
  const auto again = parse_objective(goal.text, context);
  require(again.has_value(), "the text of an objective is one");
  require(again->terms.size() == goal.terms.size(), "the text of an objective is the same one");
  (void)(context == GoalContext::single ? objective_value(goal, results()[0]) : objective_value(goal, results()));
}

void use(const Constraint& goal, GoalContext context) {
  require(parse_constraint(goal.text, context).has_value(), "the text of a constraint is one");
  const LimitParameters limits;
  if (context == GoalContext::sampled) {
    require(std::isfinite(violation(goal, results(), limits)), "a violation over products is finite");
    return;
  }
  for (const ScenarioResult& result : results()) {
    const auto components = violations(goal, result, limits);
    require(components.size() == violation_names(goal, limits).size(), "each component has a name");
    for (const double component : components) require(std::isfinite(component), "a violation is finite");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const auto context = (data[0] & 1U) != 0 ? GoalContext::sampled : GoalContext::single;
  const std::string_view text = unbruised::fuzz::text_of(data + 1, size - 1);
  switch (data[0] / 2 % 3) {
    case 0: {
      const auto objective = parse_objective(text, context);
      if (objective) use(*objective, context);
      break;
    }
    case 1: {
      const auto constraint = parse_constraint(text, context);
      if (constraint) use(*constraint, context);
      break;
    }
    default:
      (void)parse_metric(text);
  }
  return 0;
}

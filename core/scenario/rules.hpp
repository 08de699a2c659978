#pragma once

/// @file
/// The one table of rules between the numbers of a scenario. `validate` walks it, and so does the config reader,
/// which adds where each value came from. Ranges of single numbers stand in fields.hpp.

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/scenario/scenario.hpp"

namespace unbruised {

/// A rule that does not hold.
struct Violation {
  std::string field;  ///< dotted, e.g. "product.size_m[0]"
  std::string value;  ///< what it is, as text; may be empty
  std::string rule;   ///< "must be <= gripper.max_force_N = 100.0"
};
using Violations = std::vector<Violation>;

struct Rule {
  /// Paths of everything the rule looks at, as in number_fields.hpp or of a choice; the first is the one to blame.
  /// Two scenarios that agree in all of them keep or break it together.
  std::vector<std::string_view> fields;
  /// The rule as it stands behind the name of the first field: "<= gripper.max_force_N".
  std::string_view sentence;
  /// Appends what is broken. Every number has to lie in its range.
  std::function<void(const Scenario&, Violations&)> check;
  /// The same behind the name of the second field, where that is worth saying: "goes with tangent_modulus_Pa".
  std::string_view of_second = {};
};

/// All rules, in the order of the parameters. Each is checked for every scenario.
const std::vector<Rule>& scenario_rules();

/// All rules that `scenario` breaks: the ranges of its numbers, and where they all hold the rules between them.
/// Empty: `Model::build` can build it.
Violations validate(const Scenario& scenario);

}  // namespace unbruised

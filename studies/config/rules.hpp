#pragma once

/// @file
/// Rules between several values of one scenario.

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "studies/config/schema.hpp"

namespace unbruised::studies {

/// A rule that does not hold: the key to blame, its value as text (may be empty), and the rule.
struct Broken {
  std::string key;
  std::string value;
  std::string rule;
};

/// A rule and the keys it looks at; a scenario needs checking only if it differs in one of them.
struct CrossRule {
  std::vector<std::string_view> keys;  ///< patterns; a varied element counts as its array
  std::optional<Broken> (*broken)(const Scenario&, const StudySettings&);
};

const std::vector<CrossRule>& cross_rules();

/// All broken rules of a network's lists.
std::vector<Broken> broken_network_rules(const NetworkParameters& network);

/// Allowed, but probably not meant.
std::vector<std::string> doubts(const Scenario& scenario);

}  // namespace unbruised::studies

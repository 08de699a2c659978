#pragma once

/// @file
/// The rules that the scenarios of a study keep: those of core/scenario/rules.hpp, and those between a study's own
/// settings.

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/scenario/rules.hpp"
#include "studies/config/schema.hpp"

namespace unbruised::studies {

/// A rule and the keys it looks at; a scenario needs checking only if it differs in one of them.
struct StudyRule {
  std::vector<std::string_view> fields;  ///< patterns; a varied element counts as its array
  std::function<void(const Scenario&, const StudySettings&, Violations&)> check;
};

/// All of them. Of a window study the rules about the grip force are checked at both ends of the window.
const std::vector<StudyRule>& study_rules();

}  // namespace unbruised::studies

#pragma once

/// @file
/// How many time steps the shortest contact of a study gets.

#include <limits>
#include <string>

#include "studies/config/study.hpp"

namespace unbruised::studies {

/// A contact that closes and opens again within fewer steps is not resolved (docs/theory.md, "Contact").
inline constexpr double kStepsPerContact = 20.0;

/// The contact that gets the fewest time steps.
struct ContactSteps {
  double steps = std::numeric_limits<double>::infinity();  ///< infinite: the study has no such contact
  double contact_s = std::numeric_limits<double>::infinity();
  std::string where;  ///< its varied keys and values; may be empty
};

ContactSteps fewest_contact_steps(const Study& study);

}  // namespace unbruised::studies

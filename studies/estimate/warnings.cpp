#include "studies/estimate/warnings.hpp"

#include <algorithm>
#include <cmath>

#include "studies/estimate/contact_steps.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

void warn_about_contact(const Study& study, std::vector<std::string>& warnings) {
  const ContactSteps fewest = fewest_contact_steps(study);
  if (!(fewest.steps < kStepsPerContact)) return;
  warnings.push_back(
      joined({"the fingers' contact with the product lasts ", short_number(fewest.steps), " time steps",
              fewest.where.empty() ? "" : " at ", fewest.where, ", and ", short_number(kStepsPerContact),
              " are needed to resolve it: peak forces and damage are wrong there, and F_damage may come out too "
              "high; use "
              "simulation.time_step_s <= ",
              short_number(fewest.contact_s / kStepsPerContact)}));
}

}  // namespace

std::vector<std::string> study_warnings(const Study& study) {
  std::vector<std::string> warnings = study.warnings();
  warn_about_contact(study, warnings);
  return warnings;
}

}  // namespace unbruised::studies

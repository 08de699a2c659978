#include "studies/estimate/warnings.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <variant>

#include "core/contact/contact_effort.hpp"
#include "core/contact/contact_time.hpp"
#include "core/scenario/body_modes.hpp"
#include "core/scenario/product_mesh.hpp"
#include "studies/estimate/grip_force_warnings.hpp"
#include "studies/estimate/guard_warnings.hpp"
#include "studies/estimate/layer_lines.hpp"
#include "studies/estimate/some_scenarios.hpp"
#include "studies/findings/shown_probability.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

std::string contact_words(ContactPart part) {
  switch (part) {
    case ContactPart::finger:
      return "a finger's contact with the product";
    case ContactPart::support:
      return "the product's fall onto the support";
    case ContactPart::finger_surface:
      return "the first swing of the product's flat face against a finger's pad";
    case ContactPart::support_surface:
      return "the first swing of the product's flat base against the support";
  }
  return "";
}

/// What too few steps do to the numbers.
std::string harm_words(ContactPart part) {
  const bool is_surface = part == ContactPart::finger_surface || part == ContactPart::support_surface;
  return is_surface
             ? "the peak of the impact comes out too low (at 10 steps by up to 20 %, at 5 by 30 %, at 2 by half)"
             : "peak forces and damage are off, and F_damage may come out too high (a ripe kiwi at 15 "
               "steps: by a third)";
}

void warn_about_contact(const Study& study, std::vector<std::string>& warnings) {
  const ContactSteps& fewest = study.fewest_contact_steps();
  if (!(fewest.steps < kStepsPerContact)) return;
  const double step_s = fewest.contact_s / kStepsPerContact;
  warnings.push_back(
      joined({contact_words(fewest.part), " lasts only ", short_number(fewest.steps), " time steps",
              fewest.where.empty() ? "" : " at ", fewest.where, "; below ", short_number(kStepsPerContact), " ",
              harm_words(fewest.part), "; use simulation.time_step_s <= ", short_number(step_s), " (about ",
              short_number(kStepsPerContact / fewest.steps), " times as long a run)"}));
}

void warn_about_light_products(const Study& study, std::vector<std::string>& warnings) {
  double largest = 0.0, step_s = 0.0;
  look_at_some(study, kLookedAt, [&](const Scenario& scenario) {
    const double coupling = contact_coupling(scenario);
    if (coupling <= largest) return;
    largest = coupling;
    step_s = time_step_of_coupling_s(scenario, kLargestCoupling);
  });
  if (!(largest > kLargestCoupling)) return;
  warnings.push_back(
      joined({"the pads or the support are so stiff against so light a product that the contact forces may not be "
              "found within a time step (coupling ",
              short_number(largest), ", at most ", short_number(kLargestCoupling),
              "); use simulation.time_step_s <= ", short_number(step_s)}));
}

bool is_undamped(const LatticeParameters& product) {
  return product.relaxation_time_s.value_or(product.loss_ratio.value_or(0.0)) == 0.0;
}

/// What is written as 0 and bounces for ever.
void warn_about_damping(const Study& study, std::vector<std::string>& warnings) {
  const Scenario scenario = study.scenario(0);
  const auto* product = std::get_if<LatticeParameters>(&scenario.product);
  if (product == nullptr) return;
  std::vector<std::string> what;
  if (is_undamped(*product)) what.emplace_back("the product (relaxation_time_s or loss_ratio)");
  if (const auto* jaw = parallel_jaw(scenario); jaw != nullptr && jaw->pad_relaxation_time_s == 0.0)
    what.emplace_back("the pads (pad_relaxation_time_s)");
  if (scenario.cell.support && scenario.cell.support_relaxation_time_s == 0.0) {
    what.emplace_back("the support (support_relaxation_time_s)");
  }
  if (what.empty()) return;
  warnings.push_back(
      joined({"without damping: ", comma_list(what),
              ": what is bumped goes on bouncing, so products drop and are marked that a real gripper "
              "would hold; a grip window may come out half as wide"}));
}

/// Scenarios that are computed with every particle although modes are asked for.
void warn_about_modes(const Study& study, std::vector<std::string>& warnings) {
  std::string_view why;
  bool all = true;
  look_at_some(study, kLookedAt, [&](const Scenario& scenario) {
    if (scenario.simulation.body != ProductBody::modes) return;
    const std::string_view because = needs_full_body_because(scenario);
    all = all && !because.empty();
    if (why.empty()) why = because;
  });
  if (why.empty()) return;
  warnings.push_back(joined({"simulation.body = \"modes\" serves ", all ? "none" : "not all",
                             " of the scenarios: ", why, "; such are computed with every particle"}));
}

/// Fruits of one kind differ in their proportions by a fifth at most.
constexpr double kProportionsMost = 1.2;

void warn_about_stretched_meshes(const Study& study, std::vector<std::string>& warnings) {
  std::array<double, 3> worst{};
  double largest = kProportionsMost;
  look_at_some(study, kLookedAt, [&](const Scenario& scenario) {
    const auto* product = std::get_if<LatticeParameters>(&scenario.product);
    if (product == nullptr || !product->mesh) return;
    std::array<double, 3> stretch{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      stretch[axis] = product->size_m[axis] / product->mesh->extents()[axis];
    }
    const auto [least, most] = std::ranges::minmax(stretch);
    if (!(most > largest * least)) return;
    largest = most / least;
    for (std::size_t axis = 0; axis < 3; ++axis) worst[axis] = stretch[axis] / least;
  });
  if (worst[0] == 0.0) return;
  warnings.push_back(joined(
      {"product.size_m stretches the mesh to other proportions than those of its file: ", short_number(worst[0]),
       " : ", short_number(worst[1]), " : ", short_number(worst[2]), " along x, y, z"}));
}

}  // namespace

std::vector<std::string> study_warnings(const Study& study) {
  std::vector<std::string> warnings = study.warnings();
  warn_about_contact(study, warnings);
  warn_about_light_products(study, warnings);
  warn_about_damping(study, warnings);
  warn_about_modes(study, warnings);
  warn_about_stretched_meshes(study, warnings);
  for (std::string& warning : layer_warnings(study)) warnings.push_back(std::move(warning));
  for (std::string& warning : guard_warnings(study)) warnings.push_back(std::move(warning));
  for (std::string& warning : grip_force_warnings(study)) warnings.push_back(std::move(warning));
  for (std::string& doubt : probability_doubts(study)) warnings.push_back(std::move(doubt));
  return warnings;
}

}  // namespace unbruised::studies

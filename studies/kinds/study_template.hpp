#pragma once

/// @file
/// The commented study that `unbruised new` writes for a product and a gripper.

#include <string>

#include "core/scenario/scenario.hpp"
#include "studies/config/study.hpp"

namespace unbruised::studies {

struct TemplateRequest {
  std::string name;
  StudyKind kind = StudyKind::window;
  std::string product;  ///< as `use` takes it
  std::string gripper;  ///< as `use` takes it
};

/// What a first study of a product in a gripper may try, rounded so that a person could have chosen it.
struct TemplateNumbers {
  double hold_force_N = 0.0;  ///< m (g + a) / (2 mu): what holding takes at least
  double force_N = 0.0;       ///< twice that, within the gripper's forces
  double force_from_N = 0.0;
  double force_to_N = 0.0;
  double force_step_N = 0.0;  ///< the gripper's; 0: any force
  double speed_m_s = 0.0;
  double speed_from_m_s = 0.0;
  double speed_to_m_s = 0.0;
  double friction = 0.0;
  double youngs_modulus_Pa = 0.0;
};

// What each kind needs beside product, gripper, cell and strategy.
std::string simulate_template(const TemplateNumbers& numbers);
std::string sweep_template(const TemplateNumbers& numbers);
std::string window_template(const TemplateNumbers& numbers);
std::string sample_template(const TemplateNumbers& numbers);
std::string optimize_template(const TemplateNumbers& numbers);
std::string robust_template(const TemplateNumbers& numbers);
std::string pareto_template(const TemplateNumbers& numbers);
std::string compare_template(const TemplateNumbers& numbers);
std::string sensitivity_template(const TemplateNumbers& numbers);
std::string calibrate_template(const TemplateNumbers& numbers);

/// @param scenario the product in the gripper, all else by default; the product is a lattice.
TemplateNumbers template_numbers(const Scenario& scenario);

/// A study with only its product and gripper, to be read for `template_numbers`.
std::string bare_study(const TemplateRequest& request);
/// The TOML text; every line says what it means, with its unit.
std::string study_template(const TemplateRequest& request, const TemplateNumbers& numbers);

}  // namespace unbruised::studies

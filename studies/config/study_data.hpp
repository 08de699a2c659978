#pragma once

/// @file
/// What a `Study` holds, and its resolved text.

#include <string>
#include <vector>

#include "studies/config/schema.hpp"
#include "studies/config/vary.hpp"

namespace unbruised::studies {

struct StudyData {
  StudySettings settings;
  VaryPlan plan;
  std::vector<InputColumn> inputs;
  /// One scenario per combination of the values of product.use and gripper.use (the latter faster).
  std::vector<Scenario> bases;
  std::vector<SearchVariable> variables;
  std::vector<RandomVariable> randoms;
  std::vector<RandomBlock> random_blocks;  ///< as written, with the values of files, for the resolved text
  std::vector<RankCorrelation> correlations;
  std::vector<StrategyCandidate> candidates;
  SearchSettings search;
  SamplingSettings sampling;
  CompareSettings compare;
  SensitivitySettings sensitivity;
  CalibrateSettings calibrate;
  std::vector<Entry> sources;  ///< where the values come from: "product.source.mass_kg" and the like
  ContactSteps fewest_contact_steps;
  bool is_time_step_chosen = false;
  std::string resolved;
  std::vector<std::string> warnings;

  /// The fully specified run `id` of the plan.
  [[nodiscard]] Scenario scenario(std::size_t id) const;
  /// Which combination a scenario belongs to.
  [[nodiscard]] std::size_t base_of(std::size_t scenario) const;
};

/// The complete TOML of a study (everything but `resolved` is set).
std::string resolved_text(const StudyData& data);

}  // namespace unbruised::studies

#include "studies/scenarios/scenario_set.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "core/scenario/factor_key.hpp"
#include "studies/statistics/distribution.hpp"
#include "studies/statistics/seed_purpose.hpp"
#include "studies/statistics/sensitivity.hpp"

namespace unbruised::studies {
namespace {

std::vector<ColumnInfo> random_columns(const Study& study) {
  std::vector<ColumnInfo> columns;
  for (const RandomVariable& random : study.randoms()) columns.push_back({random.key, random.units, ""});
  return columns;
}

std::vector<InputValue> as_inputs(std::span<const double> values) { return {values.begin(), values.end()}; }

/// Every scenario is the base with the random keys of its row.
ScenarioSet of_rows(const Study& study, ProductSample rows) {
  const auto shared = std::make_shared<const ProductSample>(std::move(rows));
  ScenarioSet set;
  set.count = shared->size();
  set.columns = random_columns(study);
  set.scenario = [study, shared](std::size_t id) { return study.scenario_with(shared->keys, shared->at(id)); };
  set.inputs = [shared](std::size_t id) { return as_inputs(shared->at(id)); };
  return set;
}

ScenarioSet of_candidates(const Study& study) {
  const auto products = std::make_shared<const ProductSample>(study_products(study));
  ScenarioSet set;
  set.count = products->size() * study.candidates().size();
  set.columns = random_columns(study);
  set.columns.insert(set.columns.begin(), {kCandidateColumn, "", "strategy"});
  set.scenario = [study, products](std::size_t id) {
    const CompareIndex at = compare_index(study, id);
    return Study::with_values(study.candidates()[at.candidate].scenario, products->keys, products->at(at.product));
  };
  set.inputs = [study, products](std::size_t id) {
    const CompareIndex at = compare_index(study, id);
    std::vector<InputValue> inputs;
    inputs.emplace_back(study.candidates()[at.candidate].name);
    for (const double value : products->at(at.product)) inputs.emplace_back(value);
    return inputs;
  };
  return set;
}

ScenarioSet of_design(const Study& study) {
  const UnitDesign design = sensitivity_design(study);
  ProductSample rows;
  for (const RandomVariable& random : study.randoms()) rows.keys.push_back(random.key);
  rows.group.resize(design.size());
  for (std::size_t i = 0; i < design.size(); ++i) {
    for (std::size_t k = 0; k < design.dimensions; ++k) {
      rows.values.push_back(quantile(study.randoms()[k].distribution, design.at(i, k)));
    }
  }
  return of_rows(study, std::move(rows));
}

ScenarioSet of_grid(const Study& study) {
  ScenarioSet set;
  set.count = study.scenario_count();
  for (const InputColumn& input : study.inputs()) set.columns.push_back({input.key, input.units, ""});
  set.scenario = [study](std::size_t id) { return study.scenario(id); };
  set.inputs = [study](std::size_t id) { return grid_inputs(study, id); };
  return set;
}

}  // namespace

std::vector<InputValue> grid_inputs(const Study& study, std::size_t point) {
  std::vector<InputValue> values;
  for (std::size_t i = 0; i < study.inputs().size(); ++i) {
    if (study.inputs()[i].is_text) {
      values.emplace_back(study.input_text(point, i));
    } else {
      values.emplace_back(study.input_number(point, i));
    }
  }
  return values;
}

ScenarioSet scenario_set(const Study& study) {
  switch (row_of(study.kind()).scenarios) {
    case ScenarioSource::products:
      return of_rows(study, study_products(study));
    case ScenarioSource::pairs:
      return of_candidates(study);
    case ScenarioSource::design:
      return of_design(study);
    default:
      return of_grid(study);
  }
}

std::vector<std::size_t> factor_groups(const ScenarioSet& set) {
  std::vector<std::size_t> group_of;
  group_of.reserve(set.count);
  GroupNumbers groups;
  for (std::size_t id = 0; id < set.count; ++id) group_of.push_back(groups.number_of(set.scenario(id)));
  return group_of;
}

std::size_t GroupNumbers::number_of(const Scenario& scenario) {
  const WideDigest key = wide_digest(factor_key(scenario));
  if (const auto found = known_.find(key); found != known_.end()) return found->second;
  if (known_.size() < kKnownMost) known_.emplace(key, count_);
  return count_++;
}

CompareIndex compare_index(const Study& study, std::size_t id) {
  return {id / study.candidates().size(), id % study.candidates().size()};
}

ProductSample study_products(const Study& study) {
  return draw_products(study, study.sampling().count, seed_for(study.seed(), SeedPurpose::products));
}

UnitDesign sensitivity_design(const Study& study) {
  const SensitivitySettings& settings = study.sensitivity();
  const std::uint64_t seed = seed_for(study.seed(), SeedPurpose::sensitivity);
  const std::size_t keys = study.randoms().size();
  UnitDesign design = settings.method == SensitivityMethod::morris
                          ? morris_design(settings.samples, keys, settings.levels, seed)
                          : sobol_index_design(settings.samples, keys, study.sampling().design, seed);
  const auto levels = static_cast<double>(settings.levels);
  for (std::size_t k = 0; k < keys; ++k) {
    if (!study.randoms()[k].changes_factor) continue;
    for (std::size_t i = 0; i < design.size(); ++i) {
      double& u = design.values[i * keys + k];
      u = (std::min(std::floor(u * levels), levels - 1.0) + 0.5) / levels;
    }
  }
  return design;
}

}  // namespace unbruised::studies

#include "studies/config/contact_steps.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include "core/contact/contact_time.hpp"
#include "studies/config/execution_error.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/key_names.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

/// All but one drawn value in a thousand lie between these quantiles, at either end.
constexpr double kRareLow = 1e-3;
constexpr double kRareHigh = 1.0 - 1e-3;

double steps_of(const Scenario& scenario) { return contact_time_s(scenario) / scenario.simulation.time_step_s; }

std::string leaf(const std::string& key) { return key.substr(key.rfind('.') + 1); }

void add_place(std::string& where, const std::string& key, const std::string& value) {
  add_part(where, ", ", joined({leaf(key), " = ", value}));
}

/// A key that takes any value between two ends in every scenario: the ends and the middle.
struct Side {
  Side(std::string of_key, double low, double high)
      : key(std::move(of_key)), values{low, 0.5 * (low + high), high} {}
  std::string key;
  std::array<double, 3> values;
};

std::vector<Side> sides_of(const StudyData& data) {
  std::vector<Side> sides;
  for (const SearchVariable& v : data.variables) sides.emplace_back(v.key, v.from, v.to);
  for (const RandomVariable& r : data.randoms) {
    sides.emplace_back(r.key, quantile(r.distribution, kRareLow), quantile(r.distribution, kRareHigh));
  }
  if (searches_force(data.settings.kind)) {
    // The answer lies somewhere inside the range; its upper end is often a number nobody expects to reach.
    const WindowSettings& range = data.settings.window;
    sides.emplace_back(kGripForceKey, range.from_N, std::sqrt(range.from_N * range.to_N));
  }
  return sides;
}

/// Where an axis of the grid has its least and its greatest value; all of them where words or several keys vary.
std::vector<std::size_t> ends_of_axis(const VaryPlan& plan, std::size_t axis) {
  const VaryColumn* only = nullptr;
  bool is_plain = true;
  for (const VaryColumn& column : plan.columns) {
    if (column.axis != axis) continue;
    is_plain = is_plain && only == nullptr && !column.input.is_text;
    only = &column;
  }
  if (only != nullptr && is_plain) {
    const std::vector<double>& numbers = only->input.numbers;
    const auto [least, most] = std::minmax_element(numbers.begin(), numbers.end());
    return {static_cast<std::size_t>(least - numbers.begin()), static_cast<std::size_t>(most - numbers.begin())};
  }
  std::vector<std::size_t> all(plan.axes[axis].count);
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
  return all;
}

/// Scenario ids of the grid's ends.
std::vector<std::size_t> ends_of_grid(const VaryPlan& plan) {
  std::vector<std::size_t> ids = {0};
  for (std::size_t axis = 0; axis < plan.axes.size(); ++axis) {
    std::vector<std::size_t> more;
    for (const std::size_t index : ends_of_axis(plan, axis)) {
      for (const std::size_t id : ids) more.push_back(id + index * plan.axes[axis].stride);
    }
    ids = std::move(more);
  }
  return ids;
}

/// Moves each key to where it gives fewest steps, one after the other; says which of them matter.
ContactSteps fewest_over_sides(Scenario scenario, const std::vector<Side>& sides) {
  ContactSteps found;
  for (const Side& side : sides) {
    std::array<double, 3> steps{};
    for (std::size_t i = 0; i < steps.size(); ++i) {
      steps[i] = steps_of(Study::with_values(scenario, {&side.key, 1}, {&side.values[i], 1}));
    }
    const auto [least, most] = std::minmax_element(steps.begin(), steps.end());
    const double value = side.values[static_cast<std::size_t>(least - steps.begin())];
    scenario = Study::with_values(scenario, {&side.key, 1}, {&value, 1});
    if (*least != *most) add_place(found.where, side.key, three_digits(value));
  }
  found.steps = steps_of(scenario);
  const ShortestContact shortest = shortest_contact(scenario);
  found.contact_s = shortest.time_s;
  found.part = shortest.part;
  return found;
}

/// Does the contact of this grid point get other steps where one column alone has another of its values?
bool matters(const StudyData& data, std::size_t id, std::size_t c) {
  const VaryPlan& plan = data.plan;
  const VaryColumn& column = plan.columns[c];
  const VaryAxis& axis = plan.axes[column.axis];
  const Scenario scenario = data.scenario(id);
  const std::size_t first = id - plan.index(id, c) * axis.stride;
  const std::vector<std::size_t> ends = ends_of_axis(plan, column.axis);
  return std::any_of(ends.begin(), ends.end(), [&](std::size_t index) {
    Scenario other = data.scenario(first + index * axis.stride);
    if (!column.input.is_text) {
      other = scenario;
      apply_named(other, column.input.key, column.input.numbers[index]);
    }
    return steps_of(other) != steps_of(scenario);
  });
}

/// The varied keys of a grid point that change the steps of its contact.
std::string place_on_grid(const StudyData& data, std::size_t id) {
  std::string where;
  for (std::size_t c = 0; c < data.plan.columns.size(); ++c) {
    if (!matters(data, id, c)) continue;
    const InputColumn& input = data.plan.columns[c].input;
    const std::size_t index = data.plan.index(id, c);
    add_place(where, input.key, input.is_text ? input.texts[index] : three_digits(input.numbers[index]));
  }
  return where;
}

/// The largest number of two digits that is not above a positive one.
double rounded_down(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.1e", value);
  double rounded = std::strtod(text.data(), nullptr);
  if (rounded <= value) return rounded;
  const double digit = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
  std::snprintf(text.data(), text.size(), "%.1e", value - digit);
  rounded = std::strtod(text.data(), nullptr);
  return rounded;
}

}  // namespace

ContactSteps fewest_contact_steps(const StudyData& data) {
  const std::vector<Side> sides = sides_of(data);
  ContactSteps fewest;
  const auto look = [&](const Scenario& scenario) {
    ContactSteps found = fewest_over_sides(scenario, sides);
    const bool is_fewer = found.steps < fewest.steps;
    if (is_fewer) fewest = std::move(found);
    return is_fewer;
  };
  std::optional<std::size_t> best;
  const bool runs_base = data.candidates.empty();  // of a comparison, nobody runs the strategy that is written
  for (const std::size_t id : runs_base ? ends_of_grid(data.plan) : std::vector<std::size_t>{}) {
    if (look(data.scenario(id))) best = id;
  }
  if (best) {
    std::string where = place_on_grid(data, *best);
    add_part(where, ", ", fewest.where);
    fewest.where = std::move(where);
  }
  for (const StrategyCandidate& candidate : data.candidates) {
    if (look(candidate.scenario)) add_place(fewest.where, "candidate", candidate.name);
  }
  return fewest;
}

void set_time_step(StudyData& data, double time_step_s) {
  for (Scenario& base : data.bases) base.simulation.time_step_s = time_step_s;
  for (StrategyCandidate& candidate : data.candidates) candidate.scenario.simulation.time_step_s = time_step_s;
}

void choose_time_step(StudyData& data) {
  const double wanted_s = fewest_contact_steps(data).contact_s / kStepsPerContact;
  const double step_s = !(wanted_s > kLeastChosenStep_s)  ? kLeastChosenStep_s
                        : wanted_s < kLongestChosenStep_s ? rounded_down(wanted_s)
                                                          : kLongestChosenStep_s;
  set_time_step(data, step_s);
  data.is_time_step_chosen = true;
}

}  // namespace unbruised::studies

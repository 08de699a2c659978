#include "core/simulation/step_levels.hpp"

#include <algorithm>

#include "core/contact/contact_effort.hpp"
#include "core/scenario/conveyor.hpp"
#include "core/scenario/gripper.hpp"
#include "core/scenario/pad_face.hpp"
#include "core/scenario/pad_lattice.hpp"
#include "core/scenario/product.hpp"
#include "core/scenario/product_frame.hpp"

namespace unbruised {
namespace {

/// Steps of the two longer levels, as multiples of the shortest and in seconds. Measured on a kiwi with 0.7 ms
/// (docs/performance.md): twice the step does for pressing and placing, eight times, 5.6 ms, for carrying; longer
/// steps gain little and cost accuracy.
constexpr int kMedium = 2, kLongest = 8;
constexpr double kMostMedium_s = 1.5e-3, kMostLongest_s = 6e-3;

/// Of the contacts at the longest step (contact_effort.hpp): far from where they may have no solution, and sweeps
/// do not eat what longer steps save.
constexpr double kMostCoupling = 0.5 * kLargestCoupling;

/// Is everything that can happen to the product foreseen by the rule?
bool is_foreseen(const Scenario& scenario) {
  const auto* jaw = parallel_jaw(scenario);
  return jaw != nullptr && !lists_fingers(scenario) && true_shape(scenario.product).has_value() &&
         product_frame(scenario) == ProductFrame::upright && !has_sensor(scenario) &&
         scenario.strategy.guard == GuardKind::none && !has_belt(scenario.cell) &&
         scenario.cell.place_velocity_m_s == std::array<double, 2>{} && scenario.cell.surface.empty() &&
         !has_shaped_pads(scenario) && !has_lattice_pads(scenario) && !starts_in_the_air(scenario.product);
}

}  // namespace

StepLevels step_levels(const Scenario& scenario) {
  StepLevels levels;
  if (scenario.simulation.levels == LevelUse::off || !is_foreseen(scenario)) return levels;
  const double step_s = scenario.simulation.time_step_s;
  const double most_s = time_step_of_coupling_s(scenario, kMostCoupling);
  int medium = kMedium, longest = kLongest;
  while (medium > 1 && medium * step_s > std::min(kMostMedium_s, most_s)) medium /= 2;
  while (longest > 1 && longest * step_s > std::min(kMostLongest_s, most_s)) longest /= 2;
  if (medium > 1) levels.ticks.push_back(medium);
  if (longest > levels.ticks.back()) levels.ticks.push_back(longest);
  return levels;
}

}  // namespace unbruised

#include "core/simulation/step_levels.hpp"

#include <algorithm>

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

/// As many steps of this length as fit into a span, `most` at most and 1 at least.
int ticks_within(double step_s, double span_s, int most) {
  constexpr double kRounding = 1e-9;
  return std::clamp(static_cast<int>(span_s / step_s + kRounding), 1, most);
}

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
  if (scenario.simulation.levels == LevelUse::off || !is_foreseen(scenario)) return {};
  const double step_s = scenario.simulation.time_step_s;
  return {ticks_within(step_s, kMostMedium_s, kMedium), ticks_within(step_s, kMostLongest_s, kLongest)};
}

}  // namespace unbruised

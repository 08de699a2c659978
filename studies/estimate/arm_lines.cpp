#include "studies/estimate/arm_lines.hpp"

#include <algorithm>

#include "core/robot/arm_timing.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

constexpr std::size_t kArmScenariosMost = 100;

std::string limit_line(const TimedScenario& timed) {
  if (timed.ride.breach) {
    return joined({"arm: ", words_of(*timed.ride.breach), ", ", three_digits(timed.ride.breach->time_s),
                   " s after the start"});
  }
  const ArmBreach most = timed.ride.binding();
  return joined({"arm: no limit is broken; ", words_of(most), " (", three_digits(most.time_s),
                 " s after the start), more than of any other limit"});
}

}  // namespace

std::vector<std::string> arm_lines(const Study& study) {
  const Scenario first = study.scenario(0);
  if (!has_robot(first)) return {};
  const TimedScenario timed = timed_for_arm(first);
  std::vector<std::string> lines = {limit_line(timed)};
  if (const double slowed_s = timed.ride.moving_s - ride(first, planned_motion(first)).moving_s; slowed_s > 0.0) {
    lines.push_back(joined({"arm: slowed down by ", three_digits(slowed_s), " s to ",
                            three_digits(timed.ride.moving_s), " s from lift to lowering"}));
  }
  const std::size_t all = study.scenario_count(), looked = std::min(all, kArmScenariosMost);
  std::size_t stuck = 0;
  for (std::size_t i = 0; i < looked; ++i) {
    const Scenario scenario = study.scenario(i * all / looked);
    if (has_robot(scenario) && timed_for_arm(scenario).ride.breach) ++stuck;
  }
  if (all > 1) {
    lines.push_back(joined({"arm: cannot follow ", std::to_string(stuck), " of ", std::to_string(looked),
                            looked < all ? " scenarios looked at" : " scenarios"}));
  }
  return lines;
}

}  // namespace unbruised::studies

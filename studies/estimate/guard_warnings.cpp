#include "studies/estimate/guard_warnings.hpp"

#include "core/scenario/guard.hpp"
#include "studies/estimate/some_scenarios.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

/// Slower by less than this part is as told.
constexpr double kAsTold = 0.01;

}  // namespace

std::vector<std::string> guard_warnings(const Study& study) {
  double worst = 1.0 + kAsTold;
  std::string sentence;
  look_at_some(study, kLookedAt, [&](const Scenario& scenario) {
    const StrategyParameters& s = scenario.strategy;
    if (s.guard != GuardKind::range || !(s.guard_speed_m_s > 0.0)) return;
    const double touch_m_s = planned_approach(scenario).touch_speed_m_s;
    if (touch_m_s <= worst * s.guard_speed_m_s) return;
    worst = touch_m_s / s.guard_speed_m_s;
    sentence = joined({"strategy.guard_range_m = ", short_number(s.guard_range_m.value_or(0.0)),
                       " leaves the drives no room to brake from ", short_number(s.approach_speed_m_s), " to ",
                       short_number(s.guard_speed_m_s),
                       " m/s with strategy.contact_force_N = ", short_number(s.contact_force_N),
                       ": the fingers touch at ", short_number(touch_m_s), " m/s at least"});
  });
  if (sentence.empty()) return {};
  return {sentence};
}

}  // namespace unbruised::studies

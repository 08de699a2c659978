#include "studies/estimate/guard_warnings.hpp"

#include "core/scenario/guard.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

/// The scenarios that are looked at: at most this many, evenly spread over the study.
constexpr std::size_t kLookedAt = 64;
/// Slower by less than this part is as told.
constexpr double kAsTold = 0.01;

}  // namespace

std::vector<std::string> guard_warnings(const Study& study) {
  const std::size_t stride = 1 + (study.scenario_count() - 1) / kLookedAt;
  double worst = 1.0 + kAsTold;
  std::string sentence;
  for (std::size_t id = 0; id < study.scenario_count(); id += stride) {
    const Scenario scenario = study.scenario(id);
    const StrategyParameters& s = scenario.strategy;
    if (s.guard != GuardKind::range || !(s.guard_speed_m_s > 0.0)) continue;
    const double touch_m_s = planned_approach(scenario).touch_speed_m_s;
    if (touch_m_s <= worst * s.guard_speed_m_s) continue;
    worst = touch_m_s / s.guard_speed_m_s;
    sentence = joined({"strategy.guard_range_m = ", short_number(s.guard_range_m.value_or(0.0)),
                       " leaves the drives no room to brake from ", short_number(s.approach_speed_m_s), " to ",
                       short_number(s.guard_speed_m_s),
                       " m/s with strategy.contact_force_N = ", short_number(s.contact_force_N),
                       ": the fingers touch at ", short_number(touch_m_s), " m/s at least"});
  }
  if (sentence.empty()) return {};
  return {sentence};
}

}  // namespace unbruised::studies

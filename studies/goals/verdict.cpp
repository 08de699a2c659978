#include "studies/goals/verdict.hpp"

#include <algorithm>

#include "core/outcome/damage_limits.hpp"

namespace unbruised::studies {
namespace {

bool ended_early(Outcome outcome) {
  return outcome == Outcome::diverged || outcome == Outcome::out_of_range || outcome == Outcome::not_run;
}

bool exceeds_a_damage_limit(const Metrics& metrics, const LimitParameters& limits) {
  return std::any_of(kDamageLimits.begin(), kDamageLimits.end(),
                     [&](const DamageLimit& limit) { return exceeds(metrics, limit, limits); });
}

}  // namespace

Verdict holds(const Metrics& metrics, Outcome outcome, const LimitParameters& limits) {
  if (outcome == Outcome::not_grasped || outcome == Outcome::dropped || outcome == Outcome::slipped) {
    return Verdict::no;
  }
  for (const SlipLimit& limit : kSlipLimits) {
    if (exceeds(metrics, limit, limits)) return Verdict::no;
  }
  return ended_early(outcome) ? Verdict::unknown : Verdict::yes;
}

Verdict undamaged(const Metrics& metrics, Outcome outcome, const LimitParameters& limits) {
  if (outcome == Outcome::damaged || exceeds_a_damage_limit(metrics, limits)) return Verdict::no;
  return ended_early(outcome) ? Verdict::unknown : Verdict::yes;
}

}  // namespace unbruised::studies

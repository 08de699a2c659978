#include "core/simulation/step_level.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace unbruised {
namespace {

/// A finger that touches or leaves, a support that lets go or is touched, a jump of the palm's acceleration or a
/// pad that slides rings on for so long; 10 ms would do for a kiwi.
constexpr double kRinging_s = 0.03;
/// What a touch or the support has set ringing has come to rest once loads have gone so straight for a while that
/// a long step would miss no more than this share of what presses: of a force that bends, an eighth of its second
/// derivative times the step squared.
constexpr double kMisses = 3e-3;
/// The drive presses into the swing of an impact, which may throw the finger back: for so long, or until all
/// fingers have rested for a while.
constexpr double kImpact_s = 0.06, kRested_s = 0.01;
/// Fingers that go no farther within a long step rest.
constexpr double kRests_m = 1e-6;
/// Fingers that approach keep their speed, but for such a share within what a long step sees.
constexpr double kKeepsSpeed = 0.05;
/// A surface that is this near is about to touch.
constexpr double kNearPad_m = 1e-4, kNearSupport_m = 1e-3;
/// The support still carries the product, as a share of its weight.
constexpr double kCarries = 0.7;
/// What the plan does is known as far as a step looks. What the product does on its way may come twice as soon.
constexpr double kSooner = 2.0;
/// Before the product hangs, a pad with this share of its contacts sliding slides: the fingers still swing, and
/// show in them. Later that is the rim of a patch of which the rest sticks, and a pad slides when all of it does.
constexpr double kSlidingBefore = 0.3, kSlidingHung = 1.0;
/// A pad that carries more than this share of what its friction holds may be about to slide as a whole; one that
/// is asked for more than by this factor already where it is to carry the smaller share.
constexpr double kAtTheLimit = 0.9, kNearTheLimit = 0.85, kGrows = 1.001;
/// Of a product that falls beside its fingers.
constexpr double kLeastPull_m_s2 = 1e-6;
/// Contacts that need more sweeps in a step are solved sooner in short ones, and surely.
constexpr double kManySweeps = 100.0;
/// A product flows that has absorbed this much more of the energy it had.
constexpr double kFlows = 0.01;

bool slides(const StepObservation& seen, double share) {
  return std::ranges::any_of(seen.fingers(), [=](const FingerObservation& finger) {
    return finger.closed_contacts > 0.0 && finger.sliding_contacts >= share * finger.closed_contacts;
  });
}

/// What a hanging product pulls with at its pads as the plan moves it, per kilogram.
double pull_m_s2(const LevelSigns& signs, double time_s) {
  const PalmState palm = signs.cycle.plan().palm(time_s);
  double square = 0.0;
  for (std::size_t i = 0; i < 3; ++i) square += std::pow(palm.acceleration_m_s2[i] - signs.gravity_m_s2[i], 2);
  return std::sqrt(square);
}

/// Will a pad slide as a whole within `reach_s`, or nearly so, when its load grows with what the plan asks for?
bool may_slide(double reach_s, const LevelSigns& signs) {
  const double now_m_s2 = pull_m_s2(signs, signs.time_s), then_m_s2 = pull_m_s2(signs, signs.time_s + reach_s);
  return std::ranges::any_of(signs.seen.fingers(), [&](const FingerObservation& finger) {
    const double tangent_N = std::hypot(finger.tangent_N[0], finger.tangent_N[1]);
    const double friction_N = signs.friction * finger.normal_N;
    if (tangent_N > kAtTheLimit * friction_N) return true;
    const double growth = then_m_s2 / std::max(now_m_s2, kLeastPull_m_s2);
    return growth > kGrows && tangent_N * growth > kNearTheLimit * friction_N;
  });
}

bool touches(const StepObservation& seen) {
  return std::ranges::any_of(seen.fingers(),
                             [](const FingerObservation& finger) { return finger.closed_contacts > 0.0; });
}

double sinks_m(const PalmState& from, const PalmState& to) {
  return std::max(0.0, from.position_m[2] - to.position_m[2]);
}

/// Will the fingers stay where they are for so long?
bool rests(double reach_s, const LevelSigns& signs) { return signs.closing_m_s * reach_s < kRests_m; }

}  // namespace

void LevelChoice::decide(const StepClock& clock, const LevelSigns& signs) {
  const double sees_s = clock.theta * levels_.longest * clock.tick_s;
  note(sees_s, signs);
  ticks_ = ticks_for(need(sees_s, signs));
  const double left_s = signs.cycle.plan().end_s() - signs.time_s;
  while (ticks_ > 1 && ticks_ * clock.tick_s > left_s) --ticks_;
  ticks_ = levels_.not_beyond(ticks_);
}

/// Would a long step miss something of how the loads change? Where no pad is pressed nothing tells.
void LevelChoice::note_loads(const LevelSigns& signs) {
  Loads now{};
  now.back() = signs.seen.support_N;
  double pressed_N = 0.0, bends_N = 0.0;
  for (std::size_t f = 0; f < kJawFingers; ++f) {
    const FingerObservation& finger = signs.seen.finger[f];
    pressed_N += finger.normal_N;
    now[3 * f] = finger.normal_N;
    for (std::size_t t = 0; t < 2; ++t) now[3 * f + 1 + t] = finger.tangent_N[t];
  }
  for (std::size_t i = 0; i < now.size(); ++i) {
    bends_N = std::max(bends_N, std::abs(now[i] - 2.0 * loads_[i] + loads_before_[i]));
  }
  loads_before_ = std::exchange(loads_, now);
  short_steps_ = ticks_ == 1 ? short_steps_ + 1 : 0;
  constexpr int kBend = 3;  // steps that it takes to see one
  const double misses_N = bends_N * levels_.longest * levels_.longest / 8.0;
  if (short_steps_ < kBend || pressed_N == 0.0 || misses_N > kMisses * pressed_N) swung_s_ = signs.time_s;
  if (signs.time_s > swung_s_ + kRested_s) rings_until_s_ = 0.0;
}

void LevelChoice::note(double sees_s, const LevelSigns& signs) {
  note_loads(signs);
  const auto ring = [&] {
    rings_until_s_ = signs.time_s + kRinging_s;
    swung_s_ = signs.time_s;
  };
  const auto keep_short = [&] { short_until_s_ = signs.time_s + kRinging_s; };
  const MotionPlan& plan = signs.cycle.plan();
  for (std::size_t f = 0; f < kJawFingers; ++f) {
    const bool touches = signs.seen.finger[f].closed_contacts > 0.0;
    if (std::exchange(touches_[f], touches) == touches) continue;
    ring();
    const bool lets_go = !touches && signs.time_s > plan.release_start_s();
    if (!lets_go) swings_until_s_ = signs.time_s + kRinging_s + kImpact_s;
  }
  if (!rests(kSooner * sees_s, signs)) moved_s_ = signs.time_s;
  speeds_up_m_s2_ = std::abs(signs.closing_m_s - speed_m_s_) / (signs.time_s - seen_s_);
  speed_m_s_ = signs.closing_m_s;
  seen_s_ = signs.time_s;
  if (signs.seen.absorbed_energy_J > (1.0 + kFlows) * absorbed_J_) {
    absorbed_J_ = signs.seen.absorbed_energy_J;
    keep_short();
  }
  if (slides(signs.seen, hung_ ? kSlidingHung : kSlidingBefore)) keep_short();
  if (ticks_ > 1 && signs.contact_sweeps > kManySweeps) keep_short();
  const bool stands = signs.seen.support_N > 0.0;
  if (std::exchange(stands_, stands) != stands && hung_) ring();
  if (signs.time_s >= plan.lift_start_s() && !hung_ && !stands) {
    hung_ = true;
    ring();
  }
  if (off_s_ == kNever && signs.time_s > plan.release_start_s() && !touches(signs.seen)) off_s_ = signs.time_s;
}

int LevelChoice::ticks_for(Need need) const {
  if (need == Need::shortest) return 1;
  return need == Need::medium ? levels_.medium : levels_.longest;
}

LevelChoice::Need LevelChoice::need(double sees_s, const LevelSigns& signs) const {
  const MotionPlan& plan = signs.cycle.plan();
  if (!signs.cycle.has_contact()) {
    const bool near = signs.pad_gap_m < kNearPad_m + signs.closing_m_s * kSooner * sees_s;
    return near || speeds_up_m_s2_ * sees_s > kKeepsSpeed * signs.closing_m_s ? Need::shortest : Need::longest;
  }
  const double swings_until_s = std::min(swings_until_s_, moved_s_ + kRested_s);
  if (signs.time_s < std::max({short_until_s_, rings_until_s_, swings_until_s})) {
    return Need::shortest;
  }
  if (plan.jumps_between(signs.time_s - kRinging_s, signs.time_s + sees_s)) return Need::shortest;
  const bool pressed = signs.time_s < plan.lift_start_s() && !plan.is_stopped(signs.time_s);
  return pressed ? need_of_pressed(sees_s, signs) : need_of_carried(sees_s, signs);
}

/// Until nothing moves any more.
LevelChoice::Need LevelChoice::need_of_pressed(double sees_s, const LevelSigns& signs) const {
  const MotionPlan& plan = signs.cycle.plan();
  const bool grips = signs.time_s > plan.ramp_end_s() && std::ranges::all_of(touches_, std::identity());
  const bool is_held = grips && rests(kSooner * sees_s, signs) && signs.time_s + sees_s < plan.lift_start_s();
  return is_held ? Need::longest : Need::medium;
}

LevelChoice::Need LevelChoice::need_of_carried(double sees_s, const LevelSigns& signs) const {
  const MotionPlan& plan = signs.cycle.plan();
  if (!hung_) return signs.seen.support_N < kCarries * signs.weight_N ? Need::shortest : Need::medium;
  const bool is_let_go = signs.time_s > off_s_ + kRinging_s;
  if (is_let_go) return Need::longest;
  if (may_slide(kSooner * sees_s, signs)) return Need::shortest;
  if (signs.time_s + sees_s > plan.release_start_s() || stands_) return Need::medium;
  const double way_m = sinks_m(plan.palm(signs.time_s), plan.palm(signs.time_s + kSooner * sees_s));
  return signs.support_gap_m < kNearSupport_m + way_m ? Need::medium : Need::longest;
}

double planned_steps(const Scenario& scenario, double contact_s) {
  /// By then the support has let go, and open fingers are off.
  constexpr double kLetsGo_s = 0.01;
  const StepClock clock{scenario.simulation.time_step_s, 1, scenario.simulation.theta};
  HandlingCycle cycle(scenario);
  LevelChoice choice(step_levels(scenario));
  StepObservation seen;
  double steps = 0.0;
  const double speed_m_s = scenario.strategy.approach_speed_m_s;
  for (double time_s = 0.0; time_s < cycle.plan().end_s(); time_s += choice.ticks() * clock.tick_s) {
    if (time_s >= contact_s) cycle.observe(time_s, contact_s);
    const MotionPlan& plan = cycle.plan();
    const double height_m = plan.palm(time_s).position_m[2] - scenario.cell.place_height_m;
    const bool hangs = time_s > plan.lift_start_s() + kLetsGo_s && height_m > scenario.strategy.release_height_m;
    const bool grips = cycle.has_contact() && time_s < plan.release_start_s() + kLetsGo_s;
    seen.support_N = hangs ? 0.0 : 1.0;
    for (FingerObservation& finger : seen.finger) finger.closed_contacts = grips ? 1.0 : 0.0;
    choice.decide(clock, {.time_s = time_s,
                          .cycle = cycle,
                          .seen = seen,
                          .pad_gap_m = std::max(0.0, contact_s - time_s) * speed_m_s,
                          .closing_m_s = speed_m_s,
                          .support_gap_m = height_m,
                          .weight_N = 1.0});
    steps += 1.0;
  }
  return scenario.strategy.repeat * steps;
}

}  // namespace unbruised

#pragma once

/// @file
/// The phase machine of one handling cycle. It is fed with what a step showed, and answers with the plan to
/// follow: until a finger touches the fingers only approach, the first contact fixes everything that comes. A
/// guard slows the approach down; one by force is the first to know of the contact, and fixes what comes.

#include <memory>
#include <optional>

#include "core/motion/motion_plan.hpp"
#include "core/scenario/scenario.hpp"

namespace unbruised {

/// What a step means for the cycle.
enum class CycleEvent {
  none,
  lift_started,  ///< the step is the first to end at or after the start of the lift
};

class HandlingCycle {
 public:
  HandlingCycle() = default;
  /// @param carrier of the palm; nullptr: it goes as planned
  explicit HandlingCycle(const Scenario& scenario, std::shared_ptr<const PalmCarrier> carrier = nullptr);

  /// Takes in the step that ended at `time_s`.
  /// @param touch_s when a finger touched the product; none: no new contact. All but the first are ignored.
  /// @param guard_s when an instrument first showed what the guard waits for; none: not yet
  CycleEvent observe(double time_s, std::optional<double> touch_s, std::optional<double> guard_s = {});

  /// What is to be done, as far as is known.
  [[nodiscard]] const MotionPlan& plan() const { return plan_; }
  /// The phase at a time; the approach lasts until the first contact.
  [[nodiscard]] CyclePhase phase(double time_s) const;

  [[nodiscard]] bool has_contact() const { return first_contact_s_ < kNever; }
  [[nodiscard]] double first_contact_s() const { return first_contact_s_; }
  /// Is it known when the grip began?
  [[nodiscard]] bool grip_started() const { return grip_started_; }
  [[nodiscard]] bool lift_started() const { return lift_started_; }
  /// Without a grip by then, there is nothing between the fingers, or nothing that the guard feels.
  [[nodiscard]] double approach_deadline_s() const { return approach_deadline_s_; }

 private:
  void follow_guard(double guard_s);
  void start_grip();
  [[nodiscard]] MotionPlan plan_from(double ramp_start_s) const;

  Scenario scenario_{};
  std::shared_ptr<const PalmCarrier> carrier_;
  double first_contact_s_ = kNever;
  double guard_s_ = kNever;  ///< that the fingers obey
  MotionPlan plan_;
  double approach_deadline_s_ = kNever;
  bool grip_started_ = false;
  bool lift_started_ = false;
};

}  // namespace unbruised

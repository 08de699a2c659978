#pragma once

/// @file
/// Step levels: a scenario takes its own `time_step_s` where something happens, and multiples of it while the
/// product is merely gripped, held or carried (docs/theory.md, "Step levels"). Which one is decided by the
/// scenario's own state at the end of each step, so that its bits know nothing of other scenarios.

#include <array>
#include <utility>

#include "core/motion/handling_cycle.hpp"
#include "core/outcome/handling_record.hpp"
#include "core/simulation/step_clock.hpp"
#include "core/simulation/step_levels.hpp"
#include "core/surface/surfaces.hpp"

namespace unbruised {

/// What decides about the coming step, at the end of the last.
struct LevelSigns {
  double time_s = 0.0;
  const HandlingCycle& cycle;
  const StepObservation& seen;
  double pad_gap_m = 0.0;      ///< least gap of a pad; asked for before the first contact
  double closing_m_s = 0.0;    ///< speed of the fastest finger
  double support_gap_m = 0.0;  ///< of the product over its support; asked for after it
  double weight_N = 0.0;       ///< of the product
  double friction = 0.0;       ///< between product and pads
  std::array<double, 3> gravity_m_s2{};
  double contact_sweeps = 0.0;  ///< that the step took
};

/// How long the coming step of a scenario is, and what that remembers of former ones.
class LevelChoice {
 public:
  LevelChoice() = default;
  explicit LevelChoice(const StepLevels& levels) : levels_(levels) {}

  /// Is there anything to choose?
  [[nodiscard]] bool chooses() const { return levels_.any(); }
  /// Takes in the end of a step. @param clock of any level
  void decide(const StepClock& clock, const LevelSigns& signs);
  /// Of the coming step.
  [[nodiscard]] int ticks() const { return ticks_; }

 private:
  enum class Need { shortest, medium, longest };
  void note(double sees_s, const LevelSigns& signs);
  void note_loads(const LevelSigns& signs);
  // Where a long step would see so far.
  [[nodiscard]] Need need(double sees_s, const LevelSigns& signs) const;
  [[nodiscard]] Need need_of_pressed(double sees_s, const LevelSigns& signs) const;
  [[nodiscard]] Need need_of_carried(double sees_s, const LevelSigns& signs) const;
  [[nodiscard]] int ticks_for(Need need) const;

  StepLevels levels_;
  int ticks_ = 1;
  double short_until_s_ = 0.0;   ///< something goes on
  double rings_until_s_ = 0.0;   ///< something has happened, unless loads have gone straight for a while since
  double swung_s_ = 0.0;         ///< when they last did not
  double swings_until_s_ = 0.0;  ///< a finger has touched or left, unless all have come to rest before
  double moved_s_ = 0.0;         ///< when one of them last did not rest
  double speed_m_s_ = 0.0;       ///< of the fastest finger, as it was last seen
  double seen_s_ = 0.0;          ///< when
  double speeds_up_m_s2_ = 0.0;  ///< how it has changed until now
  std::array<bool, kJawFingers> touches_{};
  using Loads = std::array<double, 3 * kJawFingers + 1>;  ///< of the pads along N, T1, T2; of the support [N]
  Loads loads_{}, loads_before_{};                        ///< at the ends of the last two steps
  int short_steps_ = 0;                                   ///< in a row
  double absorbed_J_ = 0.0;                               ///< by the cells
  double off_s_ = kNever;                                 ///< when the fingers had let go
  bool stands_ = false;                                   ///< the support carries something
  bool hung_ = false;                                     ///< the support has let go of the product
};

/// How many steps a scenario with several levels takes when everything goes as planned.
/// @param contact_s when the fingers touch; finite
double planned_steps(const Scenario& scenario, double contact_s);

}  // namespace unbruised

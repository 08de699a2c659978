#pragma once

/// @file
/// What carries a palm, as far as plans ask it: motion knows of no arm.

#include <memory>
#include <optional>

#include "core/motion/palm_track.hpp"
#include "core/motion/stop_law.hpp"

namespace unbruised {

class MotionPlan;

/// What carries the palm, where it is known.
class PalmCarrier {
 public:
  PalmCarrier() = default;
  virtual ~PalmCarrier() = default;
  PalmCarrier(const PalmCarrier&) = delete;
  PalmCarrier& operator=(const PalmCarrier&) = delete;

  /// How it brakes. @return none: it does not know
  [[nodiscard]] virtual std::optional<StopLaw> stop(const MotionPlan& plan, double time_s) const = 0;
  /// How the palm really goes where this is the plan. @return nullptr: as planned
  [[nodiscard]] virtual std::shared_ptr<const PalmTrack> track(const MotionPlan& plan) const = 0;
};

}  // namespace unbruised

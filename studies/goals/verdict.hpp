#pragma once

/// @file
/// Does a grip hold, and does it leave the product undamaged? Decided from metrics and limits, because the
/// outcome word names only the first of several things that may be true of a run.

#include "core/outcome/outcome.hpp"
#include "core/scenario/scenario.hpp"

namespace unbruised::studies {

enum class Verdict {
  no,
  yes,
  unknown,  ///< the run ended before it could be told (diverged, out_of_range, not run)
};

/// Neither `not_grasped` nor `dropped`, and within limits.slip_m and limits.slip_rad.
Verdict holds(const Metrics& metrics, Outcome outcome, const LimitParameters& limits);

/// No damage limit exceeded; slip is no damage. A run that ended early is damaged when a limit was exceeded by
/// then, else unknown. The outcome `damaged` is believed where no metric tells why.
Verdict undamaged(const Metrics& metrics, Outcome outcome, const LimitParameters& limits);

}  // namespace unbruised::studies

#pragma once

/// @file
/// Does the answer of a study with grip windows depend on the time step? The ends that decide it, and those next
/// to a run whose impact the step does not resolve, are looked for again at half of it.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "studies/kinds/end_search.hpp"
#include "studies/kinds/window_findings.hpp"

namespace unbruised::studies {

/// Rows in the order of the requests, from the journal or run now; nothing: interrupted.
using ForceRunner = std::function<std::optional<std::vector<ScenarioRow>>(const std::vector<ForceRequest>&)>;

/// What a run of these forces says, in the order of the requests.
std::vector<GripSample> samples_of(const Study& study, const std::vector<ForceRequest>& requests,
                                   const std::vector<ScenarioRow>& rows);

/// Ends to look at beside those on unresolved impacts.
enum class LookAt { deciding_ends, impacts_only };

struct HalfStepLook {
  const Study& study;
  LookAt ends = LookAt::deciding_ends;
  EndSearchSettings range;
  const ForceRunner& run;                ///< makes the runs
  std::function<WindowAnswer()> answer;  ///< anew from the table as it is
};

/// Until the answer rests on no ends that were not looked at; writes what is found into the table: infinite
/// (F_hold) or zero (F_damage) where no force of the range is on the safe side any more. Nothing is looked at
/// where the study varies the time step.
/// @return the answer; nothing: interrupted
std::optional<WindowAnswer> look_at_half_step(const HalfStepLook& look, StudyWindow& window);

/// One sentence for each end that moves by more than the tolerance.
std::vector<std::string> half_step_warnings(const Study& study, const StudyWindow& window, double tolerance);

}  // namespace unbruised::studies

#pragma once

/// @file
/// Scenarios of a recorded study, run again to be seen on its page.

#include <cstdint>
#include <optional>
#include <vector>

#include "core/scenario/scenario.hpp"
#include "studies/cli/recorded.hpp"
#include "studies/report/report_replay.hpp"

namespace unbruised::studies {

/// Time from frame to frame: 25 to 40 in a second, of a long run 130 in all, of a very short one 40.
double replay_interval_s(const Scenario& scenario);
/// The scenario with its trace thinned to what panel, charts and sound need.
Scenario thinned_for_replay(Scenario scenario);

/// The scenarios that the study makes worth seeing, and those that are asked for. Those that this build runs to
/// another outcome are left out, and all of them where it would take long; a note says so. Nothing where they
/// cannot be made again, or when interrupted.
std::vector<ScenarioReplay> replays_of(const RecordedStudy& recorded, const std::vector<std::uint64_t>& asked);
/// One of its scenarios as the study has it. Nothing where there is none of this number.
std::optional<Scenario> recorded_scenario(const RecordedStudy& recorded, std::uint64_t id);
/// One of its scenarios. Nothing where there is none of this number, or when interrupted.
std::optional<ScenarioReplay> replay_of(const RecordedStudy& recorded, std::uint64_t id);

}  // namespace unbruised::studies

#pragma once

/// @file
/// A scenario on its way into the page as a scene that plays: its surface and what touches it, frame by frame, in
/// few bytes, with the signals and the events beside it.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "core/outcome/outcome.hpp"
#include "core/outcome/replay.hpp"
#include "core/outcome/trace.hpp"
#include "core/scenario/scenario.hpp"
#include "studies/report/packed_columns.hpp"

namespace unbruised::studies {

/// What stands around, as far as the frames do not say it.
struct ReplayStage {
  bool support = true;
  std::optional<std::array<double, 3>> target_m;  ///< middle of the plane it is put down on, from the start's
  bool belt = false;
  double smallest_extent_m = 0;  ///< of the product
};
ReplayStage replay_stage(const Scenario& scenario);

/// One scenario that was run again to be seen.
struct ScenarioReplay {
  std::uint64_t id = 0;
  std::string why;
  ScenarioResult result;
  ReplayStage stage;
  Replay replay;
  Trace trace;  ///< may be without the motion of particles
  /// [frame, place, 3]; base, joints and flange of the arm from the middle of the palm. Empty: there is none.
  std::vector<double> arm_m;
};

/// Does the palm leave its upright attitude in any frame?
bool palm_turns(const Replay& replay);

/// What happened when, for people.
struct ReplayEvent {
  double time_s = 0;
  std::string_view kind;  ///< "touch", "part", "slip", "stop", "decided"
  std::string where;      ///< name of the surface, or the word of the outcome; may stay empty
};
/// A surface touches when its first contact closes, and parts when its last opens; a pad slips when all of its
/// contacts slide. What comes and goes within kSameEvent_s counts once. In the order of time.
inline constexpr double kSameEvent_s = 0.02;
std::vector<ReplayEvent> replay_events(const ScenarioReplay& seen);

/// @param row of the scenario among those of the page; none: it is not one of them
nlohmann::json replay_json(PackedColumns& packed, const ScenarioReplay& seen, std::optional<std::size_t> row);

}  // namespace unbruised::studies

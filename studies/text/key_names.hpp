#pragma once

/// @file
/// The names of keys as text: the unit a name ends in, its words, and which known name is spelt most like it.

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace unbruised::studies {

/// Keys that the studies themselves search, vary or halve.
inline constexpr const char* kGripForceKey = "strategy.grip_force_N";
inline constexpr const char* kTimeStepKey = "simulation.time_step_s";

/// A unit and how names, people and UDUNITS write it.
struct Unit {
  std::string_view suffix;   ///< of the key
  std::string_view display;  ///< "m/s2"
  std::string_view udunits;  ///< "m s-2"
  std::string_view after{};  ///< how what stands before it has to end: a stiffness and a torque are written alike
};
/// All of them, longer endings before those they end in.
std::span<const Unit> all_units();
/// The unit a key's name ends in; nullptr when it has none.
const Unit* unit_of(std::string_view path);

/// "strategy.lift_acceleration_m_s2" -> "lift acceleration", "product.size_m[0]" -> "size[0]"
std::string key_words(std::string_view path);
/// Names that would read wrongly with the underscores taken out, and their words.
std::span<const std::pair<std::string_view, std::string_view>> odd_key_words();

/// The path with every index emptied: "product.particle[].position_m[]".
std::string pattern_of(std::string_view path);

/// Optimal string alignment distance: edits and swaps of neighbours.
int edit_distance(std::string_view a, std::string_view b);
/// The known path spelt most like `path` among the candidates; empty when none is near.
std::string nearest(const std::string& path, const std::vector<std::string>& candidates);

}  // namespace unbruised::studies

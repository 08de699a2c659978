#pragma once

/// @file
/// A replay as sound: the force of the fingers as a tone, contact and slip as sounds of their own, damage as an
/// alarm. The page plays the same (report/src/replay/sound.js).

#include <span>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "studies/report/report_replay.hpp"

namespace unbruised::studies {

/// Pitch base + span x force / force_N; loudness the root of force / force_N.
struct SoundMap {
  double base_Hz = 160.0;
  double span_Hz = 640.0;
  double force_N = 1.0;  ///< at full loudness

  [[nodiscard]] double pitch_Hz(double force) const { return base_Hz + span_Hz * force / force_N; }
  [[nodiscard]] double loudness(double force) const;
};
/// One for all of them, so that they can be compared: full loudness at their largest force.
SoundMap sound_map(std::span<const ScenarioReplay> all);
nlohmann::json sound_json(const SoundMap& map);

/// The force of the finger that presses most, row by row of the trace [N]; empty without fingers.
std::vector<double> pressing_forces_N(const ScenarioReplay& seen);

inline constexpr int kSoundRate_Hz = 44100;
/// At the speed it happened, one channel of 16 bits: the bytes of a WAV file.
std::string wav_of(const ScenarioReplay& seen, const SoundMap& map);

}  // namespace unbruised::studies

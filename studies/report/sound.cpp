#include "studies/report/sound.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string_view>

#include <nlohmann/json.hpp>

#include "core/scenario/vectors.hpp"

namespace unbruised::studies {
namespace {

/// Of what a channel can carry: the tone at full loudness, and the sounds of events.
constexpr double kToneLevel = 0.35, kEventLevel = 0.3;

/// A value of the rows at a time, straight between two of them.
class Follower {
 public:
  Follower(std::span<const double> time_s, std::span<const double> values) : time_s_(time_s), values_(values) {}
  /// @param time_s not less than the last one asked for
  double at(double time_s) {
    while (row_ + 1 < time_s_.size() && time_s_[row_ + 1] <= time_s) ++row_;
    if (row_ + 1 >= time_s_.size() || time_s <= time_s_[row_]) return values_[row_];
    const double part = (time_s - time_s_[row_]) / (time_s_[row_ + 1] - time_s_[row_]);
    return values_[row_] + part * (values_[row_ + 1] - values_[row_]);
  }

 private:
  std::span<const double> time_s_, values_;
  std::size_t row_ = 0;
};

/// A short tone that dies away.
struct Beep {
  double at_s, pitch_Hz, length_s, level;
};

std::vector<Beep> beeps_of(const ReplayEvent& event) {
  if (event.kind == "touch") return {{event.time_s, 1200.0, 0.05, 0.9}};
  if (event.kind == "part") return {{event.time_s, 700.0, 0.05, 0.6}};
  if (event.kind == "slip") return {{event.time_s, 95.0, 0.16, 0.8}};
  if (event.kind != "decided" || event.where != "damaged") return {};
  std::vector<Beep> alarm;
  for (int i = 0; i < 4; ++i) alarm.push_back({event.time_s + 0.12 * i, i % 2 == 0 ? 1400.0 : 1050.0, 0.11, 1.0});
  return alarm;
}

void add(const Beep& beep, std::vector<double>& samples) {
  const auto first = static_cast<std::size_t>(std::max(0.0, beep.at_s * kSoundRate_Hz));
  const auto count = static_cast<std::size_t>(beep.length_s * kSoundRate_Hz);
  for (std::size_t i = 0; i < count && first + i < samples.size(); ++i) {
    const double time_s = static_cast<double>(i) / kSoundRate_Hz;
    samples[first + i] += kEventLevel * beep.level * std::exp(-5.0 * time_s / beep.length_s) *
                          std::sin(2.0 * std::numbers::pi * beep.pitch_Hz * time_s);
  }
}

void put(std::string& bytes, std::uint32_t value, int size) {
  for (int i = 0; i < size; ++i) bytes += static_cast<char>((value >> (8U * static_cast<unsigned>(i))) & 0xFFU);
}

std::string wav_bytes(const std::vector<double>& samples) {
  constexpr std::uint32_t kBytes = 2, kFormat = 16;
  const auto size = static_cast<std::uint32_t>(kBytes * samples.size());
  std::string bytes = "RIFF";
  put(bytes, 36 + size, 4);
  bytes += "WAVEfmt ";
  put(bytes, kFormat, 4);
  put(bytes, 1, 2);  // plain numbers
  put(bytes, 1, 2);  // one channel
  put(bytes, kSoundRate_Hz, 4);
  put(bytes, kSoundRate_Hz * kBytes, 4);
  put(bytes, kBytes, 2);
  put(bytes, 8 * kBytes, 2);
  bytes += "data";
  put(bytes, size, 4);
  for (const double sample : samples) {
    const auto whole = static_cast<std::int16_t>(std::lround(32767.0 * std::clamp(sample, -1.0, 1.0)));
    put(bytes, static_cast<std::uint16_t>(whole), 2);
  }
  return bytes;
}

}  // namespace

double SoundMap::loudness(double force) const { return std::min(1.0, std::sqrt(std::max(0.0, force) / force_N)); }

SoundMap sound_map(std::span<const ScenarioReplay> all) {
  SoundMap map;
  double most_N = 0.0;
  for (const ScenarioReplay& seen : all) {
    for (const double force_N : pressing_forces_N(seen)) most_N = std::max(most_N, force_N);
  }
  if (most_N > 0.0) map.force_N = most_N;
  return map;
}

nlohmann::json sound_json(const SoundMap& map) {
  return {{"base_Hz", map.base_Hz}, {"span_Hz", map.span_Hz}, {"force_N", map.force_N}};
}

std::vector<double> pressing_forces_N(const ScenarioReplay& seen) {
  const Trace& trace = seen.trace;
  const auto signal = std::find_if(trace.signals.begin(), trace.signals.end(),
                                   [](const TraceSignal& each) { return each.name == "finger_force_N"; });
  if (signal == trace.signals.end() || trace.time_s.empty()) return {};
  std::vector<std::array<double, 3>> normal;
  for (const ReplaySurface& surface : seen.replay.surface) {
    if (surface.kind == ReplaySurface::Kind::pad) normal.push_back(surface.axes[2]);
  }
  // A pad's normal tells pressing from carrying where the palm stays upright; else all force counts.
  const bool turns = palm_turns(seen.replay);
  const std::size_t width = signal->values.size() / trace.time_s.size();
  std::vector<double> largest(trace.time_s.size());
  for (std::size_t row = 0; row < largest.size(); ++row) {
    for (std::size_t f = 0; f < normal.size() && 3 * f + 2 < width; ++f) {
      const double* values = &signal->values[row * width + 3 * f];
      const std::array<double, 3> force_N = {values[0], values[1], values[2]};
      largest[row] = std::max(largest[row], turns ? length(force_N) : std::abs(dot(force_N, normal[f])));
    }
  }
  return largest;
}

std::string wav_of(const ScenarioReplay& seen, const SoundMap& map) {
  const std::vector<double> forces_N = pressing_forces_N(seen);
  const double end_s = seen.trace.time_s.empty() ? 0.0 : seen.trace.time_s.back();
  std::vector<double> samples(static_cast<std::size_t>(end_s * kSoundRate_Hz) + 1);
  if (!forces_N.empty()) {
    Follower force(seen.trace.time_s, forces_N);
    double turns = 0.0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const double force_N = force.at(static_cast<double>(i) / kSoundRate_Hz);
      samples[i] = kToneLevel * map.loudness(force_N) * std::sin(2.0 * std::numbers::pi * turns);
      turns += map.pitch_Hz(force_N) / kSoundRate_Hz;
    }
  }
  for (const ReplayEvent& event : replay_events(seen)) {
    for (const Beep& beep : beeps_of(event)) add(beep, samples);
  }
  return wav_bytes(samples);
}

}  // namespace unbruised::studies

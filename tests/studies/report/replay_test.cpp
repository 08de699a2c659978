// What goes into the page of a scenario in motion: coded tables, events, sound; and which scenarios do.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "studies/findings/replay_choice.hpp"
#include "studies/report/delta_coder.hpp"
#include "studies/report/report_replay.hpp"
#include "studies/report/sound.hpp"

namespace unbruised::studies {
namespace {

/// As report/src/replay/decode.js reads it.
std::vector<std::int64_t> decoded(const std::string& bytes, std::size_t width, std::size_t count) {
  std::size_t at = 0;
  const auto next = [&] {
    std::uint64_t value = 0;
    for (unsigned shift = 0;; shift += 7) {
      const auto byte = static_cast<unsigned char>(bytes.at(at++));
      value |= static_cast<std::uint64_t>(byte & 0x7FU) << shift;
      if (byte < 0x80U) return value;
    }
  };
  std::vector<std::int64_t> values, row(width, 0);
  std::uint64_t zeros = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (zeros > 0) {
      --zeros;
    } else {
      const std::uint64_t value = next();
      if (value == 0) {
        zeros = next();
      } else {
        row[i % width] +=
            value % 2 == 0 ? static_cast<std::int64_t>(value / 2) : -static_cast<std::int64_t>(value / 2) - 1;
      }
    }
    values.push_back(row[i % width]);
  }
  EXPECT_EQ(at, bytes.size()) << "bytes are left over";
  return values;
}

TEST(DeltaCoder, GivesBackEveryWholeNumber) {
  std::mt19937 chance(7);  // the same on every machine
  for (const std::size_t width : {1U, 3U, 40U}) {
    std::vector<std::int32_t> values;
    for (std::size_t i = 0; i < 50 * width; ++i) {
      const auto kind = chance() % 4;
      const std::int32_t before = i < width ? 0 : values[i - width];
      values.push_back(kind < 2    ? before
                       : kind == 2 ? before + static_cast<std::int32_t>(chance() % 9) - 4
                                   : static_cast<std::int32_t>(chance()) / 2);
    }
    const auto back = decoded(delta_coded(values, width), width, values.size());
    EXPECT_TRUE(std::equal(values.begin(), values.end(), back.begin(), back.end()));
  }
  EXPECT_EQ(delta_coded({}, 3), "");
}

TEST(DeltaCoder, IsOffByHalfAStepAtMostAndShortWhereNothingMoves) {
  std::vector<float> values;
  for (int row = 0; row < 100; ++row) {
    for (int i = 0; i < 30; ++i) values.push_back(0.003F * static_cast<float>(std::sin(0.1 * row + i)));
  }
  const CodedTable table = coded(values, 30, 1500);
  EXPECT_NEAR(table.step, 0.003 / 1500, 1e-9);
  const auto back = decoded(table.bytes, 30, values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    EXPECT_LE(std::abs(static_cast<double>(back[i]) * table.step - static_cast<double>(values[i])),
              0.5 * table.step * (1.0 + 1e-6));
  }
  const std::vector<float> resting(30 * 100, 0.5F);
  EXPECT_LT(coded(resting, 30, 1500).bytes.size(), 70U) << "a row, and one run of zeros";
}

const std::vector<ColumnInfo> kInputs = {{"strategy.grip_force_N", "N", ""}, {"product.use", "", ""}};

ScenarioRow row(std::uint64_t id, Outcome outcome, double force_N, double cycle_time_s = kAbsent) {
  ScenarioRow made;
  made.id = id;
  made.result.outcome = outcome;
  made.result.metrics[Metric::cycle_time_s] = cycle_time_s;
  made.inputs = {force_N, std::string("kiwi")};
  return made;
}

std::vector<std::uint64_t> ids(const std::vector<ChosenReplay>& chosen) {
  std::vector<std::uint64_t> found;
  for (const ChosenReplay& each : chosen) found.push_back(each.id);
  return found;
}

// 1.5 N is the middle of 1 to 2 N, which are held.
TEST(ReplayChoice, TakesTheBestHeldAndItsNearestNeighboursThatWentWrong) {
  const std::vector<ScenarioRow> rows = {row(0, Outcome::dropped, 0.5),   row(1, Outcome::slipped, 0.9),
                                         row(2, Outcome::held, 1.0, 1.9), row(3, Outcome::held, 1.5, 2.0),
                                         row(4, Outcome::damaged, 3.0),   row(5, Outcome::damaged, 2.2),
                                         row(6, Outcome::held, 2.0, 2.0)};
  const auto chosen = chosen_replays(kInputs, rows, {});
  EXPECT_EQ(ids(chosen), (std::vector<std::uint64_t>{3, 1, 5}));
  EXPECT_EQ(chosen[0].why, "best held");
  EXPECT_EQ(chosen[1].why, "nearest slipped");
  EXPECT_EQ(chosen[2].why, "nearest damaged");
  EXPECT_EQ(ids(chosen_replays(kInputs, rows, {4, 3})), (std::vector<std::uint64_t>{4, 3, 1, 5}));
}

TEST(ReplayChoice, PrefersTheSameProduct) {
  std::vector<ScenarioRow> rows = {row(0, Outcome::held, 1.0, 2.0), row(1, Outcome::damaged, 1.0),
                                   row(2, Outcome::damaged, 1.8)};
  rows[1].inputs[1] = std::string("peach");
  EXPECT_EQ(ids(chosen_replays(kInputs, rows, {})), (std::vector<std::uint64_t>{0, 2}));
}

TEST(ReplayChoice, HasSomethingToShowWithoutAHeldOne) {
  EXPECT_EQ(ids(chosen_replays(kInputs, {row(0, Outcome::not_run, 1.0), row(1, Outcome::diverged, 2.0)}, {})),
            (std::vector<std::uint64_t>{1}));
  EXPECT_TRUE(chosen_replays(kInputs, {row(0, Outcome::not_run, 1.0)}, {}).empty());
  EXPECT_TRUE(chosen_replays(kInputs, {}, {}).empty());
}

/// One pad along x whose force rises in a straight line over a second, in rows of 5 ms.
ScenarioReplay rising_force(double from_N, double to_N) {
  ScenarioReplay seen;
  ReplaySurface pad;
  pad.kind = ReplaySurface::Kind::pad;
  pad.finger = 0;
  pad.name = "left pad";
  pad.axes = {{{0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}, {1.0, 0.0, 0.0}}};
  seen.replay.surface = {pad};
  seen.replay.palm_attitude = {1.0, 0.0, 0.0, 0.0};
  TraceSignal force{.name = "finger_force_N",
                    .units = "N",
                    .long_name = "",
                    .dimensions = {"finger", "component"},
                    .extents = {1, 3},
                    .values = {}};
  for (int i = 0; i <= 200; ++i) {
    seen.trace.time_s.push_back(0.005 * i);
    const double force_N = from_N + (to_N - from_N) * 0.005 * i;
    force.values.insert(force.values.end(), {force_N, 0.2, -0.3});
  }
  seen.trace.signals = {force};
  return seen;
}

std::vector<double> samples_of(const std::string& wav) {
  std::vector<double> samples;
  for (std::size_t at = 44; at + 1 < wav.size(); at += 2) {
    const auto whole = static_cast<std::int16_t>(static_cast<unsigned char>(wav[at]) |
                                                 static_cast<unsigned char>(wav[at + 1]) << 8U);
    samples.push_back(whole / 32767.0);
  }
  return samples;
}

/// From the times at which it rises through zero around a time, by straight lines between samples.
double pitch_at(const std::vector<double>& samples, double time_s, double span_s) {
  std::vector<double> rises;
  const auto first = static_cast<std::size_t>((time_s - 0.5 * span_s) * kSoundRate_Hz);
  const auto last = static_cast<std::size_t>((time_s + 0.5 * span_s) * kSoundRate_Hz);
  for (std::size_t i = first; i < last; ++i) {
    if (samples[i] < 0.0 && samples[i + 1] >= 0.0) {
      rises.push_back(static_cast<double>(i) - samples[i] / (samples[i + 1] - samples[i]));
    }
  }
  return static_cast<double>(rises.size() - 1) * kSoundRate_Hz / (rises.back() - rises.front());
}

TEST(Sound, FollowsTheForceInPitchWithinTwoPerCent) {
  const ScenarioReplay seen = rising_force(0.5, 4.0);
  const SoundMap map = sound_map({&seen, 1});
  EXPECT_EQ(map.force_N, 4.0);
  const std::vector<double> samples = samples_of(wav_of(seen, map));
  EXPECT_NEAR(static_cast<double>(samples.size()), kSoundRate_Hz, 2.0);
  for (double time_s = 0.1; time_s < 0.95; time_s += 0.05) {
    const double wanted_Hz = map.pitch_Hz(0.5 + 3.5 * time_s);
    EXPECT_NEAR(pitch_at(samples, time_s, 0.05), wanted_Hz, 0.02 * wanted_Hz) << "at " << time_s << " s";
  }
}

TEST(Sound, IsLouderUnderMoreForce) {
  const ScenarioReplay seen = rising_force(0.0, 4.0);
  const std::vector<double> samples = samples_of(wav_of(seen, sound_map({&seen, 1})));
  const auto loudest = [&](std::size_t from, std::size_t to) {
    return *std::max_element(samples.begin() + static_cast<std::ptrdiff_t>(from),
                             samples.begin() + static_cast<std::ptrdiff_t>(to));
  };
  const double early = loudest(9000, 11000), late = loudest(42000, 44000);
  // The root of the force: a quarter of it is half as loud.
  EXPECT_NEAR(early / late, std::sqrt(0.25), 0.05);
}

/// Energy at a pitch over a stretch (Goertzel), per sample.
double energy_at(const std::vector<double>& samples, double pitch_Hz, double from_s, double to_s) {
  double real = 0.0, imaginary = 0.0;
  const auto first = static_cast<std::size_t>(from_s * kSoundRate_Hz),
             last = static_cast<std::size_t>(to_s * kSoundRate_Hz);
  for (std::size_t i = first; i < last; ++i) {
    const double turn = 2.0 * std::numbers::pi * pitch_Hz * static_cast<double>(i) / kSoundRate_Hz;
    real += samples[i] * std::cos(turn);
    imaginary += samples[i] * std::sin(turn);
  }
  return std::hypot(real, imaginary) / static_cast<double>(last - first);
}

TEST(Sound, SoundsAnAlarmWhereDamageIsDecidedAndNowhereElse) {
  ScenarioReplay seen = rising_force(0.5, 1.0);
  seen.result.outcome = Outcome::damaged;
  seen.result.outcome_time_s = 0.4;
  const std::vector<double> samples = samples_of(wav_of(seen, sound_map({&seen, 1})));
  EXPECT_GT(energy_at(samples, 1400.0, 0.4, 0.45), 10.0 * energy_at(samples, 1400.0, 0.3, 0.35));
  EXPECT_GT(energy_at(samples, 1050.0, 0.52, 0.57), 10.0 * energy_at(samples, 1050.0, 0.3, 0.35));
}

ContactEvent contact(double time_s, ContactEvent::Kind kind, int number) {
  ContactEvent event;
  event.time_s = time_s;
  event.kind = kind;
  event.contact = number;
  return event;
}

TEST(ReplayEvents, TellOfASurfaceWhatItsContactsDo) {
  using Kind = ContactEvent::Kind;
  ScenarioReplay seen = rising_force(0.0, 1.0);
  seen.trace.events = {contact(0.1, Kind::make, 4),   contact(0.11, Kind::make, 7), contact(0.2, Kind::slip, 4),
                       contact(0.25, Kind::slip, 7),  contact(0.3, Kind::stick, 4), contact(0.4, Kind::stick, 7),
                       contact(0.5, Kind::break_, 4), contact(0.6, Kind::break_, 7)};
  const auto events = replay_events(seen);
  ASSERT_EQ(events.size(), 3U);
  EXPECT_EQ(events[0].kind, "touch");
  EXPECT_EQ(events[0].time_s, 0.1);
  EXPECT_EQ(events[1].kind, "slip");
  EXPECT_EQ(events[1].time_s, 0.25) << "one contact that slides is no slip of the pad";
  EXPECT_EQ(events[2].kind, "part");
  EXPECT_EQ(events[2].time_s, 0.6);
  EXPECT_EQ(events[2].where, "left pad");
}

TEST(ReplayEvents, CountOnceWhatChatters) {
  using Kind = ContactEvent::Kind;
  ScenarioReplay seen = rising_force(0.0, 1.0);
  for (int i = 0; i < 10; ++i) {
    seen.trace.events.push_back(contact(0.1 + 0.004 * i, Kind::make, 1));
    seen.trace.events.push_back(contact(0.102 + 0.004 * i, Kind::break_, 1));
  }
  EXPECT_EQ(replay_events(seen).size(), 2U);
}

}  // namespace
}  // namespace unbruised::studies

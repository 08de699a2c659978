#pragma once

/// @file
/// The plan of one handling cycle: approach, grip, lift, hold, transfer, lower, release, recover. Times are real
/// numbers; everything after the approach is fixed by the time of the first contact.

#include <array>
#include <cstdint>
#include <limits>
#include <string_view>

#include "core/motion/profile.hpp"
#include "core/scenario/scenario.hpp"

namespace unbruised {

/// Motion of the palm along x, y, z from where it stood during the approach.
struct PalmState {
  std::array<double, 3> position_m{};
  std::array<double, 3> velocity_m_s{};
  std::array<double, 3> acceleration_m_s2{};
};

/// The phases in their order; the codes stand in results files.
enum class CyclePhase : std::uint8_t { approach, grip, lift, hold, transfer, lower, release, recover };
inline constexpr std::array<std::string_view, 8> kCyclePhaseWords = {"approach", "grip",  "lift",    "hold",
                                                                     "transfer", "lower", "release", "recover"};

class HandlingCycle {
 public:
  HandlingCycle() = default;
  explicit HandlingCycle(const Scenario& scenario);

  /// The first contact of a finger: fixes every later time. Ignored once set.
  void contact_made(double time_s);
  [[nodiscard]] bool has_contact() const { return first_contact_s_ < kNever; }

  /// The phase at a time; lower lasts until the fingers open.
  [[nodiscard]] CyclePhase phase(double time_s) const;
  [[nodiscard]] PalmState palm(double time_s) const;
  /// Largest drive force per finger.
  [[nodiscard]] double force_limit_N(double time_s) const;
  /// Closing speed the drive aims at per finger, before the end stops of the stroke are looked at.
  [[nodiscard]] double set_speed_m_s(double time_s) const;
  /// Height of the plane under the product.
  [[nodiscard]] double support_height_m(double time_s) const;

  static constexpr double kNever = std::numeric_limits<double>::infinity();
  [[nodiscard]] double first_contact_s() const { return first_contact_s_; }
  [[nodiscard]] double lift_start_s() const { return lift_start_s_; }
  [[nodiscard]] double lift_end_s() const { return lift_end_s_; }
  [[nodiscard]] double hold_end_s() const { return hold_end_s_; }
  [[nodiscard]] double lower_end_s() const { return lower_end_s_; }
  [[nodiscard]] double release_start_s() const { return release_start_s_; }
  [[nodiscard]] double release_end_s() const { return release_end_s_; }
  /// End of the run.
  [[nodiscard]] double end_s() const { return end_s_; }
  /// Without a first contact by then, there is nothing between the fingers.
  [[nodiscard]] double approach_deadline_s() const { return approach_deadline_s_; }

 private:
  void schedule(double ramp_start_s);

  Scenario scenario_{};
  MotionProfile lift_, transfer_, lower_;
  std::array<double, 2> transfer_direction_{0.0, 0.0};
  double first_contact_s_ = kNever;
  double ramp_start_s_ = kNever;
  double lift_start_s_ = kNever, lift_end_s_ = kNever, hold_end_s_ = kNever, transfer_end_s_ = kNever;
  double lower_end_s_ = kNever, release_start_s_ = kNever, release_end_s_ = kNever;
  double end_s_ = kNever, approach_deadline_s_ = kNever;
};

}  // namespace unbruised

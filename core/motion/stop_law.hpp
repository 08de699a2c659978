#pragma once

/// @file
/// How a palm brakes along its path.

#include <vector>

#include "core/motion/palm_path.hpp"

namespace unbruised {

/// The path is gone along as it was planned, but ever slower: at the time t the palm is where the plan has it at
/// s(t), with s' = 1 at the start of the stop and 0 at its end; s'' is even in each of its parts.
class StopLaw {
 public:
  /// At rest from this time of the plan on, at once.
  explicit StopLaw(double start_s) : end_{start_s, 1.0, 0.0} {}

  struct State {
    double plan_s = 0.0, rate = 0.0, change_1_s = 0.0;  ///< s, s', s''
  };
  /// Changes s' by so much a second for so long.
  void add(double change_1_s, double duration_s);

  [[nodiscard]] double duration_s() const { return duration_s_; }
  /// @param since_s >= 0
  [[nodiscard]] State at(double since_s) const;
  /// Where a palm is that goes along the plan with this s.
  /// @param planned what the plan has at s
  [[nodiscard]] static PalmState slowed(PalmState planned, const State& s);

 private:
  struct Part {
    double since_s;
    State start;
  };
  /// A time h later.
  [[nodiscard]] static State after(State start, double h);

  State end_;  ///< of the last part
  double duration_s_ = 0.0;
  std::vector<Part> part_;
};

}  // namespace unbruised

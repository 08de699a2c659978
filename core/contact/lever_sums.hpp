#pragma once

/// @file
/// How contact forces turn the body as a whole within a step, all lanes at once: a place turns with it about its
/// particle, and a force on a place turns it by its arm (docs/theory.md, "Places that touch").

#include <array>

#include "core/lanes/lane_vector.hpp"

namespace unbruised {

class LeverSums {
 public:
  LeverSums() = default;
  /// @param turn_per_moment of the contact model
  explicit LeverSums(const std::array<double, 9>& turn_per_moment) {
    for (std::size_t i = 0; i < 9; ++i) turn_per_moment_.at[i] = Lane(turn_per_moment[i]);
  }

  /// How a moment turns the body within a step.
  [[nodiscard]] LaneVector turn_by(const LaneVector& moment_N_m) const { return turn_per_moment_ * moment_N_m; }
  /// Starts anew in `lanes`. @param moment_N_m of all that acts but contact
  void restart(const LaneVector& moment_N_m, const Mask& lanes) {
    turn_ = select(lanes, turn_by(moment_N_m), turn_);
    turn_by_arms_ = select(lanes, LaneVector{}, turn_by_arms_);
  }
  /// A force has changed. @param X of the particle it acts on @param arm from there to its place
  /// @return by how much more than before arms turn the body
  [[gnu::always_inline]] LaneVector add(const LaneVector& X, const LaneVector& arm, const LaneVector& force_N) {
    const LaneVector by_arm = turn_per_moment_ * cross(arm, force_N);
    turn_ += turn_per_moment_ * cross(X, force_N) + by_arm;
    turn_by_arms_ += by_arm;
    return by_arm;
  }

  /// Of the body at t + theta dt against its frame [rad].
  [[nodiscard]] const LaneVector& turn() const { return turn_; }
  /// The part of it that the forces' action on particles does not bring.
  [[nodiscard]] const LaneVector& turn_by_arms() const { return turn_by_arms_; }

 private:
  LaneMatrix turn_per_moment_;
  LaneVector turn_, turn_by_arms_;
};

}  // namespace unbruised

#pragma once

/// @file
/// The largest force of a drive over the speed of its finger, all lanes at once: falling, linear between points,
/// that at rest where the motion goes against the force, and that of the last point beyond it.

#include <span>
#include <vector>

#include "core/lanes/lane.hpp"

namespace unbruised {

class ForceCurveLanes {
 public:
  /// From a point on: force + slope x (speed - speed of the point).
  struct Piece {
    Lane speed_m_s{0.0}, force_N{kUnlimited}, slope_N_s_m{0.0};
  };

  /// @param speed_m_s ascending from 0 @param force_N as many, not rising; none: no limit
  void load(int lane, std::span<const double> speed_m_s, std::span<const double> force_N);
  /// Lanes that have a curve, and is there one?
  [[nodiscard]] const Mask& given() const { return given_; }
  [[nodiscard]] bool any_given() const { return any_given_; }
  [[nodiscard]] const std::vector<Piece>& pieces() const { return piece_; }
  /// Largest force at a speed along it.
  [[nodiscard]] Lane force_N(const Lane& speed_m_s) const;

 private:
  /// Above every force, and small enough to calculate with.
  static constexpr double kUnlimited = 1e200;

  Mask given_{false};
  bool any_given_ = false;
  std::vector<Piece> piece_ = std::vector<Piece>(1);
};

}  // namespace unbruised

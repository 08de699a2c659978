#pragma once

/// @file
/// The largest pressure averaged over a square window that slides over the places of a surface that carry force,
/// all lanes at once.

#include <array>
#include <vector>

#include "core/lanes/lane.hpp"

namespace unbruised {

class PlaceWindows {
 public:
  /// @param side_m of the window
  explicit PlaceWindows(double side_m) : side_m_(side_m) {}

  void clear() { place_.clear(); }
  /// @param at on the face
  void add(const std::array<Lane, 2>& at, const Lane& force_N) { place_.push_back({at, force_N}); }
  /// Largest force within a window around one of the places over its area [Pa].
  [[nodiscard]] Lane largest_Pa() const;

 private:
  struct Place {
    std::array<Lane, 2> at;
    Lane force_N;
  };
  double side_m_;
  std::vector<Place> place_;
};

}  // namespace unbruised

#pragma once

/// @file
/// How much of each place of a tributary rectangle a surface covers, where its edge cuts a curved contact.

#include <cstddef>

#include "core/contact/tributary.hpp"
#include "core/lanes/lane.hpp"

namespace unbruised {

/// Weights of the places of one candidate, mean 1 over those of the rectangle.
class PlaceCover {
 public:
  /// Every place in full.
  PlaceCover() = default;
  /// @param first kReliefSide rows of weights along the first tangent @param second along the second
  PlaceCover(const double* first, const double* second) : first_(first), second_(second) {}

  [[nodiscard]] bool is_full() const { return first_ == nullptr; }
  [[nodiscard]] Lane weight(int place) const {
    return load(first_ + kLanes * (place % kReliefSide)) * load(second_ + kLanes * (place / kReliefSide));
  }

 private:
  const double* first_ = nullptr;
  const double* second_ = nullptr;
};

}  // namespace unbruised

#pragma once

/// @file
/// How much of each place of a tributary rectangle a surface covers, where its edge cuts a curved contact, and how
/// far the surface lies behind the face of a shaped pad there.

#include <array>
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
  /// @param relief of a shaped pad: kReliefPlaces rows
  PlaceCover(const double* first, const double* second, const double* relief = nullptr)
      : first_(first), second_(second), relief_(relief) {}

  [[nodiscard]] bool is_full() const { return first_ == nullptr; }
  [[nodiscard]] Lane weight(int place) const {
    return load(first_ + kLanes * (place % kReliefSide)) * load(second_ + kLanes * (place / kReliefSide));
  }
  /// How far the true surface lies behind the one at the particle, seen from the surface it meets [m].
  /// @param of_product before a plane
  template <std::size_t places>
  [[nodiscard]] Lane relief(const std::array<double, places>& of_product, int place) const {
    return relief_ == nullptr ? Lane(of_product[static_cast<std::size_t>(place)]) : load(relief_ + kLanes * place);
  }

 private:
  const double* first_ = nullptr;
  const double* second_ = nullptr;
  const double* relief_ = nullptr;
};

}  // namespace unbruised

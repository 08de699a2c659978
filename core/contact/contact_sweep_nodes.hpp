#pragma once

/// @file
/// What a pass of the contact solve looks at a node through; inside contact_sweep.cpp.

#include "core/contact/contact_sweep.hpp"

namespace unbruised {

/// The contact node whose candidates are being updated, in the axes of the product.
struct ContactSweep::Node {
  LaneArray& force;       ///< of all nodes
  std::size_t row;        ///< of its x freedom
  const double* own;      ///< its 3x3 block of the compliance
  std::array<Lane, 3> d;  ///< its displacement under the present forces

  [[nodiscard, gnu::always_inline]] Lane compliance(std::size_t axis) const { return Lane(own[4 * axis]); }
  [[gnu::always_inline]] void push(std::size_t axis, const Lane& sign, const Lane& change) {
    for (std::size_t i = 0; i < 3; ++i) d[i] += Lane(own[3 * i + axis]) * sign * change;
    force.put(row + axis, force.get(row + axis) + sign * change);
  }
  [[gnu::always_inline]] void push(const std::array<std::size_t, 2>& axis, const std::array<Lane, 2>& change) {
    for (std::size_t i = 0; i < 3; ++i) {
      d[i] += Lane(own[3 * i + axis[0]]) * change[0] + Lane(own[3 * i + axis[1]]) * change[1];
    }
    for (std::size_t t = 0; t < 2; ++t) force.put(row + axis[t], force.get(row + axis[t]) + change[t]);
  }
  void push(const LaneVector& change) {
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) d[i] += Lane(own[3 * i + j]) * change[j];
      force.put(row + i, force.get(row + i) + change[i]);
    }
  }
};

/// The same node in the axes of a surface's carrier.
struct ContactSweep::TurnedNode {
  const double* own;     ///< rows of lanes
  LaneVector d, change;  ///< `change` of the force so far

  [[nodiscard, gnu::always_inline]] Lane block(std::size_t i, std::size_t j) const {
    return load(own + static_cast<std::size_t>(kLanes) * (3 * i + j));
  }
  [[nodiscard, gnu::always_inline]] Lane compliance(std::size_t axis) const { return block(axis, axis); }
  [[gnu::always_inline]] void push(std::size_t axis, const Lane& sign, const Lane& by) {
    for (std::size_t i = 0; i < 3; ++i) d[i] += block(i, axis) * sign * by;
    change[axis] += sign * by;
  }
  [[gnu::always_inline]] void push(const std::array<std::size_t, 2>& axis, const std::array<Lane, 2>& by) {
    for (std::size_t t = 0; t < 2; ++t) push(axis[t], Lane(1.0), by[t]);
  }
  [[nodiscard, gnu::always_inline]] bool has_changed() const {
    return any(max(abs(change[0]), max(abs(change[1]), abs(change[2]))) > Lane(0.0));
  }
};

}  // namespace unbruised

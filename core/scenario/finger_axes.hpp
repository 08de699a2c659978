#pragma once

/// @file
/// How many fingers a gripper may have, and where the pad of one that it lists faces.

#include <array>
#include <cstddef>

#include "core/scenario/finger.hpp"

namespace unbruised {

/// That a gripper may list.
inline constexpr int kMostFingers = 8;
/// Of a gripper that lists none.
inline constexpr int kJawFingers = 2;

/// Axes of its pad in those of the palm, as rows: its two extents, across and up, and the direction in which it
/// closes.
std::array<std::array<double, 3>, 3> finger_axes(const FingerParameters& finger);

/// Across which axis the face of an upright product lies that a pad meets which closes in this direction.
std::size_t faced_axis(const std::array<double, 3>& direction);
/// The two directions in the face across an axis.
std::array<std::size_t, 2> face_tangents(std::size_t axis);

}  // namespace unbruised

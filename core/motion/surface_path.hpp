#pragma once

/// @file
/// How a surface that the cell lists moves along its path.

#include <array>

#include "core/scenario/cell_surface.hpp"

namespace unbruised {

/// Along the surface's own axes (its two extents, its normal), from where it stands at the start.
struct SurfaceMotion {
  std::array<double, 3> place_m{}, velocity_m_s{}, acceleration_m_s2{};
};

SurfaceMotion surface_motion(const CellSurfaceParameters& surface, double time_s);

}  // namespace unbruised

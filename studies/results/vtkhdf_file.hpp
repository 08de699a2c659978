#pragma once

/// @file
/// A replay as VTKHDF, which ParaView 5.12 and VTK 9.3 read: one grid of triangles, quadrilaterals and points
/// whose points move from step to step (docs/commands.md says what is in it).

#include <filesystem>

#include "core/outcome/replay.hpp"
#include "studies/results/expected.hpp"

namespace unbruised::studies {

/// Cells carry the number of their part: 0 the product, then the surfaces in the order of traces; each surface has
/// a point where the pressure on it has its centre, with the force.
MaybeError write_vtkhdf(const std::filesystem::path& path, const Replay& replay);

}  // namespace unbruised::studies

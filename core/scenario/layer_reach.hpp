#pragma once

/// @file
/// How far a layer is followed when it is pressed in.

namespace unbruised {

/// Over its thickness. A layer whose law was measured in points is followed as deep as it was measured.
inline constexpr double kFollowedLayerStrain = 0.8;

}  // namespace unbruised

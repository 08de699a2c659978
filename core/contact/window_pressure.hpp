#pragma once

/// @file
/// The largest pressure averaged over a square window that slides over the part of a face that a surface covers,
/// all lanes at once (docs/theory.md, "Areas of contact").

#include <array>
#include <vector>

#include "core/contact/contact_model.hpp"
#include "core/lanes/lane.hpp"
#include "core/lanes/lane_archive.hpp"
#include "core/surface/surface_lanes.hpp"

namespace unbruised {

class WindowPressure {
 public:
  /// @param grid has to outlive this @param side_m of the window
  WindowPressure(const FaceGrid& grid, double side_m);

  /// Largest force within a window / its area, in each lane [Pa]. A window lies within the covered part of the
  /// face where it is large enough, and in its middle where not.
  /// @param normal_N force of every candidate of the contact model
  /// @param reach of the surface along the tangents, relative to the particles' places at rest
  /// @param lanes that are asked for
  [[nodiscard]] Lane largest_Pa(const LaneArray& normal_N, const std::array<Stretch, 2>& reach, const Mask& lanes);
  /// Forgets where the windows of another scenario lay.
  void clear(int lane);
  /// Where those of a lane lie.
  void archive(LaneArchive& lane);

 private:
  /// Which part of each piece's force along one axis lies in which window.
  struct Axis {
    Stretch reach{Lane(0.0), Lane(0.0)};  ///< of the surface when its windows were laid
    bool laid = true;                     ///< by this reach
    std::size_t windows = 0;
    LaneArray share;                                ///< rows window x pieces + piece
    std::vector<std::array<std::size_t, 2>> piece;  ///< of each window: from, to
  };
  /// Lays windows over the covered part, close enough that the largest is hardly missed: a quarter of their side.
  void lay_windows(std::size_t tangent);

  const FaceGrid& grid_;
  double side_m_;
  std::array<Axis, 2> axis_;
  LaneArray row_N_;  ///< per piece of the first tangent: its force within a window of the second
};

}  // namespace unbruised

#pragma once

/// @file
/// The surfaces of every lane: the layer, the friction and the frame of each, and how it moves with its carrier.

#include <array>

#include "core/lanes/lane.hpp"
#include "core/lanes/lane_archive.hpp"
#include "core/scenario/pad_face.hpp"
#include "core/scenario/scenario.hpp"
#include "core/surface/carrier_motion.hpp"
#include "core/surface/layer_curve.hpp"
#include "core/surface/surfaces.hpp"

namespace unbruised {

/// A stretch of an axis, per lane [m].
struct Stretch {
  Lane low, high;
};

/// One surface, per lane.
struct SurfaceLane {
  Mask present{false};
  Mask has_rim{false};  ///< a rectangle that the cell lists
  Lane friction{1.0};
  Lane stiffness_N_m3{1.0};  ///< of the layer, per area
  Lane backing_N_m3{1.0};    ///< the same; of a pad that is a body what a layer in its place would have
  Lane springs_N_m3{1.0};    ///< E / thickness of the layer; a third of it in shear
  Lane thickness_m{1.0};     ///< of the layer
  Lane edge_radius_m{0.0};   ///< of a pad
  LayerCurve curve;          ///< of a pad that is measured
  Lane bent{0.0};            ///< 1: the face of a pad is no plane
  Lane relaxation_s{0.0};    ///< of the layer
  Lane rest_place_m{0.0};    ///< along the normal axis, where neither carrier nor finger has moved
  std::array<Lane, 2> center_m{Lane(0.0), Lane(0.0)};  ///< along the tangent axes
  std::array<Lane, 2> size_m{Lane(1.0), Lane(1.0)};    ///< along the tangent axes
  /// From the axes of its carrier to those of a surface that is listed, and its origin: of a pad from the middle
  /// of the grip, along the axes of the palm. All others have the axes of their carrier.
  LaneMatrix axes = identity_lanes();
  LaneVector origin_m;
};

/// Where the product stands between the surfaces of one lane.
struct ProductPlace {
  std::array<double, 3> center_m{};
  std::array<double, kJawFingers> pole_m{};  ///< outermost place along the normal axis of each pad
};

class SurfaceLanes {
 public:
  /// Sets the surfaces of a lane up for a scenario.
  /// @param layer_N_m3 stiffness per area of the layers of pads and support
  void load(int lane, const Scenario& scenario, const ProductPlace& product,
            const std::array<double, kFirstCellSurface>& layer_N_m3);

  /// All that changes in a lane after `load`.
  void archive(LaneArchive& lane) {
    for (SurfaceLane& surface : surface_) lane(surface.present);
  }

  /// Nothing touches this surface of a lane until the next load.
  void remove(int surface, int lane) { surface_[static_cast<std::size_t>(surface)].present.set(lane, false); }

  [[nodiscard]] const SurfaceLane& operator[](int surface) const { return surface_[surface]; }
  /// The face of the pads of a lane.
  [[nodiscard]] const PadFace& face(int lane) const { return face_[static_cast<std::size_t>(lane)]; }
  /// The middle of the grip where the palm has not moved.
  [[nodiscard]] const LaneVector& grip_m() const { return grip_m_; }

  /// Place along the normal axis.
  /// @param way that its finger has closed; not looked at where no finger carries it
  [[nodiscard, gnu::always_inline]] Lane place(int surface, const CarrierMotion& carriers, const Lane& way) const;
  /// Place, velocity and acceleration along the normal axis.
  /// @param closing motion of its finger; not looked at where no finger carries it
  [[nodiscard]] AxisMotion motion(int surface, const CarrierMotion& carriers, const AxisMotion& closing) const;
  /// From where to where the surface reaches along one of its tangent axes; far beyond any product where it has no
  /// edge.
  [[nodiscard]] Stretch reach(int surface, const CarrierMotion& carriers, std::size_t tangent) const;

 private:
  static void load_listed(int lane, const CellSurfaceParameters& parameters, SurfaceLane& surface);
  void load_fingers(int lane, const Scenario& scenario, double layer_N_m3);

  std::array<SurfaceLane, kSurfaceCount> surface_;
  std::array<PadFace, kLanes> face_;
  LaneVector grip_m_;
};

/// How the carrier of a surface moves.
inline const std::array<AxisMotion, 3>& carrier_of(int surface, const CarrierMotion& carriers) {
  if (is_pad(surface)) return carriers.palm;
  if (surface == kSupport) return carriers.cell;
  return carriers.listed[static_cast<std::size_t>(surface - kFirstCellSurface)];
}

// Asked for in every sweep over every contact.
inline Lane SurfaceLanes::place(int surface, const CarrierMotion& carriers, const Lane& way) const {
  const Lane& carried = carrier_of(surface, carriers)[normal_axis(surface)].place_m;
  if (!is_pad(surface)) return carried;
  return surface_[surface].rest_place_m + Lane(normal_sign(surface)) * way + carried;
}

/// Length of the overlap of a piece of width `extent` around `place` with one of width `size` around 0; not
/// negative.
[[gnu::always_inline]] inline Lane overlap(const Lane& place, const Lane& half_extent, const Lane& half_size) {
  return max0(min(place + half_extent, half_size) - max(place - half_extent, -half_size));
}

}  // namespace unbruised

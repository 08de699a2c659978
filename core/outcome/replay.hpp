#pragma once

/// @file
/// What there is to see of one scenario: the product's true surface with its deformation and its fields, and what
/// touches it, from frame to frame. Everything along x, y, z unless it says otherwise.

#include <array>
#include <string>
#include <vector>

namespace unbruised {

/// A face that the product can touch.
struct ReplaySurface {
  enum class Kind {
    pad,      ///< goes with the palm and its finger
    support,  ///< what the product stands on
    listed,   ///< by the cell
    absent,   ///< a pad where there is no gripper: it has its number in traces, and no face
  };
  Kind kind = Kind::support;
  std::string name;
  int finger = -1;  ///< of a pad
  /// Its middle, where nothing has moved: of a pad from the middle of the grip, along the axes of the palm.
  std::array<double, 3> origin_m{};
  /// As rows: the directions of its two extents, and the normal towards the product, along which a finger closes.
  std::array<std::array<double, 3>, 3> axes{};
  std::array<double, 2> size_m{};  ///< 0: it has no edge
  double thickness_m = 0;
  /// Heights of a pad's face that is no plane, on a grid of kReplayFaceSide x kReplayFaceSide places over it,
  /// along the second extent first. Empty: it is one.
  std::vector<double> height_m;
};

inline constexpr int kReplayFaceSide = 17;

/// Rows of all tables: frames, each row as wide as it says.
struct Replay {
  // Once.
  std::vector<std::array<double, 3>> vertex_m;  ///< of the undeformed surface, from the centre of mass at rest
  std::vector<std::array<int, 3>> triangle;     ///< counter-clockwise from outside
  std::vector<std::array<int, 2>> line;         ///< springs of a network, whose vertices are its particles
  std::array<double, 3> grip_m{};               ///< middle of the grip where the palm has not moved
  std::vector<ReplaySurface> surface;           ///< in the order of traces
  std::vector<double> permanent_m;              ///< [vertex, 3]; what the plastic strain alone leaves of the shape

  std::vector<double> time_s;
  std::vector<double> product_m;      ///< [3]; of the centre of mass
  std::vector<double> attitude;       ///< [4]; unit quaternion w, x, y, z of the product as a whole
  std::vector<double> palm_m;         ///< [3]; since the start
  std::vector<double> palm_attitude;  ///< [4]
  std::vector<double> finger_way_m;   ///< [finger]
  std::vector<double> support_m;      ///< [3]; of the plane, and of a belt's points
  std::vector<double> listed_m;       ///< [listed, 3]; since the start
  std::vector<double> force_N;        ///< [surface, 3]; on the product
  std::vector<double> force_place_m;  ///< [surface, 3]; centre of the pressure; 0 where there is none
  std::vector<double> wrist_wrench;   ///< [6]; what an ideal sensor in the palm's middle reads of the fingers
  /// [vertex, 3]; along the axes of the attitude: a vertex stands at product_m + R (vertex_m + deformation).
  std::vector<float> deformation_m;
  std::vector<float> plastic_strain;  ///< [vertex]; of the cells, and of what the patches left below them
  std::vector<float> von_mises_Pa;    ///< [vertex]; mean of the cells around
  std::vector<float> pressure_Pa;     ///< [vertex]; of contacts

  [[nodiscard]] std::size_t frame_count() const { return time_s.size(); }
};

}  // namespace unbruised

#pragma once

/// @file
/// The true surface of a product as its particles carry it, met by rays (docs/range_sensors.md). A place X of the
/// shape at rest stands at c + R (X + u(X)), u being interpolated between the particles that stand for the true
/// surface on the side that the ray meets.

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/body/body_motion.hpp"
#include "core/body/lattice.hpp"
#include "core/scenario/true_shape.hpp"

namespace unbruised {

/// From a place along a unit vector, in x, y, z.
struct Ray {
  std::array<double, 3> start_m{};
  std::array<double, 3> direction{};
};

/// How a body stands as a whole.
struct BodyPose {
  std::array<double, 3> center_m{};  ///< where the shape's middle stands but for u, in x, y, z
  std::array<std::array<double, 3>, 3> axes{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};  ///< R
  std::array<double, 3> mean_displacement_m{};  ///< of u, in the axes of the body
};

/// Of one lane, at the end of a step.
BodyPose pose_of(const BodyMotion& body, const BodyModel& model, int lane);

class CarriedSurface {
 public:
  CarriedSurface(const TrueShape& shape, const Lattice& lattice);

  /// How far a ray comes before it meets the surface [m]; 0 where it starts inside; none: it passes.
  /// @param u displacements of the particles in the axes of the body, rows 3 x particle + axis
  [[nodiscard]] std::optional<double> distance_m(const Ray& ray, const BodyPose& pose, const LaneArray& u,
                                                 int lane) const;

 private:
  /// One of the six sides as a grid of columns.
  struct Side {
    std::size_t axis = 0;
    std::array<std::size_t, 2> tangent{};
    std::array<int, 2> columns{};  ///< of particles, along the tangents
    std::vector<int> node;         ///< outermost particle of each column, of the nearest one where there is none
  };
  [[nodiscard]] Side make_side(const Lattice& lattice, std::size_t axis,
                               const std::vector<SurfacePoint>& points) const;
  [[nodiscard]] const Side& met_side(const std::array<double, 3>& direction,
                                     const std::array<double, 3>& normal) const;
  [[nodiscard]] std::array<double, 3> displacement_m(const Side& side, const std::array<double, 3>& place_m,
                                                     const LaneArray& u, int lane) const;

  TrueShape shape_;
  std::array<int, 3> cells_{};
  std::array<double, 3> cell_extent_m_{};
  std::array<Side, 6> side_;  ///< -x, +x, -y, +y, -z, +z
};

}  // namespace unbruised

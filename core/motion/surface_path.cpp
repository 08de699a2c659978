#include "core/motion/surface_path.hpp"

#include "core/motion/profile.hpp"

namespace unbruised {
namespace {

/// How a stretch of the path is travelled from 0 to 1.
MotionProfile::State progress(const CellSurfaceParameters& surface, std::size_t stretch, double time_s) {
  const double from_s = surface.path_time_s[stretch], to_s = surface.path_time_s[stretch + 1];
  return MotionProfile::in_time(ProfileKind::minimum_jerk, 1.0, to_s - from_s).at(time_s - from_s);
}

}  // namespace

SurfaceMotion surface_motion(const CellSurfaceParameters& surface, double time_s) {
  SurfaceMotion motion;
  if (surface.path_time_s.size() < 2) return motion;
  SurfaceMotion along;  // x, y, z
  for (std::size_t stretch = 0; stretch + 1 < surface.path_time_s.size(); ++stretch) {
    if (time_s < surface.path_time_s[stretch]) break;
    const MotionProfile::State state = progress(surface, stretch, time_s);
    for (std::size_t i = 0; i < 3; ++i) {
      const double way = surface.path_m[stretch + 1][i] - surface.path_m[stretch][i];
      along.place_m[i] = surface.path_m[stretch][i] - surface.path_m[0][i] + way * state.position_m;
      along.velocity_m_s[i] = way * state.velocity_m_s;
      along.acceleration_m_s2[i] = way * state.acceleration_m_s2;
    }
  }
  const auto axes = surface_axes(surface);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      motion.place_m[i] += axes[i][j] * along.place_m[j];
      motion.velocity_m_s[i] += axes[i][j] * along.velocity_m_s[j];
      motion.acceleration_m_s2[i] += axes[i][j] * along.acceleration_m_s2[j];
    }
  }
  return motion;
}

}  // namespace unbruised

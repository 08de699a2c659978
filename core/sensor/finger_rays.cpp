#include "core/sensor/finger_rays.hpp"

#include "core/scenario/attitude.hpp"
#include "core/scenario/guard.hpp"

namespace unbruised {

std::array<Ray, kJawFingers> finger_rays(const Scenario& scenario, const std::array<double, 3>& middle_m,
                                         const CarrierMotion& carriers, const GripperLanes& gripper, int lane) {
  std::array<Ray, kJawFingers> rays{};
  const auto* jaw = parallel_jaw(scenario);
  if (jaw == nullptr) return rays;
  const Attitude palm = attitude_of(of_lane(carriers.palm_rotation_rad, lane));
  // The palm turns about the middle between the pads.
  const std::array<double, 3> from_product = {0.0, scenario.cell.grip_offset_m, scenario.cell.grip_height_m};
  for (std::size_t f = 0; f < kJawFingers; ++f) {
    const double sign = normal_sign(static_cast<int>(f));
    std::array<double, 3> start = ray_start_m(scenario, *jaw);
    start[0] = sign * (start[0] + gripper.way(static_cast<int>(f))[lane]);
    for (std::size_t i = 0; i < 3; ++i) start[i] -= from_product[i];
    const std::array<double, 3> turned_start = turned(palm, start);
    for (std::size_t i = 0; i < 3; ++i) {
      rays[f].start_m[i] = middle_m[i] + from_product[i] + carriers.palm[i].place_m[lane] + turned_start[i];
    }
    rays[f].direction = turned(palm, {sign, 0.0, 0.0});
  }
  return rays;
}

}  // namespace unbruised

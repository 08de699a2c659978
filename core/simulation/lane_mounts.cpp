#include "core/simulation/lane_mounts.hpp"

#include "core/scenario/attitude.hpp"
#include "core/scenario/vectors.hpp"

namespace unbruised {
namespace {

using Vector = std::array<double, 3>;

Vector times(const Vector& factor, const Vector& x) {
  return {factor[0] * x[0], factor[1] * x[1], factor[2] * x[2]};
}

/// Weight of what the sensor carries itself, and its inertia where its carrier is accelerated and turns, about the
/// sensor's origin and along the axes of the carrier.
Six own_wrench(int lane, const Scenario& scenario, const CarrierMotion& carriers) {
  const SixAxisSensorParameters& sensor = scenario.sensor;
  Vector pull = scenario.cell.gravity_m_s2;
  Vector torque{};
  if (sensor.at == SensorMount::wrist) {
    const Attitude back = inverse(attitude_of(of_lane(carriers.palm_rotation_rad, lane)));
    const Vector spin = turned(back, of_lane(carriers.palm_spin_rad_s, lane));
    const Vector spin_up = turned(back, of_lane(carriers.palm_spin_acceleration_rad_s2, lane));
    Vector lever = sensor.position_m.value_or(Vector{});
    for (std::size_t i = 0; i < 3; ++i) {
      lever[i] += sensor.center_of_mass_m[i];
      pull[i] -= carriers.palm[i].acceleration_m_s2[lane];
    }
    pull = turned(back, pull);
    const Vector tangential = cross(spin_up, lever), centripetal = cross(spin, cross(spin, lever));
    const Vector gyroscopic = cross(spin, times(sensor.inertia_kg_m2, spin));
    for (std::size_t i = 0; i < 3; ++i) {
      pull[i] -= tangential[i] + centripetal[i];
      torque[i] -= sensor.inertia_kg_m2[i] * spin_up[i] + gyroscopic[i];
    }
  }
  const double m = sensor.mass_kg;
  Six wrench = wrench_of({m * pull[0], m * pull[1], m * pull[2]}, sensor.center_of_mass_m);
  for (std::size_t i = 0; i < 3; ++i) wrench[3 + i] += torque[i];
  return wrench;
}

/// Of a product that stands on a plate, on the plate.
Six standing_wrench(const Model::Parts& model, const StaticRest& rest, const Vector& origin_m) {
  Six sum{};
  for (std::size_t c = 0; c < rest.normal_force_N.size(); ++c) {
    Vector arm = model.body.position_m[static_cast<std::size_t>(model.contact.candidate[c].node)];
    for (std::size_t i = 0; i < 3; ++i) arm[i] -= origin_m[i];
    sum = add(sum, 1.0, wrench_of({0.0, 0.0, -rest.normal_force_N[c]}, arm));
  }
  return sum;
}

/// The mount of a scenario; nothing where it has no sensor.
std::optional<Mount> mount_of(const Scenario& scenario, const BodyModel& body) {
  if (!has_sensor(scenario)) return std::nullopt;
  const Vector center_m = body.center_m();
  const CellParameters& cell = scenario.cell;
  return sensor_mount(scenario, {center_m[0], center_m[1] + cell.grip_offset_m, center_m[2] + cell.grip_height_m},
                      {center_m[0], center_m[1], 0.0});
}

}  // namespace

void load_mount(int lane, const Scenario& scenario, const Model::Parts& model, const StaticRest* rest,
                const CarrierMotion& now, MountLanes& mounts) {
  const std::optional<Mount> mount = mount_of(scenario, model.body);
  if (!mount) return mounts.load(lane, mount, {}, {}, *model.wilson);
  const Six own = own_wrench(lane, scenario, now);
  Six carried{};
  if (mount->carries_support && rest != nullptr) carried = standing_wrench(model, *rest, mount->origin_m);
  mounts.load(lane, mount, carried, own, *model.wilson);
}

void command_mount(int lane, const Scenario& scenario, const CarrierMotion& theta, const CarrierMotion& next,
                   MountLanes& mounts) {
  if (scenario.sensor.at != SensorMount::wrist) return;
  mounts.set_own_wrench(lane, own_wrench(lane, scenario, theta), own_wrench(lane, scenario, next));
}

MountState mount_state(int lane, const MountLanes& mounts) {
  return {of_lane(mounts.twist(), lane), of_lane(mounts.velocity(), lane), of_lane(mounts.acceleration(), lane),
          of_lane(mounts.own_wrench(), lane), of_lane(mounts.contact_wrench(), lane)};
}

}  // namespace unbruised

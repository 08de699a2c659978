#include "core/scenario/palm_stops.hpp"

#include <algorithm>
#include <cmath>

#include "core/scenario/conveyor.hpp"
#include "core/scenario/pad_face.hpp"
#include "core/scenario/pad_lattice.hpp"
#include "core/scenario/true_shape.hpp"
#include "core/scenario/vectors.hpp"

namespace unbruised {
namespace {

bool is_zero(const std::array<double, 3>& vector) {
  return std::ranges::all_of(vector, [](double component) { return component == 0.0; });
}

Attitude attitude_at(const Waypoint& waypoint, const Attitude& before) {
  if (waypoint.rotation_rad) return attitude_of(*waypoint.rotation_rad);
  if (!waypoint.quaternion) return before;
  const std::array<double, 4>& q = *waypoint.quaternion;
  const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  if (!(length > 0.0)) return before;
  return {q[0] / length, {q[1] / length, q[2] / length, q[3] / length}};
}

}  // namespace

PalmStop lifted_stop(const Scenario& scenario) {
  const auto along = belt_direction(scenario.cell.conveyor);
  const double offset_m = scenario.strategy.pick_offset_m;
  PalmStop stop{{0.0, 0.0, scenario.cell.lift_height_m}, {}, 0.0};
  if (offset_m == 0.0) return stop;
  for (std::size_t i = 0; i < 2; ++i) stop.place_m[i] = along[i] * offset_m;
  return stop;
}

std::vector<PalmStop> palm_stops(const Scenario& scenario) {
  std::vector<PalmStop> stops;
  PalmStop stop = lifted_stop(scenario);
  if (!is_zero(scenario.strategy.tilt_rad)) {
    stop.attitude = attitude_of(scenario.strategy.tilt_rad);
    stops.push_back(stop);
  }
  for (const Waypoint& waypoint : scenario.strategy.waypoint) {
    stop = {waypoint.place_m.value_or(stop.place_m),
            attitude_at(waypoint, stop.attitude),
            waypoint.wait_s,
            waypoint.via_m,
            waypoint.blend_m,
            waypoint.speed_m_s,
            waypoint.duration_s};
    stops.push_back(stop);
  }
  return stops;
}

std::optional<Arc> arc_between(const PalmStop& from, const PalmStop& to) {
  return to.via_m ? arc_through(from.place_m, *to.via_m, to.place_m) : std::nullopt;
}

std::array<double, 3> place_between(const PalmStop& from, const PalmStop& to, double share) {
  std::array<double, 3> place{};
  if (const auto arc = arc_between(from, to)) {
    const double angle = share * arc->angle_rad;
    const Attitude turn = attitude_of({angle * arc->axis[0], angle * arc->axis[1], angle * arc->axis[2]});
    return sum(arc->center_m, turned(turn, arc->from_center_m));
  }
  for (std::size_t i = 0; i < 3; ++i) place[i] = from.place_m[i] + share * (to.place_m[i] - from.place_m[i]);
  return place;
}

bool turns_product(const Scenario& scenario) {
  if (!has_gripper(scenario)) return false;
  return std::ranges::any_of(palm_stops(scenario),
                             [](const PalmStop& stop) { return !is_zero(stop.attitude.axis); });
}

bool hangs_off_centre(const Scenario& scenario) {
  constexpr double kCentred = 0.05;
  const auto* lattice = std::get_if<LatticeParameters>(&scenario.product);
  if (lattice == nullptr || !has_gripper(scenario) || turns_product(scenario)) return false;
  if (has_shaped_pads(scenario) || has_lattice_pads(scenario)) return false;
  const std::array<double, 3> mass_m = TrueShape(*lattice).center_of_mass_m();
  return std::abs(scenario.cell.grip_offset_m - mass_m[1]) > kCentred * lattice->size_m[1] ||
         std::abs(scenario.cell.grip_height_m - mass_m[2]) > kCentred * lattice->size_m[2];
}

PalmStop placing_stop(const Scenario& scenario) {
  return scenario.strategy.waypoint.empty() ? lifted_stop(scenario) : palm_stops(scenario).back();
}

bool lands_otherwise(const Scenario& scenario) {
  constexpr double kLean_rad = 0.01;
  if (!has_gripper(scenario)) return false;
  const std::array<double, 3> up = turned(placing_stop(scenario).attitude, {0.0, 0.0, 1.0});
  return std::hypot(up[0], up[1]) > kLean_rad || up[2] < 0.0;
}

std::array<double, 3> centre_shift_m(const Scenario& scenario, const Attitude& attitude) {
  const std::array<double, 3> centre = {0.0, -scenario.cell.grip_offset_m, -scenario.cell.grip_height_m};
  std::array<double, 3> shift = turned(attitude, centre);
  for (std::size_t i = 0; i < 3; ++i) shift[i] -= centre[i];
  return shift;
}

double lowest_place_m(const Scenario& scenario, const Attitude& attitude) {
  const auto* lattice = std::get_if<LatticeParameters>(&scenario.product);
  if (lattice == nullptr) return 0.0;
  const double reach_m = TrueShape(*lattice).reach_m(turned(inverse(attitude), {0.0, 0.0, -1.0}));
  return 0.5 * lattice->size_m[2] + centre_shift_m(scenario, attitude)[2] - reach_m;
}

double largest_turn_rad(const Scenario& scenario) {
  double largest = 0.0;
  Attitude before;
  for (const PalmStop& stop : palm_stops(scenario)) {
    largest = std::max(largest, angle_between_rad(before, stop.attitude));
    before = stop.attitude;
  }
  return largest;
}

}  // namespace unbruised

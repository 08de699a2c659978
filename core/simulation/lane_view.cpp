#include "core/simulation/lane_view.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "core/body/rigid_motion.hpp"
#include "core/lanes/lane_rotation.hpp"
#include "core/outcome/damage_limits.hpp"
#include "core/scenario/contact_set.hpp"
#include "core/scenario/gripper.hpp"
#include "core/scenario/opening.hpp"
#include "core/scenario/product.hpp"
#include "core/sensor/finger_rays.hpp"

namespace unbruised {
namespace {

/// Cells with more accumulated plastic strain than this count as bruised where no limit is set.
constexpr double kBruisedStrain = 0.01;
/// Of the smallest extent, by which the true surface may lie below the lowest of the places that can touch: places
/// of the poles are that near to each other.
constexpr double kLargestGap = 0.005;

/// From the axes of the palm to x, y, z, where the palm is turned.
void turn_by_palm(const CarrierMotion& carriers, int lane, std::array<double, 3>& force_N) {
  const LaneVector& turn = carriers.palm_rotation_rad;
  if (turn[0][lane] == 0.0 && turn[1][lane] == 0.0 && turn[2][lane] == 0.0) return;
  force_N = of_lane(rotation_by(turn).matrix() * to_lanes(force_N), lane);
}

}  // namespace

StoredEnergy LaneView::stored_energy(int lane, const Scenario& scenario) const {
  StoredEnergy energy;
  const auto add = [&energy](double StoredEnergy::*part, double value) {
    energy.total += value;
    energy.*part += value;
  };
  if (const std::optional<BodyEnergy> known = body.energy(lane)) {
    add(&StoredEnergy::kinetic, known->kinetic);
    add(&StoredEnergy::elastic, known->elastic);
  } else {
    const BodyModel& product = model.body;
    const std::size_t freedoms = 3 * product.particle_count;
    std::vector<double> displacement(freedoms), force(freedoms);
    for (std::size_t i = 0; i < freedoms; ++i) displacement[i] = body.u().at(i, lane);
    multiply(product.K, std::span<const double>(displacement), std::span<double>(force));
    const std::vector<double> plastic = material.plastic_load_N(lane);
    for (std::size_t i = 0; i < freedoms; ++i) {
      add(&StoredEnergy::kinetic, 0.5 * product.mass_kg[i / 3] * body.v().at(i, lane) * body.v().at(i, lane));
      add(&StoredEnergy::elastic, displacement[i] * (0.5 * force[i] - plastic[i]));
      if (!product.rest_force_N.empty()) add(&StoredEnergy::elastic, -displacement[i] * product.rest_force_N[i]);
    }
  }
  const double self_energy = material.self_energy(lane, body.u());
  energy.elastic += self_energy;
  energy.hardening = material.hardening_energy()[lane];
  energy.layers = contact.stored_energy()[lane];
  energy.fingers = has_gripper(scenario) ? gripper.energy()[lane] : 0.0;
  if (pads) energy.fingers += pads->energy_J(lane, gripper);
  energy.total += self_energy + energy.hardening;
  energy.mount = mounts.has(lane) ? mounts.energy()[lane] : 0.0;
  energy.total = energy.total + energy.layers + energy.fingers + energy.mount;
  return energy;
}

std::array<PatchDamage, kSurfaceCount> LaneView::damage_below_patches(int lane, const Scenario& scenario) const {
  std::array<PatchDamage, kSurfaceCount> damage{};
  const std::optional<FlowLaw> law = flow_law(scenario.product);
  if (!law) return damage;
  const double bruised_strain = scenario.limits.plastic_strain.value_or(kBruisedStrain);
  for (const int surface : model.contact.surface) {
    const auto s = static_cast<std::size_t>(surface);
    const PatchForm& form = contact.patch_form(surface, lane);
    const SurfaceTally& tally = contact.tally()[s];
    const double traction_N = std::hypot(tally.tangent[0][lane], tally.tangent[1][lane]);
    const PatchLoad load = patch_load(form, *law, yield_ratio[s][lane], tally.normal[lane], traction_N);
    damage[s] = patch_damage(load, form, *law, bruised_strain);
  }
  return damage;
}

StepObservation LaneView::observe(int lane, const Scenario& scenario, double time_s) const {
  const WilsonTheta& w = *model.wilson;
  StepObservation seen;
  seen.time_s = time_s;
  seen.register_time_s = time_s + (w.theta - 1.0) * w.dt;
  for (std::size_t i = 0; i < 3; ++i) {
    seen.center_motion_m[i] = body.mass_u()[i][lane] / model.body.total_mass_kg;
    seen.center_acceleration_m_s2[i] = body.mass_a()[i][lane] / model.body.total_mass_kg;
    seen.palm_m[i] = carriers.palm[i].place_m[lane];
  }
  seen.rotation_rad = model.body.is_solid ? body.rotation_rad(lane) : 0.0;
  if (const FrameLanes* frame = body.frame()) {
    const std::array<double, 4> q = frame->attitude().of_lane(lane);
    seen.attitude = Attitude{q[0], {q[1], q[2], q[3]}};
  }
  seen.plastic_strain = material.largest_plastic_strain()[lane];
  seen.absorbed_energy_J = material.plastic_work()[lane];
  for (const int surface : model.contact.surface) {
    if (is_pad(surface)) continue;
    const auto s = static_cast<std::size_t>(surface);
    seen.support_N += contact.tally()[s].normal[lane];
    seen.support_yield_ratio = std::max(seen.support_yield_ratio, yield_ratio[s][lane]);
  }
  seen.patch = damage_below_patches(lane, scenario);
  seen.layer_strain = contact.layer_strain()[lane];
  if (!has_gripper(scenario)) return seen;
  seen.finger_count = model.contact.finger_count();
  for (std::size_t f = 0; f < seen.finger_count; ++f) {
    const int pad = model.contact.surface[f];
    const SurfaceTally& tally = contact.tally()[static_cast<std::size_t>(pad)];
    FingerObservation& finger = seen.finger[f];
    finger.normal_N = tally.normal[lane];
    finger.tangent_N = {tally.tangent[0][lane], tally.tangent[1][lane]};
    finger.closed_contacts = tally.closed[lane];
    finger.sliding_contacts = tally.sliding[lane];
    finger.slip_m = contact.slip(f).way_m(lane);
    finger.slip_rad = contact.slip(f).angle_rad(lane);
    finger.yield_ratio = yield_ratio[static_cast<std::size_t>(pad)][lane];
    const double touched = contact.touched(f)[lane], left = contact.left(f)[lane];
    if (touched <= 1.0) finger.touched_s = time_s + (touched * w.theta - 1.0) * w.dt;
    if (left >= 0.0) finger.left_s = time_s + (left * w.theta - 1.0) * w.dt;
    const std::array<double, 3> force_N = contact.surface_force(pad, lane);
    for (std::size_t i = 0; i < 3; ++i) {
      seen.force_N[i] += force_N[i];
      seen.torque_N_m[i] += tally.torque[i][lane];
    }
  }
  seen.patch_pressure_Pa = contact.patch_pressure()[lane];
  seen.compression_m = gripper.closing()[lane] - static_cast<double>(seen.finger_count) * approach_gap_m(scenario);
  seen.end_of_stroke = gripper.at_end_of_stroke()[lane];
  return seen;
}

double LaneView::lean_in_grip_rad(int lane, const Scenario& scenario) const {
  const FrameLanes* frame = body.frame();
  if (frame == nullptr || !has_gripper(scenario) || model.contact.lists_fingers()) return 0.0;
  const LaneRotation back = rotation_by(Lane(-1.0) * carriers.palm_rotation_rad);
  const LaneVector axis = (back * frame->attitude()).axis;
  return 2.0 * std::asin(std::min(1.0, std::hypot(axis[1][lane], axis[2][lane])));
}

bool LaneView::sinks_through(int lane, const Scenario& scenario) const {
  if (contact_set(scenario) != ContactSet::six_sides) return false;
  for (const int surface : model.contact.surface) {
    if (is_pad(surface)) continue;
    const std::optional<FacedPlane> plane = contact.faced_plane(surface, lane, carriers);
    if (!plane) continue;
    const std::array<double, 3> down = {-plane->normal[0], -plane->normal[1], -plane->normal[2]};
    const double reach_m = shape_reach_m(scenario.product, down).value_or(0.0);
    const double lowest_m = plane->center_m - reach_m;
    if (!(plane->center_m > 0.0) || lowest_m > 0.0) continue;  // behind it, or clear of it
    const double left_m = contact.lowest_place_m(surface, body.u())[lane] - plane->place_m - lowest_m;
    if (left_m > kLargestGap * model.body.smallest_extent_m()) return true;
  }
  return false;
}

FingerSigns LaneView::finger_signs(int lane, const Scenario& scenario, bool with_range) const {
  FingerSigns signs;
  for (std::size_t f = 0; f < model.contact.finger_count(); ++f) {
    signs.force_N[f] = contact.tally()[static_cast<std::size_t>(model.contact.surface[f])].normal[lane];
  }
  if (!with_range || !model.carried_surface) return signs;
  const BodyPose pose = pose_of(body, model.body, lane);
  const auto rays = finger_rays(scenario, model.body.center_m(), carriers, gripper, lane);
  for (std::size_t f = 0; f < kJawFingers; ++f) {
    signs.distance_m[f] = model.carried_surface->distance_m(rays[f], pose, body.u(), lane)
                              .value_or(std::numeric_limits<double>::infinity());
  }
  return signs;
}

TraceRow LaneView::trace_row(int lane, const Scenario& scenario, double time_s) const {
  TraceRow row;
  row.time_s = time_s;
  row.gripper = has_gripper(scenario);
  row.yields = can_yield(scenario);
  row.ranged = has_range_sensors(scenario);
  const auto torques = contact.surface_torques(lane, body, carriers);
  row.surface_count = model.contact.surface.size();
  row.finger_count = model.contact.finger_count();
  for (std::size_t s = 0; s < row.surface_count; ++s) {
    const int surface = model.contact.surface[s];
    const auto at = static_cast<std::size_t>(surface);
    row.surface_force_N[s] = contact.surface_force(surface, lane);
    if (is_pad(surface)) turn_by_palm(carriers, lane, row.surface_force_N[s]);
    row.surface_torque_N_m[s] = torques[at];
    row.closed[s] = contact.tally()[at].closed[lane];
    row.sliding[s] = contact.tally()[at].sliding[lane];
  }
  for (std::size_t f = 0; f < row.finger_count; ++f) {
    row.finger_way_m[f] = gripper.way(static_cast<int>(f))[lane];
    row.finger_speed_m_s[f] = gripper.speed(static_cast<int>(f))[lane];
  }
  for (std::size_t i = 0; i < 3; ++i) row.palm_m[i] = carriers.palm[i].place_m[lane];
  row.palm_rotation_rad = of_lane(carriers.palm_rotation_rad, lane);
  row.plastic_strain = material.largest_plastic_strain()[lane];
  row.stored = stored_energy(lane, scenario);
  row.plastic_work_J = material.plastic_work()[lane];
  if (const FrameLanes* frame = body.frame()) {
    row.attitude = frame->attitude().of_lane(lane);
    row.spin_rad_s = of_lane(frame->to_world(frame->spin_rad_s()), lane);
  }
  return row;
}

void LaneView::measure_permanent_set(int lane, const LimitParameters& limits, Metrics& metrics) const {
  metrics[Metric::permanent_set_max_m] = metrics[Metric::permanent_set_rms_m] = 0.0;
  if (const auto bruised = material.volume_above_m3(lane, limits.plastic_strain.value_or(kBruisedStrain))) {
    metrics[Metric::bruised_volume_m3] = *bruised;
    metrics[Metric::bruised_area_m2] = metrics[Metric::bruised_depth_m] = 0.0;  // until patches say more
  }
  if (!(material.largest_plastic_strain()[lane] > 0.0) && !material.flows()) return;
  const BodyModel& product = model.body;
  const LastingShape lasting = material.lasting(lane, body.u());
  std::vector<double> shape = product.statics->free_shape(lasting.load_N);
  for (std::size_t i = 0; i < lasting.displacement_m.size(); ++i) shape[i] += lasting.displacement_m[i];
  if (!product.is_anchored()) remove_rigid_motion(product.position_m, shape);
  double largest = 0.0, sum = 0.0;
  for (std::size_t p = 0; p < product.particle_count; ++p) {
    const double square =
        shape[3 * p] * shape[3 * p] + shape[3 * p + 1] * shape[3 * p + 1] + shape[3 * p + 2] * shape[3 * p + 2];
    largest = std::max(largest, square);
    sum += square;
  }
  metrics[Metric::permanent_set_max_m] = std::sqrt(largest);
  metrics[Metric::permanent_set_rms_m] = std::sqrt(sum / static_cast<double>(product.particle_count));
}

}  // namespace unbruised

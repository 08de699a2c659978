#include "core/surface/surface_lanes.hpp"

#include "core/door/require.hpp"
#include "core/scenario/cell_surface.hpp"
#include "core/scenario/layer_reach.hpp"
#include "core/scenario/opening.hpp"
#include "core/scenario/pad_lattice.hpp"
#include "core/scenario/pad_meeting.hpp"
#include "core/scenario/product.hpp"

namespace unbruised {
namespace {

/// Beyond anything that is handled.
constexpr double kFar_m = 1e6;

/// What the layer of every pad of a gripper is.
void load_pad(int lane, const ParallelJawParameters& jaw, double layer_N_m3, SurfaceLane& surface) {
  const bool is_layer = !has_lattice_pads(jaw);
  const double springs = pad_springs_N_m3(jaw);
  surface.stiffness_N_m3.set(lane, is_layer ? layer_N_m3 : springs);
  surface.backing_N_m3.set(lane, layer_N_m3);
  surface.springs_N_m3.set(lane, springs);
  if (const auto law = pad_law(jaw.pad)) {
    surface.springs_N_m3.set(lane, layer_N_m3);
    surface.curve.set(lane, *law, layer_N_m3 * jaw.pad_size_m[0] * jaw.pad_size_m[1]);
  }
  surface.edge_radius_m.set(lane, jaw.pad_edge_radius_m);
  surface.thickness_m.set(
      lane, jaw.pad.law_depth_m.empty() ? jaw.pad_thickness_m : jaw.pad.law_depth_m.back() / kFollowedLayerStrain);
  surface.relaxation_s.set(lane, is_layer ? jaw.pad_relaxation_time_s : 0.0);
}

}  // namespace

void SurfaceLanes::load(int lane, const Scenario& scenario, const ProductPlace& product,
                        const std::array<double, kFirstCellSurface>& layer_N_m3) {
  require(is_lane(lane), "SurfaceLanes::load: there is no such lane");
  const CellParameters& cell = scenario.cell;
  const auto* jaw = parallel_jaw(scenario);
  const double reach_m = pad_reach_m(scenario);
  face_[static_cast<std::size_t>(lane)] = jaw == nullptr ? PadFace() : PadFace(*jaw);
  grip_m_[0].set(lane, product.center_m[0]);
  grip_m_[1].set(lane, product.center_m[1] + cell.grip_offset_m);
  grip_m_[2].set(lane, product.center_m[2] + cell.grip_height_m);
  for (int pad = 0; pad < kJawFingers; ++pad) {
    SurfaceLane& surface = surface_[pad];
    surface.present.set(lane, jaw != nullptr && jaw->finger.empty());
    surface.friction.set(lane, product_friction(scenario.product));
    surface.center_m[0].set(lane, product.center_m[1] + cell.grip_offset_m);
    surface.center_m[1].set(lane, product.center_m[2] + cell.grip_height_m);
    surface.curve.clear(lane);
    if (jaw == nullptr) continue;
    load_pad(lane, *jaw, layer_N_m3[static_cast<std::size_t>(pad)], surface);
    const std::array<double, 2> rises = face(lane).range_m();
    surface.bent.set(lane, rises[1] > rises[0] ? 1.0 : 0.0);
    surface.rest_place_m.set(lane, product.pole_m[pad] - normal_sign(pad) * (approach_gap_m(scenario) + reach_m));
    for (std::size_t t = 0; t < 2; ++t) surface.size_m[t].set(lane, jaw->pad_size_m[t]);
  }
  SurfaceLane& support = surface_[kSupport];
  support.present.set(lane, cell.support);
  support.friction.set(lane, cell.support_friction);
  support.stiffness_N_m3.set(lane, layer_N_m3[kSupport]);
  support.backing_N_m3.set(lane, layer_N_m3[kSupport]);
  support.springs_N_m3.set(lane, cell.support_modulus_Pa / cell.support_thickness_m);
  support.thickness_m.set(lane, cell.support_thickness_m);
  support.relaxation_s.set(lane, cell.support_relaxation_time_s);
  for (Lane& size_m : support.size_m) size_m.set(lane, 2.0 * kFar_m);
  for (int i = 0; i < kMostCellSurfaces; ++i) {
    SurfaceLane& listed = surface_[static_cast<std::size_t>(kFirstCellSurface + i)];
    const bool present = i < static_cast<int>(cell.surface.size());
    listed.present.set(lane, present);
    if (present) load_listed(lane, cell.surface[static_cast<std::size_t>(i)], listed);
  }
  load_fingers(lane, scenario, layer_N_m3[kLeftPad]);
}

void SurfaceLanes::load_fingers(int lane, const Scenario& scenario, double layer_N_m3) {
  const auto* jaw = parallel_jaw(scenario);
  const std::size_t count = jaw == nullptr ? 0 : jaw->finger.size();
  for (std::size_t f = 0; f < kMostFingers; ++f) {
    SurfaceLane& surface = surface_[kFirstListedPad + f];
    surface.present.set(lane, f < count);
    surface.curve.clear(lane);
    if (f >= count) continue;
    const FingerParameters& finger = jaw->finger[f];
    const std::array<std::array<double, 3>, 3> axes = finger_axes(finger);
    const std::array<std::size_t, 2> tangent = face_tangents(faced_axis(axes[2]));
    load_pad(lane, *jaw, layer_N_m3, surface);
    surface.friction.set(lane, product_friction(scenario.product));
    surface.rest_place_m.set(lane, -opened_half_m(scenario));
    for (std::size_t t = 0; t < 2; ++t) {
      surface.size_m[t].set(lane, jaw->pad_size_m[t]);
      surface.center_m[t].set(lane, grip_m_[tangent[t]][lane] + finger.offset_m[tangent[t]]);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      surface.origin_m[i].set(lane, finger.offset_m[i]);
      for (std::size_t j = 0; j < 3; ++j) surface.axes(i, j).set(lane, axes[i][j]);
    }
  }
}

void SurfaceLanes::load_listed(int lane, const CellSurfaceParameters& parameters, SurfaceLane& surface) {
  surface.has_rim.set(lane, parameters.size_m.has_value());
  surface.friction.set(lane, parameters.friction);
  surface.springs_N_m3.set(lane, parameters.modulus_Pa / parameters.thickness_m);
  surface.stiffness_N_m3.set(lane, parameters.modulus_Pa / parameters.thickness_m);
  surface.backing_N_m3.set(lane, parameters.modulus_Pa / parameters.thickness_m);
  surface.thickness_m.set(lane, parameters.thickness_m);
  surface.relaxation_s.set(lane, parameters.relaxation_time_s);
  for (std::size_t t = 0; t < 2; ++t) {
    surface.size_m[t].set(lane, parameters.size_m ? (*parameters.size_m)[t] : 2.0 * kFar_m);
  }
  const std::array<std::array<double, 3>, 3> axes = surface_axes(parameters);
  for (std::size_t i = 0; i < 3; ++i) {
    surface.origin_m[i].set(lane, parameters.center_m[i]);
    for (std::size_t j = 0; j < 3; ++j) surface.axes(i, j).set(lane, axes[i][j]);
  }
}

AxisMotion SurfaceLanes::motion(int surface, const CarrierMotion& carriers, const AxisMotion& closing) const {
  AxisMotion motion = carrier_of(surface, carriers)[normal_axis(surface)];
  motion.place_m = place(surface, carriers, closing.place_m);
  if (is_pad(surface)) {
    motion.velocity_m_s += Lane(normal_sign(surface)) * closing.velocity_m_s;
    motion.acceleration_m_s2 += Lane(normal_sign(surface)) * closing.acceleration_m_s2;
  }
  return motion;
}

Stretch SurfaceLanes::reach(int surface, const CarrierMotion& carriers, std::size_t tangent) const {
  if (!is_pad(surface)) return {Lane(-kFar_m), Lane(kFar_m)};
  const SurfaceLane& pad = surface_[surface];
  const auto axis = static_cast<std::size_t>(tangent_axes(surface)[tangent]);
  const Lane center = carrier_of(surface, carriers)[axis].place_m + pad.center_m[tangent];
  return {center - Lane(0.5) * pad.size_m[tangent], center + Lane(0.5) * pad.size_m[tangent]};
}

}  // namespace unbruised

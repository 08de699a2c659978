#pragma once

/// @file
/// What observers of a step may look at: the parts of a lane simulation, read-only, and what they say of one lane.

#include "core/body/body_motion.hpp"
#include "core/body/mount_lanes.hpp"
#include "core/contact/contact_lanes.hpp"
#include "core/gripper/gripper_lanes.hpp"
#include "core/gripper/pad_lanes.hpp"
#include "core/material/material.hpp"
#include "core/outcome/handling_record.hpp"
#include "core/sensor/finger_instruments.hpp"
#include "core/simulation/model_parts.hpp"
#include "core/simulation/trace_row.hpp"
#include "core/surface/carrier_motion.hpp"

namespace unbruised {

struct LaneView {
  const Model::Parts& model;
  const BodyMotion& body;
  const Material& material;
  const ContactLanes& contact;
  const GripperLanes& gripper;
  const MountLanes& mounts;
  const CarrierMotion& carriers;  ///< at the present time
  /// Of each surface's patch, with what traction adds; 1: first yield.
  const std::array<Lane, kSurfaceCount>& yield_ratio;
  const std::optional<PadLanes>& pads;  ///< where these are bodies

  /// Of product, layers, fingers with their pads, and mount.
  [[nodiscard]] StoredEnergy stored_energy(int lane, const Scenario& scenario) const;
  /// What the outcome is decided from.
  [[nodiscard]] StepObservation observe(int lane, const Scenario& scenario, double time_s) const;
  /// What the instruments of the fingers have to read. @param with_range do they ask for distances?
  [[nodiscard]] FingerSigns finger_signs(int lane, const Scenario& scenario, bool with_range) const;
  /// Angle between the grip axis and what of a product that turns lay along it; 0 for one that stays upright.
  [[nodiscard]] double lean_in_grip_rad(int lane, const Scenario& scenario) const;
  /// Does the product reach through a plane with places that its contact set leaves out?
  [[nodiscard]] bool sinks_through(int lane, const Scenario& scenario) const;
  /// The signals of a trace that are read from the state.
  [[nodiscard]] TraceRow trace_row(int lane, const Scenario& scenario, double time_s) const;
  /// What the present load of each surface leaves below its patch.
  [[nodiscard]] std::array<PatchDamage, kSurfaceCount> damage_below_patches(int lane,
                                                                            const Scenario& scenario) const;
  /// Fills the metrics of the shape that the plastic strain leaves.
  void measure_permanent_set(int lane, const LimitParameters& limits, Metrics& metrics) const;
};

}  // namespace unbruised

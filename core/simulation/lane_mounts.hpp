#pragma once

/// @file
/// The mounts of lanes: what they carry at the start, what their carriers' motion asks of them, what they do.

#include "core/body/mount_lanes.hpp"
#include "core/contact/static_rest.hpp"
#include "core/sensor/six_axis_instrument.hpp"
#include "core/simulation/model_parts.hpp"
#include "core/surface/carrier_motion.hpp"

namespace unbruised {

/// Puts it into a lane at rest. @param rest how the product stands on its support; null: it does not
void load_mount(int lane, const Scenario& scenario, const Model::Parts& model, const StaticRest* rest,
                const CarrierMotion& now, MountLanes& mounts);

/// Tells the mount of a lane how its carrier moves, where it does.
void command_mount(int lane, const Scenario& scenario, const CarrierMotion& theta, const CarrierMotion& next,
                   MountLanes& mounts);

/// Where it has come to.
MountState mount_state(int lane, const MountLanes& mounts);

}  // namespace unbruised

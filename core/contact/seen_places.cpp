#include "core/contact/seen_places.hpp"

namespace unbruised {

SeenPlaces::SeenPlaces(const ContactModel& model, const BodyModel& body, const SurfaceLanes& surfaces)
    : model_(model), surfaces_(surfaces), center_of_mass_m_(to_lanes(body.center_of_mass_m)) {}

/// A surface sees B (c + R y - o) from its origin; measured, as its candidates' places are, from where the centre
/// of mass is at rest.
void SeenPlaces::see(const FrameLanes& frame) {
  const LaneVector center = center_of_mass_m_ + frame.center_motion_m();
  for (int surface = kSupport; surface < model_.surface_count; ++surface) {
    const SurfaceLane& lanes = surfaces_[surface];
    axes_[static_cast<std::size_t>(surface)] = {lanes.axes * frame.axes(),
                                                lanes.axes * (center - lanes.origin_m) - center_of_mass_m_};
  }
}

SeenPlaces::Start SeenPlaces::start(const ContactCandidate& candidate, const FrameLanes& frame,
                                    const LaneVector& u, const LaneVector& v, const LaneVector& a) const {
  const PlaceArm& place = arm_of(candidate);
  const LaneMatrix& turn = axes(candidate.surface).turn;
  const LaneVector arm = to_lanes(place.arm_m);
  const LaneVector moved = u + frame.from_start() * arm - arm;
  return {axes(candidate.surface).displacement(to_lanes(place.from_mass_m), moved),
          turn * (v + frame.from_start() * frame.velocity_of(arm)),
          turn * (a + frame.from_start() * frame.acceleration_of(arm))};
}

}  // namespace unbruised

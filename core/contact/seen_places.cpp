#include "core/contact/seen_places.hpp"

#include "core/lanes/lane_rotation.hpp"

namespace unbruised {

SeenPlaces::SeenPlaces(const ContactModel& model, const BodyModel& body, const SurfaceLanes& surfaces)
    : model_(model), surfaces_(surfaces), center_of_mass_m_(to_lanes(body.center_of_mass_m)) {}

/// A surface sees B (c + R y - o) from its origin; measured, as its candidates' places are, from where the centre
/// of mass is at rest.
void SeenPlaces::see(const FrameLanes& frame, const CarrierMotion& there) {
  const LaneVector center = center_of_mass_m_ + frame.center_motion_m();
  for (const int surface : model_.surface) {
    if (!model_.has_places(surface)) continue;
    CarrierAxes& axes = axes_[static_cast<std::size_t>(surface)];
    if (is_pad(surface)) {
      axes = pad_axes(surface, frame, there);
      continue;
    }
    const SurfaceLane& lanes = surfaces_[surface];
    axes = {lanes.axes * frame.axes(), lanes.axes * (center - lanes.origin_m) - center_of_mass_m_};
  }
}

/// A pad sees B (P' (c + R y - g - p) - o), o its origin from the middle of the grip g in the axes of the palm.
CarrierAxes SeenPlaces::pad_axes(int surface, const FrameLanes& frame, const CarrierMotion& there) const {
  const SurfaceLane& lanes = surfaces_[surface];
  const LaneMatrix back = transposed(rotation_by(there.palm_rotation_rad).matrix());
  LaneVector from_palm = center_of_mass_m_ + frame.center_motion_m() - surfaces_.grip_m();
  for (std::size_t i = 0; i < 3; ++i) from_palm[i] -= there.palm[i].place_m;
  return {lanes.axes * (back * frame.axes()),
          lanes.axes * (back * from_palm - lanes.origin_m) - center_of_mass_m_};
}

void SeenPlaces::see_start(const FrameLanes& frame, const CarrierMotion& now, const CarrierMotion& theta) {
  see(frame, theta);
  LaneVector V, A;
  for (std::size_t i = 0; i < 3; ++i) {
    V[i] = now.palm[i].velocity_m_s;
    A[i] = now.palm[i].acceleration_m_s2;
  }
  for (const int surface : model_.surface) {
    if (!is_listed_pad(surface)) continue;
    const SurfaceLane& lanes = surfaces_[surface];
    const LaneMatrix back = lanes.axes * transposed(rotation_by(now.palm_rotation_rad).matrix());
    palm_[finger_of(surface)] = {pad_axes(surface, frame, now),
                                 back * V,
                                 back * A,
                                 back * now.palm_spin_rad_s,
                                 back * now.palm_spin_acceleration_rad_s2,
                                 lanes.axes * lanes.origin_m};
  }
}

SeenPlaces::Start SeenPlaces::start(const ContactCandidate& candidate, const FrameLanes& frame,
                                    const LaneVector& u, const LaneVector& v, const LaneVector& a) const {
  const PlaceArm& place = arm_of(candidate);
  const LaneVector arm = to_lanes(place.arm_m);
  const LaneVector moved = u + frame.from_start() * arm - arm;
  const LaneVector velocity = v + frame.from_start() * frame.velocity_of(arm);
  const LaneVector acceleration = a + frame.from_start() * frame.acceleration_of(arm);
  if (is_pad(candidate.surface)) return start_before_pad(candidate, moved, velocity, acceleration);
  const LaneMatrix& turn = axes(candidate.surface).turn;
  return {axes(candidate.surface).displacement(to_lanes(place.from_mass_m), moved), turn * velocity,
          turn * acceleration};
}

/// w = v - V - Omega x r and a - A - Omega' x r - Omega x (Omega x r) - 2 Omega x w, r from the palm.
SeenPlaces::Start SeenPlaces::start_before_pad(const ContactCandidate& candidate, const LaneVector& moved,
                                               const LaneVector& v, const LaneVector& a) const {
  const PalmSeen& palm = palm_[finger_of(candidate.surface)];
  const LaneVector X = to_lanes(arm_of(candidate).from_mass_m);
  const LaneVector displacement = palm.axes.displacement(X, moved);
  const LaneVector r = center_of_mass_m_ + X + displacement + palm.offset_m;
  const LaneVector w = palm.axes.turn * v - palm.velocity - cross(palm.spin, r);
  return {displacement, w,
          palm.axes.turn * a - palm.acceleration - cross(palm.spin_rate, r) -
              cross(palm.spin, cross(palm.spin, r) + Lane(2.0) * w)};
}

}  // namespace unbruised

#pragma once

/// @file
/// The places of a product's true surface as the surfaces of its cell and the pads of listed fingers see them:
/// displaced along the axes of each surface, as if the product had never turned, the palm standing still. A place
/// goes with its particle, and turns about it with the body as a whole (docs/theory.md, "Places that touch").

#include <array>
#include <vector>

#include "core/contact/contact_model.hpp"
#include "core/contact/seen_nodes.hpp"
#include "core/frame/frame_lanes.hpp"
#include "core/surface/surface_lanes.hpp"

namespace unbruised {

class SeenPlaces {
 public:
  /// All have to outlive this.
  SeenPlaces(const ContactModel& model, const BodyModel& body, const SurfaceLanes& surfaces);

  /// Takes in where the frame is, and the palm: between its prediction and the end of a step the predicted one,
  /// then the one that fits.
  void see(const FrameLanes& frame, const CarrierMotion& there);
  /// The same at the start of a step, with how the palm moves then.
  void see_start(const FrameLanes& frame, const CarrierMotion& now, const CarrierMotion& theta);

  /// From the axes of the frame into those of a surface.
  [[nodiscard]] const CarrierAxes& axes(int surface) const { return axes_[static_cast<std::size_t>(surface)]; }
  /// Normal of a surface in the axes of the frame.
  [[nodiscard]] LaneVector normal(int surface) const {
    const LaneMatrix& turn = axes(surface).turn;
    return {{turn(2, 0), turn(2, 1), turn(2, 2)}};
  }
  /// How high the middle of the product stands over the plane of a surface that has not moved.
  [[nodiscard]] Lane center_height(int surface) const { return center(surface)[2]; }
  /// Where it stands along the axes of such a surface.
  [[nodiscard]] LaneVector center(int surface) const { return axes(surface).origin + center_of_mass_m_; }
  /// How much of the piece of surface around a place faces a surface: the cosine of the angle between them.
  [[nodiscard]] Lane facing(const ContactCandidate& candidate) const {
    return max0(-dot(normal(candidate.surface), to_lanes(arm_of(candidate).outward)));
  }

  /// Displacement along the axes of its surface of a candidate's place, by that of its particle and the turn of
  /// the body as a whole, both against the frame that was seen last.
  [[nodiscard, gnu::always_inline]] LaneVector displacement(const ContactCandidate& candidate, const LaneVector& u,
                                                            const LaneVector& turn_rad) const {
    const PlaceArm& place = arm_of(candidate);
    const LaneVector moved = u + cross(turn_rad, to_lanes(place.arm_m));
    return axes(candidate.surface).displacement(to_lanes(place.from_mass_m), moved);
  }
  /// How high such a place stands over the plane of its surface where that has not moved.
  [[nodiscard]] Lane height(const ContactCandidate& candidate, const LaneVector& u,
                            const LaneVector& turn_rad) const {
    const PlaceArm& place = arm_of(candidate);
    const LaneVector there = to_lanes(place.from_mass_m) + u + cross(turn_rad, to_lanes(place.arm_m));
    return dot(normal(candidate.surface), there) + axes(candidate.surface).origin[2] + center_of_mass_m_[2];
  }
  /// The same in a frame that fits: the body has not turned against it.
  [[nodiscard]] LaneVector displacement(const ContactCandidate& candidate, const LaneVector& u) const {
    return axes(candidate.surface).displacement(to_lanes(arm_of(candidate).from_mass_m), u);
  }
  /// Displacement, velocity and acceleration at the start of a step, whose state stands in the predicted axes.
  struct Start {
    LaneVector displacement, velocity, acceleration;
  };
  [[nodiscard]] Start start(const ContactCandidate& candidate, const FrameLanes& frame, const LaneVector& u,
                            const LaneVector& v, const LaneVector& a) const;

 private:
  [[nodiscard]] const PlaceArm& arm_of(const ContactCandidate& candidate) const {
    return model_.place[static_cast<std::size_t>(candidate.place)];
  }

  /// A listed pad at the start of a step, along its own axes: how its palm moves, and where its origin is from
  /// that of the palm.
  struct PalmSeen {
    CarrierAxes axes;
    LaneVector velocity, acceleration, spin, spin_rate, offset_m;
  };
  [[nodiscard]] CarrierAxes pad_axes(int surface, const FrameLanes& frame, const CarrierMotion& there) const;
  [[nodiscard]] Start start_before_pad(const ContactCandidate& candidate, const LaneVector& moved,
                                       const LaneVector& v, const LaneVector& a) const;

  const ContactModel& model_;
  const SurfaceLanes& surfaces_;
  LaneVector center_of_mass_m_;
  std::array<CarrierAxes, kSurfaceCount> axes_;
  std::array<PalmSeen, kMostFingers> palm_;
};

}  // namespace unbruised

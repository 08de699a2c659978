#pragma once

/// @file
/// Finds when within a step the contact state register changed. It is asked once a step, at t + theta dt, so that
/// a change lies between the last time it was asked and this one: those windows, ((theta - 1) dt, theta dt] after
/// the start of each step, follow one another without gap or overlap (docs/instruments.md).

#include <array>
#include <vector>

#include "core/contact/contact_event.hpp"
#include "core/integration/wilson_theta.hpp"
#include "core/lanes/lane.hpp"
#include "core/lanes/lane_archive.hpp"

namespace unbruised {

/// How one candidate of one lane went through a step.
struct ContactStep {
  bool was_closed = false, is_closed = false;    ///< at the last step's t + theta dt, at this one's
  bool was_sliding = false, is_sliding = false;  ///< likewise
  double gap_now_m = 0, gap_free_m = 0;          ///< at t; at t + theta dt without contact forces
  double depth_m = 0;  ///< to which the layer pushes at t + theta dt; not positive: it does not
  double friction = 0;
  double shear_N_m = 0;                         ///< stiffness of the layer along the tangents
  std::array<double, 3> before_N{}, theta_N{};  ///< normal, tangents at t and t + theta dt
  std::array<double, 2> anchor_m{}, place_m{};  ///< at t, and of the particle at t + theta dt
};

/// A change of a candidate of one lane.
struct ContactChange {
  int candidate = 0;
  ContactEvent::Kind kind = ContactEvent::Kind::make;
  double after_s = 0;               ///< since the start of the step
  std::array<double, 3> force_N{};  ///< then: normal, tangents
};

class ContactEvents {
 public:
  /// @param wilson has to outlive this
  ContactEvents(std::size_t candidate_count, const WilsonTheta& wilson);

  /// Begins with a lane in which nothing is closed, or has nothing to do with it any more.
  void start(int lane);
  void stop(int lane) { lanes_.set(lane, false); }
  /// All that a lane keeps from step to step.
  void archive(LaneArchive& lane);
  [[nodiscard]] const Mask& lanes() const { return lanes_; }

  /// A contact that is there before the first step.
  void note_rest(int candidate, int lane, const ContactStep& rest);
  void note(int candidate, int lane, const ContactStep& step);
  /// Its surface is taken away between two steps. @param force_N normal, tangents that it carried
  void note_left(int candidate, int lane, const std::array<double, 3>& force_N);
  /// Lets go of what was noted since the last time.
  void forget();

  /// What was noted, in the order of time.
  [[nodiscard]] std::vector<ContactChange> changes(int lane) const;

 private:
  /// Of a closed contact at the last t + theta dt.
  struct Memory {
    double depth_m = 0;
    std::array<double, 2> place_m{}, way_m{};  ///< along the tangents, and from the last step on
  };
  /// The moment itself still belongs to the last step.
  [[nodiscard]] double earliest_s() const { return (w_.theta - 1.0 + 1e-6) * w_.dt; }
  [[nodiscard]] double latest_s() const { return w_.theta * w_.dt; }
  [[nodiscard]] double touching_s(const ContactStep& step) const;
  [[nodiscard]] double leaving_s(const ContactStep& step, const Memory& last) const;
  [[nodiscard]] double halting_s(const ContactStep& step, const Memory& last) const;
  [[nodiscard]] ContactChange first_slip(int candidate, const ContactStep& step) const;

  std::size_t candidate_count_;
  const WilsonTheta& w_;
  Mask lanes_{false};
  std::array<std::vector<Memory>, kLanes> memory_;
  std::array<std::vector<ContactChange>, kLanes> change_;
};

}  // namespace unbruised

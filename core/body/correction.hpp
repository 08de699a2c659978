#pragma once

/// @file
/// A step of a solid, solved as a correction of what is known already (docs/theory.md, "Solving a step").

#include <span>
#include <vector>

#include "core/body/body_motion.hpp"
#include "core/body/factor_solve.hpp"
#include "core/integration/wilson_theta.hpp"
#include "core/lanes/lane_archive.hpp"

namespace unbruised {

/// The displacement at t + theta dt is what a constant acceleration would bring, known in double precision, and a
/// correction, solved for in single precision: its error is a share of what changes within the step. Contact
/// forces of the last step act from the start, so that where all rests there is nothing to correct.
class Correction {
 public:
  /// All have to outlive this. @param body with rounded values of its factor
  /// @param touchable particles that contact forces may act on
  Correction(const BodyModel& body, const WilsonTheta& wilson, const Touchable& touchable);

  void load(int lane) { held_.clear_lane(lane); }
  void archive(LaneArchive& lane);

  /// What a constant acceleration brings, [3n]; for the caller to put there before `start`.
  [[nodiscard]] LaneArray& predicted() { return predicted_; }
  [[nodiscard]] const LaneArray& predicted() const { return predicted_; }
  /// Begins with what is left of the right-hand side, in elimination order. @param load beside it, [3n], may be
  /// null
  void start(const LaneArray& left, const LaneArray* load, const Mask& running);
  /// The displacement without contact forces but those that are held: rows 3 x touchable particle + axis.
  void look_under_held(const Touchable& touchable, LaneArray& base);
  /// The same, and without these.
  void look_without_contact(const Touchable& touchable, LaneArray& base);
  [[nodiscard]] HeldForces held() const { return {&held_, held_on_}; }
  /// The contact forces of this step; all others are zero. @param active indices of touchable particles
  void take_contact(std::span<const int> particles, std::span<const int> active, const LaneArray& force);
  void finish();
  /// The displacement of a freedom that can move, a pack of lanes, after `finish`.
  [[nodiscard, gnu::always_inline]] NarrowPack displacement_m(std::size_t freedom, int first_lane) const {
    const auto at = static_cast<std::size_t>(body_.slot[freedom]);
    return get_pack(predicted_, freedom, first_lane) +
           (get_widened(solve_.rows(), at, first_lane) + narrow(shift_[freedom % 3], first_lane));
  }

 private:
  /// Is the answer to a change of the contact forces a product, and no solve?
  [[nodiscard]] bool has_columns() const { return columns_ != nullptr && !columns_->empty(); }
  void add_answer_to_change();
  /// What the correction of a free body lacks as a whole: momentum is balanced in double precision.
  [[nodiscard]] LaneVector missing_shift() const;

  const BodyModel& body_;
  const WilsonTheta& w_;
  std::vector<int> touchable_;
  const SingleMatrix* columns_;
  FactorSolve<SingleArray> solve_;
  LaneArray predicted_;
  LaneArray held_, change_;                ///< contact forces that the solve began with, and what they lacked
  std::vector<int> held_on_, changed_on_;  ///< touchable particles on which they may not be zero
  std::vector<int> all_touchable_;         ///< 0, 1, 2 and so on
  SingleArray rounded_change_;             ///< for the product
  std::vector<int> changed_rows_;          ///< of both
  LaneVector unbalanced_N_;                ///< sum of all forces that the correction is solved for
  LaneVector shift_;
  Mask running_{true};  ///< in the present step
};

}  // namespace unbruised

#pragma once

/// @file
/// Follows one scenario step by step and decides its outcome: which limits were crossed when, peaks, slip, margin.

#include <array>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/contact/patch_damage.hpp"
#include "core/motion/handling_cycle.hpp"
#include "core/outcome/contact_transition.hpp"
#include "core/outcome/outcome.hpp"
#include "core/outcome/peak_rise.hpp"
#include "core/scenario/attitude.hpp"
#include "core/scenario/scenario.hpp"
#include "core/surface/surfaces.hpp"

namespace unbruised {

/// What one finger did at the end of a step.
struct FingerObservation {
  double normal_N = 0;
  std::array<double, 2> tangent_N{};  ///< along the extents of its pad, on the product
  double closed_contacts = 0;
  double sliding_contacts = 0;
  double slip_m = 0;    ///< that the product has slipped past its pad since the start of the lift
  double slip_rad = 0;  ///< that it has turned against it meanwhile
  double yield_ratio = 0;
  double touched_s = kNever, left_s = kNever;  ///< when it came to touch or left within the step
  double range_m = 0;                          ///< that its sensor reads, where it has one
};

/// How far a finger that touches is from losing its hold: mu N / |T| - 1; while it slides as a whole, how much of
/// the slip limits it has used up, negative. Nothing where it has no tangential force to speak of.
std::optional<double> friction_margin(const FingerObservation& finger, double friction,
                                      const LimitParameters& limits);

/// What one scenario looked like at the end of a step.
struct StepObservation {
  double time_s = 0;
  double register_time_s = 0;  ///< t + theta dt, the time that the contacts' open / stick / slip belong to
  std::array<FingerObservation, kMostFingers> finger;
  std::size_t finger_count = kJawFingers;
  std::array<double, 3> force_N{};          ///< of the fingers on the product
  std::array<double, 3> torque_N_m{};       ///< on the product about the palm centre
  std::array<double, 3> center_motion_m{};  ///< displacement of the centre of mass
  std::array<double, 3> center_acceleration_m_s2{};
  std::array<double, 3> palm_m{};
  double rotation_rad = 0;           ///< of the product as a whole
  std::optional<Attitude> attitude;  ///< of a product that may turn far
  double compression_m = 0;
  double patch_pressure_Pa = 0;
  double support_N = 0;  ///< normal force of the support
  double support_yield_ratio = 0;
  std::array<PatchDamage, kSurfaceCount> patch;  ///< that the present load alone of each surface leaves
  double layer_strain = 0;       ///< largest compression of a pad or the support over its thickness
  double plastic_strain = 0;     ///< of the cells
  double absorbed_energy_J = 0;  ///< by the cells
  bool end_of_stroke = false;

  [[nodiscard]] std::span<const FingerObservation> fingers() const {
    return std::span(finger).first(finger_count);
  }
};

class HandlingRecord {
 public:
  HandlingRecord() = default;
  explicit HandlingRecord(const Scenario& scenario);
  /// Of the next handling of the product that this one has left.
  [[nodiscard]] HandlingRecord next(const Scenario& scenario) const;

  /// Takes in one step. @return false: the run has nothing more to show and ends here (dropped, not grasped).
  bool observe(const StepObservation& now, const HandlingCycle& cycle);

  /// The run cannot go on: `outcome` is diverged or out_of_range.
  void abort(Outcome outcome, std::string cause, double time_s);
  [[nodiscard]] bool aborted() const { return aborted_; }
  /// Aborted without a state that still says something.
  [[nodiscard]] bool diverged() const { return aborted_ && abort_outcome_ == Outcome::diverged; }

  /// Metrics that are known at the end only are in `metrics` already; limits on them are checked here.
  [[nodiscard]] ScenarioResult finish(const HandlingCycle& cycle, double end_time_s) const;

  Metrics metrics;

 private:
  struct Crossing {
    double time_s = kNever;
    std::string cause;
    [[nodiscard]] bool happened() const { return time_s < kNever; }
    void at(double time, std::string_view why) {
      if (!happened()) *this = {time, std::string(why)};
    }
  };
  void raise(Metric metric, double value);
  /// Notes the first limit that these metrics exceed, in the order given.
  /// @param where appended to the cause
  void check_limits(std::initializer_list<Metric> changed, double time_s, std::string_view where = {});
  void observe_support(const StepObservation& now);
  void observe_grip(const StepObservation& now);
  void observe_impulse(const StepObservation& now, const HandlingCycle& cycle);
  void observe_carrying(const StepObservation& now, const HandlingCycle& cycle);
  [[nodiscard]] double peak_rise_steps() const;
  void observe_leaving(const StepObservation& now);
  void observe_transition(const StepObservation& now, const HandlingCycle& cycle);
  /// Where no grip comes, the run ends.
  void observe_approach(const StepObservation& now, const HandlingCycle& cycle);
  void observe_hold(const StepObservation& now, const HandlingCycle& cycle);
  void observe_belt(const StepObservation& now, const HandlingCycle& cycle);
  void observe_places(const StepObservation& now, const HandlingCycle& cycle);

  LimitParameters limits_{};
  double friction_ = 0;
  double hold_s_ = 0;
  Attitude placing_attitude_;     ///< of the palm when it puts the product down
  Horizontal placing_shift_m_{};  ///< of the product's centre over where the palm is then
  bool has_gripper_ = false;
  bool lists_fingers_ = false;
  bool has_belt_ = false;
  bool has_product_yield_ = false;
  WorstPatches patches_;                           ///< of former handlings too
  double absorbed_before_J_ = 0, absorbed_J_ = 0;  ///< by the cells: in former handlings, and with this one
  ContactTransition transition_;
  bool both_touched_ = false;  ///< at the last contacts within the grip phase; of more fingers, two of them
  bool grasp_checked_ = false;
  bool aborted_ = false;
  Outcome abort_outcome_ = Outcome::not_run;
  Crossing not_grasped_, dropped_, slipped_, damaged_, misplaced_, abort_;
  double drift_from_s_ = 0, drift_to_s_ = 0;
  std::array<double, 3> drift_from_m_{}, drift_to_m_{};
  bool drift_started_ = false;
  double pressed_m_ = 0;  ///< compression when all fingers touched last
  std::array<PeakRise, kMostFingers> finger_rise_;
  PeakRise support_rise_;
  double finger_yield_ratio_ = 0, support_yield_ratio_ = 0;  ///< largest
  double impulse_time_s_ = 0, impulse_normal_N_ = 0;         ///< end of the last step
};

}  // namespace unbruised

#pragma once

/// @file
/// What a six-axis force/torque sensor reads in one scenario (docs/instruments.md): the force in its spring, from
/// the motion that is predicted within each step, then a low pass, sampling, noise, resolution and range. A
/// reading is the wrench with which the sensor holds what it carries: the weight of a gripper or of a product on
/// its plate reads as a force upwards.

#include <cstdint>
#include <optional>

#include "core/body/mount.hpp"
#include "core/scenario/sensor.hpp"

namespace unbruised {

/// What a mount does at the end of a step.
struct MountState {
  Six twist{}, velocity{}, acceleration{};
  Six own_wrench{};      ///< on it: its weight, the inertia of what moves its carrier
  Six contact_wrench{};  ///< on it, as the contact register holds it
};

class SixAxisInstrument {
 public:
  /// Begins to read at t = 0. @param stiffness of its spring
  SixAxisInstrument(const SixAxisSensorParameters& sensor, const SixBySix& stiffness, const MountState& start);

  /// Takes in a step.
  void observe(double start_s, double end_s, const MountState& end);

  /// Fx, Fy, Fz [N], Mx, My, Mz [N m] about the point of report: less the tare, as it was read last.
  [[nodiscard]] const Six& reading() const { return reading_; }
  /// The same without tare, weight and inertia of what the sensor carries itself: what the product does to it.
  [[nodiscard]] const Six& compensated() const { return compensated_; }
  [[nodiscard]] double peak_force_N() const { return peak_force_N_; }
  [[nodiscard]] double peak_force_time_s() const { return peak_force_time_s_; }
  [[nodiscard]] double peak_torque_N_m() const { return peak_torque_N_m_; }
  /// Largest size of a component before it is cut off, over its range; nothing where there is no range.
  [[nodiscard]] std::optional<double> overload() const { return overload_; }

 private:
  /// Wrenches about the point of report.
  struct Signal {
    Six held{};        ///< by the spring
    Six correction{};  ///< what takes from it all but the contacts: weight and inertia of what the sensor carries
  };
  /// A reading's force and when it was.
  struct ForceSample {
    double time_s = 0, force_N = 0;
  };
  [[nodiscard]] Signal signal(const Six& twist, const Six& own_wrench, const Six& contact_wrench) const;
  [[nodiscard]] Signal signal_at(double since_s, double step_s, const MountState& end) const;
  void filter(double time_s, const Signal& to);
  /// @param sample its number, where there is a rate
  void read(std::int64_t sample);
  [[nodiscard]] Six as_shown(Six wrench);
  void note_peaks(double time_s);

  SixAxisSensorParameters sensor_;
  SixBySix stiffness_;
  MountState last_;  ///< at the start of the present step
  Six tare_{};
  double filtered_at_s_ = 0;
  Signal filtered_, filtered_from_;  ///< behind the low pass, and before it, at that time
  Six reading_{}, compensated_{};
  std::array<ForceSample, 2> before_{};  ///< the last two readings
  double peak_force_N_ = 0, peak_force_time_s_ = 0, peak_torque_N_m_ = 0;
  std::optional<double> overload_;
};

}  // namespace unbruised

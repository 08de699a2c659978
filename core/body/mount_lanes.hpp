#pragma once

/// @file
/// The mounts of all lanes at once, integrated by the same Wilson-theta as the product and coupled to it through
/// the contacts of the surfaces they carry. A lane without a mount has one that never moves.

#include <array>
#include <optional>

#include "core/body/mount.hpp"
#include "core/integration/wilson_theta.hpp"
#include "core/lanes/lane_archive.hpp"
#include "core/lanes/lane_vector.hpp"

namespace unbruised {

/// A wrench or a twist, per lane.
struct LaneSix {
  LaneVector linear, angular;

  [[gnu::always_inline]] LaneSix& operator+=(const LaneSix& b) {
    linear += b.linear;
    angular += b.angular;
    return *this;
  }
  [[gnu::always_inline]] friend LaneSix operator+(LaneSix a, const LaneSix& b) { return a += b; }
  [[gnu::always_inline]] friend LaneSix operator-(const LaneSix& a, const LaneSix& b) {
    return {a.linear - b.linear, a.angular - b.angular};
  }
  [[gnu::always_inline]] friend LaneSix operator*(const Lane& factor, const LaneSix& a) {
    return {factor * a.linear, factor * a.angular};
  }
  [[gnu::always_inline]] Lane& operator[](std::size_t i) { return i < 3 ? linear[i] : angular[i - 3]; }
  [[gnu::always_inline]] const Lane& operator[](std::size_t i) const { return i < 3 ? linear[i] : angular[i - 3]; }
};

[[gnu::always_inline]] inline LaneSix select(const Mask& mask, const LaneSix& yes, const LaneSix& no) {
  return {select(mask, yes.linear, no.linear), select(mask, yes.angular, no.angular)};
}

[[gnu::always_inline]] inline Lane dot(const LaneSix& a, const LaneSix& b) {
  return dot(a.linear, b.linear) + dot(a.angular, b.angular);
}

inline Six of_lane(const LaneSix& value, int lane) {
  Six out{};
  for (std::size_t i = 0; i < 6; ++i) out[i] = value[i][lane];
  return out;
}

inline void set_lane(LaneSix& value, int lane, const Six& from) {
  for (std::size_t i = 0; i < 6; ++i) value[i].set(lane, from[i]);
}

/// Blocks of a 6x6 matrix, per lane.
struct LaneSixBySix {
  LaneMatrix block[2][2];

  LaneSixBySix() {
    for (auto& row : block) {
      for (LaneMatrix& part : row) part.at.fill(Lane(0.0));
    }
  }
  void set_lane(int lane, const SixBySix& from);
  [[gnu::always_inline]] friend LaneSix operator*(const LaneSixBySix& A, const LaneSix& x) {
    return {A.block[0][0] * x.linear + A.block[0][1] * x.angular,
            A.block[1][0] * x.linear + A.block[1][1] * x.angular};
  }
};

class MountLanes {
 public:
  /// Puts a mount into a lane, at rest; nothing: what its surfaces are fixed to does not give way.
  /// @param carried_wrench on it by what stands on it @param own_wrench its own weight
  void load(int lane, const std::optional<Mount>& mount, const Six& carried_wrench, const Six& own_wrench,
            const WilsonTheta& wilson);
  /// All that a lane keeps from step to step, but for what `load` sets.
  void archive(LaneArchive& lane);
  /// Is there a mount in any lane?
  [[nodiscard]] bool any() const { return count_ > 0; }
  [[nodiscard]] bool has(int lane) const { return mounted_[static_cast<std::size_t>(lane)]; }

  /// What acts on the mount of a lane beside contacts at t + theta dt and t + dt: weight, inertia of a carrier
  /// that moves.
  void set_own_wrench(int lane, const Six& at_theta, const Six& at_end);
  /// Collects what does not depend on the contact forces of this step.
  void begin_step(const WilsonTheta& wilson);
  /// Displacement from the start at t + theta dt without contact forces.
  [[nodiscard]] const LaneSix& free() const { return free_; }
  /// How far a wrench at t + theta dt moves it.
  [[nodiscard]] const LaneSixBySix& compliance() const { return inverse_; }
  /// Moves to t + dt under the contacts' wrench at t + theta dt, in the lanes of `running`.
  void advance(const WilsonTheta& wilson, const LaneSix& contact_theta, const Mask& running);

  /// Displacement from the start, velocity and acceleration.
  [[nodiscard]] LaneSix displacement() const { return twist_ - start_; }
  [[nodiscard]] const LaneSix& velocity() const { return velocity_; }
  [[nodiscard]] const LaneSix& acceleration() const { return acceleration_; }
  /// Displacement from where the spring is without force.
  [[nodiscard]] const LaneSix& twist() const { return twist_; }
  /// Of the contacts on it, now.
  [[nodiscard]] const LaneSix& contact_wrench() const { return contact_; }
  /// Weight and inertia of its carrier's motion, now.
  [[nodiscard]] const LaneSix& own_wrench() const { return own_; }

  /// 1 where the mount of a lane carries this surface, else 0.
  [[nodiscard]] const Lane& carries_pads() const { return carries_pads_; }
  [[nodiscard]] const Lane& carries_support() const { return carries_support_; }
  [[nodiscard]] const LaneVector& origin_m() const { return origin_m_; }

  /// Kinetic energy against what it is fixed to and elastic energy of its spring [J].
  [[nodiscard]] Lane energy() const;
  /// Work of its own wrench since load, and the positive part of each step's [J].
  [[nodiscard]] const Lane& work() const { return work_; }
  [[nodiscard]] const Lane& positive_work() const { return positive_work_; }
  /// Dissipated in its spring since load [J].
  [[nodiscard]] const Lane& dissipated() const { return dissipated_; }

 private:
  int count_ = 0;
  std::array<bool, kLanes> mounted_{};
  LaneSixBySix mass_, damping_, stiffness_, inverse_;
  LaneSix start_, twist_, velocity_, acceleration_;
  LaneSix own_, own_theta_, own_next_, contact_;
  LaneSix load_theta_;  ///< right-hand side of the step without contacts
  LaneSix free_;
  LaneVector origin_m_;
  Lane carries_pads_{0.0}, carries_support_{0.0};
  Lane work_{0.0}, positive_work_{0.0}, dissipated_{0.0};
};

}  // namespace unbruised

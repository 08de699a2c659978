#include "core/motion/belt.hpp"

#include <algorithm>
#include <cmath>

#include "core/scenario/conveyor.hpp"

namespace unbruised {

Belt::Belt(const ConveyorParameters& conveyor)
    : direction_(belt_direction(conveyor)),
      start_speed_m_s_(belt_start_speed_m_s(conveyor)),
      end_speed_m_s_(conveyor.speed_m_s),
      start_s_(conveyor.start_s) {
  const double change_m_s = end_speed_m_s_ - start_speed_m_s_;
  if (change_m_s == 0.0 || !conveyor.acceleration_m_s2) return;
  acceleration_m_s2_ = std::copysign(*conveyor.acceleration_m_s2, change_m_s);
  change_s_ = change_m_s / acceleration_m_s2_;
}

MotionProfile::State Belt::at(double time_s) const {
  const double before_s = std::min(time_s, start_s_);
  const double changing_s = std::clamp(time_s - start_s_, 0.0, change_s_);
  const double after_s = std::max(0.0, time_s - start_s_ - change_s_);
  const bool changes = changing_s < change_s_ && time_s >= start_s_;
  return {start_speed_m_s_ * (before_s + changing_s) + 0.5 * acceleration_m_s2_ * changing_s * changing_s +
              end_speed_m_s_ * after_s,
          changing_s < change_s_ ? start_speed_m_s_ + acceleration_m_s2_ * changing_s : end_speed_m_s_,
          changes ? acceleration_m_s2_ : 0.0};
}

}  // namespace unbruised

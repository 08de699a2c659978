#include "core/scenario/conveyor.hpp"

#include <cmath>

namespace unbruised {

bool has_belt(const CellParameters& cell) {
  return cell.conveyor.speed_m_s != 0.0 || belt_start_speed_m_s(cell.conveyor) != 0.0;
}

std::array<double, 2> belt_direction(const ConveyorParameters& conveyor) {
  const double length = std::hypot(conveyor.direction[0], conveyor.direction[1]);
  return {conveyor.direction[0] / length, conveyor.direction[1] / length};
}

double belt_start_speed_m_s(const ConveyorParameters& conveyor) {
  return conveyor.initial_speed_m_s.value_or(conveyor.acceleration_m_s2 ? 0.0 : conveyor.speed_m_s);
}

}  // namespace unbruised

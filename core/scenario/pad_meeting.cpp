#include "core/scenario/pad_meeting.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/scenario/gripper.hpp"
#include "core/scenario/true_shape.hpp"

namespace unbruised {

std::optional<PadMeeting> pad_meeting(const Scenario& scenario) {
  const auto* jaw = parallel_jaw(scenario);
  const auto* lattice = std::get_if<LatticeParameters>(&scenario.product);
  if (jaw == nullptr || !jaw->finger.empty() || lattice == nullptr) return std::nullopt;
  // Every shape falls away from the axis, so it stands highest where the pad comes nearest to it.
  const std::array<double, 2> center_m = {scenario.cell.grip_offset_m, scenario.cell.grip_height_m};
  std::array<double, 3> place_m{};
  for (std::size_t t = 0; t < 2; ++t) {
    const double half = 0.5 * jaw->pad_size_m[t];
    place_m[t + 1] = std::clamp(0.0, center_m[t] - half, center_m[t] + half);
  }
  const TrueShape shape(*lattice);
  if (!shape.contains(place_m)) return std::nullopt;
  const double half_chord_m = shape.half_chord_m(0, place_m);
  place_m[0] = half_chord_m;
  const double along = shape.is_round(0) ? std::abs(shape.nearest(place_m).normal[0]) : 1.0;
  return PadMeeting{0.5 - half_chord_m / lattice->size_m[0], std::acos(std::min(1.0, along))};
}

}  // namespace unbruised

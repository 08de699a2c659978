#include "core/scenario/pad_meeting.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/scenario/gripper.hpp"
#include "core/scenario/pad_face.hpp"
#include "core/scenario/true_shape.hpp"

namespace unbruised {
namespace {

using Place = std::array<double, 2>;

/// Of the side -x that the left pad meets, in the column through a place; where there is none, far inside.
double half_chord_m(const TrueShape& shape, const std::array<double, 3>& place_m) {
  return shape.column_m(0, place_m).value_or(-1.0);
}

/// A shaped pad before the side of a product.
struct FacingPad {
  PadFace face;
  TrueShape shape;
  double half_width_m;
  Place center_m;  ///< of the pad, from the product's middle

  /// How far the face stands before the product at a place of the pad, where the pad's plane is at the outermost
  /// place of the product; far behind where the product is not.
  [[nodiscard]] double ahead_m(const Place& on_pad) const {
    const std::array<double, 3> there = {0.0, center_m[0] + on_pad[0], center_m[1] + on_pad[1]};
    if (!shape.contains(there)) return -1e3;
    return face.height_m(on_pad) - (half_width_m - half_chord_m(shape, there));
  }
};

/// Along one tangent: the best of many places, then closer and closer.
void climb(const FacingPad& pad, std::size_t t, Place& on_pad) {
  constexpr int kPlaces = 64, kRefinements = 40;
  const double half = pad.face.half_size_m()[t];
  const auto ahead = [&](double along) {
    Place there = on_pad;
    there[t] = along;
    return pad.ahead_m(there);
  };
  double best = on_pad[t], best_m = ahead(best);
  const auto look = [&](double along) {
    const double there_m = ahead(along);
    if (there_m > best_m) best = along, best_m = there_m;
  };
  for (int i = 0; i <= kPlaces; ++i) look((2.0 * i / kPlaces - 1.0) * half);
  for (double step = 2.0 * half / kPlaces; step > half * std::ldexp(1.0, -kRefinements); step *= 0.5) {
    look(std::max(-half, best - step));
    look(std::min(half, best + step));
  }
  on_pad[t] = best;
}

PadMeeting shaped_meeting(const FacingPad& pad, Place on_pad) {
  constexpr int kRounds = 3;
  constexpr double kSlopeOver = 1e-4;  // of the pad
  for (int round = 0; round < kRounds; ++round) {
    for (std::size_t t = 0; t < 2; ++t) climb(pad, t, on_pad);
  }
  std::array<double, 3> there = {0.0, pad.center_m[0] + on_pad[0], pad.center_m[1] + on_pad[1]};
  PadMeeting meeting;
  meeting.reach_m = pad.ahead_m(on_pad);
  there[0] = half_chord_m(pad.shape, there);
  meeting.depth_share = 0.5 - 0.5 * there[0] / pad.half_width_m;
  if (!pad.shape.is_round(0)) return meeting;
  // Of the least of the angles between the product's normal and the face to both sides of the place: a face may
  // have a kink, and ends at its edges.
  const std::array<double, 3> normal = pad.shape.nearest(there).normal;
  double least = 4.0;
  for (int side = 0; side < 4; ++side) {
    std::array<double, 2> slope{};
    for (std::size_t t = 0; t < 2; ++t) {
      const double length = kSlopeOver * pad.face.half_size_m()[t];
      Place beside = on_pad;
      beside[t] += (((side >> t) & 1) != 0 ? 1.0 : -1.0) * length;
      slope[t] = pad.face.slope(beside, t, length);
    }
    const double along = (std::abs(normal[0]) + slope[0] * normal[1] + slope[1] * normal[2]) /
                         std::sqrt(1.0 + slope[0] * slope[0] + slope[1] * slope[1]);
    least = std::min(least, std::acos(std::clamp(along, -1.0, 1.0)));
  }
  meeting.lean_rad = least;
  return meeting;
}

}  // namespace

std::optional<PadMeeting> pad_meeting(const Scenario& scenario) {
  const auto* jaw = parallel_jaw(scenario);
  const auto* lattice = std::get_if<LatticeParameters>(&scenario.product);
  if (jaw == nullptr || !jaw->finger.empty() || lattice == nullptr) return std::nullopt;
  // Every shape falls away from its pole, so it stands highest where the pad comes nearest to that.
  const TrueShape shape(*lattice);
  const std::array<double, 3> pole_m = shape.pole_m(0);
  const std::array<double, 2> center_m = {scenario.cell.grip_offset_m, scenario.cell.grip_height_m};
  std::array<double, 3> place_m{};
  for (std::size_t t = 0; t < 2; ++t) {
    const double half = 0.5 * jaw->pad_size_m[t];
    place_m[t + 1] = std::clamp(pole_m[t + 1], center_m[t] - half, center_m[t] + half);
  }
  if (!shape.contains(place_m)) return std::nullopt;
  if (is_shaped(jaw->pad)) {
    const Place on_pad = {place_m[1] - center_m[0], place_m[2] - center_m[1]};
    return shaped_meeting({PadFace(*jaw), shape, 0.5 * lattice->size_m[0], center_m}, on_pad);
  }
  place_m[0] = half_chord_m(shape, place_m);
  const double along = shape.is_round(0) ? std::abs(shape.nearest(place_m).normal[0]) : 1.0;
  return PadMeeting{0.5 - place_m[0] / lattice->size_m[0], std::acos(std::min(1.0, along)), 0.0};
}

double pad_reach_m(const Scenario& scenario) {
  if (!has_shaped_pads(scenario)) return 0.0;
  const auto meeting = pad_meeting(scenario);
  return meeting ? meeting->reach_m : 0.0;
}

}  // namespace unbruised

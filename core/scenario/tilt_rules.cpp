#include <algorithm>
#include <array>
#include <cmath>

#include "core/scenario/product.hpp"
#include "core/scenario/rule_tables.hpp"
#include "core/scenario/words.hpp"

namespace unbruised {
namespace {

using Vector = std::array<double, 3>;

/// Of the way to the tilt, at which the product's corners are looked at.
constexpr int kLooks = 32;

double length(const Vector& x) { return std::hypot(x[0], x[1], x[2]); }

/// Height of what has turned about a line through the origin: Rodrigues' formula along z.
double turned_height(const Vector& x, const Vector& axis, double angle) {
  const double along = axis[0] * x[0] + axis[1] * x[1] + axis[2] * x[2];
  const double across = axis[0] * x[1] - axis[1] * x[0];
  return std::cos(angle) * x[2] + std::sin(angle) * across + (1.0 - std::cos(angle)) * along * axis[2];
}

/// How far below where it was lifted to the lowest corner of the product's extents comes on the way to the tilt
/// [m].
double swing_down_m(const Vector& extents_m, const CellParameters& cell, const Vector& tilt_rad) {
  const double angle = length(tilt_rad);
  Vector axis = tilt_rad;
  for (double& component : axis) component /= angle;
  double lowest = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    Vector x{};  // from the centre of the pads
    for (std::size_t i = 0; i < 3; ++i) x[i] = 0.5 * extents_m[i] * (((corner >> i) & 1) != 0 ? 1.0 : -1.0);
    x[1] -= cell.grip_offset_m;
    x[2] -= cell.grip_height_m;
    for (int look = 1; look <= kLooks; ++look) {
      lowest = std::min(lowest, turned_height(x, axis, angle * look / kLooks));
    }
  }
  return -0.5 * extents_m[2] - cell.grip_height_m - lowest;
}

bool is_tilted(const Scenario& s) { return has_gripper(s) && length(s.strategy.tilt_rad) > 0.0; }

void tilts_with_both_fingers(const Scenario& s, Violations& out) {
  const auto* jaw = parallel_jaw(s);
  if (!is_tilted(s) || jaw == nullptr || jaw->coupling == FingerCoupling::centric) return;
  out.push_back({"strategy.tilt_rad", "",
                 "needs gripper.coupling = \"centric\": fingers that are driven alone by a force cannot carry the "
                 "product along the grip axis"});
}

void tilts_by_half_a_turn(const Scenario& s, Violations& out) {
  constexpr double kMost_rad = 3.1416;  // pi as a person writes it
  if (length(s.strategy.tilt_rad) <= kMost_rad) return;
  out.push_back({"strategy.tilt_rad", "",
                 "turns by " + for_people(length(s.strategy.tilt_rad)) + " rad; it must be <= pi in length"});
}

void tilt_clears_the_plane(const Scenario& s, Violations& out) {
  const auto extents_m = shape_extents_m(s.product);
  if (!is_tilted(s) || !extents_m) return;
  const double room_m = s.cell.lift_height_m - std::max(0.0, s.cell.place_height_m);
  const double needed_m = swing_down_m(*extents_m, s.cell, s.strategy.tilt_rad);
  if (room_m > needed_m) return;
  out.push_back({"strategy.tilt_rad", "",
                 "turns the product into the plane below it: it needs a lift of more than " +
                     for_people(needed_m) + " m above that, and has " + for_people(room_m) +
                     " m (cell.lift_height_m)"});
}

}  // namespace

std::vector<Rule> tilt_rules() {
  return {
      {{"strategy.tilt_rad", "gripper", "gripper.coupling"}, "needs centric fingers", tilts_with_both_fingers},
      {{"strategy.tilt_rad"}, "<= pi in length", tilts_by_half_a_turn},
      {{"strategy.tilt_rad", "gripper", "cell.lift_height_m", "cell.place_height_m", "cell.grip_offset_m",
        "cell.grip_height_m", "product.size_m"},
       "clear of the plane below",
       tilt_clears_the_plane},
  };
}

}  // namespace unbruised

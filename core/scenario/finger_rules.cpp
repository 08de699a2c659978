#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/scenario/finger_axes.hpp"
#include "core/scenario/gripper.hpp"
#include "core/scenario/opening.hpp"
#include "core/scenario/rule_tables.hpp"
#include "core/scenario/sensor.hpp"
#include "core/scenario/vectors.hpp"
#include "core/scenario/words.hpp"

namespace unbruised {
namespace {

using Vector = std::array<double, 3>;

/// Fingers may miss the balance by this share of one finger's force; friction takes it.
constexpr double kBalanceRoom = 0.02;
/// Places between the open gripper and the product, at which the fingers are looked at.
constexpr int kLooks = 16;

std::string finger_path(std::size_t finger, std::string_view leaf) {
  return "gripper.finger[" + std::to_string(finger) + "]." + std::string(leaf);
}

const std::vector<FingerParameters>& fingers_of(const Scenario& s) {
  static const std::vector<FingerParameters> none;
  const auto* jaw = parallel_jaw(s);
  return jaw == nullptr ? none : jaw->finger;
}

/// Do all fingers point somewhere?
bool have_directions(const std::vector<FingerParameters>& fingers) {
  return std::ranges::all_of(fingers, [](const FingerParameters& finger) {
    return finger.angle_rad.has_value() != finger.direction.has_value() &&
           (!finger.direction || length(*finger.direction) > 0.0);
  });
}

void two_to_eight_fingers(const Scenario& s, Violations& out) {
  const std::size_t count = fingers_of(s).size();
  if (count == 0 || (count >= 2 && count <= kMostFingers)) return;
  out.push_back({"gripper.finger", std::to_string(count),
                 "must be 2 to " + std::to_string(kMostFingers) + " tables, one for each finger"});
}

void angle_or_direction(const Scenario& s, Violations& out) {
  const auto& fingers = fingers_of(s);
  for (std::size_t f = 0; f < fingers.size(); ++f) {
    if (fingers[f].angle_rad.has_value() != fingers[f].direction.has_value()) continue;
    out.push_back({finger_path(f, "angle_rad"), "",
                   fingers[f].direction ? "excludes direction; give one of them"
                                        : "missing: a finger stands at an angle_rad or closes in a direction"});
  }
}

void directions_point_somewhere(const Scenario& s, Violations& out) {
  const auto& fingers = fingers_of(s);
  for (std::size_t f = 0; f < fingers.size(); ++f) {
    if (!fingers[f].direction || length(*fingers[f].direction) > 0.0) continue;
    out.push_back({finger_path(f, "direction"), "", "must not be zero: the finger closes in it"});
  }
}

void fingers_hold_a_solid(const Scenario& s, Violations& out) {
  if (fingers_of(s).empty() || std::holds_alternative<LatticeParameters>(s.product)) return;
  out.push_back({"gripper.finger", "", "needs a product with a shape"});
}

/// Shortest sum of the directions in shares that add up to 1, as near as Frank and Wolfe's method comes.
double unbalanced(const std::vector<Vector>& way) {
  constexpr int kRounds = 500;
  Vector sum{};
  for (const Vector& each : way) {
    for (std::size_t i = 0; i < 3; ++i) sum[i] += each[i] / static_cast<double>(way.size());
  }
  for (int round = 0; round < kRounds; ++round) {
    Vector best = sum;
    for (const Vector& each : way) {
      if (dot(each, sum) < dot(best, sum)) best = each;
    }
    const Vector step = {best[0] - sum[0], best[1] - sum[1], best[2] - sum[2]};
    const double square = dot(step, step);
    if (!(square > 0.0)) break;
    const double share = std::clamp(-dot(sum, step) / square, 0.0, 1.0);
    for (std::size_t i = 0; i < 3; ++i) sum[i] += share * step[i];
  }
  return length(sum);
}

void fingers_balance(const Scenario& s, Violations& out) {
  const auto* jaw = parallel_jaw(s);
  const auto& fingers = fingers_of(s);
  if (jaw == nullptr || fingers.size() < 2 || !have_directions(fingers)) return;
  std::vector<Vector> way;
  Vector sum{};
  for (const FingerParameters& finger : fingers) {
    const Vector direction = finger_axes(finger)[2];
    way.push_back(direction);
    for (std::size_t i = 0; i < 3; ++i) sum[i] += direction[i];
  }
  if (unbalanced(way) > kBalanceRoom) {
    out.push_back(
        {"gripper.finger", "",
         "press the product away between them: no forces in the directions in which they close balance"});
  } else if (jaw->coupling == FingerCoupling::independent && length(sum) > kBalanceRoom) {
    out.push_back({"gripper.finger", "",
                   "press alike where gripper.coupling = \"independent\", and " + for_people(length(sum)) +
                       " of one finger's force are left over: their directions must add up to nothing"});
  }
}

/// A pad as a rectangle in the axes of the palm, from the middle of the grip.
struct PadPlate {
  std::array<Vector, 3> axes;
  Vector middle_m{};
  std::array<double, 2> half_m;
};

PadPlate plate_of(const ParallelJawParameters& jaw, const FingerParameters& finger, double from_middle_m) {
  PadPlate plate{finger_axes(finger), finger.offset_m, {0.5 * jaw.pad_size_m[0], 0.5 * jaw.pad_size_m[1]}};
  for (std::size_t i = 0; i < 3; ++i) plate.middle_m[i] -= from_middle_m * plate.axes[2][i];
  return plate;
}

/// Half of what a plate covers of an axis.
double shadow_m(const PadPlate& plate, const Vector& axis) {
  return std::abs(dot(plate.axes[0], axis)) * plate.half_m[0] +
         std::abs(dot(plate.axes[1], axis)) * plate.half_m[1];
}

/// Two plates meet where no axis parts them: their normals, their edges, and what is across an edge of either.
bool plates_meet(const PadPlate& a, const PadPlate& b) {
  constexpr double kRounding_m = 1e-9;
  std::vector<Vector> axes(a.axes.begin(), a.axes.end());
  axes.insert(axes.end(), b.axes.begin(), b.axes.end());
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t j = 0; j < 2; ++j) axes.push_back(cross(a.axes[i], b.axes[j]));
  }
  const Vector way = {b.middle_m[0] - a.middle_m[0], b.middle_m[1] - a.middle_m[1], b.middle_m[2] - a.middle_m[2]};
  return std::ranges::all_of(axes, [&](const Vector& axis) {
    return std::abs(dot(way, axis)) <= shadow_m(a, axis) + shadow_m(b, axis) - kRounding_m * length(axis) ||
           length(axis) < kRounding_m;
  });
}

void fingers_clear_each_other(const Scenario& s, Violations& out) {
  const auto* jaw = parallel_jaw(s);
  const auto& fingers = fingers_of(s);
  const auto half = half_width_m(s);
  if (jaw == nullptr || fingers.size() < 2 || !half || !have_directions(fingers)) return;
  const double opened_m = opened_half_m(s);
  for (int look = 0; look <= kLooks; ++look) {
    const double from_middle_m = opened_m + (*half - opened_m) * look / kLooks;
    for (std::size_t f = 0; f < fingers.size(); ++f) {
      for (std::size_t other = f + 1; other < fingers.size(); ++other) {
        if (!plates_meet(plate_of(*jaw, fingers[f], from_middle_m), plate_of(*jaw, fingers[other], from_middle_m)))
          continue;
        out.push_back({finger_path(other, fingers[other].direction ? "direction" : "angle_rad"), "",
                       "its pad meets that of gripper.finger[" + std::to_string(f) + "] " +
                           for_people(from_middle_m) + " m from the middle, before both touch the product; " +
                           "take a smaller gripper.pad_size_m or more room between them"});
        return;
      }
    }
  }
}

void what_fingers_lack(const Scenario& s, Violations& out) {
  const auto* jaw = parallel_jaw(s);
  if (jaw == nullptr || jaw->finger.empty()) return;
  const auto refuse = [&out](const std::string& what) {
    out.push_back({"gripper.finger", "", "does not go with " + what});
  };
  if (jaw->range.maximum_m) refuse("gripper.range: rays are those of two fingers that face each other along x");
  if (has_sensor(s) && s.sensor.at == SensorMount::wrist)
    refuse("sensor.at = \"wrist\": the sensor carries two pads that face each other along x");
  if (jaw->pad.kind != PadKind::layer || jaw->pad.shape != PadShape::flat)
    refuse("gripper.pad: the pads of listed fingers are flat and have a layer");
}

constexpr std::string_view kFinger = "gripper.finger", kAngle = "gripper.finger[].angle_rad",
                           kDirection = "gripper.finger[].direction", kOffset = "gripper.finger[].offset_m";

}  // namespace

std::vector<Rule> finger_rules() {
  return {
      {{kFinger}, "2 to 8", two_to_eight_fingers},
      {{kFinger, "product.kind"}, "needs a product with a shape", fingers_hold_a_solid},
      {{kFinger, kAngle, kDirection, "gripper.coupling"}, "directions that balance", fingers_balance},
      {{kFinger, "gripper.range.maximum_m", "sensor.at", "gripper.pad.kind", "gripper.pad.shape"},
       "not with range sensors, a sensor at the wrist, or shaped pads",
       what_fingers_lack},
      {{kAngle, kDirection}, "excludes direction", angle_or_direction, "excludes angle_rad"},
      {{kDirection}, "not zero", directions_point_somewhere},
      {{kOffset, kAngle, kDirection, "gripper.pad_size_m", "gripper.opening_m", "cell.approach_gap_m",
        "cell.grip_offset_m", "cell.grip_height_m", "product.size_m", "product.shape", "product.axis",
        "product.profile_height", "product.profile_radius", "product.exponents"},
       "clear of each other's pads until the product is touched",
       fingers_clear_each_other},
  };
}

}  // namespace unbruised

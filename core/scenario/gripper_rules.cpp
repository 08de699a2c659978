#include <cmath>

#include "core/scenario/gripper.hpp"
#include "core/scenario/opening.hpp"
#include "core/scenario/product.hpp"
#include "core/scenario/rule_tables.hpp"
#include "core/scenario/words.hpp"

namespace unbruised {
namespace {

/// A gripper with an opening, and the product that is to fit into it.
struct OpenGripper {
  double opening_m;
  double width_m;  ///< of the product along x; of listed fingers twice what it reaches towards them
};

std::optional<OpenGripper> open_gripper(const Scenario& s) {
  const auto opening = opening_m(s.gripper);
  const auto half = half_width_m(s);
  if (!opening || !half) return std::nullopt;
  return OpenGripper{*opening, 2.0 * *half};
}

void product_fits_opening(const Scenario& s, Violations& out) {
  const auto open = open_gripper(s);
  if (!open || open->width_m < open->opening_m) return;
  out.push_back({"gripper.opening_m", spelled(open->opening_m),
                 lists_fingers(s)
                     ? "must be > " + for_people(open->width_m) +
                           " m, twice what the product reaches towards a finger: the pads overlap it at the start"
                     : "must be > product.size_m[0] = " + spelled(open->width_m) +
                           ": the product is wider than the open gripper"});
}

void gap_follows_opening(const Scenario& s, Violations& out) {
  const auto open = open_gripper(s);
  if (!open || !s.cell.approach_gap_m) return;
  constexpr double kSame_m = 1e-9;  // what decimals of millimetres lose in sums
  const double left = gap_in_opening_m(open->opening_m, open->width_m, s);
  if (left <= 0.0 || std::abs(left - *s.cell.approach_gap_m) <= kSame_m) return;
  out.push_back({"cell.approach_gap_m", spelled(*s.cell.approach_gap_m),
                 "contradicts gripper.opening_m = " + spelled(open->opening_m) + ", which leaves " +
                     for_people(left) + " m on either side of the product; leave one of them out"});
}

void fingers_reach(const Scenario& s, Violations& out) {
  const auto stroke = finger_stroke_m(s.gripper);
  if (!stroke) return;
  const double gap = approach_gap_m(s);
  if (*stroke > gap || gap <= 0.0) return;
  out.push_back({"gripper.stroke_m", spelled(*stroke),
                 "must be > the way to the product, " + for_people(gap) + " m: the fingers never reach it"});
}

/// Of fingers that are listed.
constexpr std::string_view kAngle = "gripper.finger[].angle_rad", kDirection = "gripper.finger[].direction",
                           kOffset = "gripper.finger[].offset_m";

}  // namespace

std::vector<Rule> gripper_rules() {
  return {
      {{"gripper.stroke_m", "cell.approach_gap_m", "gripper.opening_m", "product.size_m", kAngle, kDirection,
        kOffset, "cell.grip_offset_m", "cell.grip_height_m", "product.shape", "product.axis",
        "product.profile_height", "product.profile_radius", "product.exponents"},
       "> the way to the product",
       fingers_reach},
      bounded("gripper.min_force_N", "<= max_force_N", "gripper.max_force_N"),
      bounded("gripper.force_step_N", "<= max_force_N", "gripper.max_force_N"),
      {{"gripper.opening_m", "product.size_m", kAngle, kDirection, kOffset, "cell.grip_offset_m",
        "cell.grip_height_m", "product.shape", "product.axis", "product.profile_height", "product.profile_radius",
        "product.exponents"},
       "> product.size_m[0]",
       product_fits_opening},
      {{"cell.approach_gap_m", "gripper.opening_m", "product.size_m", kAngle, kDirection, kOffset,
        "cell.grip_offset_m", "cell.grip_height_m", "product.shape", "product.axis", "product.profile_height",
        "product.profile_radius", "product.exponents"},
       "with gripper.opening_m: what the opening leaves",
       gap_follows_opening},
  };
}

}  // namespace unbruised

#include <cmath>

#include "core/scenario/opening.hpp"
#include "core/scenario/rule_tables.hpp"
#include "core/scenario/words.hpp"

namespace unbruised {
namespace {

const LatticeParameters* gripped(const Scenario& s) {
  return s.gripper ? std::get_if<LatticeParameters>(&s.product) : nullptr;
}

void product_fits_opening(const Scenario& s, Violations& out) {
  const auto* product = gripped(s);
  if (product == nullptr || !s.gripper->opening_m || product->size_m[0] < *s.gripper->opening_m) return;
  out.push_back({"gripper.opening_m", spelled(*s.gripper->opening_m),
                 "must be > product.size_m[0] = " + spelled(product->size_m[0]) +
                     ": the product is wider than the open gripper"});
}

void gap_follows_opening(const Scenario& s, Violations& out) {
  const auto* product = gripped(s);
  if (product == nullptr || !s.gripper->opening_m || !s.cell.approach_gap_m) return;
  constexpr double kSame_m = 1e-9;  // what decimals of millimetres lose in sums
  const double left = 0.5 * (*s.gripper->opening_m - product->size_m[0]);
  if (left <= 0.0 || std::abs(left - *s.cell.approach_gap_m) <= kSame_m) return;
  out.push_back({"cell.approach_gap_m", spelled(*s.cell.approach_gap_m),
                 "contradicts gripper.opening_m = " + spelled(*s.gripper->opening_m) + ", which leaves " +
                     for_people(left) + " m on either side of the product; leave one of them out"});
}

void fingers_reach(const Scenario& s, Violations& out) {
  if (!s.gripper) return;
  const double gap = approach_gap_m(s);
  if (s.gripper->stroke_m > gap || gap <= 0.0) return;
  out.push_back({"gripper.stroke_m", spelled(s.gripper->stroke_m),
                 "must be > the way to the product, " + for_people(gap) + " m: the fingers never reach it"});
}

}  // namespace

std::vector<Rule> gripper_rules() {
  return {
      {{"gripper.stroke_m", "cell.approach_gap_m", "gripper.opening_m", "product.size_m"},
       "> the way to the product",
       fingers_reach},
      bounded("gripper.min_force_N", "<= max_force_N", "gripper.max_force_N"),
      bounded("gripper.force_step_N", "<= max_force_N", "gripper.max_force_N"),
      {{"gripper.opening_m", "product.size_m"}, "> product.size_m[0]", product_fits_opening},
      {{"cell.approach_gap_m", "gripper.opening_m", "product.size_m"},
       "with gripper.opening_m: what the opening leaves",
       gap_follows_opening},
  };
}

}  // namespace unbruised

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "core/scenario/gripper.hpp"
#include "core/scenario/opening.hpp"
#include "core/scenario/pad_face.hpp"
#include "core/scenario/pad_law.hpp"
#include "core/scenario/pad_meeting.hpp"
#include "core/scenario/product.hpp"
#include "core/scenario/rule_tables.hpp"
#include "core/scenario/words.hpp"

namespace unbruised {
namespace {

std::string_view name_of(PadShape shape) {
  constexpr std::array<std::string_view, 5> kNames = {"flat", "cylinder", "v_groove", "sphere", "profile"};
  return kNames[static_cast<std::size_t>(shape)];
}

std::string with_shape(PadShape shape) { return "gripper.pad.shape = \"" + std::string(name_of(shape)) + "\""; }

/// Calls `check` for the pads of a scenario, where it has any.
template <class Check>
std::function<void(const Scenario&, Violations&)> of_jaw(Check check) {
  return [check](const Scenario& s, Violations& out) {
    if (const auto* jaw = parallel_jaw(s)) check(*jaw, out);
  };
}

/// A number that belongs to some shapes: required there, without effect elsewhere.
void belongs(std::string_view field, const std::optional<double>& value, bool to_shape, PadShape shape,
             Violations& out) {
  if (to_shape && !value) {
    out.push_back({std::string(field), "", "missing; " + with_shape(shape) + " needs it"});
  } else if (!to_shape && value) {
    out.push_back({std::string(field), spelled(*value), "not used with " + with_shape(shape)});
  }
}

void radius_of_round_face(const ParallelJawParameters& jaw, Violations& out) {
  const PadParameters& pad = jaw.pad;
  const bool is_sphere = pad.shape == PadShape::sphere, is_round = is_sphere || pad.shape == PadShape::cylinder;
  belongs("gripper.pad.radius_m", pad.radius_m, is_round, pad.shape, out);
  if (!is_round || !pad.radius_m) return;
  const double y = 0.5 * jaw.pad_size_m[0], z = 0.5 * jaw.pad_size_m[1];
  const double reach = is_sphere ? std::sqrt(y * y + z * z) : pad.along == PadAlong::z ? y : z;
  if (std::abs(*pad.radius_m) > reach) return;
  out.push_back({"gripper.pad.radius_m", spelled(*pad.radius_m),
                 "must be > " + for_people(reach) +
                     " m in size, which is how far gripper.pad_size_m reaches from "
                     "the middle: beyond its own radius the face has no height"});
}

void angle_of_groove(const ParallelJawParameters& jaw, Violations& out) {
  const PadParameters& pad = jaw.pad;
  belongs("gripper.pad.half_angle_rad", pad.half_angle_rad, pad.shape == PadShape::v_groove, pad.shape, out);
  if (!pad.half_angle_rad || *pad.half_angle_rad < 0.5 * std::numbers::pi) return;
  out.push_back({"gripper.pad.half_angle_rad", spelled(*pad.half_angle_rad),
                 "must be < pi / 2: with half a right angle to each side the groove opens by a right one"});
}

void profile_is_a_function(const ParallelJawParameters& jaw, Violations& out) {
  const PadParameters& pad = jaw.pad;
  const auto& place = pad.profile_place_m;
  const auto& height = pad.profile_height_m;
  if (pad.shape != PadShape::profile) {
    if (!place.empty() || !height.empty()) {
      out.push_back({"gripper.pad.profile_place_m", "", "not used with " + with_shape(pad.shape)});
    }
    return;
  }
  if (place.size() < 2 || place.size() != height.size()) {
    out.push_back({"gripper.pad.profile_place_m", std::to_string(place.size()) + " places",
                   "must have as many places as profile_height_m has heights, " + std::to_string(height.size()) +
                       ", and two at least"});
    return;
  }
  const auto repeated = std::adjacent_find(place.begin(), place.end(), std::greater_equal<>());
  if (repeated == place.end()) return;
  const auto i = static_cast<std::size_t>(repeated - place.begin()) + 1;
  out.push_back(
      {"gripper.pad.profile_place_m[" + std::to_string(i) + "]", spelled(place[i]),
       "must be > the place before it, " + spelled(*repeated) + ": a profile has one height at each place"});
}

std::optional<double> product_width_m(const Scenario& s) {
  const auto extents_m = shape_extents_m(s.product);
  return extents_m ? std::optional<double>((*extents_m)[0]) : std::nullopt;
}

/// Can the face be asked for heights?
bool has_face(const Scenario& s) {
  const auto* jaw = parallel_jaw(s);
  if (jaw == nullptr || !is_shaped(jaw->pad)) return false;
  Violations none;
  radius_of_round_face(*jaw, none);
  angle_of_groove(*jaw, none);
  profile_is_a_function(*jaw, none);
  return none.empty();
}

void pads_clear_of_product(const Scenario& s, Violations& out) {
  const auto width_m = product_width_m(s);
  const auto opening = opening_m(s.gripper);
  if (!width_m || !has_face(s) || !opening || s.cell.approach_gap_m || *width_m >= *opening) return;
  const double gap = gap_in_opening_m(*opening, *width_m, s);
  if (gap > 0.0) return;
  out.push_back({"gripper.opening_m", spelled(*opening),
                 "must be > " + for_people(*opening - 2.0 * gap) +
                     " m: the faces of the pads overlap the product at the start"});
}

void pads_clear_of_each_other(const Scenario& s, Violations& out) {
  const auto width_m = product_width_m(s);
  if (!width_m || !has_face(s)) return;
  const PadFace face(jaw_of(s));
  const double room = 0.5 * *width_m + pad_reach_m(s) - face.range_m()[1];
  if (room > 0.0) return;
  out.push_back({"gripper.pad.shape", "\"" + std::string(name_of(jaw_of(s).pad.shape)) + "\"",
                 "lets the pads meet each other before the product: their faces rise by " +
                     for_people(face.range_m()[1]) + " m, and there are " +
                     for_people(0.5 * *width_m + pad_reach_m(s)) + " m to the middle"});
}

void shaped_pads_need_a_solid(const Scenario& s, Violations& out) {
  if (!has_shaped_pads(s) || std::holds_alternative<LatticeParameters>(s.product)) return;
  out.push_back({"gripper.pad.shape", "", "needs a product with a shape"});
}

void law_is_measured(const ParallelJawParameters& jaw, Violations& out) {
  const PadParameters& pad = jaw.pad;
  const bool points = !pad.law_depth_m.empty() || !pad.law_force_N.empty();
  if (points && !pad.law_coefficients.empty()) {
    out.push_back({"gripper.pad.law_coefficients", "", "excludes law_depth_m and law_force_N; give one of them"});
    return;
  }
  if (!points && pad.law_coefficients.empty()) return;
  if (is_shaped(pad)) {
    out.push_back({"gripper.pad.shape", "\"" + std::string(name_of(pad.shape)) + "\"",
                   "must be \"flat\" with a measured law, which is of the whole fingertip against a flat plate"});
  }
  if (jaw.pad_poisson_ratio != 0.0) {
    out.push_back({"gripper.pad_poisson_ratio", spelled(jaw.pad_poisson_ratio),
                   "not used with a measured law; leave it out"});
  }
  if (points && (pad.law_depth_m.size() != pad.law_force_N.size() || pad.law_depth_m.size() < 2)) {
    out.push_back({"gripper.pad.law_depth_m", std::to_string(pad.law_depth_m.size()) + " depths",
                   "must have as many depths as law_force_N has forces, " +
                       std::to_string(pad.law_force_N.size()) + ", and two at least"});
    return;
  }
  if (const auto why = law_flaw(jaw)) out.push_back({std::string(why->field), "", why->rule});
}

}  // namespace

std::vector<Rule> pad_rules() {
  return {
      {{"gripper.pad.radius_m", "gripper.pad.shape", "gripper.pad.along", "gripper.pad_size_m"},
       "of a cylinder or sphere, larger than the pad reaches from its middle",
       of_jaw(radius_of_round_face)},
      {{"gripper.pad.half_angle_rad", "gripper.pad.shape"}, "of a V groove, < pi / 2", of_jaw(angle_of_groove)},
      {{"gripper.pad.profile_place_m", "gripper.pad.profile_height_m", "gripper.pad.shape"},
       "of a profile: one height at each place, which rise",
       of_jaw(profile_is_a_function),
       "of a profile: as many as places"},
      {{"gripper.opening_m", "gripper.pad.shape", "gripper.pad.along", "gripper.pad.radius_m",
        "gripper.pad.half_angle_rad", "gripper.pad.profile_place_m", "gripper.pad.profile_height_m",
        "gripper.pad_size_m", "cell.approach_gap_m", "cell.grip_offset_m", "cell.grip_height_m", "product.kind",
        "product.shape", "product.axis", "product.profile_height", "product.profile_radius", "product.exponents",
        "product.size_m"},
       "so wide that the pads' faces are clear of the product",
       pads_clear_of_product},
      {{"gripper.pad.shape", "gripper.pad.along", "gripper.pad.radius_m", "gripper.pad.half_angle_rad",
        "gripper.pad.profile_place_m", "gripper.pad.profile_height_m", "gripper.pad_size_m", "cell.grip_offset_m",
        "cell.grip_height_m", "product.kind", "product.shape", "product.axis", "product.profile_height",
        "product.profile_radius", "product.exponents", "product.size_m"},
       "whose faces meet the product before each other",
       pads_clear_of_each_other},
      {{"gripper.pad.shape", "product.kind"}, "needs a product with a shape", shaped_pads_need_a_solid},
      {{"gripper.pad.law_coefficients", "gripper.pad.law_depth_m", "gripper.pad.law_force_N", "gripper.pad.shape",
        "gripper.pad_poisson_ratio", "gripper.pad_thickness_m"},
       "a law that rises from (0, 0), of a flat pad",
       of_jaw(law_is_measured)},
  };
}

}  // namespace unbruised

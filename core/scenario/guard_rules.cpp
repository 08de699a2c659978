#include <algorithm>

#include "core/scenario/guard.hpp"
#include "core/scenario/product.hpp"
#include "core/scenario/rule_tables.hpp"
#include "core/scenario/words.hpp"

namespace unbruised {
namespace {

constexpr double kRounding = 1e-9;  // 1 / (1 / 3) is not 3

/// Of an instrument of the gripper: a sample belongs to one step at most.
void rate_fits_step(std::string_view field, const std::optional<double>& rate_Hz, const Scenario& s,
                    Violations& out) {
  const double most_Hz = 1.0 / s.simulation.time_step_s;
  if (!rate_Hz || *rate_Hz <= most_Hz * (1.0 + kRounding)) return;
  out.push_back({std::string(field), spelled(*rate_Hz),
                 "must be <= 1 / simulation.time_step_s = " + for_people(most_Hz) +
                     ": samples between the steps would show nothing new; leave it out to read at all times"});
}

void range_rate_fits_step(const Scenario& s, Violations& out) {
  const auto* jaw = parallel_jaw(s);
  if (jaw != nullptr) rate_fits_step("gripper.range.rate_Hz", jaw->range.rate_Hz, s, out);
}

void force_rate_fits_step(const Scenario& s, Violations& out) {
  const auto* jaw = parallel_jaw(s);
  if (jaw != nullptr) rate_fits_step("gripper.force_rate_Hz", jaw->force_rate_Hz, s, out);
}

void noise_is_of_samples(const Scenario& s, Violations& out) {
  const auto* jaw = parallel_jaw(s);
  if (jaw == nullptr || jaw->range.noise_m == 0.0 || jaw->range.rate_Hz) return;
  out.push_back({"gripper.range.noise_m", spelled(jaw->range.noise_m),
                 "must be 0 without gripper.range.rate_Hz: the noise is that of a sample"});
}

void ray_starts_outside(const Scenario& s, Violations& out) {
  const auto* jaw = parallel_jaw(s);
  const auto shape = true_shape(s.product);
  if (jaw == nullptr || !shape || !jaw->range.maximum_m) return;
  if (!shape->contains(ray_start_m(s, *jaw))) return;
  out.push_back({"gripper.range.depth_m", spelled(jaw->range.depth_m),
                 "must be > - the way to the product: the rays would start within it"});
}

void guard_has_instrument(const Scenario& s, Violations& out) {
  if (s.strategy.guard == GuardKind::none) return;
  const bool by_range = s.strategy.guard == GuardKind::range;
  const auto* jaw = parallel_jaw(s);
  const std::string word = by_range ? "\"range\"" : "\"force\"";
  if (jaw == nullptr) {
    out.push_back({"strategy.guard", word, "needs a gripper: it slows its fingers down"});
  } else if (by_range && !jaw->range.maximum_m) {
    out.push_back({"strategy.guard", word, "needs range sensors: give gripper.range.maximum_m"});
  }
}

/// The ramp of the force then begins with the run, and nothing that the fingers meet moves the cycle.
void guard_waits_for_contact(const Scenario& s, Violations& out) {
  if (s.strategy.guard == GuardKind::none || !s.strategy.ramp_from_start) return;
  out.push_back({"strategy.ramp_from_start", "true",
                 "must be false with a guard: the force rises before the guard could see anything"});
}

bool guards_by(GuardKind kind, const Scenario& s) { return has_gripper(s) && s.strategy.guard == kind; }

void guard_slows_down(const Scenario& s, Violations& out) {
  const double slow = s.strategy.guard_speed_m_s;
  if (s.strategy.guard == GuardKind::none || !has_gripper(s)) return;
  if (!(slow < s.strategy.approach_speed_m_s)) {
    add_bound(out, "strategy.guard_speed_m_s", slow, "strategy.approach_speed_m_s", s.strategy.approach_speed_m_s,
              Strictness::below);
  } else if (slow == 0.0 && s.strategy.guard == GuardKind::range) {
    out.push_back({"strategy.guard_speed_m_s", spelled(slow),
                   "must be > 0 with strategy.guard = \"range\": the fingers would stop before the product"});
  }
}

void range_can_be_read(const Scenario& s, Violations& out) {
  const auto* jaw = parallel_jaw(s);
  if (!guards_by(GuardKind::range, s)) return;
  if (!s.strategy.guard_range_m) {
    out.push_back({"strategy.guard_range_m", "", "missing; strategy.guard = \"range\" needs it"});
    return;
  }
  if (jaw == nullptr || !jaw->range.maximum_m || *s.strategy.guard_range_m <= *jaw->range.maximum_m) return;
  add_bound(out, "strategy.guard_range_m", *s.strategy.guard_range_m, "gripper.range.maximum_m",
            *jaw->range.maximum_m);
}

void range_lies_in_approach(const Scenario& s, Violations& out) {
  const auto* jaw = parallel_jaw(s);
  if (!guards_by(GuardKind::range, s) || jaw == nullptr || !jaw->range.maximum_m || !s.strategy.guard_range_m)
    return;
  const auto refuse = [&](const std::string& why) {
    out.push_back({"strategy.guard_range_m", spelled(*s.strategy.guard_range_m), why});
  };
  const auto ray = ray_at_start(s);
  if (!ray) {
    refuse("is never read: the rays of the range sensors or the pads pass the product");
  } else if (*s.strategy.guard_range_m > ray->distance_m) {
    refuse("must be <= what the range sensors read at the start, " + for_people(ray->distance_m) +
           " m: the fingers would be slow from the start");
  } else if (*s.strategy.guard_range_m <= ray->touch_distance_m) {
    refuse("must be > what the range sensors read when the pads touch, " + for_people(ray->touch_distance_m) +
           " m: the guard would come too late");
  }
}

/// Until the guard has seen the contact, the fingers press with no more than this.
void force_is_reached(const Scenario& s, Violations& out) {
  const auto* jaw = parallel_jaw(s);
  if (!guards_by(GuardKind::force, s) || jaw == nullptr) return;
  if (!s.strategy.guard_force_N) {
    out.push_back({"strategy.guard_force_N", "", "missing; strategy.guard = \"force\" needs it"});
    return;
  }
  const double force = *s.strategy.guard_force_N, limit = s.strategy.contact_force_N;
  const double driven = jaw->drive_gain_N_s_m * s.strategy.approach_speed_m_s;
  if (!(force < limit)) {
    add_bound(out, "strategy.guard_force_N", force, "strategy.contact_force_N", limit, Strictness::below);
  } else if (!(force < driven)) {
    out.push_back({"strategy.guard_force_N", spelled(force),
                   "must be < gripper.drive_gain_N_s_m x strategy.approach_speed_m_s = " + for_people(driven) +
                       " N: the drives press no harder before the guard has seen the contact"});
  }
}

}  // namespace

std::vector<Rule> guard_rules() {
  return {
      {{"gripper.force_rate_Hz", "simulation.time_step_s"}, "<= 1 / simulation.time_step_s", force_rate_fits_step},
      {{"gripper.range.depth_m", "gripper.range.maximum_m", "gripper.range.offset_m", "gripper.opening_m",
        "cell.approach_gap_m", "cell.grip_offset_m", "cell.grip_height_m", "product.size_m", "product.shape",
        "product.axis", "product.profile_height", "product.profile_radius", "product.exponents"},
       "not so far in front of the pad that the ray starts within the product",
       ray_starts_outside},
      {{"gripper.range.rate_Hz", "simulation.time_step_s"}, "<= 1 / simulation.time_step_s", range_rate_fits_step},
      {{"gripper.range.noise_m", "gripper.range.rate_Hz"}, "0 without rate_Hz", noise_is_of_samples},
      {{"strategy.guard", "gripper.range.maximum_m"},
       "\"range\" needs gripper.range.maximum_m",
       guard_has_instrument},
      {{"strategy.ramp_from_start", "strategy.guard"}, "false with a guard", guard_waits_for_contact},
      {{"strategy.guard_range_m", "gripper.range.maximum_m", "strategy.guard"},
       "<= gripper.range.maximum_m; required with guard = \"range\"",
       range_can_be_read},
      {{"strategy.guard_range_m", "strategy.guard", "gripper.range.maximum_m", "gripper.range.depth_m",
        "gripper.range.offset_m", "gripper.opening_m", "gripper.pad_size_m", "cell.approach_gap_m",
        "cell.grip_offset_m", "cell.grip_height_m", "product.size_m", "product.shape", "product.axis",
        "product.profile_height", "product.profile_radius", "product.exponents"},
       "between what the sensors read at the start and at the first contact",
       range_lies_in_approach},
      {{"strategy.guard_force_N", "strategy.guard", "strategy.contact_force_N", "strategy.approach_speed_m_s",
        "gripper.drive_gain_N_s_m"},
       "< strategy.contact_force_N; required with guard = \"force\"",
       force_is_reached},
      {{"strategy.guard_speed_m_s", "strategy.approach_speed_m_s", "strategy.guard"},
       "< approach_speed_m_s; > 0 with guard = \"range\"",
       guard_slows_down},
  };
}

}  // namespace unbruised

#include <algorithm>
#include <functional>

#include "core/scenario/rule_tables.hpp"
#include "core/scenario/words.hpp"

namespace unbruised {
namespace {

/// A grip force that squeezes the product by less of its width than this leaves nothing for a lock to hold.
constexpr double kRigidStrain = 1e-6;

void lock_has_something_to_hold(const Scenario& s, Violations& out) {
  const auto* jaw = parallel_jaw(s);
  const auto* product = std::get_if<LatticeParameters>(&s.product);
  if (jaw == nullptr || product == nullptr || jaw->hold != HoldMode::position || jaw->lock_stiffness_N_m) return;
  const double area_m2 = product->size_m[1] * product->size_m[2];
  const double strain = s.strategy.grip_force_N / (product->youngs_modulus_Pa * area_m2);
  if (strain >= kRigidStrain) return;
  out.push_back({"gripper.hold", "\"position\"",
                 "needs gripper.lock_stiffness_N_m for a product as good as rigid: strategy.grip_force_N squeezes "
                 "it by " +
                     for_people(strain) + " of its width, < " + for_people(kRigidStrain) +
                     ", and locks that do not give way leave its force to the smallest change of a way"});
}

void curve_falls(const Scenario& s, Violations& out) {
  const auto* jaw = parallel_jaw(s);
  if (jaw == nullptr) return;
  const std::vector<double>&speed = jaw->curve_speed_m_s, &force = jaw->curve_force_N;
  const auto refuse = [&out](const std::string& key, const std::string& rule) {
    out.push_back({"gripper." + key, "", rule});
  };
  if (speed.size() != force.size() || speed.size() == 1) {
    refuse("curve_force_N", "must have as many elements as gripper.curve_speed_m_s, two at least; they have " +
                                std::to_string(force.size()) + " and " + std::to_string(speed.size()));
    return;
  }
  if (speed.empty()) return;
  if (speed.front() != 0.0)
    refuse("curve_speed_m_s", "must begin with 0, not " + spelled(speed.front()) + ": at rest");
  if (!(force.front() > 0.0)) refuse("curve_force_N", "must begin with more than 0: at rest the drive presses");
  for (std::size_t i = 1; i < speed.size(); ++i) {
    if (!(speed[i] > speed[i - 1]))
      refuse("curve_speed_m_s", "must rise: " + spelled(speed[i]) + " follows " + spelled(speed[i - 1]));
    if (force[i] > force[i - 1]) {
      refuse("curve_force_N", "must not rise: " + spelled(force[i]) + " follows " + spelled(force[i - 1]) +
                                  ", and no drive presses harder the faster it goes");
    }
  }
}

bool has_curve(const ParallelJawParameters* jaw) {
  return jaw != nullptr && jaw->curve_speed_m_s.size() == jaw->curve_force_N.size() && !jaw->curve_force_N.empty();
}

void curve_reaches_force(const Scenario& s, Violations& out) {
  const auto* jaw = parallel_jaw(s);
  if (!has_curve(jaw) || jaw->max_force_N <= jaw->curve_force_N.front()) return;
  add_bound(out, "gripper.max_force_N", jaw->max_force_N, "gripper.curve_force_N[0]", jaw->curve_force_N.front());
}

/// Where the curve ends at no force, no finger gets beyond it.
void drive_gets_there(std::string_view field, double speed_m_s, const Scenario& s, Violations& out) {
  const auto* jaw = parallel_jaw(s);
  if (!has_curve(jaw)) return;
  const auto none = std::ranges::find_if(jaw->curve_force_N, [](double force) { return !(force > 0.0); });
  if (none == jaw->curve_force_N.end()) return;
  const double most = jaw->curve_speed_m_s[static_cast<std::size_t>(none - jaw->curve_force_N.begin())];
  if (speed_m_s < most) return;
  out.push_back({std::string(field), spelled(speed_m_s),
                 "must be < " + spelled(most) + ", the speed at which gripper.curve_force_N has fallen to 0"});
}

}  // namespace

std::vector<Rule> holding_rules() {
  return {
      {{"gripper.hold", "gripper.lock_stiffness_N_m", "strategy.grip_force_N", "product.youngs_modulus_Pa",
        "product.size_m"},
       "\"position\" needs lock_stiffness_N_m where the product is as good as rigid",
       lock_has_something_to_hold},
      {{"gripper.curve_force_N", "gripper.curve_speed_m_s"},
       "as many as curve_speed_m_s, two at least, > 0 at rest, not rising",
       curve_falls,
       "from 0, ascending"},
      {{"gripper.max_force_N", "gripper.curve_force_N", "gripper.curve_speed_m_s"},
       "<= curve_force_N[0]",
       curve_reaches_force},
      {{"strategy.approach_speed_m_s", "gripper.curve_force_N", "gripper.curve_speed_m_s"},
       "< the speed at which gripper.curve_force_N is 0",
       [](const Scenario& s, Violations& out) {
         drive_gets_there("strategy.approach_speed_m_s", s.strategy.approach_speed_m_s, s, out);
       }},
      {{"strategy.release_speed_m_s", "gripper.curve_force_N", "gripper.curve_speed_m_s"},
       "< the speed at which gripper.curve_force_N is 0",
       [](const Scenario& s, Violations& out) {
         drive_gets_there("strategy.release_speed_m_s", s.strategy.release_speed_m_s, s, out);
       }},
  };
}

}  // namespace unbruised

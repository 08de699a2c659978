#include "studies/config/rules.hpp"

#include <algorithm>
#include <string>

#include "core/outcome/damage_limits.hpp"
#include "studies/config/doubts.hpp"
#include "studies/text/key_names.hpp"

namespace unbruised::studies {
namespace {

constexpr std::string_view kGripForce = kGripForceKey;

std::string renamed(std::string text, std::string_view name) {
  for (std::size_t at = text.find(kGripForce); at != std::string::npos; at = text.find(kGripForce, at + 1)) {
    text.replace(at, kGripForce.size(), name);
  }
  return text;
}

/// Checks a rule about the grip force where the force is that end of the window, which is what is blamed then.
void check_end(const Rule& rule, Scenario scenario, double force_N, std::string_view name, Violations& out) {
  scenario.strategy.grip_force_N = force_N;
  Violations broken;
  rule.check(scenario, broken);
  for (const Violation& violation : broken) {
    out.push_back({renamed(violation.field, name), violation.value, renamed(violation.rule, name)});
  }
}

/// A rule of core, as a rule of a study.
StudyRule of_scenarios(const Rule& rule) {
  StudyRule out{rule.fields, nullptr};
  if (std::find(rule.fields.begin(), rule.fields.end(), kGripForce) == rule.fields.end()) {
    out.check = [&rule](const Scenario& s, const StudySettings& /*settings*/, Violations& broken) {
      rule.check(s, broken);
    };
    return out;
  }
  out.fields.insert(out.fields.end(), {"window.from_N", "window.to_N"});
  out.check = [&rule](const Scenario& s, const StudySettings& settings, Violations& broken) {
    if (!searches_force(settings.kind)) return rule.check(s, broken);
    check_end(rule, s, settings.window.from_N, "window.from_N", broken);
    if (broken.empty()) check_end(rule, s, settings.window.to_N, "window.to_N", broken);
  };
  return out;
}

void window_ordered(const Scenario& /*scenario*/, const StudySettings& settings, Violations& out) {
  if (!searches_force(settings.kind) || settings.window.from_N < settings.window.to_N) return;
  out.push_back({"window.from_N", spelled(settings.window.from_N),
                 "must be < window.to_N = " + spelled(settings.window.to_N)});
}

/// An answer that says "undamaged" where nothing could ever have been damaged is no answer.
void damage_can_show(const Scenario& s, const StudySettings& settings, Violations& out) {
  const bool is_judged = has_gripper(s) && s.limits.damage == DamageJudging::judged;
  if (!judges_damage(settings.kind) || !is_judged || !active_damage_limits(s).empty()) return;
  const std::string idle = idle_limits(s);
  const std::string ways =
      idle.empty() ? "give a limit in [limits], e.g. limits.finger_force_N or, with product.yield_stress_Pa, "
                     "limits.contact_yield_ratio = 1"
                   : "give product.yield_stress_Pa, or a limit that needs none (limits.finger_force_N, "
                     "limits.peak_pressure_Pa)";
  out.push_back(
      {"limits.damage", "\"judged\"",
       (idle.empty() ? std::string("there is no limit of damage, so nothing could ever count as damaged: ")
                     : idle + " can never act without a yield stress, so nothing could ever count as "
                              "damaged: ") +
           ways + ", or write limits.damage = \"not considered\" and get answers about holding alone"});
}

/// Everything that decides whether a limit of damage can act.
std::vector<std::string_view> damage_keys() {
  std::vector<std::string_view> keys = {"limits.damage", "product.yield_stress_Pa",
                                        "product.spring[].yield_force_N"};
  for (const DamageLimit& limit : kDamageLimits) keys.push_back(limit.key);
  return keys;
}

}  // namespace

const std::vector<StudyRule>& study_rules() {
  static const std::vector<StudyRule> rules = [] {
    std::vector<StudyRule> all;
    for (const Rule& rule : scenario_rules()) all.push_back(of_scenarios(rule));
    all.push_back({{"window.from_N", "window.to_N"}, window_ordered});
    all.push_back({damage_keys(), damage_can_show});
    return all;
  }();
  return rules;
}

}  // namespace unbruised::studies

#include "core/scenario/rules.hpp"

#include <cmath>

#include "core/scenario/number_fields.hpp"
#include "core/scenario/rule_tables.hpp"
#include "core/scenario/words.hpp"

namespace unbruised {

void add_bound(Violations& out, std::string_view field, double value, std::string_view other, double bound,
               Strictness strictness) {
  const std::string order = strictness == Strictness::below ? "must be < " : "must be <= ";
  out.push_back({std::string(field), spelled(value), order + std::string(other) + " = " + spelled(bound)});
}

Rule bounded(std::string_view lower, std::string_view sentence, std::string_view upper, Strictness strictness) {
  const NumberField* low = find_number_field(lower);
  const NumberField* high = find_number_field(upper);
  return {{lower, upper}, sentence, [=](const Scenario& scenario, Violations& out) {
            const auto value = number_of(*low, scenario);
            const auto bound = number_of(*high, scenario);
            if (!value || !bound) return;
            const bool holds = strictness == Strictness::below ? *value < *bound : *value <= *bound;
            if (!holds) add_bound(out, lower, *value, upper, *bound, strictness);
          }};
}

void add_unpaired(Violations& out, const std::string& path, const char* field, const std::optional<double>& value,
                  const char* with, const std::optional<double>& other) {
  if (value.has_value() == other.has_value()) return;
  out.push_back(value ? Violation{path + field, spelled(*value), std::string("not used without ") + with}
                      : Violation{path + field, "", std::string("missing; ") + with + " needs it"});
}

const std::vector<Rule>& scenario_rules() {
  static const std::vector<Rule> table = [] {
    std::vector<Rule> all;
    for (const auto& part :
         {lattice_rules(), shape_rules(), layer_rules(), relaxation_rules(), network_rules(), gripper_rules(),
          finger_rules(), pad_rules(), lattice_pad_rules(), holding_rules(), motion_rules(), sensor_rules(),
          surface_rules(), turn_rules(), guard_rules(), robot_rules()}) {
      all.insert(all.end(), part.begin(), part.end());
    }
    return all;
  }();
  return table;
}

Violations validate(const Scenario& scenario) {
  Violations out;
  for (const NumberField& field : number_fields()) {
    for_each_number(field, scenario, [&](const NumberPlace& place, double value) {
      if (std::isfinite(value) && field.range.contains(value)) return;
      out.push_back({path_of(field.path, place), spelled(value),
                     std::isfinite(value) ? "must be " + field.range.text() : "must be finite"});
    });
  }
  if (!out.empty()) return out;
  for (const Rule& rule : scenario_rules()) rule.check(scenario, out);
  return out;
}

}  // namespace unbruised

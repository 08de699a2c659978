#include "core/scenario/number_fields.hpp"
#include "core/scenario/rules.hpp"
#include "studies/config/keys/key_tables.hpp"
#include "studies/config/schema.hpp"
#include "studies/text/joined.hpp"

namespace unbruised::studies {
namespace {

/// Ranges and rules of a scenario's keys come from core.
void add_rules_of_core(KeySpec& spec) {
  if (const NumberField* field = find_number_field(spec.path)) spec.range = field->range;
  std::vector<std::string> rules;
  const auto add = [&](std::string_view sentence) {
    if (!sentence.empty()) rules.emplace_back(sentence);
  };
  for (const Rule& rule : scenario_rules()) {
    if (rule.fields.front() == spec.path) add(rule.sentence);
    if (rule.fields.size() > 1 && rule.fields[1] == spec.path) add(rule.of_second);
  }
  add(spec.note);
  spec.note = separated(rules, "; ");
}

}  // namespace

const std::vector<KeySpec>& key_table() {
  static const std::vector<KeySpec> table = [] {
    using namespace key_rows;
    std::vector<KeySpec> all;
    for (const Table& part : {study_keys(),
                              goal_keys(),
                              algorithm_keys(),
                              sampling_keys(),
                              compare_keys(),
                              sensitivity_keys(),
                              shape_keys(),
                              material_keys(),
                              relaxation_keys(),
                              skin_keys(),
                              network_file_keys(),
                              layer_keys(),
                              particle_keys(),
                              spring_and_load_keys(),
                              spring_relaxation_keys(),
                              finger_and_pad_keys(),
                              drive_keys(),
                              holding_keys(),
                              data_sheet_keys(),
                              pad_keys(),
                              range_keys(),
                              finger_list_keys(),
                              support_keys(),
                              path_keys(),
                              conveyor_keys(),
                              surface_keys(),
                              sensor_keys(),
                              robot_keys(),
                              arm_joint_keys(),
                              grip_keys(),
                              guard_keys(),
                              pick_keys(),
                              motion_keys(),
                              waypoint_keys(),
                              limit_keys(),
                              simulation_keys(),
                              vary_keys(),
                              calibrate_keys(),
                              parameter_keys(),
                              specimen_keys(),
                              variable_keys(),
                              random_keys(),
                              random_bound_keys(),
                              correlation_keys(),
                              candidate_keys()}) {
      all.insert(all.end(), part.begin(), part.end());
    }
    for (KeySpec& spec : all) {
      if (spec.field != nullptr) add_rules_of_core(spec);
    }
    return all;
  }();
  return table;
}

}  // namespace unbruised::studies

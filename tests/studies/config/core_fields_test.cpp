// The key table against core's table of numbers: one range, one place, and every rule a key of the reference.

#include <algorithm>

#include "core/scenario/number_fields.hpp"
#include "core/scenario/rules.hpp"
#include "studies/config/schema.hpp"
#include "tests/core/scenario/scenarios.hpp"
#include "tests/studies/config/config_testing.hpp"

namespace unbruised::studies {
namespace {

bool is_numeric(KeyType type) {
  return type == KeyType::number || type == KeyType::optional_number || type == KeyType::integer ||
         type == KeyType::integers || is_number_array(type);
}

TEST(CoreFields, AreTheNumericKeysOfAScenarioWithTheirRanges) {
  for (const KeySpec& spec : key_table()) {
    const NumberField* field = find_number_field(spec.path);
    EXPECT_EQ(field != nullptr, spec.field != nullptr && is_numeric(spec.type)) << spec.path;
    if (field == nullptr) continue;
    EXPECT_EQ(field->range, spec.range) << spec.path;
  }
  for (const NumberField& field : number_fields()) {
    EXPECT_NE(find_key(path_of(field.path, {.index = 0})).spec, nullptr) << field.path;
  }
}

TEST(CoreFields, AreTheNumbersThatTheirKeysWrite) {
  for (Scenario scenario : {unbruised::testing::usual_grip(), unbruised::testing::usual_network()}) {
    for (const NumberField& field : number_fields()) {
      field.each(scenario, [&](const NumberPlace& place, NumberSlot slot) {
        constexpr double kMark = 77.0;
        unbruised::testing::set(slot, kMark);
        const std::string path = path_of(field.path, place);
        const KeyAddress address = find_key(path);
        ASSERT_NE(address.spec, nullptr) << path;
        EXPECT_EQ(number_at(address.spec->field(scenario, address.index), address.elements), kMark) << path;
        unbruised::testing::set(slot, 0.0);
      });
    }
  }
}

TEST(CoreFields, RulesOfCoreStandInTheReferenceOfTheirKeys) {
  const std::string reference = reference_markdown();
  for (const Rule& rule : scenario_rules()) {
    const KeyAddress address = find_key(rule.fields.front());
    if (address.spec == nullptr) continue;  // about a table
    EXPECT_NE(address.spec->note.find(rule.sentence), std::string::npos) << rule.fields.front();
  }
  EXPECT_NE(explain_key("strategy.contact_force_N")->find("rule: >= 0; <= strategy.grip_force_N"),
            std::string::npos);
}

}  // namespace
}  // namespace unbruised::studies

#include "core/scenario/number_fields.hpp"

#include <set>

#include <gtest/gtest.h>

#include "tests/core/scenario/scenarios.hpp"

namespace unbruised {
namespace {

using namespace testing;

TEST(NumberFields, ReachDifferentNumbersUnderDifferentNames) {
  for (Scenario scenario : {usual_grip(), usual_network()}) {
    std::set<NumberSlot> slots;
    std::set<std::string> names;
    std::size_t count = 0;
    for (const NumberField& field : number_fields()) {
      field.each(scenario, [&](const NumberPlace& place, NumberSlot slot) {
        ++count;
        slots.insert(slot);
        names.insert(path_of(field.path, place));
      });
    }
    EXPECT_EQ(slots.size(), count);
    EXPECT_EQ(names.size(), count);
  }
}

TEST(NumberFields, NameTheirPlacesAsConfigsDo) {
  EXPECT_EQ(path_of("strategy.speed_m_s", {}), "strategy.speed_m_s");
  EXPECT_EQ(path_of("product.size_m", {.element = 2}), "product.size_m[2]");
  EXPECT_EQ(path_of("product.load[].force_N", {.index = 3, .element = 1, .component = 2}),
            "product.load[3].force_N[1][2]");
}

TEST(NumberFields, ReadWhatIsThereAndNothingElse) {
  Scenario scenario = usual_grip();
  EXPECT_EQ(number_of(*find_number_field("product.mass_kg"), scenario), 0.1);
  EXPECT_EQ(number_of(*find_number_field("product.density_kg_m3"), scenario), std::nullopt);
  EXPECT_EQ(number_of(*find_number_field("product.spring[].stiffness_N_m"), scenario), std::nullopt);
  scenario.gripper = NoGripper{};
  EXPECT_EQ(number_of(*find_number_field("gripper.stroke_m"), scenario), std::nullopt);
  EXPECT_EQ(find_number_field("strategy.profile"), nullptr);
}

}  // namespace
}  // namespace unbruised

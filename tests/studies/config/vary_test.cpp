#include "studies/config/vary.hpp"

#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "tests/studies/config/config_testing.hpp"

namespace unbruised::studies {
namespace {

using testing::config_root;
using testing::errors_of;
using testing::gripped_block;
using testing::search_block;
using testing::study_of;

TEST(Vary, IsACartesianProductWithTheFirstBlockSlowest) {
  const Study study = study_of(gripped_block("sweep") + R"(
[[vary]]
key = "strategy.hold_s"
values = [0.0, 1.0]
[[vary]]
key = "product.size_m[1]"
from = 0.05
to = 0.07
count = 3
)");
  ASSERT_EQ(study.scenario_count(), 6U);
  ASSERT_EQ(study.inputs().size(), 2U);
  EXPECT_EQ(study.inputs()[1].key, "product.size_m[1]");
  EXPECT_EQ(study.inputs()[1].units, "m");
  const double hold[] = {0, 0, 0, 1, 1, 1};
  // 0.05 + 0.5 x (0.07 - 0.05) is 0.06 to one rounding.
  const double width[] = {0.05, 0.06, 0.07, 0.05, 0.06, 0.07};
  for (std::size_t id = 0; id < 6; ++id) {
    EXPECT_EQ(study.input_number(id, 0), hold[id]);
    EXPECT_DOUBLE_EQ(study.input_number(id, 1), width[id]);
    const Scenario scenario = study.scenario(id);
    EXPECT_EQ(scenario.strategy.hold_s, study.input_number(id, 0));
    EXPECT_EQ(std::get<LatticeParameters>(scenario.product).size_m[1], study.input_number(id, 1));
    EXPECT_EQ(std::get<LatticeParameters>(scenario.product).size_m[0], 0.05);
  }
}

TEST(Vary, ZippedBlocksMoveTogetherAtThePlaceOfTheFirst) {
  const Study study = study_of(gripped_block("sweep") + R"(
[[vary]]
key = "strategy.hold_s"
values = [1.0, 2.0]
zip = "a"
[[vary]]
key = "strategy.speed_m_s"
values = [0.1, 0.2, 0.3]
[[vary]]
key = "strategy.settle_s"
values = [10.0, 20.0]
zip = "a"
)");
  ASSERT_EQ(study.scenario_count(), 6U);
  for (std::size_t id = 0; id < 6; ++id) {
    EXPECT_EQ(study.input_number(id, 0), id < 3 ? 1.0 : 2.0);
    EXPECT_EQ(study.input_number(id, 2), 10.0 * study.input_number(id, 0));
    EXPECT_EQ(study.input_index(id, 1), id % 3);
  }
}

TEST(Vary, LogScaleHasEqualRatiosAndExactEnds) {
  const Study study = study_of(gripped_block("sweep") +
                               "[[vary]]\nkey = \"strategy.grip_force_N\"\nfrom = 0.6\nto = 6.0\ncount = 16\n"
                               "scale = \"log\"\n");
  const std::vector<double>& force = study.inputs()[0].numbers;
  ASSERT_EQ(force.size(), 16U);
  EXPECT_EQ(force.front(), 0.6);
  EXPECT_EQ(force.back(), 6.0);
  // pow is right to an ulp or two, and a ratio of two such values to four times that.
  for (std::size_t i = 1; i < 16; ++i) EXPECT_NEAR(force[i] / force[i - 1], std::pow(10.0, 1.0 / 15.0), 2e-15);
}

TEST(Vary, TakesWordsBooleansAndProductFiles) {
  const Study study = study_of(R"(
[study]
name = "t"
kind = "sweep"
[gripper]
[product]
friction = 0.9
[[vary]]
key = "product.use"
values = ["products/kiwi_ripe.toml", "products/pear_korla.toml"]
[[vary]]
key = "strategy.profile"
values = ["minimum_jerk", "trapezoid"]
[[vary]]
key = "strategy.ramp_from_start"
values = [false, true]
)");
  ASSERT_EQ(study.scenario_count(), 8U);
  EXPECT_TRUE(study.inputs()[0].is_text);
  EXPECT_EQ(study.input_text(5, 0), "products/pear_korla.toml");
  EXPECT_EQ(study.input_text(5, 2), "true");
  EXPECT_TRUE(std::isnan(study.input_number(5, 0)));
  for (const Study& s : {study, study_of(study.resolved_toml())}) {
    const Scenario kiwi = s.scenario(3);
    const Scenario pear = s.scenario(4);
    EXPECT_EQ(std::get<LatticeParameters>(kiwi.product).yield_stress_Pa, 0.024e6);
    EXPECT_EQ(std::get<LatticeParameters>(pear.product).yield_stress_Pa, std::nullopt);
    EXPECT_EQ(std::get<LatticeParameters>(pear.product).friction, 0.9) << "the study overrides every file";
    EXPECT_EQ(kiwi.limits.plastic_strain, 0.01);
    EXPECT_EQ(pear.limits.plastic_strain, std::nullopt);
    EXPECT_EQ(pear.limits.finger_force_N, 35.0);
    EXPECT_EQ(kiwi.strategy.profile, ProfileKind::trapezoid);
    EXPECT_TRUE(kiwi.strategy.ramp_from_start);
    EXPECT_EQ(pear.strategy.profile, ProfileKind::minimum_jerk);
  }
}

TEST(Vary, NumbersAHundredThousandScenarios) {
  const Study study = study_of(gripped_block("sweep") + R"(
[[vary]]
key = "strategy.grip_force_N"
from = 1.0
to = 2.0
count = 1000
[[vary]]
key = "strategy.contact_force_N"
from = 0.0
to = 1.0
count = 100
)");
  ASSERT_EQ(study.scenario_count(), 100'000U);
  const auto forces = [&study](std::uint64_t id) {
    const StrategyParameters strategy = study.scenario(id).strategy;
    return std::pair{strategy.grip_force_N, strategy.contact_force_N};
  };
  EXPECT_EQ(forces(0), std::pair(1.0, 0.0));
  EXPECT_EQ(forces(99), std::pair(1.0, 1.0));
  EXPECT_EQ(forces(99'900), std::pair(2.0, 0.0));
  EXPECT_EQ(forces(99'999), std::pair(2.0, 1.0));
}

TEST(ContactForce, FollowsTheLeastGripForceOfTheStudyWhereItIsNotWritten) {
  const auto contact_of = [](const Study& study) { return study.scenario(0).strategy.contact_force_N; };
  EXPECT_EQ(contact_of(study_of(gripped_block("simulate"))), 0.3) << "the default, below every grip force";
  EXPECT_EQ(contact_of(study_of(gripped_block("simulate"), {"strategy.grip_force_N=0.2"})), 0.2);
  const Study window = study_of(gripped_block("window") + "[window]\nfrom_N = 0.1\nto_N = 5.0\n");
  EXPECT_EQ(contact_of(window), 0.1);
  EXPECT_NE(window.resolved_toml().find("contact_force_N = 0.1\n"), std::string::npos);
  const std::string grips = "[[vary]]\nkey = \"strategy.grip_force_N\"\nvalues = [0.9, 0.15, 0.4]\n";
  EXPECT_EQ(contact_of(study_of(gripped_block("sweep") + grips)), 0.15);
}

}  // namespace
}  // namespace unbruised::studies

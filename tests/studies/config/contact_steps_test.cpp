#include "studies/config/contact_steps.hpp"

#include <algorithm>
#include <cmath>

#include "core/contact/contact_time.hpp"
#include "tests/studies/config/config_testing.hpp"

namespace unbruised::studies {
namespace {

using testing::config_root;
using testing::gripped_block;
using testing::search_block;
using testing::small_network;
using testing::study_of;

constexpr const char* kSpeeds = R"(
[[vary]]
key = "strategy.approach_speed_m_s"
values = [0.05, 0.4, 0.1]
)";

std::string kiwi(const std::string& kind, const std::string& more) {
  return "[study]\nname = \"t\"\nkind = \"" + kind +
         "\"\n[product]\nuse = \"products/kiwi_ripe.toml\"\n[gripper]\nuse = \"grippers/parallel_jaw.toml\"\n" +
         more;
}

double step_of(const Study& study) { return study.scenario(0).simulation.time_step_s; }

TEST(ChosenTimeStep, GivesTheShortestContactOfTheStudyTwentySteps) {
  const Study study = study_of(kiwi("sweep", kSpeeds));
  EXPECT_TRUE(study.is_time_step_chosen());
  double shortest_s = INFINITY;
  for (std::size_t id = 0; id < study.scenario_count(); ++id) {
    shortest_s = std::min(shortest_s, contact_time_s(study.scenario(id)));
    EXPECT_EQ(study.scenario(id).simulation.time_step_s, step_of(study)) << "one step: factor groups stay shared";
  }
  EXPECT_LE(step_of(study) * kStepsPerContact, shortest_s);
  EXPECT_GT(step_of(study) * kStepsPerContact, 0.9 * shortest_s);  // two digits: off by less than a tenth
  EXPECT_EQ(study.fewest_contact_steps().where, "approach_speed_m_s = 0.4");
}

TEST(ContactSteps, NameOnlyTheKeysThatMatterOfThoseThatVaryTogether) {
  const std::string zipped =
      "[[vary]]\nkey = \"product.friction\"\nzip = \"z\"\nvalues = [0.4, 0.5]\n"
      "[[vary]]\nkey = \"product.youngs_modulus_Pa\"\nzip = \"z\"\nvalues = [2e5, 3e5]\n";
  EXPECT_EQ(study_of(kiwi("sweep", zipped)).fewest_contact_steps().where, "youngs_modulus_Pa = 300,000");
}

TEST(ChosenTimeStep, OfAKiwiMetAtThreeHundredMillimetresPerSecondIsNotTheMillisecondThatMovesItsDamageByAThird) {
  const Study study = study_of(kiwi("simulate", "[strategy]\napproach_speed_m_s = 0.3\ngrip_force_N = 2.0\n"));
  EXPECT_LE(step_of(study), 7.8e-4);
}

TEST(ChosenTimeStep, OfAFlatFaceKnowsTheTimeOfItsSurfaceOnTheLayerWhereTheImpactDecides) {
  const auto block = [](const std::string& strategy) {
    return study_of(
        "[study]\nname = \"t\"\nkind = \"simulate\"\n[product]\nuse = "
        "\"products/silicone_block.toml\"\n[gripper]\nuse = \"grippers/parallel_jaw.toml\"\n"
        "pad_poisson_ratio = 0.0\n[strategy]\ngrip_force_N = 3.0\n" +
        strategy);
  };
  const Study fast = block("approach_speed_m_s = 0.2\n");
  EXPECT_EQ(step_of(fast), kLeastChosenStep_s);
  EXPECT_EQ(fast.fewest_contact_steps().part, ContactPart::finger_surface);
  EXPECT_NEAR(fast.fewest_contact_steps().steps, 10.7, 0.1);  // 1.07 ms
  EXPECT_GT(step_of(block("approach_speed_m_s = 0.05\n")), 5e-4) << "pressed with more than the first peak";
}

TEST(ChosenTimeStep, LooksAtTheEndsOfWhatIsSearchedDrawnAndAskedFor) {
  const std::string slow = "[strategy]\napproach_speed_m_s = 0.05\n";
  const std::string firm = slow + "grip_force_N = 4.0\n";
  const double at_base = step_of(study_of(kiwi("simulate", firm)));
  const std::string stiff =
      "[[random]]\nkey = \"product.youngs_modulus_Pa\"\ndistribution = \"uniform\"\n"
      "from = 0.2e6\nto = 2e6\n";
  EXPECT_LT(step_of(study_of(kiwi("sample", firm + stiff))), at_base);
  const std::string fast = "[[variable]]\nkey = \"strategy.approach_speed_m_s\"\nfrom = 0.01\nto = 0.5\n";
  EXPECT_LT(step_of(study_of(kiwi("optimize", fast))), at_base);
  EXPECT_LT(step_of(study_of(kiwi("window", slow + "[window]\nfrom_N = 0.5\nto_N = 80.0\n"))), at_base);
}

TEST(ChosenTimeStep, LooksAtEveryCandidate) {
  const Study study = study_of(search_block("compare") +
                               "[[candidate]]\nname = \"fast\"\nuse = \"strategies/fast.toml\"\n"
                               "approach_speed_m_s = 0.5\n[strategy]\ncontact_force_N = 0.2\n");
  for (const StrategyCandidate& candidate : study.candidates()) {
    EXPECT_LE(candidate.scenario.simulation.time_step_s * kStepsPerContact, contact_time_s(candidate.scenario));
  }
}

TEST(ChosenTimeStep, OfAComparisonDoesNotLookAtTheStrategyThatNobodyRuns) {
  const std::string compare = kiwi("compare",
                                   "[strategy]\napproach_speed_m_s = 0.4\n[[candidate]]\nname = \"a\"\n"
                                   "approach_speed_m_s = 0.02\n[[candidate]]\nname = \"b\"\n"
                                   "approach_speed_m_s = 0.03\n[[random]]\nkey = \"product.friction\"\n"
                                   "distribution = \"uniform\"\nfrom = 0.4\nto = 0.6\n");
  EXPECT_EQ(step_of(study_of(compare)),
            step_of(study_of(kiwi("simulate", "[strategy]\napproach_speed_m_s = 0.03\n"))));
}

TEST(ChosenTimeStep, StandsInTheResolvedConfigAndReadsBackAsGiven) {
  const Study study = study_of(kiwi("sweep", kSpeeds));
  const Study again = study_of(study.resolved_toml());
  EXPECT_EQ(step_of(again), step_of(study));
  EXPECT_EQ(again.resolved_toml(), study.resolved_toml());
  EXPECT_FALSE(again.is_time_step_chosen());
}

TEST(ChosenTimeStep, StaysBetweenATenthOfAMillisecondAndOne) {
  EXPECT_EQ(step_of(study_of(gripped_block("simulate"), {"gripper.finger_mass_kg=5"})), kLongestChosenStep_s);
  EXPECT_EQ(step_of(study_of(gripped_block("simulate"), {"gripper.finger_mass_kg=1e-4"})), kLeastChosenStep_s);
  EXPECT_EQ(step_of(study_of(small_network())), kLongestChosenStep_s) << "nothing hits anything";
}

TEST(ChosenTimeStep, AGivenOrVariedStepStays) {
  const Study given = study_of(kiwi("sweep", kSpeeds), {"simulation.time_step_s=2e-3"});
  EXPECT_FALSE(given.is_time_step_chosen());
  EXPECT_EQ(step_of(given), 2e-3);
  const Study varied =
      study_of(kiwi("sweep", "[[vary]]\nkey = \"simulation.time_step_s\"\nvalues = [1e-3, 2e-3]\n"));
  EXPECT_EQ(varied.scenario(1).simulation.time_step_s, 2e-3);
  EXPECT_EQ(varied.fewest_contact_steps().where, "time_step_s = 0.002");
}

}  // namespace
}  // namespace unbruised::studies

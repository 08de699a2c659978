// A study that answers "undamaged" needs something that could have been damaged.

#include "studies/findings/claims.hpp"

#include "tests/studies/config/config_testing.hpp"

namespace unbruised::studies {
namespace {

using testing::errors_of;
using testing::gripped_block;
using testing::search_block;
using testing::study_of;

const std::vector<std::string> kJudging = {"window", "optimize", "robust", "pareto", "compare"};

std::string block_of(const std::string& kind) {
  return kind == "window" ? gripped_block(kind) + "[window]\nfrom_N = 1.0\nto_N = 2.0\n" : search_block(kind);
}

std::string one_error(const std::string& text, const std::vector<std::string>& sets) {
  const std::vector<std::string> errors = errors_of(text, sets);
  return errors.size() == 1 ? errors.front() : std::to_string(errors.size()) + " errors";
}

TEST(DamageClaim, KindsThatJudgeDamageRefuseAStudyWithoutALimitThatCanAct) {
  for (const std::string& kind : kJudging) {
    EXPECT_EQ(one_error(block_of(kind), {"limits.finger_force_N=none"}),
              "--set: limits.damage = \"judged\": there is no limit of damage, so nothing could ever count "
              "as damaged: give a limit in [limits], e.g. limits.finger_force_N or, with product.yield_stress_Pa, "
              "limits.contact_yield_ratio = 1, or write limits.damage = \"not considered\" and get answers about "
              "holding alone")
        << kind;
    EXPECT_TRUE(errors_of(block_of(kind), {}).empty()) << kind;
  }
}

TEST(DamageClaim, ALimitThatCanNeverActIsNoLimit) {
  for (const std::string& kind : kJudging) {
    for (const char* limit : {"permanent_set_m=1e-4", "plastic_strain=0.01", "bruised_volume_m3=1e-6",
                              "absorbed_energy_J=1e-3", "contact_yield_ratio=1.0"}) {
      const std::string error =
          one_error(block_of(kind), {"limits.finger_force_N=none", std::string("limits.") + limit});
      EXPECT_NE(error.find("can never act without a yield stress"), std::string::npos) << kind << ": " << error;
    }
    EXPECT_TRUE(errors_of(block_of(kind), {"limits.finger_force_N=none", "limits.contact_yield_ratio=1.0",
                                           "product.yield_stress_Pa=1e4", "product.tangent_modulus_Pa=1e5"})
                    .empty())
        << kind;
  }
}

TEST(DamageClaim, NotConsideredIsAWayOutInWords) {
  for (const std::string& kind : kJudging) {
    const Study study = study_of(block_of(kind), {"limits.finger_force_N=none", "limits.damage=not considered"});
    EXPECT_EQ(damage_word(damage_claim(study).claim), "not considered") << kind;
    EXPECT_TRUE(damage_sentence(damage_claim(study)).starts_with("damage was not considered")) << kind;
  }
}

TEST(DamageClaim, OtherKindsSayThatNobodyLooked) {
  for (const std::string kind : {"simulate", "sample", "sensitivity"}) {
    const Study study = study_of(kind == "simulate" ? gripped_block(kind) : search_block(kind));
    EXPECT_EQ(damage_word(damage_claim(study).claim), "not looked at") << kind;
    EXPECT_TRUE(damage_sentence(damage_claim(study)).starts_with("damage was not looked at")) << kind;
    const Study judged =
        study_of(kind == "simulate" ? gripped_block(kind) : search_block(kind), {"limits.peak_pressure_Pa=1e5"});
    EXPECT_EQ(damage_word(damage_claim(judged).claim), "judged") << kind;
    EXPECT_EQ(damage_sentence(damage_claim(judged)), "") << kind;
  }
}

const std::string kTwoYields =
    "[[vary]]\nkey = \"product.yield_stress_Pa\"\nvalues = [1e4, 2e4]\n[[vary]]\nkey = \"limits.damage\"\nvalues "
    "= "
    "[\"judged\", \"not considered\"]\n";

TEST(DamageClaim, ASweepNeverAveragesScenariosAway) {
  const Study study = study_of(gripped_block("sweep") + "[limits]\npeak_pressure_Pa = 1e5\n" + kTwoYields,
                               {"product.tangent_modulus_Pa=1e5"});
  const StudyClaim claim = damage_claim(study);
  EXPECT_EQ(claim.claim, DamageClaim::not_considered);
  EXPECT_EQ(claim.judged, 2U);
  EXPECT_EQ(damage_sentence(claim),
            "damage was not considered in 2 of 4 scenarios: there \"held\" does not mean undamaged");
}

}  // namespace
}  // namespace unbruised::studies

#include "studies/estimate/grip_force_warnings.hpp"

#include <variant>

#include <gtest/gtest.h>

namespace unbruised::studies {
namespace {

const std::string kBlock = R"([product]
shape = "box"
size_m = [0.05, 0.05, 0.05]
youngs_modulus_Pa = 1e6
mass_kg = 0.1
[limits]
finger_force_N = 50.0
[gripper]
)";
const std::string kFriction = R"([[random]]
key = "product.friction"
distribution = "uniform"
from = 0.4
to = 0.8
)";
const std::string kForceSearched = "[[variable]]\nkey = \"strategy.grip_force_N\"\nfrom = 1.0\nto = 8.0\n";
const std::string kForceScatters = "[[random]]\nkey = \"strategy.grip_force_N\"\nrelative = 0.1\n";

std::vector<std::string> warnings_of(const std::string& kind, const std::string& more,
                                     const std::vector<std::string>& sets) {
  const std::string text = "[study]\nname = \"t\"\nkind = \"" + kind + "\"\n" + kBlock + more;
  const StudyOrError read = read_study_text(text, "study.toml", sets, {}, {});
  if (!read) return {"unreadable: " + read.error().messages.front()};
  return grip_force_warnings(*read);
}

/// The only warning; the empty text when there is none.
std::string only(const std::vector<std::string>& warnings) {
  EXPECT_LE(warnings.size(), 1U) << ::testing::PrintToString(warnings);
  return warnings.empty() ? "" : warnings.front();
}

TEST(GripForceWarnings, NameForcesBelowTheLeastOfTheGripper) {
  const std::vector<std::string> sets = {"gripper.min_force_N=3"};
  EXPECT_NE(only(warnings_of("optimize", kForceSearched, sets)).find("down to 1 N"), std::string::npos);
  const std::string swept = "[[vary]]\nkey = \"strategy.grip_force_N\"\nvalues = [5.0, 2.0]\n";
  EXPECT_NE(only(warnings_of("sweep", swept, sets)).find("down to 2 N"), std::string::npos);
  EXPECT_EQ(only(warnings_of("simulate", "[strategy]\ngrip_force_N = 3.0\n", sets)), "");
}

TEST(GripForceWarnings, NameForcesThatCannotBeSet) {
  const std::vector<std::string> sets = {"gripper.force_step_N=0.5"};
  EXPECT_NE(only(warnings_of("simulate", "[strategy]\ngrip_force_N = 1.2\n", sets)).find("1.2 N cannot be set"),
            std::string::npos);
  EXPECT_EQ(only(warnings_of("simulate", "[strategy]\ngrip_force_N = 1.5\n", sets)), "");
  EXPECT_NE(only(warnings_of("optimize", kForceSearched, sets)).find("round the force"), std::string::npos);
}

TEST(GripForceWarnings, SayThatAnAccuracyIsNotLookedAt) {
  const std::vector<std::string> sets = {"gripper.force_accuracy=0.1"};
  EXPECT_NE(only(warnings_of("sample", kFriction, sets)).find("relative = 0.1"), std::string::npos);
  EXPECT_EQ(only(warnings_of("sample", kFriction + kForceScatters, sets)), "");
  EXPECT_NE(only(warnings_of("optimize", kForceSearched, sets)).find("robust"), std::string::npos);
  EXPECT_EQ(only(warnings_of("window", "[window]\nfrom_N = 1.0\nto_N = 5.0\n", sets)), "")
      << "a window takes it off its set-point";
}

}  // namespace
}  // namespace unbruised::studies

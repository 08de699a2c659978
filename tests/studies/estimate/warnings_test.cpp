#include "studies/estimate/warnings.hpp"

#include <variant>

#include <gtest/gtest.h>

namespace unbruised::studies {
namespace {

constexpr const char* kGripped = R"([study]
name = "t"
kind = "simulate"
[product]
shape = "box"
size_m = [0.05, 0.05, 0.05]
youngs_modulus_Pa = 1e6
mass_kg = 0.1
[gripper]
[strategy]
grip_force_N = 2.0
)";

std::vector<std::string> warnings_of(const std::string& text, const std::vector<std::string>& sets = {}) {
  const StudyOrError read = read_study_text(text, "study.toml", sets, {}, {});
  if (!read) return {"unreadable: " + read.error().messages.front()};
  return study_warnings(*read);
}

bool one_says(const std::vector<std::string>& warnings, const std::string& words) {
  for (const std::string& warning : warnings) {
    if (warning.find(words) != std::string::npos) return true;
  }
  return false;
}

TEST(Warnings, TooLongATimeStepSaysWhatItDoesToTheAnswerAndWhichServes) {
  const auto warnings = warnings_of(kGripped, {"simulation.time_step_s=2e-3"});
  EXPECT_TRUE(one_says(warnings, "F_damage may come out too high")) << ::testing::PrintToString(warnings);
  EXPECT_TRUE(one_says(warnings, "use simulation.time_step_s <= "));
}

TEST(Warnings, AShortTimeStepIsNotWarnedAbout) {
  EXPECT_FALSE(one_says(warnings_of(kGripped, {"simulation.time_step_s=1e-4"}), "time step"));
}

TEST(Warnings, AChosenTimeStepIsNotWarnedAbout) { EXPECT_FALSE(one_says(warnings_of(kGripped), "time step")); }

TEST(Warnings, WrittenZerosOfDampingSayWhatTheyDoToTheWindow) {
  EXPECT_FALSE(one_says(warnings_of(kGripped), "without damping"));
  EXPECT_TRUE(one_says(warnings_of(kGripped, {"product.relaxation_time_s=0"}), "without damping: the product"));
  EXPECT_TRUE(one_says(warnings_of(kGripped, {"gripper.pad_relaxation_time_s=0"}), "without damping: the pads"));
  EXPECT_TRUE(one_says(warnings_of(kGripped, {"cell.support_relaxation_time_s=0"}), "half as wide"));
}

TEST(Warnings, DoubtsOfReadingTheStudyAreAmongThem) {
  EXPECT_TRUE(one_says(warnings_of(kGripped, {"product.friction=0"}), "product.friction is 0"));
}

}  // namespace
}  // namespace unbruised::studies

#include "studies/estimate/warnings.hpp"

#include <filesystem>
#include <variant>

#include <gtest/gtest.h>

#include "tests/places.hpp"

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

TEST(Warnings, AMeshThatIsStretchedOutOfProportionSaysHow) {
  const std::filesystem::path configs = std::filesystem::path(UNBRUISED_SOURCE_DIR) / "configs";
  const auto of_size = [&](const std::string& size_m) {
    const StudyOrError read = read_study_text(
        "[study]\nname = \"t\"\nkind = \"simulate\"\n[product]\n"
        "use = \"products/tomato_ribbed.toml\"\nsize_m = " +
            size_m + "\n[gripper]\n",
        "study.toml", {}, configs, configs);
    EXPECT_TRUE(read.has_value());
    return read ? study_warnings(*read) : std::vector<std::string>{};
  };
  EXPECT_TRUE(one_says(of_size("[0.08, 0.08, 0.12]"), "stretches the mesh"));
  EXPECT_FALSE(one_says(of_size("[0.08, 0.08, 0.06]"), "stretches the mesh"));
}

TEST(Warnings, AGuardWithoutRoomToBrakeSaysHowFastTheFingersTouch) {
  // 0.3 N brake 0.1 kg by 3 m/s2: from 0.1 to 0.02 m/s in 1.6 mm.
  const std::vector<std::string> guard = {"strategy.approach_speed_m_s=0.1", "strategy.guard=\"range\"",
                                          "strategy.guard_speed_m_s=0.02", "gripper.range.maximum_m=0.05"};
  const auto with_range = [&](const std::string& range_m) {
    std::vector<std::string> sets = guard;
    sets.push_back("strategy.guard_range_m=" + range_m);
    return warnings_of(kGripped, sets);
  };
  EXPECT_FALSE(one_says(with_range("0.0017"), "no room to brake"));
  EXPECT_TRUE(one_says(with_range("0.001"), "no room to brake from 0.1 to 0.02 m/s"));
  EXPECT_TRUE(one_says(with_range("0.001"), "the fingers touch at 0.0632"));
}

TEST(Warnings, DoubtsOfReadingTheStudyAreAmongThem) {
  EXPECT_TRUE(one_says(warnings_of(kGripped, {"product.friction=0"}), "product.friction is 0"));
}

}  // namespace
}  // namespace unbruised::studies

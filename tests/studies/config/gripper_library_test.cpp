// The grippers that ship: each is read, means what it says within plausible ranges, and names the source of its
// values.

#include <algorithm>
#include <filesystem>
#include <set>

#include "studies/config/sources.hpp"
#include "tests/studies/config/config_testing.hpp"

namespace unbruised::studies {
namespace {

namespace fs = std::filesystem;

/// Grippers that nobody makes.
const std::set<std::string> kMadeUp = {
    "bare_aluminium",      "foam_10kPa",         "foam_2kPa",   "foam_5kPa",   "foam_pads",    "force_limited",
    "jaw_convex",          "jaw_cradle",         "jaw_groove",  "jaw_sphere",  "parallel_jaw", "parallel_jaw_firm",
    "independent_fingers", "soft_silicone_pads", "soft_tip_v1", "soft_tip_v2", "three_jaw"};

std::vector<fs::path> real_grippers() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(testing::config_root() + "/grippers")) {
    if (entry.path().extension() == ".toml" && !kMadeUp.contains(entry.path().stem().string()))
      files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// Gripping a kiwi slowly enough for all of them, with a force that it can give.
StudyOrError gripping(const fs::path& file) {
  const std::string study =
      "[study]\nname = \"t\"\nkind = \"window\"\n[window]\nfrom_N = 0.5\nto_N = 4.0\n[product]\nuse = "
      "\"products/kiwi_ripe.toml\"\n[strategy]\napproach_speed_m_s = 0.02\nrelease_speed_m_s = "
      "0.02\n[gripper]\nuse = "
      "\"grippers/" +
      file.filename().string() + "\"\n";
  return read_study_text(study, "t.toml", {}, ".", testing::config_root());
}

TEST(GripperLibrary, HasAtLeastEightRealGrippers) { EXPECT_GE(real_grippers().size(), 8U); }

TEST(GripperLibrary, IsReadAndPlausible) {
  for (const fs::path& file : real_grippers()) {
    const StudyOrError study = gripping(file);
    ASSERT_TRUE(study) << file << ": " << study.error().messages.front();
    EXPECT_EQ(study->warnings(), std::vector<std::string>{}) << file;
    const ParallelJawParameters jaw = jaw_of(study->scenario(0));
    EXPECT_LT(jaw.min_force_N, jaw.max_force_N) << file;
    EXPECT_LE(jaw.max_speed_m_s, 0.2) << file << ": of one finger";
    EXPECT_LE(jaw.stroke_m, 0.1) << file << ": of one finger";
    EXPECT_LE(2.0 * jaw.stroke_m, jaw.opening_m.value_or(1.0) + 1e-9) << file;
    // What it may carry is what its force holds at a friction of 0.1 to 1, the makers' safety factors beside.
    if (!jaw.payload_kg) continue;
    const double friction = *jaw.payload_kg * 9.81 / (2.0 * jaw.max_force_N);
    EXPECT_GT(friction, 0.02) << file;
    EXPECT_LT(friction, 0.5) << file;
  }
}

TEST(GripperLibrary, SaysWhereEachValueComesFrom) {
  for (const fs::path& file : real_grippers()) {
    const StudyOrError study = gripping(file);
    ASSERT_TRUE(study) << file;
    std::size_t cited = 0;
    for (const ValueSource& value : config_sources(study->resolved_toml()).values) {
      // A lattice pad has numbers of its own, which stand in no file here.
      if (!value.key.starts_with("gripper.") || value.key.starts_with("gripper.pad.")) continue;
      EXPECT_NE(value.standing, Standing::unsourced) << file << ": " << value.key;
      cited += value.standing == Standing::cited ? 1 : 0;
      // A remembered number is no source.
      if (value.source.find("remembered") != std::string::npos) {
        EXPECT_EQ(value.standing, Standing::assumed) << file << ": " << value.key;
      }
    }
    EXPECT_GE(cited, 2U) << file;
  }
}

}  // namespace
}  // namespace unbruised::studies

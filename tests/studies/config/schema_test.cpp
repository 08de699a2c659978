// The key table and the suggestions made from it.

#include "studies/config/schema.hpp"

#include "tests/studies/config/config_testing.hpp"

namespace unbruised::studies {
namespace {

TEST(Schema, EveryDimensionalKeyEndsInItsUnit) {
  EXPECT_EQ(unit_of("strategy.lift_acceleration_m_s2")->udunits, "m s-2");
  EXPECT_EQ(unit_of("product.spring[].damping_N_s_m")->udunits, "N s m-1");
  EXPECT_EQ(unit_of("product.size_m[0]")->udunits, "m");
  EXPECT_EQ(unit_of("sensor.inertia_kg_m2[0]")->udunits, "kg m2");
  // Stiffnesses and torques are written alike.
  EXPECT_EQ(unit_of("sensor.ring_stiffness_N_m[1]")->udunits, "N m-1");
  EXPECT_EQ(unit_of("product.spring[].burgers_recovery_N_m")->udunits, "N m-1");
  EXPECT_EQ(unit_of("sensor.stiffness_N_m_rad")->udunits, "N m rad-1");
  EXPECT_EQ(unit_of("sensor.noise_N_m")->udunits, "N m");
  EXPECT_EQ(unit_of("peak_sensor_torque_N_m")->udunits, "N m");
  EXPECT_EQ(unit_of("limits.bruised_volume_m3")->udunits, "m3");
  EXPECT_EQ(unit_of("gripper.max_speed_m_s")->udunits, "m s-1");
  EXPECT_EQ(unit_of("simulation.theta"), nullptr);
}

TEST(Schema, SaysKeysInWords) {
  EXPECT_EQ(key_words("strategy.lift_acceleration_m_s2"), "lift acceleration");
  EXPECT_EQ(key_words("product.youngs_modulus_Pa"), "Young's modulus");
  EXPECT_EQ(key_words("product.size_m[0]"), "size[0]");
  EXPECT_EQ(key_words("gripper.use"), "gripper.use");
  EXPECT_EQ(key_words("friction"), "friction");
}

TEST(Schema, OneDeletedOrSwappedLetterIsRecognised) {
  std::size_t typos = 0;
  std::size_t right = 0;
  const auto ask = [&](const std::string& typo, std::string_view key) {
    if (typo == key || find_key(typo).spec != nullptr) return;
    ++typos;
    if (nearest(typo, key_patterns()) == key) {
      ++right;
    } else {
      std::cout << typo << " -> " << nearest(typo, key_patterns()) << "\n";
    }
  };
  for (const KeySpec& spec : key_table()) {
    const std::string key(spec.path);
    for (std::size_t i = 0; i < key.size(); ++i) {
      if (key[i] == '[' || key[i] == ']') continue;
      std::string typo = key;
      ask(typo.erase(i, 1), key);
      typo = key;
      if (i + 1 < key.size() && key[i + 1] != '[' && key[i + 1] != ']') std::swap(typo[i], typo[i + 1]);
      ask(typo, key);
    }
  }
  EXPECT_GT(typos, 3000U);
  EXPECT_GE(static_cast<double>(right), 0.95 * static_cast<double>(typos)) << right << " of " << typos;
}

TEST(Schema, AWordIsSuggestedWhateverItsCaseButNotForShortOrStrangeOnes) {
  const std::vector<std::string_view> words = {"COBYLA", "BOBYQA", "x", "box"};
  EXPECT_EQ(word_suggestion("cobyla", words), "; did you mean \"COBYLA\"?");
  EXPECT_EQ(word_suggestion("BOBYAQ", words), "; did you mean \"BOBYQA\"?");
  EXPECT_EQ(word_suggestion("y", words), "");
  EXPECT_EQ(word_suggestion("blob", words), "");
  EXPECT_EQ(word_suggestion("", words), "");
}

TEST(Schema, ExplainAnswersForKeysIndicesAndTables) {
  EXPECT_NE(explain_key("strategy.grip_force_N")->find("in N"), std::string::npos);
  EXPECT_EQ(explain_key("product.size_m[0]"), explain_key("product.size_m"));
  EXPECT_EQ(explain_key("product.particle[3].mass_kg"), explain_key("product.particle[].mass_kg"));
  EXPECT_NE(explain_key("strategy")->find("strategy.recover_s"), std::string::npos);
  EXPECT_EQ(explain_key("candidate[1].grip_force_N"), explain_key("strategy.grip_force_N"));
  EXPECT_NE(explain_key("random")->find("random[].relative_deviation"), std::string::npos);
  EXPECT_NE(explain_key("search.algorithm")->find("\"AUGLAG\""), std::string::npos);
  EXPECT_EQ(explain_key("strategy.grip"), std::nullopt);
  EXPECT_EQ(nearest("strategy.grip_forc_N", key_patterns()), "strategy.grip_force_N");
  EXPECT_EQ(nearest("stratgy", table_names()), "strategy");
  EXPECT_EQ(nearest("zzzzzzzzzzzzzzzz", key_patterns()), "");
}

}  // namespace
}  // namespace unbruised::studies

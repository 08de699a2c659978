#include "studies/config/sources.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/studies/config/config_testing.hpp"

namespace unbruised::studies {
namespace {

std::string resolved_of(const std::string& config, const std::vector<std::string>& sets = {}) {
  const StudyOrError study = read_study(testing::config_root() + "/" + config, sets, testing::config_root());
  if (!study) {
    ADD_FAILURE() << (study.error().messages.empty() ? config : study.error().messages.front());
    return {};
  }
  return study->resolved_toml();
}

ValueSource source_of(const std::string& resolved, const std::string& key) {
  const std::vector<ValueSource> all = config_sources(resolved).values;
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const ValueSource& each) { return each.key == key; });
  if (found == all.end()) ADD_FAILURE() << "no value " << key;
  return found == all.end() ? ValueSource{} : *found;
}

TEST(ConfigSources, TravelFromTheLibraryFileIntoTheResolvedConfig) {
  const std::string resolved = resolved_of("kiwi_window.toml");
  const ValueSource modulus = source_of(resolved, "product.youngs_modulus_Pa");
  EXPECT_EQ(modulus.standing, Standing::cited);
  EXPECT_NE(modulus.source.find("10.13031/aim.201900242"), std::string::npos);
  EXPECT_EQ(modulus.value.number, 0.288e6);
  EXPECT_EQ(source_of(resolved, "product.mass_kg").standing, Standing::assumed);
  EXPECT_EQ(source_of(resolved, "gripper.stroke_m").standing, Standing::assumed);
  EXPECT_EQ(source_of(resolved, "product.size_m").value.items.size(), 3U);
  // One entry speaks of all limits of the file.
  EXPECT_EQ(source_of(resolved, "limits.contact_yield_ratio").standing, Standing::assumed);
}

TEST(ConfigSources, SpeakOfNoValueThatTheStudySetsItself) {
  EXPECT_EQ(source_of(resolved_of("kiwi_optimize.toml"), "product.cell_size_m").standing, Standing::unsourced);
  const std::string set = resolved_of("kiwi_window.toml", {"product.mass_kg=0.12"});
  EXPECT_EQ(source_of(set, "product.mass_kg").standing, Standing::unsourced);
  EXPECT_EQ(source_of(set, "product.friction").standing, Standing::assumed);
}

TEST(ConfigSources, AreStillThereWhenTheResolvedConfigIsReadAgain) {
  const std::string resolved = resolved_of("kiwi_window.toml");
  const auto again = [&](const std::vector<std::string>& sets) {
    return testing::study_of(resolved, sets).resolved_toml();
  };
  EXPECT_EQ(again({}), resolved);
  EXPECT_EQ(source_of(again({"product.mass_kg=0.12"}), "product.mass_kg").standing, Standing::unsourced);
}

TEST(ConfigSources, NameTheLibraryFilesThatAreVaried) {
  EXPECT_EQ(config_sources(resolved_of("pad_comparison.toml")).varied_files,
            (std::vector<std::string>{"product.use", "gripper.use"}));
  EXPECT_TRUE(config_sources(resolved_of("kiwi_window.toml")).varied_files.empty());
}

TEST(ConfigSources, HaveNothingToSayOfATextThatIsNoConfig) {
  EXPECT_TRUE(config_sources("[product\nmass_kg = ").values.empty());
  EXPECT_TRUE(config_sources("").values.empty());
}

}  // namespace
}  // namespace unbruised::studies

#include "studies/config/study.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <utility>

#include "tests/places.hpp"
#include "tests/studies/config/config_testing.hpp"

namespace unbruised::studies {
namespace {

using testing::config_root;
using testing::errors_of;
using testing::gripped_block;
using testing::search_block;
using testing::study_of;

TEST(Set, OverridesTheStudyAndTheFilesItUses) {
  const std::string text = "[study]\nname = \"t\"\nkind = \"simulate\"\n[gripper]\n[product]\nfriction = 0.9\n";
  const Study study =
      study_of(text, {"product.use=products/kiwi_ripe.toml", "product.size_m[1]=0.08", "study.seed=5",
                      "product.mass_kg = 0.11", "limits.plastic_strain=none", "study.name=123",
                      "gripper.use=\"grippers/parallel_jaw_firm.toml\"", "gripper.stroke_m=0.03"});
  const Scenario scenario = study.scenario(0);
  const auto& kiwi = std::get<LatticeParameters>(scenario.product);
  EXPECT_EQ(kiwi.size_m, (std::array<double, 3>{0.050, 0.08, 0.050}));
  EXPECT_EQ(kiwi.mass_kg, 0.11);
  EXPECT_EQ(kiwi.friction, 0.9);
  EXPECT_EQ(scenario.limits.plastic_strain, std::nullopt);
  EXPECT_EQ(scenario.limits.permanent_set_m, 1e-4);
  EXPECT_EQ(jaw_of(scenario).pad_modulus_Pa, 2.5e6);
  EXPECT_EQ(jaw_of(scenario).stroke_m, 0.03);
  EXPECT_EQ(study.seed(), 5U);
  EXPECT_EQ(study.name(), "123");
}

TEST(Set, ChangesABlockOfTheSweep) {
  const std::string text = gripped_block("sweep") + "[[vary]]\nkey = \"strategy.hold_s\"\nvalues = [0.0, 1.0]\n";
  const Study study = study_of(text, {"vary[0].values=[0.0, 1.0, 2.0]", "strategy.settle_s=0.5"});
  EXPECT_EQ(study.scenario_count(), 3U);
  EXPECT_EQ(study.scenario(2).strategy.settle_s, 0.5);
}

TEST(Use, AKeyOfTheStudyDisplacesItsAlternativeInTheFile) {
  const Study study = study_of(
      "[study]\nname = \"t\"\nkind = \"simulate\"\n[gripper]\n[product]\nuse = \"products/kiwi_ripe.toml\"\n"
      "density_kg_m3 = 1022.0\nrelaxation_time_s = 0.001\n");
  const auto product = std::get<LatticeParameters>(study.scenario(0).product);
  EXPECT_EQ(product.mass_kg, std::nullopt);
  EXPECT_EQ(product.density_kg_m3, 1022.0);
  EXPECT_EQ(product.relaxation_time_s, 0.001);
  EXPECT_EQ(product.loss_ratio, std::nullopt);
  EXPECT_EQ(product.at_frequency_Hz, std::nullopt);
}

TEST(Use, LooksBesideTheStudyFirstAndRefusesAFileThatUsesAnother) {
  const auto folder = std::filesystem::temp_directory_path() / "unbruised_use_test";
  std::filesystem::create_directories(folder / "products");
  std::ofstream(folder / "products" / "kiwi_ripe.toml")
      << "shape = \"sphere\"\nsize_m = [0.03, 0.03, 0.03]\nmass_kg = 0.01\nyoungs_modulus_Pa = 1e5\n";
  std::ofstream(folder / "looping.toml") << "use = \"looping.toml\"\n";
  std::ofstream(folder / "study.toml")
      << "[study]\nname = \"t\"\nkind = \"simulate\"\n[gripper]\n[product]\nuse = \"products/kiwi_ripe.toml\"\n";
  const auto own = read_study(folder / "study.toml", {}, config_root());
  ASSERT_TRUE(own.has_value());
  EXPECT_EQ(std::get<LatticeParameters>(own->scenario(0).product).mass_kg, 0.01);
  const auto loop = read_study(folder / "study.toml", {"product.use=looping.toml"}, config_root());
  ASSERT_FALSE(loop.has_value());
  EXPECT_NE(loop.error().messages[0].find("a file that is used may not use another one"), std::string::npos)
      << loop.error().messages[0];
  std::filesystem::remove_all(folder);
}

TEST(Networks, AreReadFromCsvLikeFromTables) {
  const Study study = study_of(R"(
[study]
name = "t"
kind = "simulate"
[product]
kind = "network"
particles_csv = "networks/elastic_bar_particles.csv"
springs_csv = "networks/elastic_bar_springs.csv"
[cell]
support = true
[simulation]
duration_s = 1.0
)",
                               {"product.particle[2].mass_kg=0.5"});
  const auto network = std::get<NetworkParameters>(study.scenario(0).product);
  ASSERT_EQ(network.particle.size(), 20U);
  ASSERT_EQ(network.spring.size(), 19U);
  EXPECT_EQ(network.particle[0].contact_stiffness_N_m, 2000.0);
  EXPECT_EQ(network.particle[2].mass_kg, 0.5);
  EXPECT_EQ(network.particle[3].mass_kg, 0.004);
  EXPECT_EQ(network.particle[3].fixed, (std::array<bool, 3>{true, true, false}));
  EXPECT_EQ(network.particle[3].initial_velocity_m_s, (std::array<double, 3>{0.0, 0.0, -0.1}));
  EXPECT_EQ(network.particle[3].position_m, (std::array<double, 3>{0.0, 0.0, 0.031}));
  EXPECT_EQ(network.spring[7].between, (std::array<int, 2>{7, 8}));
}

TEST(Networks, HaveNoSupportUnlessAskedFor) {
  EXPECT_FALSE(study_of(testing::small_network()).scenario(0).cell.support);
  EXPECT_TRUE(study_of(testing::small_network(), {"cell.support=true"}).scenario(0).cell.support);
  EXPECT_TRUE(study_of(gripped_block("simulate")).scenario(0).cell.support);
}

TEST(Networks, VaryAMassByItsIndex) {
  const std::string text = testing::small_network();
  const Study study = study_of(text + "[[vary]]\nkey = \"product.particle[1].mass_kg\"\nvalues = [1.0, 4.0]\n",
                               {"study.kind=sweep"});
  EXPECT_EQ(std::get<NetworkParameters>(study.scenario(1).product).particle[1].mass_kg, 4.0);
}

TEST(Resolved, IsCompleteDeterministicAndReadsBack) {
  for (const auto& entry : list_library(config_root())) {
    if (entry.kind != LibraryEntry::Kind::study) continue;
    const auto read = read_study(config_root() + "/" + entry.path, {}, config_root());
    ASSERT_TRUE(read.has_value()) << entry.path;
    const Study& first = *read;
    const auto again = read_study_text(first.resolved_toml(), entry.path, {}, "", "");
    ASSERT_TRUE(again.has_value()) << again.error().messages[0];
    const Study& second = *again;
    EXPECT_EQ(first.resolved_toml(), second.resolved_toml());
    EXPECT_EQ(first.scenario_count(), second.scenario_count());
    for (std::size_t c = 0; c < first.inputs().size(); ++c) {
      EXPECT_EQ(first.inputs()[c].numbers, second.inputs()[c].numbers);
      EXPECT_EQ(first.inputs()[c].texts, second.inputs()[c].texts);
    }
    EXPECT_TRUE(differing_keys(first.resolved_toml(), second.resolved_toml()).empty());
  }
}

TEST(Resolved, NamesTheKeysInWhichTwoConfigsDiffer) {
  const std::string a = study_of(gripped_block("simulate")).resolved_toml();
  const std::string b =
      study_of(gripped_block("simulate"), {"strategy.hold_s=1", "limits.plastic_strain=0.1"}).resolved_toml();
  EXPECT_EQ(differing_keys(a, b), (std::vector<std::string>{"limits.plastic_strain", "strategy.hold_s"}));
}

TEST(Configs, EveryFileThatShipsIsRead) {
  std::size_t products = 0, grippers = 0, strategies = 0, studies = 0;
  for (const auto& file : std::filesystem::recursive_directory_iterator(config_root())) {
    if (file.path().extension() != ".toml") continue;
    const std::string path = file.path().lexically_relative(config_root()).generic_string();
    const std::string head = "[study]\nname = \"t\"\nkind = \"simulate\"\n";
    if (path.starts_with("products/")) {
      ++products;
      EXPECT_EQ(errors_of(head + "[gripper]\n[product]\nuse = \"" + path + "\"\n"), std::vector<std::string>{});
    } else if (path.starts_with("grippers/")) {
      ++grippers;
      EXPECT_EQ(
          errors_of(head + "[product]\nuse = \"products/kiwi_ripe.toml\"\n[strategy]\napproach_speed_m_s = " +
                    "0.02\nrelease_speed_m_s = 0.02\n[gripper]\nuse = \"" + path + "\"\n"),
          std::vector<std::string>{});
    } else if (path.starts_with("strategies/")) {
      ++strategies;
      EXPECT_EQ(errors_of(search_block("compare") + "[[candidate]]\nname = \"c\"\nuse = \"" + path + "\"\n"),
                std::vector<std::string>{});
    } else {
      ++studies;
      const auto read = read_study(file.path(), {}, config_root());
      if (!read) {
        ADD_FAILURE() << read.error().messages[0];
      } else {
        EXPECT_EQ(read->warnings(), std::vector<std::string>{}) << path;
        EXPECT_FALSE(read->description().empty()) << path;
      }
    }
  }
  EXPECT_GE(products, 6U);
  EXPECT_GE(grippers, 1U);
  EXPECT_GE(studies, 7U);
  EXPECT_GE(strategies, 2U);
  const auto all = list_library(config_root());
  EXPECT_EQ(all.size(), products + grippers + strategies + studies);
  const auto listed = std::count_if(all.begin(), all.end(), [](const LibraryEntry& entry) {
    return entry.kind == LibraryEntry::Kind::strategy && !entry.description.empty();
  });
  EXPECT_EQ(static_cast<std::size_t>(listed), strategies);
}

TEST(Configs, TheKiwiSweepHasItsFiveHundredAndTwelveScenarios) {
  const auto read = read_study(config_root() + "/kiwi_sweep.toml", {}, config_root());
  EXPECT_EQ(read->scenario_count(), 512U);
}

TEST(Configs, BathesMatricesAreThoseOfTheExample) {
  const auto read = read_study(config_root() + "/networks/bathe_2dof.toml", {}, config_root());
  const auto network = std::get<NetworkParameters>(read->scenario(0).product);
  double k[2][2] = {{0, 0}, {0, 0}};
  for (const NetworkSpring& spring : network.spring) {
    const int a = spring.between[0] - 1, b = spring.between[1] - 1;
    for (const int i : {a, b}) {
      for (const int j : {a, b}) {
        if (i < 0 || i > 1 || j < 0 || j > 1) continue;
        k[i][j] += i == j ? spring.stiffness_N_m : -spring.stiffness_N_m;
      }
    }
  }
  EXPECT_EQ(k[0][0], 6.0);
  EXPECT_EQ(k[0][1], -2.0);
  EXPECT_EQ(k[1][0], -2.0);
  EXPECT_EQ(k[1][1], 4.0);
  EXPECT_EQ(network.particle[1].mass_kg, 2.0);
  EXPECT_EQ(network.particle[2].mass_kg, 1.0);
}

/// Compares what stands between the marks of a name in docs/config.md with what the program says; writes it there
/// where UNBRUISED_UPDATE_DOCS is set.
void expect_in_docs(const std::string& name, const std::string& wanted) {
  const std::string path = std::string(UNBRUISED_SOURCE_DIR) + "/docs/config.md";
  const std::string begin = "<!-- " + name + ": begin -->\n";
  std::stringstream content;
  content << std::ifstream(path).rdbuf();
  std::string text = content.str();
  const std::size_t first = text.find(begin) + begin.size();
  const std::size_t last = text.find("<!-- " + name + ": end -->\n");
  ASSERT_NE(last, std::string::npos);
  if (std::getenv("UNBRUISED_UPDATE_DOCS") != nullptr) {
    text.replace(first, last - first, wanted);
    std::ofstream(path) << text;
    return;
  }
  EXPECT_EQ(text.substr(first, last - first), wanted)
      << "run this test once with UNBRUISED_UPDATE_DOCS=1 to write the " << name << " anew";
}

TEST(Docs, TheConfigReferenceIsTheOneOfTheProgram) { expect_in_docs("reference", reference_markdown()); }

TEST(Docs, TheListOfPlausibleValuesIsTheOneOfTheProgram) { expect_in_docs("plausible", plausible_markdown()); }

}  // namespace
}  // namespace unbruised::studies

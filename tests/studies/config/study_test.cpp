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
  ASSERT_TRUE(std::holds_alternative<Study>(own));
  EXPECT_EQ(std::get<LatticeParameters>(std::get<Study>(own).scenario(0).product).mass_kg, 0.01);
  const auto loop = read_study(folder / "study.toml", {"product.use=looping.toml"}, config_root());
  ASSERT_TRUE(std::holds_alternative<ConfigError>(loop));
  EXPECT_NE(std::get<ConfigError>(loop).messages[0].find("a file that is used may not use another one"),
            std::string::npos)
      << std::get<ConfigError>(loop).messages[0];
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
    ASSERT_TRUE(std::holds_alternative<Study>(read)) << entry.path;
    const Study& first = std::get<Study>(read);
    const auto again = read_study_text(first.resolved_toml(), entry.path, {}, "", "");
    ASSERT_TRUE(std::holds_alternative<Study>(again)) << std::get<ConfigError>(again).messages[0];
    const Study& second = std::get<Study>(again);
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

const std::vector<std::string> kSearchKinds = {"sample", "optimize", "robust", "pareto", "compare", "sensitivity"};

TEST(Searches, OfEveryKindAreOneScenarioWithoutInputs) {
  for (const std::string& kind : kSearchKinds) {
    const Study study = study_of(search_block(kind));
    EXPECT_EQ(study_kind_word(study.kind()), kind);
    EXPECT_EQ(study.scenario_count(), 1U) << kind;
    EXPECT_TRUE(study.inputs().empty()) << kind;
    EXPECT_EQ(study.variables().size(), is_search(study.kind()) ? 1U : 0U) << kind;
    EXPECT_EQ(study.randoms().size(), is_random(study.kind()) ? 1U : 0U) << kind;
    EXPECT_EQ(study.candidates().size(), kind == "compare" ? 2U : 0U) << kind;
  }
}

TEST(Searches, ResolvedTextOfEveryKindReadsBackToItself) {
  for (const std::string& kind : kSearchKinds) {
    const Study first = study_of(search_block(kind), {"study.seed=7", "study.description=all of it"});
    const Study second = study_of(first.resolved_toml());
    EXPECT_EQ(first.resolved_toml(), second.resolved_toml()) << kind;
    EXPECT_EQ(first.variables().size(), second.variables().size());
    EXPECT_EQ(first.randoms().size(), second.randoms().size());
    EXPECT_EQ(first.candidates().size(), second.candidates().size());
    EXPECT_EQ(second.seed(), 7U);
  }
}

TEST(Searches, ResolvedTextNeedsNoFileOfAStrategy) {
  const std::string text =
      search_block("compare") + "[[candidate]]\nname = \"c\"\nuse = \"strategies/fast.toml\"\n";
  const Study first = study_of(text);
  const auto again = read_study_text(first.resolved_toml(), "resolved", {}, "", "");
  ASSERT_TRUE(std::holds_alternative<Study>(again)) << std::get<ConfigError>(again).messages[0];
  const Study& second = std::get<Study>(again);
  EXPECT_EQ(second.candidates()[2].scenario.strategy.grip_force_N, 3.5);
  EXPECT_EQ(second.candidates()[2].scenario.strategy.grip_ramp_s, 0.05);
  EXPECT_EQ(second.resolved_toml(), first.resolved_toml());
}

TEST(Searches, DefaultsFollowTheKind) {
  const SearchSettings optimize = study_of(search_block("optimize")).search();
  EXPECT_EQ(optimize.objective.text, "cycle_time_s");
  ASSERT_EQ(optimize.constraints.size(), 1U);
  EXPECT_EQ(optimize.constraints[0].text, "held");
  EXPECT_EQ(optimize.algorithm, optimizer::Algorithm::cobyla);
  EXPECT_EQ(optimize.budget, 40 * optimize.starts);
  EXPECT_EQ(study_of(search_block("optimize"), {"search.starts=100"}).search().budget, 4000U);
  const SearchSettings robust = study_of(search_block("robust")).search();
  EXPECT_EQ(robust.objective.text, "mean(cycle_time_s)");
  EXPECT_EQ(robust.objective.terms[0].statistic, Statistic::mean);
  ASSERT_EQ(robust.constraints.size(), 1U);
  EXPECT_EQ(robust.constraints[0].kind, Constraint::Kind::probability);
  EXPECT_EQ(robust.constraints[0].bound, 0.99);
  EXPECT_EQ(study_of(search_block("compare")).compare().metrics, std::vector<Metric>{Metric::cycle_time_s});
}

TEST(Searches, AddHeldWhereNoConstraintNamesAnOutcome) {
  const auto texts = [](const std::string& kind, const std::string& list) {
    std::vector<std::string> all;
    const Study study = study_of(search_block(kind), {"search.constraints=" + list});
    for (const Constraint& c : study.search().constraints) all.push_back(c.text);
    return all;
  };
  using Texts = std::vector<std::string>;
  EXPECT_EQ(texts("optimize", "[\"slip_max_m <= 1e-4\"]"), (Texts{"held", "slip_max_m <= 1e-4"}));
  EXPECT_EQ(texts("robust", "[\"worst(slip_max_m) <= 1e-4\"]"),
            (Texts{"P(held) >= 0.99", "worst(slip_max_m) <= 1e-4"}));
  EXPECT_EQ(texts("optimize", "[\"not dropped\"]"), (Texts{"not dropped"}));
  EXPECT_EQ(texts("optimize", "[]"), Texts{});
}

TEST(Searches, ARobustStudyMayJudgeTheStrategyAsWritten) {
  const std::string text =
      gripped_block("robust") +
      "[[random]]\nkey = \"product.friction\"\ndistribution = \"uniform\"\nfrom = 0.4\nto = 0.8\n";
  const Study study = study_of(text);
  EXPECT_TRUE(study.variables().empty());
  EXPECT_EQ(study_of(study.resolved_toml()).resolved_toml(), study.resolved_toml());
}

TEST(Searches, TheirBaseLiesInsideTheBoxWhereTheKeyIsNotWritten) {
  const Study middle = study_of(search_block("optimize"));
  EXPECT_EQ(middle.base_value("strategy.grip_force_N"), 2.0);
  EXPECT_EQ(study_of(search_block("optimize"), {"variable[0].start=1.25"}).base_value("strategy.grip_force_N"),
            1.25);
  // The middle of 1 .. 4 on a log scale is 2.
  const Study log = study_of(search_block("optimize"), {"variable[0].to=4.0", "variable[0].scale=log"});
  EXPECT_DOUBLE_EQ(*log.base_value("strategy.grip_force_N"), 2.0);
  EXPECT_EQ(study_of(search_block("optimize"), {"strategy.grip_force_N=1.75"}).base_value("strategy.grip_force_N"),
            1.75);
  EXPECT_DOUBLE_EQ(*study_of(search_block("sample")).base_value("product.friction"), 0.6);
  const Study element = study_of(search_block("sample"),
                                 {"random[0].key=product.size_m[1]", "random[0].from=0.05", "random[0].to=0.06"});
  EXPECT_EQ(element.base_value("product.size_m[1]"), 0.06) << "written as an array";
}

TEST(Searches, AGripForceBelowTheContactForceIsSearchedAllTheSame) {
  const Study study = study_of(search_block("optimize"),
                               {"variable[0].from=0.1", "variable[0].to=0.4", "strategy.contact_force_N=0.3"});
  const std::vector<std::string> keys = {"strategy.grip_force_N"};
  const auto contact_at = [&](double grip) {
    return study.scenario_with(keys, std::array<double, 1>{grip}).strategy.contact_force_N;
  };
  EXPECT_EQ(contact_at(0.2), 0.2);
  EXPECT_EQ(contact_at(0.4), 0.3);
  EXPECT_EQ(
      study_of(study.resolved_toml()).scenario_with(keys, std::array<double, 1>{0.4}).strategy.contact_force_N,
      0.3);
}

TEST(Searches, ValuesReachTheirKeysAndNothingElse) {
  const Study study = study_of(search_block("optimize"));
  const std::vector<std::string> keys = {"product.size_m[2]", "simulation.time_step_s", "cell.gravity_m_s2[0]"};
  const Scenario scenario = study.scenario_with(keys, std::array<double, 3>{0.0625, 0.125, 2.5});
  EXPECT_EQ(std::get<LatticeParameters>(scenario.product).size_m, (std::array<double, 3>{0.05, 0.06, 0.0625}));
  EXPECT_EQ(scenario.simulation.time_step_s, 0.125);
  EXPECT_EQ(scenario.cell.gravity_m_s2[0], 2.5);
  EXPECT_EQ(scenario.strategy.grip_force_N, study.scenario(0).strategy.grip_force_N);
}

TEST(Searches, BaseValueIsNothingForKeysThatAreNotThere) {
  const Study lattice = study_of(search_block("optimize"));
  EXPECT_EQ(lattice.base_value("product.size_m[0]"), 0.05);
  EXPECT_EQ(lattice.base_value("product.yield_stress_Pa"), std::nullopt);
  EXPECT_EQ(lattice.base_value("product.particle[0].mass_kg"), std::nullopt);
  EXPECT_EQ(lattice.base_value("product.size_m[3]"), std::nullopt);
  EXPECT_EQ(lattice.base_value("strategy.profile"), std::nullopt);
  EXPECT_EQ(lattice.base_value("no.such.key"), std::nullopt);
  const Study network = study_of(testing::small_network());
  EXPECT_EQ(network.base_value("product.particle[1].mass_kg"), 2.0);
  EXPECT_EQ(network.base_value("product.particle[2].mass_kg"), std::nullopt);
  EXPECT_EQ(network.base_value("product.cell_size_m"), std::nullopt);
  EXPECT_EQ(network.base_value("gripper.stroke_m"), std::nullopt);
}

TEST(Searches, KnowWhichRandomKeysNeedAnotherFactor) {
  const auto changes = [](const std::string& key, const std::string& from, const std::string& to) {
    const std::vector<std::string> sets = {"random[0].key=" + key, "random[0].from=" + from, "random[0].to=" + to};
    return study_of(search_block("sample"), sets).randoms().at(0).changes_factor;
  };
  EXPECT_TRUE(changes("product.youngs_modulus_Pa", "1e5", "2e5"));
  EXPECT_TRUE(changes("product.mass_kg", "0.1", "0.2"));
  EXPECT_TRUE(changes("product.size_m[0]", "0.05", "0.06"));
  EXPECT_FALSE(changes("product.friction", "0.4", "0.8"));
  EXPECT_FALSE(changes("gripper.pad_modulus_Pa", "1e5", "2e5"));
  EXPECT_FALSE(changes("strategy.grip_force_N", "1", "2"));
}

TEST(Searches, ADrawnDensityDisplacesTheMass) {
  const Study study = study_of(search_block("sample"),
                               {"random[0].key=product.density_kg_m3", "random[0].from=900", "random[0].to=1100"});
  for (const Study& s : {study, study_of(study.resolved_toml())}) {
    EXPECT_EQ(s.base_value("product.mass_kg"), std::nullopt);
    EXPECT_DOUBLE_EQ(*s.base_value("product.density_kg_m3"), 1000.0);
  }
}

TEST(Searches, ARandomKeyOfANetworkNeedsNoGripper) {
  const std::string text = testing::small_network() +
                           "[[random]]\nkey = \"product.spring[0].stiffness_N_m\"\ndistribution = \"lognormal\"\n"
                           "mean = 10.0\nrelative_deviation = 0.1\n";
  const Study study = study_of(text, {"study.kind=sample"});
  EXPECT_TRUE(study.randoms()[0].changes_factor);
  EXPECT_EQ(study.randoms()[0].units, "N m-1");
  const Scenario scenario = study.scenario_with(std::vector<std::string>{"product.spring[0].stiffness_N_m"},
                                                std::array<double, 1>{12.5});
  EXPECT_EQ(std::get<NetworkParameters>(scenario.product).spring[0].stiffness_N_m, 12.5);
}

TEST(Searches, ACommandLineGoesOverBlocksAndCandidates) {
  const Study study =
      study_of(search_block("compare"), {"candidate[0].profile=trapezoid", "candidate[1].grip_force_N=2.5",
                                         "random[0].to=0.9", "strategy.hold_s=0.25"});
  EXPECT_EQ(study.candidates()[0].scenario.strategy.profile, ProfileKind::trapezoid);
  EXPECT_EQ(study.candidates()[1].scenario.strategy.profile, ProfileKind::minimum_jerk);
  EXPECT_EQ(study.candidates()[1].scenario.strategy.grip_force_N, 2.5);
  EXPECT_EQ(study.candidates()[1].scenario.strategy.hold_s, 0.25);
  EXPECT_EQ(study.randoms()[0].distribution.to, 0.9);
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
          errors_of(head + "[product]\nuse = \"products/kiwi_ripe.toml\"\n[gripper]\nuse = \"" + path + "\"\n"),
          std::vector<std::string>{});
    } else if (path.starts_with("strategies/")) {
      ++strategies;
      EXPECT_EQ(errors_of(search_block("compare") + "[[candidate]]\nname = \"c\"\nuse = \"" + path + "\"\n"),
                std::vector<std::string>{});
    } else {
      ++studies;
      const auto read = read_study(file.path(), {}, config_root());
      if (const auto* error = std::get_if<ConfigError>(&read)) ADD_FAILURE() << error->messages[0];
      if (const auto* study = std::get_if<Study>(&read)) {
        EXPECT_EQ(study->warnings(), std::vector<std::string>{}) << path;
        EXPECT_FALSE(study->description().empty()) << path;
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
  EXPECT_EQ(std::get<Study>(read).scenario_count(), 512U);
}

TEST(Configs, BathesMatricesAreThoseOfTheExample) {
  const auto read = read_study(config_root() + "/networks/bathe_2dof.toml", {}, config_root());
  const auto network = std::get<NetworkParameters>(std::get<Study>(read).scenario(0).product);
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

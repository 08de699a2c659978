#include "studies/config/searching.hpp"

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "tests/studies/config/config_testing.hpp"

namespace unbruised::studies {
namespace {

using testing::errors_of;
using testing::gripped_block;
using testing::search_block;
using testing::study_of;

const std::vector<std::string> kSearchKinds = {"sample", "optimize", "robust", "pareto", "compare", "sensitivity"};

TEST(Searches, ACandidateHasTheWaypointsOfTheStudyOrItsOwn) {
  const std::string waypoints =
      "[[strategy.waypoint]]\nrotation_rad = [0.5, 0.0, 0.0]\n[[strategy.waypoint]]\nwait_s = 0.5\n";
  const std::string own =
      "[[candidate]]\nname = \"c\"\n[[candidate.waypoint]]\nquaternion = [0.0, 1.0, 0.0, 0.0]\n";
  const Study study = study_of(search_block("compare") + waypoints + own);
  for (const Study& each : {study, study_of(study.resolved_toml())}) {
    ASSERT_EQ(each.candidates().size(), 3U);
    EXPECT_EQ(each.candidates()[0].scenario.strategy.waypoint.size(), 2U);
    const std::vector<Waypoint>& path = each.candidates()[2].scenario.strategy.waypoint;
    ASSERT_EQ(path.size(), 1U);
    EXPECT_FALSE(path[0].rotation_rad);
    EXPECT_EQ(path[0].quaternion, (std::array<double, 4>{0.0, 1.0, 0.0, 0.0}));
  }
}

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
  ASSERT_TRUE(again.has_value()) << again.error().messages[0];
  const Study& second = *again;
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

}  // namespace
}  // namespace unbruised::studies

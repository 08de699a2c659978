// Every key of a study's own tables and blocks reaches the field it names, read directly and from the resolved
// text.

#include <algorithm>

#include "studies/config/schema.hpp"
#include "tests/studies/config/config_testing.hpp"

namespace unbruised::studies {
namespace {

using testing::search_block;
using testing::study_of;

TEST(StudyKeys, StudyKeysReachTheirFields) {
  const Study study = study_of(R"(
[study]
name = "a-b_C3"
kind = "window"
seed = 7
description = "Grüße \"quoted\" \\ tab\t"
[window]
from_N = 0.75
to_N = 1.5
tolerance = 0.25
[product]
use = "products/kiwi_ripe.toml"
[gripper]
)");
  for (const Study& s : {study, study_of(study.resolved_toml())}) {
    EXPECT_EQ(s.name(), "a-b_C3");
    EXPECT_EQ(s.kind(), StudyKind::window);
    EXPECT_EQ(s.seed(), 7U);
    EXPECT_EQ(s.description(), "Grüße \"quoted\" \\ tab\t");
    EXPECT_EQ(s.window().from_N, 0.75);
    EXPECT_EQ(s.window().to_N, 1.5);
    EXPECT_EQ(s.window().tolerance, 0.25);
    EXPECT_EQ(s.scenario(0).strategy.grip_force_N, 0.75) << "a window study starts at its lower end";
  }
}

/// A key of a kind that searches or draws products, and what must have arrived.
struct StudyArrival {
  std::string kind;
  std::string key;
  std::string value;
  bool (*arrived)(const Study&);
  std::vector<std::string> with = {};  ///< further --set that the key needs
  std::string text = {};               ///< further blocks that it needs
};

using K = const Study&;

std::vector<StudyArrival> search_arrivals() {
  return {
      {"optimize", "search.objective", "\"2 * slip_max_m - cycle_time_s\"",
       [](K s) {
         const std::vector<GoalTerm>& terms = s.search().objective.terms;
         return terms.size() == 2 && terms[0].weight == 2.0 && terms[0].metric == Metric::slip_max_m &&
                terms[1].weight == -1.0 && terms[1].metric == Metric::cycle_time_s;
       }},
      {"pareto", "search.objectives", "[\"cycle_time_s\", \"slip_max_m\", \"energy_input_J\"]",
       [](K s) { return s.search().objectives.size() == 3 && s.search().objectives[2].text == "energy_input_J"; }},
      {"optimize", "search.constraints", "[\"not dropped\", \"slip_max_m <= 1e-4\"]",
       [](K s) {
         const std::vector<Constraint>& all = s.search().constraints;
         return all.size() == 2 && all[0].kind == Constraint::Kind::outcome && all[1].bound == 1e-4 &&
                !all[1].at_least;
       }},
      {"optimize", "search.algorithm", "\"ISRES\"",
       [](K s) { return s.search().algorithm == optimizer::Algorithm::isres; }},
      {"optimize",
       "search.local_algorithm",
       "\"NELDERMEAD\"",
       [](K s) { return s.search().local == optimizer::Algorithm::neldermead; },
       {"search.algorithm=AUGLAG"}},
      {"optimize", "search.starts", "7", [](K s) { return s.search().starts == 7; }},
      {"optimize", "search.budget", "321", [](K s) { return s.search().budget == 321; }},
      {"optimize", "search.tolerance", "0.0625", [](K s) { return s.search().tolerance == 0.0625; }},
      {"optimize", "search.initial_step", "0.375", [](K s) { return s.search().initial_step == 0.375; }},
      {"pareto", "search.method", "\"chebyshev\"",
       [](K s) { return s.search().method == ParetoMethod::chebyshev; }},
      {"pareto", "search.points", "11", [](K s) { return s.search().points == 11; }},
  };
}

std::vector<StudyArrival> design_arrivals() {
  return {
      {"sample", "sampling.design", "\"latin_hypercube\"",
       [](K s) { return s.sampling().design == DesignKind::latin_hypercube; }},
      {"sensitivity", "sampling.design", "\"random\"",
       [](K s) { return s.sampling().design == DesignKind::random; }},
      {"robust", "sampling.count", "321", [](K s) { return s.sampling().count == 321; }},
      {"sample", "sampling.factor_groups", "0", [](K s) { return s.sampling().factor_groups == 0; }},
      {"compare", "sampling.confidence", "0.875", [](K s) { return s.sampling().confidence == 0.875; }},
      {"compare", "compare.metric", "\"slip_max_m\"",
       [](K s) { return s.compare().metric == Metric::slip_max_m; }},
      {"compare", "compare.metrics", "[\"slip_max_m\", \"cycle_time_s\"]",
       [](K s) {
         return s.compare().metrics == std::vector<Metric>{Metric::cycle_time_s, Metric::slip_max_m};
       }},
      {"compare", "compare.tie", "0.375", [](K s) { return s.compare().tie == 0.375; }},
      {"sensitivity", "sensitivity.method", "\"morris\"",
       [](K s) { return s.sensitivity().method == SensitivityMethod::morris; }},
      {"sensitivity", "sensitivity.metrics", "[\"slip_max_m\", \"energy_input_J\"]",
       [](K s) {
         return s.sensitivity().metrics == std::vector<Metric>{Metric::slip_max_m, Metric::energy_input_J};
       }},
      {"sensitivity", "sensitivity.samples", "32", [](K s) { return s.sensitivity().samples == 32; }},
      {"sensitivity", "sensitivity.levels", "6", [](K s) { return s.sensitivity().levels == 6; }},
      {"sensitivity", "sensitivity.bootstrap", "321", [](K s) { return s.sensitivity().bootstrap == 321; }},
      {"sensitivity", "sensitivity.confidence", "0.875", [](K s) { return s.sensitivity().confidence == 0.875; }},
  };
}

std::vector<StudyArrival> block_arrivals() {
  return {
      {"robust", "variable[0].key", "\"strategy.hold_s\"",
       [](K s) { return s.variables()[0].key == "strategy.hold_s" && s.variables()[0].units == "s"; }},
      {"optimize", "variable[0].from", "0.375", [](K s) { return s.variables()[0].from == 0.375; }},
      {"optimize", "variable[0].to", "37.5", [](K s) { return s.variables()[0].to == 37.5; }},
      {"optimize", "variable[0].scale", "\"log\"",
       [](K s) { return s.variables()[0].scale == optimizer::Scale::log; }},
      {"optimize", "variable[0].start", "1.25", [](K s) { return s.variables()[0].start == 1.25; }},
      {"compare", "candidate[1].name", "\"c-3\"", [](K s) { return s.candidates()[1].name == "c-3"; }},
      {"compare", "candidate[1].use", "\"strategies/fast.toml\"",
       [](K s) {
         const StrategyParameters& strategy = s.candidates()[1].scenario.strategy;
         return strategy.settle_s == 0.02 && strategy.grip_force_N == 2.0;  // keys beside `use` override the file
       }},
      {"compare", "candidate[0].settle_s", "0.875",
       [](K s) { return s.candidates()[0].scenario.strategy.settle_s == 0.875; }},
  };
}

std::vector<StudyArrival> random_arrivals() {
  const std::vector<std::string> normal = {"random[0].from=none", "random[0].to=none",
                                           "random[0].distribution=normal", "random[0].mean=0.5"};
  const auto with = [](std::vector<std::string> sets, const std::string& more) {
    sets.push_back(more);
    return sets;
  };
  const std::vector<std::string> spread = with(normal, "random[0].standard_deviation=0.0625");
  const std::vector<std::string> measured = {"random[0].from=none", "random[0].to=none",
                                             "random[0].distribution=normal"};
  const std::vector<std::string> of_force = {"random[0].from=none", "random[0].to=none",
                                             "random[0].key=strategy.grip_force_N"};
  const std::vector<std::string> triangle = {"random[0].distribution=triangular", "random[0].mode=0.5"};
  return {
      {"sample",
       "random[0].key",
       "\"product.poisson_ratio\"",
       [](K s) { return s.randoms()[0].key == "product.poisson_ratio" && s.randoms()[0].changes_factor; },
       {"random[0].from=0.125", "random[0].to=0.25"}},
      {"sample", "random[0].distribution", "\"lognormal\"",
       [](K s) { return s.randoms()[0].distribution.kind == DistributionKind::lognormal; },
       with(spread, "random[0].distribution=lognormal")},
      {"sample", "random[0].mean", "0.625", [](K s) { return s.randoms()[0].distribution.mean == 0.625; }, spread},
      {"sample", "random[0].standard_deviation", "0.03125",
       [](K s) { return s.randoms()[0].distribution.standard_deviation == 0.03125; }, spread},
      {"sample", "random[0].relative_deviation", "0.0625",
       [](K s) { return s.randoms()[0].distribution.standard_deviation == 0.03125; }, normal},
      {"sample", "random[0].data", "[0.25, 0.5, 0.75]",
       [](K s) {
         // Mean 0.5 and squares 2 x 0.0625 over n - 1 = 2.
         const Distribution& d = s.randoms()[0].distribution;
         return d.mean == 0.5 && d.standard_deviation == 0.25;
       },
       with(measured, "random[0].at_least=0.125")},
      {"sample", "random[0].from", "0.25", [](K s) { return s.randoms()[0].distribution.from == 0.25; }},
      {"sample", "random[0].to", "0.75", [](K s) { return s.randoms()[0].distribution.to == 0.75; }},
      {"sample", "random[0].mode", "0.625", [](K s) { return s.randoms()[0].distribution.mode == 0.625; },
       triangle},
      {"sample", "random[0].at_least", "0.4375",
       [](K s) { return s.randoms()[0].distribution.at_least == 0.4375; }, spread},
      {"sample", "random[0].at_most", "0.5625", [](K s) { return s.randoms()[0].distribution.at_most == 0.5625; },
       spread},
      {"sample", "random[0].relative", "0.25",
       [](K s) {
         const RandomVariable& error = s.randoms()[0];
         return error.key == "strategy.grip_force_N_relative_error" && error.distribution.to == 0.25;
       },
       of_force},
      {"sample", "random[0].absolute", "0.25",
       [](K s) {
         const RandomVariable& error = s.randoms()[0];
         return error.key == "strategy.grip_force_N_error" && error.distribution.to == 0.25;
       },
       of_force},
  };
}

std::vector<StudyArrival> calibrate_arrivals() {
  return {
      {"calibrate", "calibrate.test", "creep", [](K s) { return s.calibrate().test == CurveTest::creep; }},
      {"calibrate", "calibrate.outcome", "rupture_N", [](K s) { return s.calibrate().outcome == "rupture_N"; }},
      {"calibrate", "calibrate.tolerance", "0.0625", [](K s) { return s.calibrate().tolerance == 0.0625; }},
      {"calibrate", "calibrate.budget", "321", [](K s) { return s.calibrate().budget == 321; }},
      {"calibrate", "calibrate.confidence", "0.875", [](K s) { return s.calibrate().confidence == 0.875; }},
      {"calibrate",
       "parameter[0].key",
       "\"product.friction\"",
       [](K s) { return s.variables()[0].key == "product.friction"; },
       {"parameter[0].from=0.25", "parameter[0].to=0.75"}},
      {"calibrate", "parameter[0].from", "2e5", [](K s) { return s.variables()[0].from == 2e5; }},
      {"calibrate", "parameter[0].to", "3e6", [](K s) { return s.variables()[0].to == 3e6; }},
      {"calibrate", "parameter[0].scale", "\"log\"",
       [](K s) { return s.variables()[0].scale == optimizer::Scale::log; }},
      {"calibrate", "parameter[0].start", "3e5", [](K s) { return s.variables()[0].start == 3e5; }},
      {"calibrate", "specimen[0].name", "b", [](K s) { return s.calibrate().curves[0].specimen == "b"; }},
      {"calibrate", "specimen[0].closure_m", "[0.0, 0.5, 0.75]",
       [](K s) { return s.calibrate().curves[0].x[2] == 0.75; }},
      {"calibrate", "specimen[0].force_N", "[0.0, 0.5, 0.75]",
       [](K s) { return s.calibrate().curves[0].y[2] == 0.75; }},
      {"calibrate",
       "specimen[0].time_s",
       "[0.0, 0.5, 0.75]",
       [](K s) { return s.calibrate().curves[0].x[2] == 0.75; },
       {"calibrate.test=relaxation"}},
      {"calibrate", "specimen[0].outcome", "7.5", [](K s) { return s.calibrate().curves[0].outcome == 7.5; }},
  };
}

std::vector<StudyArrival> joint_arrivals() {
  const std::vector<std::string> drawn = {"random[0].from=none", "random[0].to=none",
                                          "random[0].distribution=data"};
  const auto with = [&](const std::string& more) {
    std::vector<std::string> sets = drawn;
    sets.push_back(more);
    return sets;
  };
  const std::string mass =
      "[[random]]\nkey = \"product.mass_kg\"\ndistribution = \"data\"\ndata = [0.1, 0.2, 0.3]\n";
  const std::string force = "[[random]]\nkey = \"strategy.grip_force_N\"\nrelative = 0.1\n";
  const std::string pair =
      "[[correlation]]\nbetween = [\"product.friction\", \"strategy.grip_force_N\"]\nvalue = 0.25\n";
  // 32 kiwis, 6.51 N and 2265 N/m the first.
  const auto has_kiwis = [](K s) { return s.randoms()[0].distribution.values.size() == 32; };
  return {
      {"sample", "random[0].file", "data/kiwi_rupture.csv", has_kiwis, with("random[0].column=rupture_force_N")},
      {"sample", "random[0].column", "rupture_force_N", has_kiwis, with("random[0].file=data/kiwi_rupture.csv")},
      {"sample", "random[0].zip", "fruit", [](K s) { return s.randoms()[0].zip == "fruit"; },
       with("random[0].data=[0.5, 0.25, 0.75]"), mass + "zip = \"fruit\"\n"},
      {"sample",
       "correlation[0].value",
       "-0.5",
       [](K s) { return s.correlations().size() == 1 && s.correlations()[0].value == -0.5; },
       {},
       force + pair},
      {"sample",
       "correlation[0].between",
       "[\"product.mass_kg\", \"strategy.grip_force_N\"]",
       [](K s) { return s.correlations().size() == 1 && s.correlations()[0].first == 2; },
       {},
       force + mass + pair},
  };
}

std::vector<StudyArrival> all_arrivals() {
  std::vector<StudyArrival> all;
  for (const auto& part : {search_arrivals(), design_arrivals(), block_arrivals(), random_arrivals(),
                           joint_arrivals(), calibrate_arrivals()}) {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

TEST(StudyKeys, EveryKeyOfSearchesAndSamplesReachesTheFieldItNames) {
  for (const StudyArrival& arrival : all_arrivals()) {
    const std::string text = search_block(arrival.kind) + arrival.text;
    EXPECT_FALSE(arrival.arrived(study_of(search_block(arrival.kind))))
        << arrival.key << ": the test needs a value that is not there already";
    std::vector<std::string> sets = arrival.with;
    sets.push_back(arrival.key + "=" + arrival.value);
    const Study study = study_of(text, sets);
    EXPECT_TRUE(arrival.arrived(study)) << arrival.key;
    const Study again = study_of(study.resolved_toml());
    EXPECT_TRUE(arrival.arrived(again)) << arrival.key << " from\n" << study.resolved_toml();
    EXPECT_EQ(again.resolved_toml(), study.resolved_toml());
  }
}

TEST(StudyKeys, EveryKeyOfSearchesAndSamplesIsCoveredByTheTestAbove) {
  std::vector<std::string> covered;
  for (const StudyArrival& arrival : all_arrivals()) covered.push_back(pattern_of(arrival.key));
  covered.emplace_back("calibrate.data");  // its curves stand in the resolved text: MeasuredCurves
  for (const KeySpec& spec : key_table()) {
    const bool of_study = spec.path.starts_with("study.") || spec.path.starts_with("window.");
    if ((spec.study_field == nullptr || of_study) && spec.block_field == nullptr) continue;
    EXPECT_NE(std::find(covered.begin(), covered.end(), spec.path), covered.end()) << spec.path;
  }
}

}  // namespace
}  // namespace unbruised::studies

// The key table against the fields it names, and the suggestions made from it.

#include "studies/config/schema.hpp"

#include <cmath>

#include "tests/studies/config/config_testing.hpp"

namespace unbruised::studies {
namespace {

using testing::gripped_block;
using testing::search_block;
using testing::small_network;
using testing::study_of;

/// Lines of a study that differ from `gripped_block` or `small_network`, and what must have arrived.
struct Arrival {
  std::string key;
  std::string value;
  bool (*arrived)(const Scenario&);
  std::vector<std::string> with = {};  ///< further --set that the key needs
};

const LatticeParameters& lattice(const Scenario& s) { return std::get<LatticeParameters>(s.product); }
const NetworkParameters& network(const Scenario& s) { return std::get<NetworkParameters>(s.product); }

using S = const Scenario&;
using A3 = std::array<double, 3>;
using A2 = std::array<double, 2>;

std::vector<Arrival> lattice_arrivals() {
  const std::vector<std::string> plastic = {"product.yield_stress_Pa=11.5", "product.tangent_modulus_Pa=7.5"};
  const std::vector<std::string> lossy = {"product.loss_ratio=0.25", "product.at_frequency_Hz=12.5"};
  return {
      {"product.shape", "\"cylinder\"", [](S s) { return lattice(s).shape == Shape::cylinder; }},
      {"product.size_m", "[0.5, 0.25, 0.75]",
       [](S s) {
         return lattice(s).size_m == A3{0.5, 0.25, 0.75};
       }},
      {"product.axis", "\"y\"", [](S s) { return lattice(s).axis == Axis::y; }, {"product.shape=cylinder"}},
      {"product.cell_size_m", "0.0125", [](S s) { return lattice(s).cell_size_m == 0.0125; }},
      {"product.mass_kg", "0.375", [](S s) { return lattice(s).mass_kg == 0.375 && !lattice(s).density_kg_m3; }},
      {"product.density_kg_m3", "875.0",
       [](S s) { return lattice(s).density_kg_m3 == 875.0 && !lattice(s).mass_kg; }},
      {"product.youngs_modulus_Pa", "12345.0", [](S s) { return lattice(s).youngs_modulus_Pa == 12345.0; }},
      {"product.poisson_ratio", "0.375", [](S s) { return lattice(s).poisson_ratio == 0.375; }},
      {"product.yield_stress_Pa", "11.5", [](S s) { return lattice(s).yield_stress_Pa == 11.5; }, plastic},
      {"product.tangent_modulus_Pa", "7.5", [](S s) { return lattice(s).tangent_modulus_Pa == 7.5; }, plastic},
      {"product.relaxation_time_s", "0.125", [](S s) { return lattice(s).relaxation_time_s == 0.125; }},
      {"product.loss_ratio", "0.25", [](S s) { return lattice(s).loss_ratio == 0.25; }, lossy},
      {"product.at_frequency_Hz", "12.5", [](S s) { return lattice(s).at_frequency_Hz == 12.5; }, lossy},
      {"product.friction", "0.875", [](S s) { return lattice(s).friction == 0.875; }},
      {"product.initial_velocity_m_s", "[1.0, 2.0, 3.0]",
       [](S s) {
         return lattice(s).initial_velocity_m_s == A3{1.0, 2.0, 3.0};
       }},
      {"gripper.finger_mass_kg", "0.375", [](S s) { return jaw_of(s).finger_mass_kg == 0.375; }},
      {"gripper.stroke_m", "0.375", [](S s) { return jaw_of(s).stroke_m == 0.375; }},
      {"gripper.pad_size_m", "[0.5, 0.25]",
       [](S s) {
         return jaw_of(s).pad_size_m == A2{0.5, 0.25};
       }},
      {"gripper.pad_thickness_m", "0.375", [](S s) { return jaw_of(s).pad_thickness_m == 0.375; }},
      {"gripper.pad_modulus_Pa", "375.0", [](S s) { return jaw_of(s).pad_modulus_Pa == 375.0; }},
      {"gripper.pad_relaxation_time_s", "0.375", [](S s) { return jaw_of(s).pad_relaxation_time_s == 0.375; }},
      {"gripper.drive_gain_N_s_m", "375.0", [](S s) { return jaw_of(s).drive_gain_N_s_m == 375.0; }},
      {"gripper.drive_viscous_N_s_m", "0.375", [](S s) { return jaw_of(s).drive_viscous_N_s_m == 0.375; }},
      {"gripper.min_force_N", "0.25", [](S s) { return jaw_of(s).min_force_N == 0.25; }},
      {"gripper.force_accuracy", "0.125", [](S s) { return jaw_of(s).force_accuracy == 0.125; }},
      {"gripper.force_step_N", "0.125", [](S s) { return jaw_of(s).force_step_N == 0.125; }},
      {"gripper.opening_m", "0.375", [](S s) { return jaw_of(s).opening_m == 0.375; }, {"gripper.stroke_m=0.5"}},
      {"cell.grip_offset_m", "0.0078125", [](S s) { return s.cell.grip_offset_m == 0.0078125; }},
      {"gripper.max_force_N", "375.0", [](S s) { return jaw_of(s).max_force_N == 375.0; }},
      {"gripper.max_speed_m_s", "3.75", [](S s) { return jaw_of(s).max_speed_m_s == 3.75; }},
      {"gripper.coupling", "\"independent\"",
       [](S s) { return jaw_of(s).coupling == FingerCoupling::independent; }},
      {"cell.gravity_m_s2", "[1.0, 2.0, 3.0]",
       [](S s) {
         return s.cell.gravity_m_s2 == A3{1.0, 2.0, 3.0};
       }},
      {"cell.support", "false", [](S s) { return !s.cell.support; }},
      {"cell.support_friction", "0.375", [](S s) { return s.cell.support_friction == 0.375; }},
      {"cell.support_modulus_Pa", "375.0", [](S s) { return s.cell.support_modulus_Pa == 375.0; }},
      {"cell.support_thickness_m", "0.375", [](S s) { return s.cell.support_thickness_m == 0.375; }},
      {"cell.support_relaxation_time_s", "0.375", [](S s) { return s.cell.support_relaxation_time_s == 0.375; }},
      {"cell.approach_gap_m", "0.0375", [](S s) { return s.cell.approach_gap_m == 0.0375; }},
      {"cell.grip_height_m", "-0.0375", [](S s) { return s.cell.grip_height_m == -0.0375; }},
      {"cell.lift_height_m", "0.375", [](S s) { return s.cell.lift_height_m == 0.375; }},
      {"cell.transfer_m", "[0.5, 0.25]",
       [](S s) {
         return s.cell.transfer_m == A2{0.5, 0.25};
       }},
      {"cell.place_height_m", "-0.375", [](S s) { return s.cell.place_height_m == -0.375; }},
      {"strategy.approach_speed_m_s", "0.375", [](S s) { return s.strategy.approach_speed_m_s == 0.375; }},
      {"strategy.grip_force_N", "3.75", [](S s) { return s.strategy.grip_force_N == 3.75; }},
      {"strategy.contact_force_N", "0.875", [](S s) { return s.strategy.contact_force_N == 0.875; }},
      {"strategy.grip_ramp_s", "0.875", [](S s) { return s.strategy.grip_ramp_s == 0.875; }},
      {"strategy.ramp_from_start", "true", [](S s) { return s.strategy.ramp_from_start; }},
      {"strategy.settle_s", "0.875", [](S s) { return s.strategy.settle_s == 0.875; }},
      {"strategy.profile", "\"trapezoid\"", [](S s) { return s.strategy.profile == ProfileKind::trapezoid; }},
      {"strategy.lift_acceleration_m_s2", "8.75", [](S s) { return s.strategy.lift_acceleration_m_s2 == 8.75; }},
      {"strategy.transfer_acceleration_m_s2", "8.75",
       [](S s) { return s.strategy.transfer_acceleration_m_s2 == 8.75; }},
      {"strategy.lower_acceleration_m_s2", "8.75", [](S s) { return s.strategy.lower_acceleration_m_s2 == 8.75; }},
      {"strategy.speed_m_s", "8.75", [](S s) { return s.strategy.speed_m_s == 8.75; }},
      {"strategy.hold_s", "8.75", [](S s) { return s.strategy.hold_s == 8.75; }},
      {"strategy.release_height_m",
       "0.875",
       [](S s) { return s.strategy.release_height_m == 0.875; },
       {"cell.lift_height_m=1.0"}},
      {"strategy.place_settle_s", "0.875", [](S s) { return s.strategy.place_settle_s == 0.875; }},
      {"strategy.release_speed_m_s", "0.375", [](S s) { return s.strategy.release_speed_m_s == 0.375; }},
      {"strategy.recover_s", "0.875", [](S s) { return s.strategy.recover_s == 0.875; }},
      {"limits.permanent_set_m", "0.875", [](S s) { return s.limits.permanent_set_m == 0.875; }},
      {"limits.plastic_strain", "0.875", [](S s) { return s.limits.plastic_strain == 0.875; }},
      {"limits.bruised_volume_m3", "0.875", [](S s) { return s.limits.bruised_volume_m3 == 0.875; }},
      {"limits.peak_pressure_Pa", "0.875", [](S s) { return s.limits.peak_pressure_Pa == 0.875; }},
      {"limits.absorbed_energy_J", "0.875", [](S s) { return s.limits.absorbed_energy_J == 0.875; }},
      {"limits.finger_force_N", "0.875", [](S s) { return s.limits.finger_force_N == 0.875; }},
      {"limits.contact_yield_ratio", "0.875", [](S s) { return s.limits.contact_yield_ratio == 0.875; }},
      {"limits.slip_m", "0.875", [](S s) { return s.limits.slip_m == 0.875; }},
      {"limits.damage", "\"not considered\"",
       [](S s) { return s.limits.damage == DamageJudging::not_considered; }},
      {"simulation.time_step_s", "0.125", [](S s) { return s.simulation.time_step_s == 0.125; }},
      {"simulation.theta", "1.5", [](S s) { return s.simulation.theta == 1.5; }},
      {"simulation.trace_interval_s", "0.875", [](S s) { return s.simulation.trace_interval_s == 0.875; }},
      {"simulation.pressure_patch_m", "0.875", [](S s) { return s.simulation.pressure_patch_m == 0.875; }},
      {"simulation.max_strain", "0.875", [](S s) { return s.simulation.max_strain == 0.875; }},
      {"simulation.max_rotation_rad", "0.875", [](S s) { return s.simulation.max_rotation_rad == 0.875; }},
  };
}

std::vector<Arrival> network_arrivals() {
  return {
      {"product.particle[1].position_m", "[1.0, 2.0, 3.0]",
       [](S s) {
         return network(s).particle[1].position_m == A3{1.0, 2.0, 3.0};
       }},
      {"product.particle[1].mass_kg", "0.375", [](S s) { return network(s).particle[1].mass_kg == 0.375; }},
      {"product.particle[1].fixed", "[\"z\", \"x\"]",
       [](S s) {
         return network(s).particle[1].fixed == std::array<bool, 3>{true, false, true};
       }},
      {"product.particle[1].initial_displacement_m", "[1.0, 2.0, 3.0]",
       [](S s) {
         return network(s).particle[1].initial_displacement_m == A3{1.0, 2.0, 3.0};
       }},
      {"product.particle[1].initial_velocity_m_s", "[1.0, 2.0, 3.0]",
       [](S s) {
         return network(s).particle[1].initial_velocity_m_s == A3{1.0, 2.0, 3.0};
       }},
      {"product.particle[1].contact_stiffness_N_m",
       "375.0",
       [](S s) { return network(s).particle[1].contact_stiffness_N_m == 375.0; },
       {"cell.support=true"}},
      {"product.spring[0].between", "[1, 0]",
       [](S s) {
         return network(s).spring[0].between == std::array<int, 2>{1, 0};
       }},
      {"product.spring[0].stiffness_N_m", "375.0",
       [](S s) { return network(s).spring[0].stiffness_N_m == 375.0; }},
      {"product.spring[0].damping_N_s_m", "3.75", [](S s) { return network(s).spring[0].damping_N_s_m == 3.75; }},
      {"product.spring[0].rest_length_m", "3.75", [](S s) { return network(s).spring[0].rest_length_m == 3.75; }},
      {"product.spring[0].yield_force_N", "3.75", [](S s) { return network(s).spring[0].yield_force_N == 3.75; }},
      {"product.spring[0].hardening_ratio", "3.75",
       [](S s) { return network(s).spring[0].hardening_ratio == 3.75; }},
      {"product.load[0].particle", "0", [](S s) { return network(s).load[0].particle == 0; }},
      {"product.load[0].time_s", "[0.5, 3.0]",
       [](S s) {
         return network(s).load[0].time_s == std::vector<double>{0.5, 3.0};
       }},
      {"product.load[0].force_N", "[[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]]",
       [](S s) {
         return network(s).load[0].force_N == std::vector<A3>{A3{1.0, 2.0, 3.0}, A3{4.0, 5.0, 6.0}};
       }},
      {"product.friction", "0.875", [](S s) { return network(s).friction == 0.875; }},
      {"simulation.duration_s", "3.75", [](S s) { return s.simulation.duration_s == 3.75; }},
      {"simulation.initial_acceleration", "\"zero\"",
       [](S s) { return s.simulation.initial_acceleration == InitialAcceleration::zero; }},
  };
}

/// The key read directly, and once more from the resolved text.
void expect_arrivals(const std::vector<Arrival>& arrivals, const std::string& text) {
  const Scenario before = study_of(text).scenario(0);
  for (const Arrival& arrival : arrivals) {
    EXPECT_FALSE(arrival.arrived(before)) << arrival.key << ": the test needs a value that is not there already";
    std::vector<std::string> sets = arrival.with;
    sets.push_back(arrival.key + "=" + arrival.value);
    const Study study = study_of(text, sets);
    EXPECT_TRUE(arrival.arrived(study.scenario(0))) << arrival.key;
    const Study again = study_of(study.resolved_toml());
    EXPECT_TRUE(arrival.arrived(again.scenario(0))) << arrival.key << " from\n" << study.resolved_toml();
    EXPECT_EQ(again.resolved_toml(), study.resolved_toml());
  }
}

TEST(Schema, EveryLatticeKeyReachesTheFieldItNames) {
  expect_arrivals(lattice_arrivals(), gripped_block("simulate"));
}

TEST(Schema, EveryNetworkKeyReachesTheFieldItNames) { expect_arrivals(network_arrivals(), small_network()); }

TEST(Schema, EveryKeyOfAScenarioIsCoveredByTheTestsAbove) {
  std::vector<std::string> covered;
  for (const auto& list : {lattice_arrivals(), network_arrivals()}) {
    for (const Arrival& arrival : list) covered.push_back(pattern_of(arrival.key));
  }
  for (const KeySpec& spec : key_table()) {
    if (spec.field == nullptr || spec.choices.size() == 1) continue;  // a single word has nothing to change to
    EXPECT_NE(std::find(covered.begin(), covered.end(), spec.path), covered.end()) << spec.path;
  }
}

TEST(Schema, GripperKindIsAParallelJawUntilThereIsAnother) {
  const std::string text = gripped_block("simulate");
  const Study plain = study_of(text);
  const Study named = study_of(text, {"gripper.kind=parallel_jaw"});
  for (const Study& study : {plain, named, study_of(named.resolved_toml())}) {
    EXPECT_TRUE(std::holds_alternative<ParallelJawParameters>(study.scenario(0).gripper));
  }
  EXPECT_EQ(named.resolved_toml(), plain.resolved_toml());
  const std::vector<std::string> errors = testing::errors_of(text, {"gripper.kind=suction_cup"});
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_NE(errors.front().find("parallel_jaw"), std::string::npos) << errors.front();
}

TEST(Schema, StudyKeysReachTheirFields) {
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

TEST(Schema, EveryKeyOfSearchesAndSamplesReachesTheFieldItNames) {
  for (const auto& list : {search_arrivals(), random_arrivals()}) {
    for (const StudyArrival& arrival : list) {
      EXPECT_FALSE(arrival.arrived(study_of(search_block(arrival.kind))))
          << arrival.key << ": the test needs a value that is not there already";
      std::vector<std::string> sets = arrival.with;
      sets.push_back(arrival.key + "=" + arrival.value);
      const Study study = study_of(search_block(arrival.kind), sets);
      EXPECT_TRUE(arrival.arrived(study)) << arrival.key;
      const Study again = study_of(study.resolved_toml());
      EXPECT_TRUE(arrival.arrived(again)) << arrival.key << " from\n" << study.resolved_toml();
      EXPECT_EQ(again.resolved_toml(), study.resolved_toml());
    }
  }
}

TEST(Schema, EveryKeyOfSearchesAndSamplesIsCoveredByTheTestAbove) {
  std::vector<std::string> covered;
  for (const auto& list : {search_arrivals(), random_arrivals()}) {
    for (const StudyArrival& arrival : list) covered.push_back(pattern_of(arrival.key));
  }
  for (const KeySpec& spec : key_table()) {
    const bool of_study = spec.path.starts_with("study.") || spec.path.starts_with("window.");
    if ((spec.study_field == nullptr || of_study) && spec.block_field == nullptr) continue;
    EXPECT_NE(std::find(covered.begin(), covered.end(), spec.path), covered.end()) << spec.path;
  }
}

TEST(Schema, EveryDimensionalKeyEndsInItsUnit) {
  EXPECT_EQ(unit_of("strategy.lift_acceleration_m_s2")->udunits, "m s-2");
  EXPECT_EQ(unit_of("product.spring[].damping_N_s_m")->udunits, "N s m-1");
  EXPECT_EQ(unit_of("product.size_m[0]")->udunits, "m");
  EXPECT_EQ(unit_of("limits.bruised_volume_m3")->udunits, "m3");
  EXPECT_EQ(unit_of("gripper.max_speed_m_s")->udunits, "m s-1");
  EXPECT_EQ(unit_of("simulation.theta"), nullptr);
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

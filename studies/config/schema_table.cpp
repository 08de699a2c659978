#include <limits>

#include "core/scenario/number_fields.hpp"
#include "core/scenario/rules.hpp"
#include "optimizer/algorithm.hpp"
#include "studies/config/schema.hpp"

namespace unbruised::studies {
namespace {

/// Small enough that a fixed-size table of results for it fits on a disk.
constexpr Range kCountRange{1.0, false, 10'000'000.0, false};

// -- From a member to the field a key writes. --------------------------------------------------------------

template <typename T>
FieldRef field_ref(T& member) {
  if constexpr (std::is_enum_v<T>) {
    return ChoiceRef{&member, [](const void* object) { return static_cast<int>(*static_cast<const T*>(object)); },
                     [](void* object, int word) { *static_cast<T*>(object) = static_cast<T>(word); }};
  } else {
    return &member;
  }
}
template <std::size_t n>
FieldRef field_ref(std::array<double, n>& member) {
  return NumberSpan{member.data(), static_cast<int>(n)};
}
template <std::size_t n>
FieldRef field_ref(std::array<int, n>& member) {
  return IntegerSpan{member.data(), static_cast<int>(n)};
}
FieldRef field_ref(std::array<bool, 3>& member) { return &member; }

template <auto member>
FieldRef lattice(Scenario& scenario, int /*index*/) {
  return field_ref(std::get<LatticeParameters>(scenario.product).*member);
}
template <auto member>
FieldRef particle(Scenario& scenario, int index) {
  return field_ref(std::get<NetworkParameters>(scenario.product).particle.at(static_cast<std::size_t>(index)).*
                   member);
}
template <auto member>
FieldRef spring(Scenario& scenario, int index) {
  return field_ref(std::get<NetworkParameters>(scenario.product).spring.at(static_cast<std::size_t>(index)).*
                   member);
}
template <auto member>
FieldRef load(Scenario& scenario, int index) {
  return field_ref(std::get<NetworkParameters>(scenario.product).load.at(static_cast<std::size_t>(index)).*member);
}
template <auto member>
FieldRef gripper(Scenario& scenario, int /*index*/) {
  return field_ref((*scenario.gripper).*member);
}
template <auto member>
FieldRef cell(Scenario& scenario, int /*index*/) {
  return field_ref(scenario.cell.*member);
}
template <auto member>
FieldRef strategy(Scenario& scenario, int /*index*/) {
  return field_ref(scenario.strategy.*member);
}
template <auto member>
FieldRef limits(Scenario& scenario, int /*index*/) {
  return field_ref(scenario.limits.*member);
}
template <auto member>
FieldRef simulation(Scenario& scenario, int /*index*/) {
  return field_ref(scenario.simulation.*member);
}
FieldRef product_friction(Scenario& scenario, int /*index*/) {
  return std::visit([](auto& product) -> FieldRef { return &product.friction; }, scenario.product);
}
template <auto member>
FieldRef study(StudySettings& settings) {
  return field_ref(settings.*member);
}
template <auto member>
FieldRef window(StudySettings& settings) {
  return field_ref(settings.window.*member);
}
template <auto table, auto member>
FieldRef study_table(StudySettings& settings) {
  return field_ref(settings.*table.*member);
}
template <auto member>
FieldRef vary(VaryBlock& block) {
  return field_ref(block.*member);
}
template <auto member>
FieldRef variable(StudyBlocks& blocks, int index) {
  return field_ref(blocks.variable.at(static_cast<std::size_t>(index)).*member);
}
template <auto member>
FieldRef random(StudyBlocks& blocks, int index) {
  return field_ref(blocks.random.at(static_cast<std::size_t>(index)).*member);
}
template <auto member>
FieldRef candidate(StudyBlocks& blocks, int index) {
  return field_ref(blocks.candidate.at(static_cast<std::size_t>(index)).*member);
}

// -- The tables. -------------------------------------------------------------------------------------------

using Table = std::vector<KeySpec>;
using enum KeyType;

Table study_keys() {
  return {
      {.path = "study.name",
       .type = text,
       .meaning = "Name of the study and of its run directory.",
       .required = true,
       .note = "1 to 64 letters, digits, '_' or '-'",
       .study_field = study<&StudySettings::name>},
      {.path = "study.kind",
       .type = choice,
       .meaning =
           "What is done: one run with its trace; all points of the [[vary]] blocks; a search for the grip "
           "window; random products; a search for the best strategy, for one that holds up when products vary, "
           "or for a front of them; strategies compared on the same products; what matters most.",
       .choices = {"simulate", "sweep", "window", "sample", "optimize", "robust", "pareto", "compare",
                   "sensitivity"},
       .required = true,
       .study_field = study<&StudySettings::kind>},
      {.path = "study.seed",
       .type = integer,
       .meaning = "Seed of everything random.",
       .range = kNotNegative,
       .study_field = study<&StudySettings::seed>},
      {.path = "study.description",
       .type = text,
       .meaning = "One line for reports and lists.",
       .study_field = study<&StudySettings::description>},
      {.path = "window.from_N",
       .type = number,
       .meaning = "Smallest grip force that is tried.",
       .range = kPositive,
       .use = Use::window,
       .required = true,
       .note = "< window.to_N",
       .study_field = window<&WindowSettings::from_N>},
      {.path = "window.to_N",
       .type = number,
       .meaning = "Largest grip force that is tried.",
       .range = kPositive,
       .use = Use::window,
       .required = true,
       .note = "<= gripper.max_force_N",
       .study_field = window<&WindowSettings::to_N>},
      {.path = "window.tolerance",
       .type = number,
       .meaning = "Relative width at which the search for either end of the window stops.",
       .range = {0.0, true, 1.0, true},
       .use = Use::window,
       .study_field = window<&WindowSettings::tolerance>},
  };
}

std::vector<std::string_view> algorithm_names() {
  std::vector<std::string_view> names;
  for (const optimizer::AlgorithmInfo& info : optimizer::algorithm_table()) names.push_back(info.name);
  return names;
}

Table search_keys() {
  using S = SearchTable;
  constexpr auto at = &StudySettings::search;
  return {
      {.path = "search.objective",
       .type = text,
       .meaning =
           "What is to be least: a metric or a weighted sum, \"cycle_time_s + 0.5 * peak_finger_force_N\"; of a "
           "robust study statistics over the products: mean(m), quantile(m, 0.95), worst(m).",
       .use = Use::one_objective,
       .note = "cycle_time_s, of a robust study mean(cycle_time_s), unless given",
       .study_field = study_table<at, &S::objective>},
      {.path = "search.objectives",
       .type = texts,
       .meaning = "The two or three objectives of a Pareto front.",
       .use = Use::pareto,
       .required = true,
       .study_field = study_table<at, &S::objectives>},
      {.path = "search.constraints",
       .type = texts,
       .meaning = "What has to hold: outcomes (\"held\", \"not damaged\"), metrics (\"friction_margin_min >= "
                  "0.2\"), of a "
                  "robust study \"P(held) >= 0.99\" or \"worst(permanent_set_max_m) <= 1e-4\".",
       .use = Use::search,
       .note = "\"held\", of a robust study \"P(held) >= 0.99\", is added where no outcome is named; [] is none "
               "at all",
       .study_field = study_table<at, &S::constraints>},
      {.path = "search.algorithm",
       .type = choice,
       .meaning = "NLopt algorithm of each search.",
       .choices = algorithm_names(),
       .use = Use::search,
       .note = "one that takes the study's constraints",
       .study_field = study_table<at, &S::algorithm>},
      {.path = "search.local_algorithm",
       .type = text,
       .meaning = "The algorithm inside MLSL and AUGLAG.",
       .use = Use::search,
       .note = "with MLSL and AUGLAG only",
       .study_field = study_table<at, &S::local_algorithm>},
      {.path = "search.starts",
       .type = integer,
       .meaning =
           "Searches that start from different points of the box, of a pareto study: for each of its points.",
       .range = {1.0, false, 4096.0, false},
       .use = Use::search,
       .note = "robust: 4, pareto: 2 unless given",
       .study_field = study_table<at, &S::starts>},
      {.path = "search.budget",
       .type = integer,
       .meaning = "Strategies that all searches together may evaluate.",
       .range = {1.0, false, 10'000'000.0, false},
       .use = Use::search,
       .note = ">= starts; robust: 100, else 40 for each search unless given",
       .study_field = study_table<at, &S::budget>},
      {.path = "search.tolerance",
       .type = number,
       .meaning = "A search ends when its steps fall below this part of each variable's range.",
       .range = {0.0, true, 1.0, true},
       .use = Use::search,
       .study_field = study_table<at, &S::tolerance>},
      {.path = "search.initial_step",
       .type = number,
       .meaning = "First step of a search, as part of each variable's range.",
       .range = {0.0, true, 1.0, false},
       .use = Use::search,
       .study_field = study_table<at, &S::initial_step>},
      {.path = "search.method",
       .type = choice,
       .meaning = "How points of the front are found.",
       .choices = {"epsilon_constraint", "chebyshev"},
       .use = Use::pareto,
       .study_field = study_table<at, &S::method>},
      {.path = "search.points",
       .type = integer,
       .meaning = "Points looked for between the ends of the front.",
       .range = {1.0, false, 1000.0, false},
       .use = Use::pareto,
       .study_field = study_table<at, &S::points>},
  };
}

Table sampling_keys() {
  using S = SamplingSettings;
  constexpr auto at = &StudySettings::sampling;
  const Use use = Use::sampling;
  return {
      {.path = "sampling.design",
       .type = choice,
       .meaning = "How products are drawn.",
       .choices = {"sobol", "latin_hypercube", "random"},
       .use = Use::random,
       .study_field = study_table<at, &S::design>},
      {.path = "sampling.count",
       .type = integer,
       .meaning = "Random products.",
       .range = {2.0, false, 1'000'000.0, false},
       .use = use,
       .note = "of a robust study <= 65,536 / points asked at once",
       .study_field = study_table<at, &S::count>},
      {.path = "sampling.factor_groups",
       .type = integer,
       .meaning =
           "Random keys that change the factored matrix (stiffness, size, mass) take this many joint values, so "
           "that lanes are full; 0: every product its own.",
       .range = {0.0, false, 1'000'000.0, false},
       .use = use,
       .study_field = study_table<at, &S::factor_groups>},
      {.path = "sampling.confidence",
       .type = number,
       .meaning = "Of all intervals.",
       .range = {0.5, false, 0.9999, false},
       .use = use,
       .study_field = study_table<at, &S::confidence>},
  };
}

Table compare_keys() {
  using S = CompareTable;
  constexpr auto at = &StudySettings::compare;
  const Use use = Use::compare;
  return {
      {.path = "compare.metric",
       .type = text,
       .meaning = "The metric that decides: less is better, of friction_margin_min more; a product that is not "
                  "held loses.",
       .use = use,
       .study_field = study_table<at, &S::metric>},
      {.path = "compare.metrics",
       .type = texts,
       .meaning = "Metrics whose differences are shown beside it.",
       .use = use,
       .study_field = study_table<at, &S::metrics>},
      {.path = "compare.tie",
       .type = number,
       .meaning = "Differences of the metric up to this, in its unit, count as ties.",
       .range = kNotNegative,
       .use = use,
       .study_field = study_table<at, &S::tie>},
  };
}

Table sensitivity_keys() {
  using S = SensitivityTable;
  constexpr auto at = &StudySettings::sensitivity;
  const Use use = Use::sensitivity;
  return {
      {.path = "sensitivity.method",
       .type = choice,
       .meaning = "Sobol' indices (parts of the variance), or Morris screening (elementary effects; fewer runs).",
       .choices = {"sobol", "morris"},
       .use = use,
       .study_field = study_table<at, &S::method>},
      {.path = "sensitivity.metrics",
       .type = texts,
       .meaning = "The metrics that are looked at.",
       .use = use,
       .required = true,
       .study_field = study_table<at, &S::metrics>},
      {.path = "sensitivity.samples",
       .type = integer,
       .meaning =
           "sobol: base samples, runs are samples x (keys + 2); morris: trajectories, runs are samples x (keys + "
           "1).",
       .range = {2.0, false, 1'000'000.0, false},
       .use = use,
       .study_field = study_table<at, &S::samples>},
      {.path = "sensitivity.levels",
       .type = integer,
       .meaning =
           "Levels of Morris' grid; keys that change the factored matrix take this many values in either method.",
       .range = {4.0, false, 64.0, false},
       .use = use,
       .note = "even",
       .study_field = study_table<at, &S::levels>},
      {.path = "sensitivity.bootstrap",
       .type = integer,
       .meaning = "Replicates of the bootstrap intervals.",
       .range = {10.0, false, 100'000.0, false},
       .use = use,
       .study_field = study_table<at, &S::bootstrap>},
      {.path = "sensitivity.confidence",
       .type = number,
       .meaning = "Of the intervals.",
       .range = {0.5, false, 0.9999, false},
       .use = use,
       .study_field = study_table<at, &S::confidence>},
  };
}

Table lattice_keys() {
  using L = LatticeParameters;
  const Use use = Use::lattice;
  return {
      {.path = "product.use",
       .type = text,
       .meaning = "A product file, relative to this file's folder or to the configs folder; keys given here "
                  "override it."},
      {.path = "product.kind",
       .type = choice,
       .meaning = "A solid filled with a lattice, or particles and springs written out.",
       .choices = {"lattice", "network"}},
      {.path = "product.shape",
       .type = choice,
       .meaning = "True shape of the product.",
       .choices = {"box", "sphere", "ellipsoid", "cylinder"},
       .use = use,
       .required = true,
       .field = lattice<&L::shape>},
      {.path = "product.size_m",
       .type = numbers,
       .meaning = "Full extents along x (grip axis), y and z (up).",
       .size = 3,
       .use = use,
       .required = true,
       .field = lattice<&L::size_m>},
      {.path = "product.axis",
       .type = choice,
       .meaning = "Axis of a cylinder.",
       .choices = {"x", "y", "z"},
       .use = Use::cylinder,
       .field = lattice<&L::axis>},
      {.path = "product.cell_size_m",
       .type = number,
       .meaning = "Wanted side of a lattice cell.",
       .use = use,
       .field = lattice<&L::cell_size_m>},
      {.path = "product.mass_kg",
       .type = optional_number,
       .meaning = "Mass of the product.",
       .use = use,
       .field = lattice<&L::mass_kg>},
      {.path = "product.density_kg_m3",
       .type = optional_number,
       .meaning = "Density; times the volume of the true shape it is the mass.",
       .use = use,
       .field = lattice<&L::density_kg_m3>},
      {.path = "product.youngs_modulus_Pa",
       .type = number,
       .meaning = "Young's modulus.",
       .use = use,
       .required = true,
       .field = lattice<&L::youngs_modulus_Pa>},
      {.path = "product.poisson_ratio",
       .type = number,
       .meaning = "Poisson's ratio.",
       .use = use,
       .field = lattice<&L::poisson_ratio>},
      {.path = "product.yield_stress_Pa",
       .type = optional_number,
       .meaning = "Yield stress in uniaxial compression; without it the product stays elastic.",
       .use = use,
       .field = lattice<&L::yield_stress_Pa>},
      {.path = "product.tangent_modulus_Pa",
       .type = optional_number,
       .meaning = "Slope of the stress-strain curve after yield.",
       .use = use,
       .field = lattice<&L::tangent_modulus_Pa>},
      {.path = "product.relaxation_time_s",
       .type = optional_number,
       .meaning = "Stiffness-proportional damping, C = relaxation_time_s K; 0: none, the product vibrates for "
                  "ever. Where no key of damping is given, loss_ratio and at_frequency_Hz have their defaults.",
       .use = use,
       .field = lattice<&L::relaxation_time_s>},
      {.path = "product.loss_ratio",
       .type = optional_number,
       .meaning = "The same damping as the loss factor at one frequency: relaxation time = loss_ratio / (2 pi "
                  "at_frequency_Hz). The default is an assumption for fruit.",
       .use = use,
       .field = lattice<&L::loss_ratio>},
      {.path = "product.at_frequency_Hz",
       .type = optional_number,
       .meaning = "The frequency at which loss_ratio holds.",
       .use = use,
       .field = lattice<&L::at_frequency_Hz>},
      {.path = "product.friction",
       .type = number,
       .meaning = "Coulomb coefficient against the pads.",
       .field = product_friction},
      {.path = "product.initial_velocity_m_s",
       .type = numbers,
       .meaning = "Velocity of the product at the start.",
       .size = 3,
       .use = use,
       .field = lattice<&L::initial_velocity_m_s>},
  };
}

Table particle_keys() {
  using P = NetworkParticle;
  const Use use = Use::network;
  return {
      {.path = "product.particles_csv",
       .type = text,
       .meaning = "CSV file with one particle per row, in place of [[product.particle]].",
       .use = use},
      {.path = "product.springs_csv",
       .type = text,
       .meaning = "CSV file with one spring per row, in place of [[product.spring]].",
       .use = use},
      {.path = "product.particle[].position_m",
       .type = numbers,
       .meaning = "Place in the rest shape.",
       .size = 3,
       .use = use,
       .required = true,
       .field = particle<&P::position_m>},
      {.path = "product.particle[].mass_kg",
       .type = number,
       .meaning = "Mass of the particle.",
       .use = use,
       .field = particle<&P::mass_kg>},
      {.path = "product.particle[].fixed",
       .type = axes,
       .meaning = "Freedoms that do not move.",
       .use = use,
       .field = particle<&P::fixed>},
      {.path = "product.particle[].initial_displacement_m",
       .type = numbers,
       .meaning = "Displacement from the rest shape at the start.",
       .size = 3,
       .use = use,
       .field = particle<&P::initial_displacement_m>},
      {.path = "product.particle[].initial_velocity_m_s",
       .type = numbers,
       .meaning = "Velocity at the start.",
       .size = 3,
       .use = use,
       .field = particle<&P::initial_velocity_m_s>},
      {.path = "product.particle[].contact_stiffness_N_m",
       .type = number,
       .meaning = "Stiffness of the layer through which the particle touches the support; 0: it does not.",
       .use = Use::network_support,
       .field = particle<&P::contact_stiffness_N_m>},
  };
}

Table spring_and_load_keys() {
  using S = NetworkSpring;
  using P = NetworkLoad;
  const Use use = Use::network;
  return {
      {.path = "product.spring[].between",
       .type = integers,
       .meaning = "The two particles it joins, counted from 0 in file order.",
       .size = 2,
       .use = use,
       .required = true,
       .field = spring<&S::between>},
      {.path = "product.spring[].stiffness_N_m",
       .type = number,
       .meaning = "Stiffness along the line between its particles in the rest shape.",
       .use = use,
       .field = spring<&S::stiffness_N_m>},
      {.path = "product.spring[].damping_N_s_m",
       .type = number,
       .meaning = "Viscous damping along the same line.",
       .use = use,
       .field = spring<&S::damping_N_s_m>},
      {.path = "product.spring[].rest_length_m",
       .type = optional_number,
       .meaning = "Length without force; without it the distance of the particles.",
       .use = use,
       .field = spring<&S::rest_length_m>},
      {.path = "product.spring[].yield_force_N",
       .type = optional_number,
       .meaning = "Size of the force at first yield; without it the spring stays elastic.",
       .use = use,
       .field = spring<&S::yield_force_N>},
      {.path = "product.spring[].hardening_ratio",
       .type = number,
       .meaning = "The yield force grows by hardening_ratio x stiffness x plastic elongation.",
       .use = use,
       .field = spring<&S::hardening_ratio>},
      {.path = "product.load[].particle",
       .type = integer,
       .meaning = "The particle the force acts on.",
       .use = use,
       .required = true,
       .field = load<&P::particle>},
      {.path = "product.load[].time_s",
       .type = series,
       .meaning = "Times of the points of the force.",
       .use = use,
       .required = true,
       .note = "not decreasing; a repeated time is a jump",
       .field = load<&P::time_s>},
      {.path = "product.load[].force_N",
       .type = vector_series,
       .meaning = "The force [x, y, z] at those times; linear between them, constant outside.",
       .use = use,
       .required = true,
       .field = load<&P::force_N>},
  };
}

Table gripper_keys() {
  using G = GripperParameters;
  const Use use = Use::gripper;
  return {
      {.path = "gripper.use",
       .type = text,
       .meaning = "A gripper file, relative to this file's folder or to the configs folder; keys given here "
                  "override it."},
      {.path = "gripper.finger_mass_kg",
       .type = number,
       .meaning = "Moving mass of each finger.",
       .use = use,
       .field = gripper<&G::finger_mass_kg>},
      {.path = "gripper.stroke_m",
       .type = number,
       .meaning = "How far each finger can travel inwards from its starting place; it comes to rest against a "
                  "stop there.",
       .use = use,
       .field = gripper<&G::stroke_m>},
      {.path = "gripper.pad_size_m",
       .type = numbers,
       .meaning = "Extents of a pad along y and z.",
       .size = 2,
       .use = use,
       .field = gripper<&G::pad_size_m>},
      {.path = "gripper.pad_thickness_m",
       .type = number,
       .meaning = "Thickness of the pad's compliant layer.",
       .use = use,
       .field = gripper<&G::pad_thickness_m>},
      {.path = "gripper.pad_modulus_Pa",
       .type = number,
       .meaning = "Young's modulus of the layer; its stiffness per area is modulus / thickness.",
       .use = use,
       .field = gripper<&G::pad_modulus_Pa>},
      {.path = "gripper.pad_relaxation_time_s",
       .type = number,
       .meaning = "Kelvin-Voigt relaxation time of the layer; 0: it bounces for ever. The default is a loss "
                  "ratio of 0.2 at 50 Hz: rubber loses 0.1 to 0.3.",
       .use = use,
       .field = gripper<&G::pad_relaxation_time_s>},
      {.path = "gripper.drive_gain_N_s_m",
       .type = number,
       .meaning = "Speed gain: drive force = clamp(gain x (wanted - actual speed), +-limit).",
       .use = use,
       .field = gripper<&G::drive_gain_N_s_m>},
      {.path = "gripper.drive_viscous_N_s_m",
       .type = number,
       .meaning = "Viscous friction of the finger's guide.",
       .use = use,
       .field = gripper<&G::drive_viscous_N_s_m>},
      {.path = "gripper.max_force_N",
       .type = number,
       .meaning = "The largest force the drive can give.",
       .use = use,
       .field = gripper<&G::max_force_N>},
      {.path = "gripper.max_speed_m_s",
       .type = number,
       .meaning = "The largest finger speed the drive can give.",
       .use = use,
       .field = gripper<&G::max_speed_m_s>},
      {.path = "gripper.coupling",
       .type = choice,
       .meaning = "Do both fingers stay at equal distance from the palm's centre, or is each driven alone?",
       .choices = {"centric", "independent"},
       .use = use,
       .field = gripper<&G::coupling>},
      {.path = "gripper.min_force_N",
       .type = number,
       .meaning = "The least force the drive holds: no window or set-point lies below it.",
       .use = use,
       .field = gripper<&G::min_force_N>},
      {.path = "gripper.force_accuracy",
       .type = number,
       .meaning =
           "How far the force that acts may lie from the one that is set, relative (0.1: 10 %); set-points leave "
           "room for it.",
       .use = use,
       .field = gripper<&G::force_accuracy>},
      {.path = "gripper.force_step_N",
       .type = number,
       .meaning = "Forces that can be set are multiples of it; 0: any force.",
       .use = use,
       .field = gripper<&G::force_step_N>},
      {.path = "gripper.opening_m",
       .type = optional_number,
       .meaning = "Distance of the pad faces when the gripper is open.",
       .use = use,
       .note = "absent: as wide as the product and the approach gaps need",
       .field = gripper<&G::opening_m>},
  };
}

Table cell_keys() {
  using C = CellParameters;
  const Use use = Use::gripper;
  return {
      {.path = "cell.gravity_m_s2",
       .type = numbers,
       .meaning = "Gravity as a vector.",
       .size = 3,
       .field = cell<&C::gravity_m_s2>},
      {.path = "cell.support",
       .type = boolean,
       .meaning = "Is there a support plane z = 0?",
       .note = "default for networks: false",
       .field = cell<&C::support>},
      {.path = "cell.support_friction",
       .type = number,
       .meaning = "Coulomb coefficient against the support.",
       .use = Use::support,
       .field = cell<&C::support_friction>},
      {.path = "cell.support_modulus_Pa",
       .type = number,
       .meaning = "Young's modulus of the support's compliant layer.",
       .use = Use::lattice_support,
       .field = cell<&C::support_modulus_Pa>},
      {.path = "cell.support_thickness_m",
       .type = number,
       .meaning = "Thickness of that layer.",
       .use = Use::lattice_support,
       .field = cell<&C::support_thickness_m>},
      {.path = "cell.support_relaxation_time_s",
       .type = number,
       .meaning = "Relaxation time of that layer; 0: it bounces for ever. The default is a loss ratio of 0.2 at "
                  "50 Hz; under a network it is 0.",
       .use = Use::support,
       .field = cell<&C::support_relaxation_time_s>},
      {.path = "cell.approach_gap_m",
       .type = optional_number,
       .meaning = "Way from each pad to the nearest point of the product at the start.",
       .use = use,
       .note = "absent: what gripper.opening_m leaves on either side of the product, without an opening 0.005",
       .field = cell<&C::approach_gap_m>},
      {.path = "cell.grip_height_m",
       .type = number,
       .meaning = "Height of the pads' centres above the product's centre.",
       .use = use,
       .field = cell<&C::grip_height_m>},
      {.path = "cell.grip_offset_m",
       .type = number,
       .meaning = "Offset of the pads' centres from the product's centre along y, across the grip axis.",
       .use = use,
       .field = cell<&C::grip_offset_m>},
      {.path = "cell.lift_height_m",
       .type = number,
       .meaning = "Height of the lift; 0: none.",
       .use = use,
       .field = cell<&C::lift_height_m>},
      {.path = "cell.transfer_m",
       .type = numbers,
       .meaning = "Horizontal way along x (the grip axis) and y (across it).",
       .size = 2,
       .use = use,
       .field = cell<&C::transfer_m>},
      {.path = "cell.place_height_m",
       .type = number,
       .meaning = "Height of the target plane above the support.",
       .use = use,
       .field = cell<&C::place_height_m>},
  };
}

Table strategy_keys() {
  using S = StrategyParameters;
  const Use use = Use::gripper;
  return {
      {.path = "strategy.approach_speed_m_s",
       .type = number,
       .meaning = "Closing speed of each finger.",
       .use = use,
       .field = strategy<&S::approach_speed_m_s>},
      {.path = "strategy.grip_force_N",
       .type = number,
       .meaning = "Drive force limit of each finger, so its normal force at rest.",
       .use = Use::not_window,
       .note = "a window study searches it",
       .field = strategy<&S::grip_force_N>},
      {.path = "strategy.contact_force_N",
       .type = number,
       .meaning = "Drive force limit before the first contact.",
       .use = use,
       .note = "of a window study window.from_N; lowered to it where not written",
       .field = strategy<&S::contact_force_N>},
      {.path = "strategy.grip_ramp_s",
       .type = number,
       .meaning = "Time in which the limit rises linearly to grip_force_N, from the first contact.",
       .use = use,
       .field = strategy<&S::grip_ramp_s>},
      {.path = "strategy.ramp_from_start",
       .type = boolean,
       .meaning = "Does the ramp start at t = 0 instead of at the first contact?",
       .use = use,
       .field = strategy<&S::ramp_from_start>},
      {.path = "strategy.settle_s",
       .type = number,
       .meaning = "Rest after the ramp, before the lift.",
       .use = use,
       .field = strategy<&S::settle_s>},
      {.path = "strategy.profile",
       .type = choice,
       .meaning = "Motion profile of lift, transfer and lowering.",
       .choices = {"trapezoid", "minimum_jerk"},
       .use = use,
       .field = strategy<&S::profile>},
      {.path = "strategy.lift_acceleration_m_s2",
       .type = number,
       .meaning = "Peak acceleration of the lift's profile.",
       .use = use,
       .field = strategy<&S::lift_acceleration_m_s2>},
      {.path = "strategy.transfer_acceleration_m_s2",
       .type = optional_number,
       .meaning = "Peak acceleration of the transfer; without it the lift's.",
       .use = use,
       .field = strategy<&S::transfer_acceleration_m_s2>},
      {.path = "strategy.lower_acceleration_m_s2",
       .type = optional_number,
       .meaning = "Peak acceleration of the lowering; without it the lift's.",
       .use = use,
       .field = strategy<&S::lower_acceleration_m_s2>},
      {.path = "strategy.speed_m_s",
       .type = number,
       .meaning = "Speed limit of every phase of the path.",
       .use = use,
       .field = strategy<&S::speed_m_s>},
      {.path = "strategy.hold_s",
       .type = number,
       .meaning = "Rest after the lift.",
       .use = use,
       .field = strategy<&S::hold_s>},
      {.path = "strategy.release_height_m",
       .type = number,
       .meaning = "Height above the target plane at which the fingers open.",
       .use = use,
       .field = strategy<&S::release_height_m>},
      {.path = "strategy.place_settle_s",
       .type = number,
       .meaning = "Rest after lowering, before the fingers open.",
       .use = use,
       .field = strategy<&S::place_settle_s>},
      {.path = "strategy.release_speed_m_s",
       .type = number,
       .meaning = "Opening speed of each finger.",
       .use = use,
       .field = strategy<&S::release_speed_m_s>},
      {.path = "strategy.recover_s",
       .type = number,
       .meaning = "Time without gripper contact before the permanent set is measured.",
       .use = use,
       .field = strategy<&S::recover_s>},
  };
}

Table limit_keys() {
  using M = LimitParameters;
  const Use use = Use::gripper;
  return {
      {.path = "limits.damage",
       .type = choice,
       .meaning = "Is damage judged by the limits below, or deliberately not looked at?",
       .choices = {"judged", "not considered"},
       .note = "\"not considered\" has to be written where no limit can act, for every kind that judges damage",
       .field = limits<&M::damage>},
      {.path = "limits.permanent_set_m",
       .type = optional_number,
       .meaning = "Damage: largest permanent_set_max_m.",
       .field = limits<&M::permanent_set_m>},
      {.path = "limits.plastic_strain",
       .type = optional_number,
       .meaning = "Damage: largest plastic_strain_max; also the strain from which a cell counts as bruised.",
       .field = limits<&M::plastic_strain>},
      {.path = "limits.bruised_volume_m3",
       .type = optional_number,
       .meaning = "Damage: largest bruised_volume_m3.",
       .use = Use::lattice,
       .field = limits<&M::bruised_volume_m3>},
      {.path = "limits.peak_pressure_Pa",
       .type = optional_number,
       .meaning = "Damage: largest peak_pressure_Pa.",
       .use = Use::lattice,
       .field = limits<&M::peak_pressure_Pa>},
      {.path = "limits.absorbed_energy_J",
       .type = optional_number,
       .meaning = "Damage: largest absorbed_energy_J.",
       .field = limits<&M::absorbed_energy_J>},
      {.path = "limits.finger_force_N",
       .type = optional_number,
       .meaning = "Damage: largest peak_finger_force_N; for products with nothing but a measured force.",
       .use = use,
       .field = limits<&M::finger_force_N>},
      {.path = "limits.contact_yield_ratio",
       .type = optional_number,
       .meaning = "Damage: largest contact_yield_ratio_max (1: first yield under the contact).",
       .use = use,
       .field = limits<&M::contact_yield_ratio>},
      {.path = "limits.slip_m",
       .type = number,
       .meaning = "A longer slip_max_m makes the outcome 'slipped'.",
       .use = use,
       .field = limits<&M::slip_m>},
  };
}

Table simulation_keys() {
  using S = SimulationParameters;
  return {
      {.path = "simulation.time_step_s",
       .type = number,
       .meaning = "Time step. Where it is not given, one is chosen for the whole study: 20 steps in the shortest "
                  "contact that any scenario may have, rounded down to two digits, 0.1 ms to 1 ms.",
       .default_words = "chosen by the shortest contact",
       .field = simulation<&S::time_step_s>},
      {.path = "simulation.theta",
       .type = number,
       .meaning = "Wilson's theta; from 1.37 on the method is stable for every step.",
       .field = simulation<&S::theta>},
      {.path = "simulation.duration_s",
       .type = optional_number,
       .meaning = "Length of the run; with a gripper its phases fix it.",
       .use = Use::not_gripper,
       .field = simulation<&S::duration_s>},
      {.path = "simulation.initial_acceleration",
       .type = choice,
       .meaning = "Acceleration at the start of a network: from the equations of motion, or zero.",
       .choices = {"consistent", "zero"},
       .use = Use::network,
       .field = simulation<&S::initial_acceleration>},
      {.path = "simulation.trace_interval_s",
       .type = optional_number,
       .meaning = "Wanted time between rows of the trace; without it every step.",
       .field = simulation<&S::trace_interval_s>},
      {.path = "simulation.pressure_patch_m",
       .type = number,
       .meaning = "Side of the square patch over which peak_pressure_Pa averages.",
       .use = Use::lattice,
       .field = simulation<&S::pressure_patch_m>},
      {.path = "simulation.max_strain",
       .type = number,
       .meaning = "A larger principal strain of a cell ends the run as out_of_range.",
       .use = Use::lattice,
       .field = simulation<&S::max_strain>},
      {.path = "simulation.max_rotation_rad",
       .type = number,
       .meaning = "A larger rotation of the product ends the run as out_of_range.",
       .use = Use::lattice,
       .field = simulation<&S::max_rotation_rad>},
  };
}

Table vary_keys() {
  return {
      {.path = "vary[].key",
       .type = text,
       .meaning = "The key that takes several values.",
       .required = true,
       .vary_field = vary<&VaryBlock::key>},
      {.path = "vary[].from",
       .type = optional_number,
       .meaning = "First value, in the key's unit.",
       .note = "with to and count, or values instead",
       .vary_field = vary<&VaryBlock::from>},
      {.path = "vary[].to",
       .type = optional_number,
       .meaning = "Last value, in the key's unit.",
       .note = "with from and count",
       .vary_field = vary<&VaryBlock::to>},
      {.path = "vary[].count",
       .type = integer,
       .meaning = "Number of values, both ends included.",
       .range = kCountRange,
       .note = "with from and to",
       .vary_field = vary<&VaryBlock::count>},
      {.path = "vary[].scale",
       .type = choice,
       .meaning = "Equal steps, or equal ratios.",
       .choices = {"linear", "log"},
       .note = "log needs from > 0 and to > 0",
       .vary_field = vary<&VaryBlock::scale>},
      {.path = "vary[].values",
       .type = any_array,
       .meaning = "The values themselves: numbers, strings or booleans.",
       .note = "instead of from, to, count"},
      {.path = "vary[].zip",
       .type = text,
       .meaning = "Blocks with the same word vary together, at the place of the first of them.",
       .note = "equal numbers of values",
       .vary_field = vary<&VaryBlock::zip>},
  };
}

Table variable_keys() {
  using B = VariableBlock;
  const Use use = Use::search;
  return {
      {.path = "variable[].key",
       .type = text,
       .meaning = "The numeric key that is searched.",
       .use = use,
       .required = true,
       .block_field = variable<&B::key>},
      {.path = "variable[].from",
       .type = optional_number,
       .meaning = "Least value, in the key's unit.",
       .use = use,
       .required = true,
       .note = "< to",
       .block_field = variable<&B::from>},
      {.path = "variable[].to",
       .type = optional_number,
       .meaning = "Largest value, in the key's unit.",
       .use = use,
       .required = true,
       .block_field = variable<&B::to>},
      {.path = "variable[].scale",
       .type = choice,
       .meaning = "Searched evenly, or evenly in the logarithm.",
       .choices = {"linear", "log"},
       .use = use,
       .note = "log needs from > 0",
       .block_field = variable<&B::scale>},
      {.path = "variable[].start",
       .type = optional_number,
       .meaning = "Where the first search starts.",
       .use = use,
       .note = "from <= start <= to; the middle unless given",
       .block_field = variable<&B::start>},
  };
}

Table random_keys() {
  using B = RandomBlock;
  const Use use = Use::random;
  return {
      {.path = "random[].key",
       .type = text,
       .meaning = "The numeric key that is drawn, or whose value is missed by a drawn error (relative, absolute).",
       .use = use,
       .required = true,
       .block_field = random<&B::key>},
      {.path = "random[].distribution",
       .type = choice,
       .meaning = "Its distribution; of an error uniform unless given.",
       .choices = {"uniform", "normal", "lognormal", "triangular"},
       .use = use,
       .note = "required without relative and absolute",
       .block_field = random<&B::distribution>},
      {.path = "random[].mean",
       .type = optional_number,
       .meaning = "Mean of the key itself (also of a lognormal).",
       .use = use,
       .note = "normal, lognormal",
       .block_field = random<&B::mean>},
      {.path = "random[].standard_deviation",
       .type = optional_number,
       .meaning = "Standard deviation of the key itself.",
       .range = kNotNegative,
       .use = use,
       .note = "normal, lognormal; this or relative_deviation",
       .block_field = random<&B::standard_deviation>},
      {.path = "random[].relative_deviation",
       .type = optional_number,
       .meaning = "Standard deviation over mean.",
       .range = kNotNegative,
       .use = use,
       .note = "normal, lognormal",
       .block_field = random<&B::relative_deviation>},
      {.path = "random[].data",
       .type = series,
       .meaning = "Measured values that give mean and standard deviation.",
       .use = use,
       .note = "normal, lognormal; at least 3; instead of mean and deviation",
       .block_field = random<&B::data>},
      {.path = "random[].from",
       .type = optional_number,
       .meaning = "Least value.",
       .use = use,
       .note = "uniform, triangular; < to",
       .block_field = random<&B::from>},
      {.path = "random[].to",
       .type = optional_number,
       .meaning = "Largest value.",
       .use = use,
       .note = "uniform, triangular",
       .block_field = random<&B::to>},
      {.path = "random[].mode",
       .type = optional_number,
       .meaning = "Likeliest value.",
       .use = use,
       .note = "triangular; from <= mode <= to",
       .block_field = random<&B::mode>},
      {.path = "random[].at_least",
       .type = optional_number,
       .meaning = "Smaller values are cut off.",
       .use = use,
       .note = "< at_most",
       .block_field = random<&B::at_least>},
      {.path = "random[].at_most",
       .type = optional_number,
       .meaning = "Larger values are cut off.",
       .use = use,
       .block_field = random<&B::at_most>},
      {.path = "random[].relative",
       .type = optional_number,
       .meaning =
           "An execution error around the value that is searched, a candidate's own or written: value x (1 + "
           "error), the error within +- this; normal: half of it is the standard deviation.",
       .range = {0.0, true, 1.0, true},
       .use = use,
       .note = "keys of [strategy] and [cell]; alone, or with distribution",
       .block_field = random<&B::relative>},
      {.path = "random[].absolute",
       .type = optional_number,
       .meaning = "The same in the unit of the key: value + error.",
       .range = kPositive,
       .use = use,
       .note = "keys of [strategy] and [cell]; alone, or with distribution",
       .block_field = random<&B::absolute>},
  };
}

Table candidate_keys() {
  using B = CandidateBlock;
  const Use use = Use::compare;
  return {
      {.path = "candidate[].name",
       .type = text,
       .meaning = "What the strategy is called. Beside name and use a candidate has the keys of [strategy].",
       .use = use,
       .required = true,
       .note = "1 to 64 letters, digits, '_' or '-'; all different",
       .block_field = candidate<&B::name>},
      {.path = "candidate[].use",
       .type = text,
       .meaning =
           "A strategy file, relative to this file's folder or to the configs folder; keys given here override "
           "it.",
       .use = use,
       .block_field = candidate<&B::use>},
  };
}

/// Ranges and rules of a scenario's keys come from core.
void add_rules_of_core(KeySpec& spec) {
  if (const NumberField* field = find_number_field(spec.path)) spec.range = field->range;
  std::string rules;
  const auto add = [&](std::string_view sentence) {
    if (!sentence.empty()) rules += (rules.empty() ? "" : "; ") + std::string(sentence);
  };
  for (const Rule& rule : scenario_rules()) {
    if (rule.fields.front() == spec.path) add(rule.sentence);
    if (rule.fields.size() > 1 && rule.fields[1] == spec.path) add(rule.of_second);
  }
  add(spec.note);
  spec.note = rules;
}

}  // namespace

const std::vector<KeySpec>& key_table() {
  static const std::vector<KeySpec> table = [] {
    std::vector<KeySpec> all;
    for (const Table& part :
         {study_keys(), search_keys(), sampling_keys(), compare_keys(), sensitivity_keys(), lattice_keys(),
          particle_keys(), spring_and_load_keys(), gripper_keys(), cell_keys(), strategy_keys(), limit_keys(),
          simulation_keys(), vary_keys(), variable_keys(), random_keys(), candidate_keys()}) {
      all.insert(all.end(), part.begin(), part.end());
    }
    for (KeySpec& spec : all) {
      if (spec.field != nullptr) add_rules_of_core(spec);
    }
    return all;
  }();
  return table;
}

}  // namespace unbruised::studies

#pragma once

/// @file
/// Small scenes and ways to run them, for the tests of the simulator's physics.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/simulation/simulation.hpp"

namespace unbruised::testing {

inline constexpr double kGravity = 9.80665;

inline std::shared_ptr<const Model> build(const Scenario& scenario) {
  for (const Violation& violation : validate(scenario)) {
    ADD_FAILURE() << violation.field << ": " << violation.rule;
  }
  std::string error;
  auto model = Model::build(scenario, error);
  EXPECT_NE(model, nullptr) << error;
  return model;
}

inline ScenarioResult run(const Scenario& scenario, Trace* trace = nullptr) {
  return simulate(build(scenario), scenario, trace);
}

/// Runs scenarios of one factor key side by side; as many as there are lanes at most.
/// @param traces one for each, where not null
inline std::vector<ScenarioResult> run_side_by_side(const std::vector<Scenario>& scenarios,
                                                    std::vector<Trace>* traces = nullptr) {
  LevelSimulation simulation(build(scenarios.front()));
  if (traces != nullptr) traces->resize(scenarios.size());
  for (std::size_t i = 0; i < scenarios.size(); ++i) {
    EXPECT_EQ(factor_key(scenarios[i]), factor_key(scenarios.front()));
    simulation.load(static_cast<int>(i), scenarios[i]);
    if (traces != nullptr) simulation.record(static_cast<int>(i), &(*traces)[i]);
  }
  std::vector<ScenarioResult> results(scenarios.size());
  for (std::size_t left = scenarios.size(); left > 0; left -= simulation.finished().size()) {
    simulation.step();
    for (const auto& finished : simulation.finished()) {
      results[static_cast<std::size_t>(finished.place)] = finished.result;
    }
  }
  return results;
}

/// The traces of the same.
inline std::vector<Trace> traces_of(const std::vector<Scenario>& scenarios) {
  std::vector<Trace> traces;
  run_side_by_side(scenarios, &traces);
  return traces;
}

inline const TraceSignal& signal(const Trace& trace, const std::string& name) {
  for (const TraceSignal& candidate : trace.signals) {
    if (candidate.name == name) return candidate;
  }
  ADD_FAILURE() << "no signal " << name;
  return trace.signals.front();
}

/// Values per row of a signal.
inline std::size_t width(const TraceSignal& signal) {
  std::size_t size = 1;
  for (int extent : signal.extents) size *= static_cast<std::size_t>(extent);
  return size;
}

/// One column of a signal over time.
inline std::vector<double> column(const Trace& trace, const std::string& name, std::size_t at = 0) {
  const TraceSignal& from = signal(trace, name);
  std::vector<double> values;
  for (std::size_t i = at; i < from.values.size(); i += width(from)) values.push_back(from.values[i]);
  return values;
}

/// Displacement of one freedom (3 x particle + axis) over time.
inline std::vector<double> freedom(const Trace& trace, const std::vector<double>& rows, std::size_t at) {
  std::vector<double> values;
  for (std::size_t i = at; i < rows.size(); i += 3 * static_cast<std::size_t>(trace.particle_count)) {
    values.push_back(rows[i]);
  }
  return values;
}

inline double largest(const std::vector<double>& values) {
  double result = -HUGE_VAL;
  for (double value : values) result = std::max(result, value);
  return result;
}

inline bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

/// Every metric, the outcome, its cause and its time, bit by bit.
inline void expect_same_bits(const ScenarioResult& a, const ScenarioResult& b, const std::string& where) {
  EXPECT_EQ(a.outcome, b.outcome) << where;
  EXPECT_EQ(a.cause, b.cause) << where;
  EXPECT_TRUE(same_bits(a.outcome_time_s, b.outcome_time_s)) << where;
  for (const MetricInfo& info : kMetricTable) {
    EXPECT_TRUE(same_bits(a.metrics[info.metric], b.metrics[info.metric]))
        << where << ": " << info.name << " " << a.metrics[info.metric] << " and " << b.metrics[info.metric];
  }
}

/// A soft cube of 2 cm and 8 g between two fingers; the whole cycle takes about 1.5 s.
inline Scenario small_box() {
  Scenario scenario;
  LatticeParameters product;
  product.shape = Shape::box;
  product.size_m = {0.02, 0.02, 0.02};
  product.cell_size_m = 0.01;
  product.density_kg_m3 = 1000.0;
  product.youngs_modulus_Pa = 1e5;
  product.relaxation_time_s = 2e-3;
  product.friction = 0.5;
  scenario.product = product;
  ParallelJawParameters gripper;
  gripper.pad_size_m = {0.03, 0.03};
  scenario.gripper = gripper;
  scenario.cell.approach_gap_m = 0.002;
  scenario.cell.lift_height_m = 0.02;
  scenario.cell.transfer_m = {0.0, 0.05};
  scenario.strategy.approach_speed_m_s = 0.05;
  scenario.strategy.grip_force_N = 0.3;
  scenario.strategy.contact_force_N = 0.1;
  scenario.strategy.grip_ramp_s = 0.05;
  scenario.strategy.settle_s = 0.1;
  scenario.strategy.recover_s = 0.1;
  scenario.simulation.time_step_s = 1e-3;
  scenario.simulation.levels = LevelUse::off;  // a row of the trace for each; levels: level_simulation_test
  return scenario;
}

/// The same, gripped so that it slides in the pads.
inline Scenario slipping_box() {
  Scenario scenario = small_box();
  scenario.strategy.grip_force_N = 0.12;
  return scenario;
}

inline LatticeParameters& lattice_of(Scenario& scenario) { return std::get<LatticeParameters>(scenario.product); }

/// More than any small product has.
inline constexpr int kAllModes = 2000;

inline Scenario by_modes(Scenario scenario, int count) {
  scenario.simulation.body = ProductBody::modes;
  scenario.simulation.mode_count = count;
  return scenario;
}

/// Makes the product a solid of this size, cell, mass and stiffness.
inline LatticeParameters& make_product(Scenario& scenario, const std::array<double, 3>& size_m, double cell_size_m,
                                       double mass_kg, double youngs_modulus_Pa) {
  LatticeParameters& product = lattice_of(scenario);
  product.size_m = size_m;
  product.cell_size_m = cell_size_m;
  product.density_kg_m3.reset();
  product.mass_kg = mass_kg;
  product.youngs_modulus_Pa = youngs_modulus_Pa;
  return product;
}

/// Leaves only the fingers to touch the product, and nothing that carries it away.
inline void only_grip(Scenario& scenario) {
  scenario.cell.gravity_m_s2 = {0.0, 0.0, 0.0};
  scenario.cell.support = false;
  scenario.cell.lift_height_m = 0.0;
  scenario.cell.transfer_m = {0.0, 0.0};
}

/// A slippery post of 16 cm and 1 kg: pads that are lifted 4 cm slide up along it while it stays where it stands.
inline Scenario standing_post(double place_height_m) {
  Scenario scenario = small_box();
  make_product(scenario, {0.05, 0.05, 0.16}, 0.025, 1.0, 1e6).friction = 0.05;
  scenario.cell.grip_height_m = -0.04;
  scenario.cell.lift_height_m = 0.04;
  scenario.cell.place_height_m = place_height_m;
  scenario.cell.transfer_m = {0.0, 0.0};
  scenario.strategy.grip_force_N = 2.0;
  scenario.strategy.hold_s = 0.1;
  scenario.strategy.recover_s = 0.0;
  return scenario;
}

/// A single freedom along x: a particle on a spring to a wall.
inline Scenario oscillator(double mass_kg, double stiffness_N_m, double time_step_s, int steps) {
  Scenario scenario;
  NetworkParameters network;
  NetworkParticle wall;
  wall.fixed = {true, true, true};
  NetworkParticle particle;
  particle.position_m = {1.0, 0.0, 0.0};
  particle.mass_kg = mass_kg;
  particle.fixed = {false, true, true};
  NetworkSpring spring;
  spring.between = {0, 1};
  spring.stiffness_N_m = stiffness_N_m;
  network.particle = {wall, particle};
  network.spring = {spring};
  scenario.product = network;
  scenario.cell.gravity_m_s2 = {0.0, 0.0, 0.0};
  scenario.cell.support = false;
  scenario.simulation.time_step_s = time_step_s;
  scenario.simulation.duration_s = steps * time_step_s;
  return scenario;
}

inline NetworkParameters& network_of(Scenario& scenario) { return std::get<NetworkParameters>(scenario.product); }

}  // namespace unbruised::testing

// The one table of rules: every rule is broken by a scenario of its own, and looks at the fields it names only.

#include "core/scenario/rules.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <set>

#include <gtest/gtest.h>

#include "core/scenario/lattice_cells.hpp"
#include "tests/core/scenario/meshes.hpp"
#include "tests/core/scenario/scenarios.hpp"

namespace unbruised {
namespace {

using namespace testing;

/// A change of a sound scenario, and whom the broken rule blames.
struct Breach {
  const char* field;
  const char* rule;  ///< how the sentence starts
  Scenario (*scene)();
  void (*change)(Scenario&);
};

using S = Scenario&;

void make_revolution(S s) {
  lattice_in(s).shape = Shape::revolution;
  lattice_in(s).profile_height = {0.0, 1.0, 3.0, 4.0};
  lattice_in(s).profile_radius = {0.0, 1.5, 1.5, 0.0};
}

/// Two ends and a neck that is thinner than a cell.
TriangleMesh dumbbell() {
  return moved(icosphere(3), [](const std::array<double, 3>& p) {
    const double wide = 0.04 + p[0] * p[0];
    return std::array{p[0], wide * p[1], wide * p[2]};
  });
}

std::vector<Breach> lattice_breaches() {
  return {
      {"product.shape", "needs product.mesh_file", usual_grip, [](S s) { lattice_in(s).shape = Shape::mesh; }},
      {"product.cell_size_m", "must be smaller: the product's cells fall into 2 pieces", usual_grip,
       [](S s) {
         lattice_in(s).shape = Shape::mesh;
         lattice_in(s).size_m = {0.05, 0.05, 0.05};
         lattice_in(s).cell_size_m = 0.005;
         lattice_in(s).mesh = mesh_product(dumbbell(), {}).mesh;
       }},
      {"product.size_m", "a sphere has three equal", usual_grip,
       [](S s) {
         lattice_in(s).shape = Shape::sphere;
         lattice_in(s).size_m = {0.05, 0.05, 0.06};
       }},
      {"product.profile_height", "missing; shape = \"revolution\" needs", usual_grip,
       [](S s) { lattice_in(s).shape = Shape::revolution; }},
      {"product.profile_radius", "must end at 0, on the axis", usual_grip,
       [](S s) {
         make_revolution(s);
         lattice_in(s).profile_radius.back() = 0.5;
       }},
      {"product.size_m", "a solid of revolution has two equal", usual_grip,
       [](S s) {
         make_revolution(s);
         lattice_in(s).size_m[0] = 0.051;
       }},
      {"product.cell_size_m", "must be smaller than the product's waist", usual_grip,
       [](S s) {
         make_revolution(s);
         lattice_in(s).profile_height = {0.0, 0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 3.5, 4.0};
         lattice_in(s).profile_radius = {0.0, 0.8, 0.4, 0.1, 0.08, 0.1, 0.4, 0.8, 0.0};
       }},
      {"product.cell_size_m", "must be <= half", usual_grip, [](S s) { lattice_in(s).cell_size_m = 0.03; }},
      {"product.cell_size_m", "makes more than", usual_grip, [](S s) { lattice_in(s).cell_size_m = 4e-4; }},
      {"product.cell_size_m", "divides the product into cells of 0.0125 x 0.0125 x 0.0175 m", usual_grip,
       [](S s) {
         lattice_in(s).size_m = {0.05, 0.05, 0.035};
         lattice_in(s).cell_size_m = 0.0142;
       }},
      {"product.mass_kg", "missing", usual_grip, [](S s) { lattice_in(s).mass_kg.reset(); }},
      {"product.mass_kg", "excludes", usual_grip, [](S s) { lattice_in(s).density_kg_m3 = 1e3; }},
      {"product.tangent_modulus_Pa", "missing", usual_grip, [](S s) { lattice_in(s).tangent_modulus_Pa.reset(); }},
      {"product.tangent_modulus_Pa", "not used", usual_grip, [](S s) { lattice_in(s).yield_stress_Pa.reset(); }},
      {"product.tangent_modulus_Pa", "must be < product.youngs", usual_grip,
       [](S s) { lattice_in(s).tangent_modulus_Pa = 1e6; }},
      {"product.relaxation_time_s", "excludes", usual_grip, [](S s) { lattice_in(s).relaxation_time_s = 1e-3; }},
      {"product.at_frequency_Hz", "missing", usual_grip, [](S s) { lattice_in(s).at_frequency_Hz.reset(); }},
      {"product.at_frequency_Hz", "not used", usual_grip, [](S s) { lattice_in(s).loss_ratio.reset(); }},
      {"product.prony_time_s", "must be as many as prony_modulus = 2", usual_grip,
       [](S s) {
         lattice_in(s).prony_modulus = {0.2, 0.3};
       }},
      {"product.prony_time_s", "must be 6 times at most", usual_grip,
       [](S s) {
         lattice_in(s).prony_modulus.assign(7, 0.1);
         lattice_in(s).prony_time_s.assign(7, 1.0);
       }},
      {"product.prony_modulus", "must not add up to more than the modulus, 1; they add up to 1.2", usual_grip,
       [](S s) {
         lattice_in(s).prony_modulus = {0.5, 0.7};
         lattice_in(s).prony_time_s = {1.0, 2.0};
       }},
      {"product.prony_modulus", "must add up to less than 1 with prony_from", usual_grip,
       [](S s) {
         lattice_in(s).prony_modulus = {0.5, 0.5};
         lattice_in(s).prony_time_s = {1.0, 2.0};
         lattice_in(s).prony_from = PronyFrom::long_term;
       }},
      {"product.prony_from", "not used without prony_modulus", usual_grip,
       [](S s) { lattice_in(s).prony_from = PronyFrom::long_term; }},
      {"product.burgers_recovery_modulus", "missing; a Burgers model needs", usual_grip,
       [](S s) {
         lattice_in(s).burgers_flow_time_s = 100.0;
         lattice_in(s).burgers_recovery_time_s = 2.0;
       }},
      {"product.burgers_flow_time_s", "excludes prony_modulus", usual_grip,
       [](S s) {
         lattice_in(s).burgers_flow_time_s = 100.0;
         lattice_in(s).burgers_recovery_modulus = 2.0;
         lattice_in(s).burgers_recovery_time_s = 2.0;
         lattice_in(s).prony_modulus = {0.2};
         lattice_in(s).prony_time_s = {1.0};
       }},
      {"product.initial_spin_rad_s[1]", "must be 0 with a gripper", usual_grip,
       [](S s) {
         lattice_in(s).initial_spin_rad_s = {0.0, 1.0, 0.0};
       }},
      {"product.initial_rotation_rad[2]", "must be 0 with a gripper", usual_grip,
       [](S s) {
         lattice_in(s).initial_rotation_rad = {0.0, 0.0, 1.0};
       }},
      {"product.initial_height_m", "must be 0 with a gripper", usual_grip,
       [](S s) { lattice_in(s).initial_height_m = 0.01; }},
      {"product.initial_height_m", "needs cell.support = true", usual_grip,
       [](S s) {
         s.gripper = NoGripper{};
         s.cell.support = false;
         lattice_in(s).initial_height_m = 0.01;
       }},
  };
}

/// Pads of 3 cm before a box of 5 cm.
ParallelJawParameters& pads_in(S s, PadShape shape) {
  s.gripper = ParallelJawParameters{};
  jaw_of(s).pad.shape = shape;
  return jaw_of(s);
}

std::vector<Breach> pad_breaches() {
  return {
      {"gripper.pad.radius_m", "missing; gripper.pad.shape = \"cylinder\" needs it", usual_grip,
       [](S s) { pads_in(s, PadShape::cylinder); }},
      {"gripper.pad.radius_m", "not used with gripper.pad.shape = \"flat\"", usual_grip,
       [](S s) { pads_in(s, PadShape::flat).pad.radius_m = 0.1; }},
      {"gripper.pad.radius_m", "must be > 0.015 m in size", usual_grip,
       [](S s) { pads_in(s, PadShape::cylinder).pad.radius_m = -0.015; }},
      {"gripper.pad.radius_m", "must be > 0.02121 m in size", usual_grip,
       [](S s) { pads_in(s, PadShape::sphere).pad.radius_m = 0.02; }},
      {"gripper.pad.half_angle_rad", "missing", usual_grip, [](S s) { pads_in(s, PadShape::v_groove); }},
      {"gripper.pad.half_angle_rad", "must be < pi / 2", usual_grip,
       [](S s) { pads_in(s, PadShape::v_groove).pad.half_angle_rad = 1.6; }},
      {"gripper.pad.profile_place_m", "must have as many places", usual_grip,
       [](S s) {
         pads_in(s, PadShape::profile).pad.profile_place_m = {0.0, 0.01};
       }},
      {"gripper.pad.profile_place_m[2]", "must be > the place before it, 0.01", usual_grip,
       [](S s) {
         pads_in(s, PadShape::profile).pad.profile_place_m = {0.0, 0.01, 0.01};
         jaw_of(s).pad.profile_height_m = {0.0, 0.0, 0.001};
       }},
      {"gripper.opening_m", "must be > 0.06", usual_grip,
       [](S s) {
         pads_in(s, PadShape::profile).pad.profile_place_m = {0.0, 0.01};
         jaw_of(s).pad.profile_height_m = {0.005, 0.005};
         jaw_of(s).opening_m = 0.058;
       }},
      {"gripper.pad.shape", "lets the pads meet each other", usual_grip,
       [](S s) {
         pads_in(s, PadShape::profile).pad.profile_place_m = {0.026, 0.027};
         jaw_of(s).pad.profile_height_m = {0.0, 0.06};
         jaw_of(s).pad_size_m = {0.06, 0.03};
       }},
      {"gripper.pad.law_coefficients", "excludes", usual_grip,
       [](S s) {
         pads_in(s, PadShape::flat).pad.law_coefficients = {1e3};
         jaw_of(s).pad.law_depth_m = {0.0, 1e-3};
       }},
      {"gripper.pad.law_coefficients", "must make a force that rises", usual_grip,
       [](S s) {
         pads_in(s, PadShape::flat).pad.law_coefficients = {1e3, -1e6};
       }},
      {"gripper.pad.law_depth_m", "must have as many depths", usual_grip,
       [](S s) {
         pads_in(s, PadShape::flat).pad.law_depth_m = {0.0, 1e-3};
       }},
      {"gripper.pad.law_depth_m", "must begin with no force", usual_grip,
       [](S s) {
         pads_in(s, PadShape::flat).pad.law_depth_m = {0.0, 1e-3};
         jaw_of(s).pad.law_force_N = {1.0, 2.0};
       }},
      {"gripper.pad.law_force_N", "must rise", usual_grip,
       [](S s) {
         pads_in(s, PadShape::flat).pad.law_depth_m = {0.0, 1e-3, 2e-3};
         jaw_of(s).pad.law_force_N = {0.0, 2.0, 2.0};
       }},
      {"gripper.pad.shape", "must be \"flat\" with a measured law", usual_grip,
       [](S s) {
         pads_in(s, PadShape::sphere).pad.radius_m = 0.1;
         jaw_of(s).pad.law_coefficients = {1e3};
       }},
      {"gripper.pad_poisson_ratio", "not used with a measured law", usual_grip,
       [](S s) {
         pads_in(s, PadShape::flat).pad.law_coefficients = {1e3};
         jaw_of(s).pad_poisson_ratio = 0.4;
       }},
      {"gripper.pad.shape", "needs a product with a shape", usual_network,
       [](S s) { pads_in(s, PadShape::sphere).pad.radius_m = 0.1; }},
  };
}

/// Pads of 10 mm that are bodies of 5 mm cells.
Scenario lattice_pads() {
  Scenario scenario = usual_grip();
  ParallelJawParameters& jaw = jaw_of(scenario);
  jaw.pad.kind = PadKind::lattice;
  jaw.pad_thickness_m = 0.01;
  jaw.pad.cell_size_m = 0.005;
  return scenario;
}

std::vector<Breach> lattice_pad_breaches() {
  return {
      {"gripper.pad.cell_size_m", "not used", usual_grip, [](S s) { jaw_of(s).pad.cell_size_m = 0.001; }},
      {"gripper.pad.cell_size_m", "missing", lattice_pads, [](S s) { jaw_of(s).pad.cell_size_m.reset(); }},
      {"gripper.pad.cell_size_m", "must be <= gripper.pad_thickness_m = 0.01: the pad is thinner", lattice_pads,
       [](S s) { jaw_of(s).pad.cell_size_m = 0.011; }},
      {"gripper.pad.cell_size_m", "makes more than 100,000", lattice_pads,
       [](S s) { jaw_of(s).pad.cell_size_m = 4e-4; }},
      {"gripper.pad.cell_size_m", "divides a pad into cells of 0.005 x", lattice_pads,
       [](S s) { jaw_of(s).pad.cell_size_m = 0.01; }},
      {"gripper.pad_poisson_ratio", "must be < 0.5", lattice_pads, [](S s) { jaw_of(s).pad_poisson_ratio = 0.5; }},
      {"gripper.pad.kind", "goes with gripper.pad.shape", lattice_pads,
       [](S s) {
         jaw_of(s).pad.shape = PadShape::cylinder;
         jaw_of(s).pad.radius_m = 0.1;
       }},
      {"gripper.pad.kind", "excludes a measured law", lattice_pads,
       [](S s) { jaw_of(s).pad.law_coefficients = {1e4}; }},
      {"gripper.pad.kind", "does not go with a sensor at the wrist", lattice_pads,
       [](S s) { s.sensor.at = SensorMount::wrist; }},
      {"gripper.pad.kind", "does not go with a belt", lattice_pads, [](S s) { s.cell.conveyor.speed_m_s = 0.1; }},
  };
}

std::vector<Breach> surface_breaches() {
  return {
      {"cell.surface", "must be 8 tables at most", usual_grip, [](S s) { s.cell.surface.resize(9); }},
      {"cell.surface", "needs a product with a shape", usual_network, [](S s) { s.cell.surface.resize(1); }},
      {"cell.surface[1].normal", "must not be zero", usual_grip,
       [](S s) {
         s.cell.surface.resize(2);
         s.cell.surface[1].normal = {0.0, 0.0, 0.0};
       }},
      {"cell.surface[0].center_m", "puts the surface into the product", usual_grip,
       [](S s) {
         s.cell.surface.resize(1);
         s.cell.surface[0].center_m = {0.0, 0.0, 0.01};
       }},
      {"cell.surface[0].path_m", "must have as many places as path_time_s has times, 2", usual_grip,
       [](S s) {
         s.cell.surface.resize(1);
         s.cell.surface[0].path_time_s = {0.0, 1.0};
       }},
      {"cell.surface[0].path_time_s", "must rise", usual_grip,
       [](S s) {
         s.cell.surface.resize(1);
         s.cell.surface[0].path_time_s = {1.0, 1.0};
         s.cell.surface[0].path_m.resize(2);
       }},
      {"simulation.contact_set", "does not serve [[cell.surface]]", usual_grip,
       [](S s) {
         s.cell.surface.resize(1);
         s.simulation.contact_set = ContactSet::pads_and_support;
       }},
      {"cell.target_plane", "needs [[cell.surface]]", usual_grip, [](S s) { s.cell.target_plane = false; }},
  };
}

/// Three fingers about the vertical.
Scenario three_jaw() {
  Scenario scenario = usual_grip();
  lattice_in(scenario).shape = Shape::sphere;
  for (const double angle_rad : {0.0, 2.1, 4.2}) jaw_of(scenario).finger.emplace_back().angle_rad = angle_rad;
  jaw_of(scenario).pad_size_m = {0.02, 0.02};
  return scenario;
}

std::vector<Breach> finger_breaches() {
  return {
      {"gripper.finger", "must be 2 to 8 tables", three_jaw, [](S s) { jaw_of(s).finger.resize(1); }},
      {"gripper.finger", "must be 2 to 8 tables", three_jaw,
       [](S s) { jaw_of(s).finger.resize(9, jaw_of(s).finger.front()); }},
      {"gripper.finger", "needs a product with a shape", usual_network,
       [](S s) {
         s.gripper = ParallelJawParameters{};
         jaw_of(s).finger = jaw_of(three_jaw()).finger;
       }},
      {"gripper.finger", "press the product away between them", three_jaw,
       [](S s) { jaw_of(s).finger[2].angle_rad = 1.0; }},
      {"gripper.finger", "press alike where", three_jaw,
       [](S s) {
         jaw_of(s).coupling = FingerCoupling::independent;
         jaw_of(s).finger[2].angle_rad = 3.8;
       }},
      {"gripper.finger", "does not go with gripper.range", three_jaw,
       [](S s) { jaw_of(s).range.maximum_m = 0.05; }},
      {"gripper.finger", "does not go with sensor.at", three_jaw,
       [](S s) {
         s.sensor.at = SensorMount::wrist;
         s.sensor.position_m = {0.0, 0.0, 0.1};
       }},
      {"gripper.finger", "does not go with gripper.pad", three_jaw,
       [](S s) {
         jaw_of(s).pad.shape = PadShape::sphere;
         jaw_of(s).pad.radius_m = 0.01;
       }},
      {"gripper.finger[1].angle_rad", "missing", three_jaw, [](S s) { jaw_of(s).finger[1].angle_rad.reset(); }},
      {"gripper.finger[1].angle_rad", "excludes direction", three_jaw,
       [](S s) {
         jaw_of(s).finger[1].direction = {1.0, 0.0, 0.0};
       }},
      {"gripper.finger[1].direction", "must not be zero", three_jaw,
       [](S s) {
         jaw_of(s).finger[1].angle_rad.reset();
         jaw_of(s).finger[1].direction = {0.0, 0.0, 0.0};
       }},
      {"gripper.finger[2].angle_rad", "its pad meets that of gripper.finger[0]", three_jaw,
       [](S s) {
         jaw_of(s).pad_size_m = {0.1, 0.02};
       }},
      {"gripper.opening_m", "must be > 0.05 m, twice what the product reaches", three_jaw,
       [](S s) { jaw_of(s).opening_m = 0.04; }},
      {"simulation.contact_set", "does not serve [[gripper.finger]]", three_jaw,
       [](S s) { s.simulation.contact_set = ContactSet::six_sides; }},
  };
}

/// A gripper on a wrist sensor.
Scenario measured_grip() {
  Scenario scenario = usual_grip();
  scenario.sensor.at = SensorMount::wrist;
  scenario.sensor.position_m = {0.0, 0.0, 0.1};
  return scenario;
}

std::vector<Breach> sensor_breaches() {
  return {
      {"sensor.position_m", "missing", measured_grip, [](S s) { s.sensor.position_m.reset(); }},
      {"sensor.at", "needs a [gripper]", measured_grip, [](S s) { s.gripper = NoGripper{}; }},
      {"sensor.at", "needs gripper.coupling", measured_grip,
       [](S s) { jaw_of(s).coupling = FingerCoupling::independent; }},
      {"sensor.mass_kg", "must be > 2 x gripper.finger_mass_kg = 0.2", measured_grip,
       [](S s) { s.sensor.mass_kg = 0.2; }},
      {"sensor.at", "needs cell.support = true", measured_grip,
       [](S s) {
         s.sensor.at = SensorMount::support;
         s.cell.support = false;
       }},
      {"sensor.at", "does not go with a support that moves", measured_grip,
       [](S s) {
         s.sensor.at = SensorMount::support;
         s.cell.place_velocity_m_s = {0.1, 0.0};
       }},
      {"sensor.ring_stiffness_N_m", "missing", measured_grip, [](S s) { s.sensor.model = SensorModel::ring; }},
      {"sensor.stiffness_N_m", "not used: only sensor.model = \"datasheet\"", measured_grip,
       [](S s) {
         s.sensor.stiffness_N_m = {1e6, 1e6, 1e6};
       }},
      {"sensor.ring_stiffness_N_m", "must be positive definite", measured_grip,
       [](S s) {
         s.sensor.model = SensorModel::ring;
         s.sensor.ring_stiffness_N_m = {1e6, 1e6, 0.0};
       }},
      {"sensor.stiffness_matrix", "must be positive definite", measured_grip,
       [](S s) {
         s.sensor.model = SensorModel::matrix;
         s.sensor.stiffness_matrix = std::array<double, 36>{};
         for (std::size_t i = 0; i < 6; ++i) (*s.sensor.stiffness_matrix)[7 * i] = 1.0;
         (*s.sensor.stiffness_matrix)[1] = (*s.sensor.stiffness_matrix)[6] = 1.5;
       }},
      {"sensor.stiffness_matrix", "must be symmetric: row 2, column 1", measured_grip,
       [](S s) {
         s.sensor.model = SensorModel::matrix;
         s.sensor.stiffness_matrix = std::array<double, 36>{};
         for (std::size_t i = 0; i < 6; ++i) (*s.sensor.stiffness_matrix)[7 * i] = 1.0;
         (*s.sensor.stiffness_matrix)[1] = 0.5;
       }},
      {"sensor.rate_Hz", "must be <= 1 / simulation.time_step_s = 1000", measured_grip,
       [](S s) { s.sensor.rate_Hz = 1001.0; }},
      {"sensor.noise_N_m", "needs sensor.rate_Hz", measured_grip, [](S s) { s.sensor.noise_N_m = 0.01; }},
  };
}

std::vector<Breach> network_breaches() {
  return {
      {"gripper", "a network cannot be gripped", usual_network, [](S s) { s.gripper = ParallelJawParameters{}; }},
      {"product.particle", "a network needs particles", usual_network,
       [](S s) { s.product = NetworkParameters{}; }},
      {"product.particle[0].fixed", "every particle is fixed", usual_network,
       [](S s) {
         network_in(s).particle[1].fixed = {true, true, true};
       }},
      {"product.particle[1].mass_kg", "must be > 0 unless", usual_network,
       [](S s) { network_in(s).particle[1].mass_kg = 0.0; }},
      {"product.spring[0].between", "there are 2 particles", usual_network,
       [](S s) {
         network_in(s).spring[0].between = {0, 2};
       }},
      {"product.spring[0].between", "must join two", usual_network,
       [](S s) {
         network_in(s).spring[0].between = {1, 1};
       }},
      {"product.spring[0].between", "must join two", usual_network,
       [](S s) {
         network_in(s).particle[1].position_m = {0.0, 0.0, 0.0};
       }},
      {"product.spring[0].hardening_ratio", "not used", usual_network,
       [](S s) {
         network_in(s).spring[0].hardening_ratio = 0.1;
         network_in(s).spring[0].yield_force_N.reset();
       }},
      {"product.spring[0].prony_time_s", "must be as many as prony_modulus = 1", usual_network,
       [](S s) { network_in(s).spring[0].prony_modulus = {0.2}; }},
      {"product.spring[0].prony_modulus", "must not add up to more", usual_network,
       [](S s) {
         network_in(s).spring[0].prony_modulus = {0.5, 0.7};
         network_in(s).spring[0].prony_time_s = {1.0, 2.0};
       }},
      {"product.spring[0].prony_from", "not used without prony_modulus", usual_network,
       [](S s) { network_in(s).spring[0].prony_from = PronyFrom::long_term; }},
      {"product.spring[0].burgers_flow_N_s_m", "missing; a Burgers model needs", usual_network,
       [](S s) { network_in(s).spring[0].burgers_recovery_N_m = 100.0; }},
      {"product.spring[0].burgers_flow_N_s_m", "excludes prony_modulus", usual_network,
       [](S s) {
         NetworkSpring& spring = network_in(s).spring[0];
         spring.burgers_flow_N_s_m = spring.burgers_recovery_N_m = spring.burgers_recovery_N_s_m = 100.0;
         spring.prony_modulus = {0.2};
         spring.prony_time_s = {1.0};
       }},
      {"product.spring[0].prony_modulus", "needs a stiffness_N_m > 0", usual_network,
       [](S s) {
         network_in(s).spring[0].prony_modulus = {0.2};
         network_in(s).spring[0].prony_time_s = {1.0};
         network_in(s).spring[0].stiffness_N_m = 0.0;
         network_in(s).spring[0].yield_force_N.reset();
         network_in(s).spring[0].hardening_ratio = 0.0;
       }},
      {"product.spring[0].yield_force_N", "needs a stiffness", usual_network,
       [](S s) { network_in(s).spring[0].stiffness_N_m = 0.0; }},
      {"product.load[0].particle", "there are 2 particles", usual_network,
       [](S s) { network_in(s).load[0].particle = 7; }},
      {"product.load[0].force_N", "must have as many", usual_network,
       [](S s) { network_in(s).load[0].force_N.pop_back(); }},
      {"product.load[0].time_s", "must not decrease", usual_network,
       [](S s) {
         network_in(s).load[0].time_s = {1.0, 0.0};
       }},
  };
}

/// Drives that press with less the faster they go.
Scenario curved_grip() {
  Scenario scenario = usual_grip();
  jaw_of(scenario).curve_speed_m_s = {0.0, 0.3, 0.5};
  jaw_of(scenario).curve_force_N = {100.0, 60.0, 0.0};
  return scenario;
}

std::vector<Breach> handling_breaches() {
  return {
      {"gripper.stroke_m", "must be > the way", usual_grip, [](S s) { jaw_of(s).stroke_m = 0.005; }},
      {"gripper.min_force_N", "must be <= gripper.max", usual_grip, [](S s) { jaw_of(s).min_force_N = 101.0; }},
      {"gripper.force_step_N", "must be <= gripper.max", usual_grip, [](S s) { jaw_of(s).force_step_N = 101.0; }},
      {"gripper.hold", "needs gripper.lock_stiffness_N_m for a product as good as rigid", usual_grip,
       [](S s) {
         jaw_of(s).hold = HoldMode::position;
         lattice_in(s).youngs_modulus_Pa = 2e11;
       }},
      {"gripper.curve_force_N", "must have as many elements as gripper.curve_speed_m_s, two at least", usual_grip,
       [](S s) {
         jaw_of(s).curve_speed_m_s = {0.0, 0.1, 0.2};
         jaw_of(s).curve_force_N = {100.0, 0.0};
       }},
      {"gripper.curve_speed_m_s", "must begin with 0, not 0.01", curved_grip,
       [](S s) { jaw_of(s).curve_speed_m_s[0] = 0.01; }},
      {"gripper.curve_speed_m_s", "must rise: 0.2 follows 0.3", curved_grip,
       [](S s) { jaw_of(s).curve_speed_m_s[2] = 0.2; }},
      {"gripper.curve_force_N", "must begin with more than 0", curved_grip,
       [](S s) {
         jaw_of(s).curve_force_N = {0.0, 0.0, 0.0};
       }},
      {"gripper.curve_force_N", "must not rise: 110.0 follows 100.0", curved_grip,
       [](S s) { jaw_of(s).curve_force_N[1] = 110.0; }},
      {"gripper.max_force_N", "must be <= gripper.curve_force_N[0] = 100.0", curved_grip,
       [](S s) { jaw_of(s).max_force_N = 120.0; }},
      {"strategy.approach_speed_m_s", "must be < 0.5, the speed at which gripper.curve_force_N has fallen to 0",
       curved_grip, [](S s) { s.strategy.approach_speed_m_s = 0.5; }},
      {"strategy.release_speed_m_s", "must be < 0.5, the speed at which gripper.curve_force_N has fallen to 0",
       curved_grip, [](S s) { s.strategy.release_speed_m_s = 0.5; }},
      {"gripper.opening_m", "must be > product.size_m[0]", usual_grip, [](S s) { jaw_of(s).opening_m = 0.04; }},
      {"cell.approach_gap_m", "contradicts", usual_grip,
       [](S s) {
         jaw_of(s).opening_m = 0.08;
         s.cell.approach_gap_m = 0.005;
       }},
      {"strategy.approach_speed_m_s", "must be <= gripper.max", usual_grip,
       [](S s) { s.strategy.approach_speed_m_s = 0.6; }},
      {"strategy.grip_force_N", "must be <= gripper.max", usual_grip,
       [](S s) { s.strategy.grip_force_N = 101.0; }},
      {"strategy.contact_force_N", "must be <= strategy.grip", usual_grip,
       [](S s) { s.strategy.contact_force_N = 1.1; }},
      {"strategy.release_speed_m_s", "must be <= gripper.max", usual_grip,
       [](S s) { s.strategy.release_speed_m_s = 0.6; }},
      {"strategy.tilt_rad", "needs gripper.coupling", usual_grip,
       [](S s) {
         s.strategy.tilt_rad = {0.1, 0.0, 0.0};
         jaw_of(s).coupling = FingerCoupling::independent;
       }},
      {"strategy.tilt_rad", "turns by", usual_grip,
       [](S s) {
         s.strategy.tilt_rad = {2.5, 2.5, 0.0};
       }},
      {"strategy.tilt_rad", "turns the product into", usual_grip,
       [](S s) {
         s.strategy.tilt_rad = {0.8, 0.0, 0.0};
         s.cell.lift_height_m = 0.01;
       }},
      {"strategy.tilt_rad", "does not go with [[strategy.waypoint]]", usual_grip,
       [](S s) {
         s.strategy.tilt_rad = {0.1, 0.0, 0.0};
         s.strategy.waypoint.resize(1);
       }},
      {"strategy.tilt_speed_rad_s", "turns the product by up to 0.1549", usual_grip,
       [](S s) {
         s.strategy.tilt_rad = {0.6, 0.0, 0.0};
         s.strategy.tilt_speed_rad_s = 200.0;
         s.strategy.tilt_acceleration_rad_s2 = 4e4;
       }},
      {"strategy.waypoint[0].place_m", "missing: a palm that goes with a belt", usual_grip,
       [](S s) {
         s.cell.conveyor.speed_m_s = 0.2;
         s.strategy.pick = PickKind::tracking;
         s.strategy.waypoint.resize(1);
       }},
      {"strategy.waypoint", "there are 17 waypoints", usual_grip, [](S s) { s.strategy.waypoint.resize(17); }},
      {"strategy.waypoint[1].rotation_rad", "turns by 3.", usual_grip,
       [](S s) {
         s.strategy.waypoint.resize(2);
         s.strategy.waypoint[1].rotation_rad = {2.5, 2.5, 0.0};
       }},
      {"strategy.waypoint[0].rotation_rad", "needs gripper.coupling", usual_grip,
       [](S s) {
         s.strategy.waypoint = {{.rotation_rad = std::array<double, 3>{0.1, 0.0, 0.0}}};
         jaw_of(s).coupling = FingerCoupling::independent;
       }},
      {"strategy.waypoint[0].quaternion", "has the length 1.118; a rotation has the length 1", usual_grip,
       [](S s) {
         s.strategy.waypoint = {{.quaternion = std::array<double, 4>{1.0, 0.5, 0.0, 0.0}}};
       }},
      {"strategy.waypoint[0].quaternion", "excludes rotation_rad", usual_grip,
       [](S s) {
         s.strategy.waypoint = {{.rotation_rad = std::array<double, 3>{0.1, 0.0, 0.0},
                                 .quaternion = std::array<double, 4>{1.0, 0.0, 0.0, 0.0}}};
       }},
      {"strategy.waypoint[0].via_m", "lies in a line with the places before and after it", usual_grip,
       [](S s) {
         s.strategy.waypoint = {
             {.place_m = std::array<double, 3>{0.0, 0.2, 0.1}, .via_m = std::array<double, 3>{0.0, 0.1, 0.1}}};
       }},
      {"strategy.waypoint[0].via_m", "does not go with pick = \"tracking\" at the first waypoint", usual_grip,
       [](S s) {
         s.cell.conveyor.speed_m_s = 0.2;
         s.strategy.pick = PickKind::tracking;
         s.strategy.waypoint = {
             {.place_m = std::array<double, 3>{0.0, 0.2, 0.1}, .via_m = std::array<double, 3>{0.0, 0.1, 0.2}}};
       }},
      {"strategy.waypoint[0].blend_m", "must be 0 at the last waypoint", usual_grip,
       [](S s) { s.strategy.waypoint = {{.blend_m = 0.01}}; }},
      {"strategy.waypoint[0].blend_m", "excludes wait_s = 0.5", usual_grip,
       [](S s) {
         s.strategy.waypoint = {{.blend_m = 0.01, .wait_s = 0.5}, {}};
       }},
      {"strategy.jerk_m_s3", "missing: profile = \"s_curve\" needs it", usual_grip,
       [](S s) { s.strategy.profile = ProfileKind::s_curve; }},
      {"strategy.tilt_jerk_rad_s3", "missing: profile = \"s_curve\" needs it where the palm turns", usual_grip,
       [](S s) {
         s.strategy.profile = ProfileKind::s_curve;
         s.strategy.jerk_m_s3 = 40.0;
         s.strategy.tilt_rad = {0.1, 0.0, 0.0};
       }},
      {"strategy.waypoint[1].place_m", "takes the product's lowest place down to -0.01 m", usual_grip,
       [](S s) {
         s.strategy.waypoint = {{.place_m = std::array<double, 3>{0.0, 0.1, 0.1}},
                                {.place_m = std::array<double, 3>{0.0, 0.2, -0.01}}};
       }},
      {"strategy.waypoint[0].place_m", "takes the product's lowest place down to", usual_grip,
       [](S s) {
         s.cell.lift_height_m = 0.01;
         s.strategy.waypoint = {{.rotation_rad = std::array<double, 3>{1.5708, 0.0, 0.0}}};
       }},
      {"strategy.release_height_m", "must be <= the height of the product above the target at the last waypoint",
       usual_grip,
       [](S s) {
         s.strategy.waypoint = {{.place_m = std::array<double, 3>{0.0, 0.1, 0.01}}};
         s.strategy.release_height_m = 0.02;
       }},
      {"cell.place_height_m", "must be < cell.lift", usual_grip, [](S s) { s.cell.place_height_m = 0.1; }},
      {"cell.place_height_m", "must be <= cell.lift", usual_grip,
       [](S s) {
         s.cell.lift_height_m = 0.0;
         s.cell.place_height_m = 0.01;
       }},
      {"strategy.release_height_m", "must be <= cell.lift_height_m - cell.place_height_m = 0.1", usual_grip,
       [](S s) { s.strategy.release_height_m = 0.5; }},
      {"cell.conveyor.direction", "must not be zero", usual_grip,
       [](S s) {
         s.cell.conveyor.direction = {0.0, 0.0};
       }},
      {"cell.conveyor.speed_m_s", "needs cell.support", usual_grip,
       [](S s) {
         s.cell.support = false;
         s.cell.conveyor.speed_m_s = 0.2;
       }},
      {"cell.conveyor.speed_m_s", "needs a product with a shape", usual_network,
       [](S s) { s.cell.conveyor.speed_m_s = 0.2; }},
      {"cell.conveyor.initial_speed_m_s", "differs", usual_grip,
       [](S s) { s.cell.conveyor.initial_speed_m_s = 0.2; }},
      {"strategy.speed_m_s", "must be >= 1.5 x the speed of the belt = 0.9", usual_grip,
       [](S s) {
         s.cell.conveyor.speed_m_s = 0.6;
         s.strategy.pick = PickKind::tracking;
         s.strategy.speed_m_s = 0.8;
       }},
      {"strategy.speed_m_s", "must be >= 1.5 x the speed of the target", usual_grip,
       [](S s) {
         s.cell.place_velocity_m_s = {0.6, 0.8};
       }},
      {"strategy.pick", "needs a belt", usual_grip, [](S s) { s.strategy.pick = PickKind::tracking; }},
      {"simulation.duration_s", "missing", usual_network, [](S s) { s.simulation.duration_s.reset(); }},
      {"simulation.duration_s", "must be >= simulation.time", usual_network,
       [](S s) { s.simulation.duration_s = 1e-4; }},
      {"simulation.trace_interval_s", "must be >= simulation.time", usual_grip,
       [](S s) { s.simulation.trace_interval_s = 1e-4; }},
  };
}

/// A grip that slows down 4 mm before the product, which stands 5 mm away; its sensors sit 1 mm behind the pads.
Scenario guarded_grip() {
  Scenario scenario = usual_grip();
  jaw_of(scenario).range.maximum_m = 0.05;
  jaw_of(scenario).range.depth_m = 1e-3;
  jaw_of(scenario).range.rate_Hz = 500.0;
  scenario.strategy.guard = GuardKind::range;
  scenario.strategy.guard_range_m = 5e-3;
  return scenario;
}

Scenario force_guarded_grip() {
  Scenario scenario = usual_grip();
  scenario.strategy.guard = GuardKind::force;
  scenario.strategy.guard_force_N = 0.1;
  return scenario;
}

std::vector<Breach> guard_breaches() {
  return {
      {"gripper.range.rate_Hz", "must be <= 1 / simulation.time_step_s = 1000", guarded_grip,
       [](S s) { jaw_of(s).range.rate_Hz = 1001.0; }},
      {"gripper.force_rate_Hz", "must be <= 1 / simulation.time_step_s = 1000", force_guarded_grip,
       [](S s) { jaw_of(s).force_rate_Hz = 2000.0; }},
      {"gripper.range.noise_m", "must be 0 without gripper.range.rate_Hz", guarded_grip,
       [](S s) {
         jaw_of(s).range.rate_Hz.reset();
         jaw_of(s).range.noise_m = 1e-4;
       }},
      {"gripper.range.depth_m", "must be > - the way to the product", guarded_grip,
       [](S s) { jaw_of(s).range.depth_m = -6e-3; }},
      {"strategy.guard", "needs a gripper", guarded_grip, [](S s) { s.gripper = NoGripper{}; }},
      {"strategy.guard", "needs range sensors", guarded_grip, [](S s) { jaw_of(s).range.maximum_m.reset(); }},
      {"strategy.ramp_from_start", "must be false with a guard", guarded_grip,
       [](S s) { s.strategy.ramp_from_start = true; }},
      {"strategy.guard_range_m", "missing", guarded_grip, [](S s) { s.strategy.guard_range_m.reset(); }},
      {"strategy.guard_range_m", "must be <= gripper.range.maximum_m", guarded_grip,
       [](S s) { jaw_of(s).range.maximum_m = 4e-3; }},
      {"strategy.guard_range_m", "must be <= what the range sensors read at the start, 0.006 m", guarded_grip,
       [](S s) { s.strategy.guard_range_m = 7e-3; }},
      {"strategy.guard_range_m", "must be > what the range sensors read when the pads touch, 0.001 m",
       guarded_grip, [](S s) { s.strategy.guard_range_m = 5e-4; }},
      {"strategy.guard_range_m", "is never read", guarded_grip,
       [](S s) {
         jaw_of(s).range.offset_m = {0.04, 0.0};
       }},
      {"strategy.guard_force_N", "missing", force_guarded_grip, [](S s) { s.strategy.guard_force_N.reset(); }},
      {"strategy.guard_force_N", "must be < strategy.contact_force_N = 0.3", force_guarded_grip,
       [](S s) { s.strategy.guard_force_N = 0.3; }},
      {"strategy.guard_force_N", "must be < gripper.drive_gain_N_s_m x", force_guarded_grip,
       [](S s) { jaw_of(s).drive_gain_N_s_m = 1.0; }},
      {"strategy.guard_speed_m_s", "must be < strategy.approach_speed_m_s = 0.05", force_guarded_grip,
       [](S s) { s.strategy.guard_speed_m_s = 0.05; }},
      {"strategy.guard_speed_m_s", "must be > 0 with strategy.guard = \"range\"", guarded_grip,
       [](S s) { s.strategy.guard_speed_m_s = 0.0; }},
  };
}

ArmJointParameters& one_joint(S s) {
  s.robot.joint.resize(1);
  return s.robot.joint[0];
}

std::vector<Breach> robot_breaches() {
  return {
      {"robot.joint", "must be 8 tables at most", usual_grip, [](S s) { s.robot.joint.resize(9); }},
      {"robot.joint", "needs [gripper]", usual_network, [](S s) { s.robot.joint.resize(1); }},
      {"robot.joint[0].axis", "must not be zero", usual_grip,
       [](S s) {
         one_joint(s).axis = {0.0, 0.0, 0.0};
       }},
      {"robot.joint[0].lower_rad", "must be < robot.joint[0].upper_rad = 1.0", usual_grip,
       [](S s) {
         one_joint(s).lower_rad = 1.0;
         one_joint(s).upper_rad = 1.0;
       }},
      {"robot.joint[0].inertia_kg_m2", "is of no body", usual_grip,
       [](S s) { one_joint(s).inertia_kg_m2 = {1.0, 1.0, 3.0, 0.0, 0.0, 0.0}; }},
      {"robot.joint[0].place_m", "gives a reach of 80", usual_grip,
       [](S s) {
         one_joint(s);
         s.robot.flange_place_m = {80.0, 0.0, 0.0};
       }},
      {"robot.seed_posture_rad", "must have one for each joint, 1", usual_grip,
       [](S s) {
         one_joint(s);
         s.robot.seed_posture_rad = {0.0, 0.0};
       }},
      {"robot.seed_posture_rad[0]", "must be >= robot.joint[0].lower_rad = -1.0", usual_grip,
       [](S s) {
         one_joint(s).lower_rad = -1.0;
         s.robot.seed_posture_rad = {-1.5};
       }},
      {"robot.deceleration_rad_s2", "must have one for each joint, 1, or one for all", usual_grip,
       [](S s) {
         one_joint(s);
         s.robot.deceleration_rad_s2 = {1.0, 1.0};
       }},
      {"robot.jerk_rad_s3", "must have one for each joint, 1, or one for all", usual_grip,
       [](S s) {
         one_joint(s);
         s.robot.jerk_rad_s3 = {1.0, 1.0};
       }},
      {"robot.stiffness_N_m_rad", "must have one for each joint, 1, or one for all", usual_grip,
       [](S s) {
         one_joint(s);
         s.robot.stiffness_N_m_rad = {1.0, 1.0};
       }},
      {"robot.bandwidth_Hz", "must have one for each joint, 1, or one for all", usual_grip,
       [](S s) {
         one_joint(s);
         s.robot.bandwidth_Hz = {1.0, 1.0};
       }},
      {"robot.jerk_rad_s3", "needs strategy.profile", usual_grip,
       [](S s) {
         one_joint(s);
         s.robot.jerk_rad_s3 = {100.0};
         s.strategy.profile = ProfileKind::trapezoid;
       }},
      {"robot.bandwidth_Hz", "needs gripper.coupling = \"centric\"", usual_grip,
       [](S s) {
         one_joint(s);
         s.robot.bandwidth_Hz = {10.0};
         jaw_of(s).coupling = FingerCoupling::independent;
       }},
      {"robot.acceleration_rad_s2", "must have one for each joint, 1", usual_grip,
       [](S s) {
         one_joint(s);
         s.robot.acceleration_rad_s2 = {1.0, 1.0};
       }},
  };
}

ProductLayer layer_from(double from_depth_m) {
  ProductLayer layer;
  layer.from_depth_m = from_depth_m;
  return layer;
}

std::vector<Breach> layer_breaches() {
  return {
      {"product.layer[0].from_depth_m", "must be 8 layers at most", usual_grip,
       [](S s) {
         for (int i = 0; i < 9; ++i) lattice_in(s).layer.push_back(layer_from(1e-3 * (i + 1)));
       }},
      {"product.layer[1].from_depth_m", "must be > 0.005, where the layer before", usual_grip,
       [](S s) {
         lattice_in(s).layer = {layer_from(0.005), layer_from(0.005)};
       }},
      {"product.layer[0].from_depth_m", "must be < half the smallest extent", usual_grip,
       [](S s) { lattice_in(s).layer = {layer_from(0.5)}; }},
      {"product.layer[0].from_depth_m", "missing; or size_m", usual_grip,
       [](S s) { lattice_in(s).layer.resize(1); }},
      {"product.layer[0].size_m", "not together with from_depth_m", usual_grip,
       [](S s) {
         lattice_in(s).layer = {layer_from(0.005)};
         lattice_in(s).layer[0].size_m = {0.001, 0.001, 0.001};
       }},
      {"product.layer[0].center_m", "not used without size_m", usual_grip,
       [](S s) {
         lattice_in(s).layer = {layer_from(0.005)};
         lattice_in(s).layer[0].center_m = {0.0, 0.0, 0.0};
       }},
      {"product.layer[0].size_m[1]", "must be <= product.size_m[1] less twice", usual_grip,
       [](S s) {
         lattice_in(s).layer.resize(1);
         lattice_in(s).layer[0].size_m = {0.001, 0.5, 0.001};
       }},
      {"product.layer[0].tangent_modulus_Pa", "missing; yield_stress_Pa", usual_grip,
       [](S s) {
         lattice_in(s).layer = {layer_from(0.005)};
         lattice_in(s).layer[0].yield_stress_Pa = 1e4;
       }},
      {"product.layer[0].tangent_modulus_Pa", "must be < product.layer[0].youngs_modulus_Pa", usual_grip,
       [](S s) {
         lattice_in(s).layer = {layer_from(0.005)};
         lattice_in(s).layer[0].yield_stress_Pa = 1e4;
         lattice_in(s).layer[0].tangent_modulus_Pa = 1e6;
       }},
      {"product.skin_modulus_Pa", "missing; skin_thickness_m", usual_grip,
       [](S s) { lattice_in(s).skin_thickness_m = 1e-4; }},
      {"product.skin_poisson_ratio", "not used without skin_thickness_m", usual_grip,
       [](S s) { lattice_in(s).skin_poisson_ratio = 0.4; }},
      {"product.skin_thickness_m", "must be < product.cell_size_m", usual_grip,
       [](S s) {
         lattice_in(s).skin_thickness_m = 0.02;
         lattice_in(s).skin_modulus_Pa = 1e6;
       }},
  };
}

std::vector<Breach> repeat_breaches() {
  return {
      {"strategy.repeat", "must be 1 of a product that relaxes", usual_grip,
       [](S s) {
         s.strategy.repeat = 2;
         lattice_in(s).prony_modulus = {0.2};
         lattice_in(s).prony_time_s = {1.0};
       }},
      {"strategy.repeat", "must be 1 with strategy.stop_time_s", usual_grip,
       [](S s) {
         s.strategy.repeat = 2;
         s.strategy.stop_time_s = 0.5;
       }},
  };
}

std::vector<Breach> breaches() {
  std::vector<Breach> all;
  for (const auto& part : {lattice_breaches(), layer_breaches(), repeat_breaches(), pad_breaches(),
                           lattice_pad_breaches(), finger_breaches(), surface_breaches(), sensor_breaches(),
                           network_breaches(), handling_breaches(), guard_breaches(), robot_breaches()}) {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

Scenario broken_by(const Breach& breach) {
  Scenario scenario = breach.scene();
  breach.change(scenario);
  return scenario;
}

bool speaks(const Violations& all, const Breach& breach) {
  return std::any_of(all.begin(), all.end(), [&](const Violation& violation) {
    return violation.field == breach.field && violation.rule.starts_with(breach.rule);
  });
}

TEST(Rules, HoldInUsualScenarios) {
  EXPECT_TRUE(validate(usual_grip()).empty());
  EXPECT_TRUE(validate(usual_network()).empty());
  EXPECT_TRUE(validate(guarded_grip()).empty());
  EXPECT_TRUE(validate(force_guarded_grip()).empty());
  EXPECT_TRUE(validate(curved_grip()).empty());
  EXPECT_TRUE(validate(lattice_pads()).empty());
}

TEST(Rules, AreBrokenByTheScenariosMadeForThem) {
  for (const Breach& breach : breaches()) {
    const Violations found = validate(broken_by(breach));
    EXPECT_TRUE(speaks(found, breach)) << breach.field << ": " << breach.rule << ", but "
                                       << (found.empty() ? "nothing" : found[0].field + ": " + found[0].rule);
  }
}

/// What breaks a rule each.
std::vector<Scenario> broken_scenarios() {
  std::vector<Scenario> all;
  for (const Breach& breach : breaches()) all.push_back(broken_by(breach));
  return all;
}

TEST(Rules, EachHaveAScenarioThatBreaksThem) {
  const std::vector<Scenario> all = broken_scenarios();
  for (const Rule& rule : scenario_rules()) {
    const bool broken = std::any_of(all.begin(), all.end(), [&](const Scenario& scenario) {
      Violations found;
      rule.check(scenario, found);
      return !found.empty();
    });
    EXPECT_TRUE(broken) << rule.fields.front() << ": " << rule.sentence;
  }
}

/// Does the rule say the same after every number that it does not name was changed a little?
void expect_blind_to_others(const Rule& rule, const Scenario& scenario) {
  Violations before;
  rule.check(scenario, before);
  for (const NumberField& field : number_fields()) {
    if (std::find(rule.fields.begin(), rule.fields.end(), field.path) != rule.fields.end()) continue;
    Scenario changed = scenario;
    field.each(changed, [](const NumberPlace&, NumberSlot slot) {
      if (auto* const* number = std::get_if<double*>(&slot)) **number = 1.5 * **number + 0.01;
      if (auto* const* maybe = std::get_if<std::optional<double>*>(&slot))
        **maybe = 0.5 * (*maybe)->value_or(0.02);
    });
    Violations after;
    rule.check(changed, after);
    EXPECT_EQ(after.size(), before.size()) << rule.fields.front() << " looks at " << field.path;
  }
}

TEST(Rules, LookAtTheFieldsTheyNameOnly) {
  const std::vector<Scenario> all = broken_scenarios();
  for (const Rule& rule : scenario_rules()) {
    expect_blind_to_others(rule, usual_grip());
    expect_blind_to_others(rule, usual_network());
    for (const Scenario& scenario : all) expect_blind_to_others(rule, scenario);
  }
}

TEST(Rules, NameKnownFields) {
  const std::set<std::string_view> words = {
      "product.shape",     "product.axis",           "product.kind",       "product.particle[].fixed",
      "gripper",           "gripper.coupling",       "gripper.hold",       "gripper.pad.shape",
      "gripper.pad.along", "gripper.pad.kind",       "gripper.finger",     "cell.support",
      "strategy.pick",     "strategy.profile",       "cell.surface",       "robot.joint",
      "cell.target_plane", "simulation.contact_set", "strategy.guard",     "strategy.ramp_from_start",
      "sensor.at",         "sensor.model",           "product.prony_from", "product.spring[].prony_from"};
  for (const Rule& rule : scenario_rules()) {
    for (const std::string_view field : rule.fields) {
      EXPECT_TRUE(find_number_field(field) != nullptr || words.contains(field)) << field;
    }
  }
}

TEST(Rules, AWantedCellIsAnsweredWithOneThatDividesTheProduct) {
  // For any box the cell that is offered has to be accepted.
  for (double height = 0.011; height < 0.09; height += 0.0013) {
    for (double cell = 0.004; cell < 0.5 * height; cell += 0.0007) {
      Scenario scenario = usual_grip();
      LatticeParameters& product = lattice_in(scenario);
      product.size_m = {0.05, 0.037, height};
      product.cell_size_m = std::min(cell, 0.018);
      const Violations found = validate(scenario);
      if (found.empty()) continue;
      ASSERT_EQ(found.size(), 1U);
      const std::size_t at = found[0].rule.find("; ");
      ASSERT_NE(at, std::string::npos) << found[0].rule;
      product.cell_size_m = std::stod(found[0].rule.substr(at + 2));
      EXPECT_TRUE(validate(scenario).empty()) << found[0].rule;
    }
  }
}

TEST(Rules, ThetaHasAnUpperEnd) {
  Scenario scenario = usual_grip();
  scenario.simulation.theta = 5.0;
  const Violations found = validate(scenario);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].field + " = " + found[0].value + ": " + found[0].rule,
            "simulation.theta = 5.0: must be >= 1.37, <= 3");
}

}  // namespace
}  // namespace unbruised

// Which fields enter the factor key: exactly those that change the model.

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/scenario/body_modes.hpp"
#include "core/scenario/contact_set.hpp"
#include "core/scenario/fields.hpp"
#include "core/scenario/pad_face.hpp"
#include "core/scenario/pad_lattice.hpp"
#include "core/scenario/product_frame.hpp"
#include "core/simulation/model_parts.hpp"
#include "tests/core/scenario/meshes.hpp"
#include "tests/core/simulation/scenes.hpp"

namespace unbruised {
namespace {

using namespace testing;

/// Changes the field with one number, a little, so that the scenario stays valid.
class Perturbation {
 public:
  explicit Perturbation(int field) : field_(field) {}
  template <class T>
  void operator()(const Field& field, T& value) {
    if (next_++ != field_) return;
    name_ = field.name;
    decides_ = field.decides;
    change(value);
  }
  /// Did the scenario have such a field?
  [[nodiscard]] bool happened() const { return !name_.empty(); }
  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] Decides decides() const { return decides_; }

 private:
  static void change(double& value) { value = value == 0.0 ? 0.01 : value * 1.02; }
  static void change(std::optional<double>& value) { value = value ? *value * 1.02 : 0.02; }
  static void change(bool& value) { value = !value; }
  static void change(int& value) { value = value == 0 ? 2 : 0; }
  template <class T>
  requires std::is_enum_v<T>
  static void change(T& value) { value = static_cast<T>(value == T{} ? 1 : 0); }
  template <class T, std::size_t N>
  static void change(std::array<T, N>& values) {
    change(values.back());
  }
  template <class T, std::size_t N>
  static void change(std::optional<std::array<T, N>>& values) {
    if (!values) values.emplace();
    change(values->back());
  }
  static void change(std::shared_ptr<const ProductMesh>& mesh) {
    mesh = mesh_product(cube_mesh(), {}, mesh ? mesh->source().hash + 1 : 5).mesh;
  }
  template <class T>
  static void change(std::vector<T>& values) {
    if (values.empty()) values.emplace_back();
    change(values.back());
  }

  int field_;
  int next_ = 0;
  std::string name_;
  Decides decides_ = Decides::run;
};

/// All numbers of a model that a run may depend on.
std::vector<double> numbers_of(const Model& model) {
  const Model::Parts& parts = model.parts();
  std::vector<double> all = {parts.wilson->dt, parts.wilson->theta, parts.body.relaxation_time_s,
                             parts.contact.patch_side_m};
  const auto add = [&all](const auto& values) { all.insert(all.end(), values.begin(), values.end()); };
  for (const BranchStep& branch : parts.body.relaxation.branch)
    add(std::vector<double>{branch.share, branch.time_s});
  for (const auto* values : {&parts.body.mass_kg, &parts.body.K.value, &parts.body.C.value,
                             &parts.body.factor.value, &parts.body.rest_force_N, &parts.contact.compliance}) {
    add(*values);
  }
  add(parts.body.factor.single_value);
  for (const auto& place : parts.body.position_m) add(place);
  for (const auto& fixed : parts.body.fixed) add(fixed);
  for (const SpringGeometry& spring : parts.body.springs) {
    add(std::vector<double>{spring.stiffness, spring.rest_length, spring.yield_force, spring.hardening_ratio});
    for (const RelaxationBranch& branch : spring.branch) add(std::vector<double>{branch.share, branch.time_s});
  }
  for (const ContactCandidate& candidate : parts.contact.candidate) {
    add(std::vector<double>{candidate.surface_m, candidate.area_m2, candidate.stiffness_N_m,
                            candidate.cell_compliance_m_Pa});
    add(candidate.relief_m);
    for (const Tributary& piece : candidate.tributary) add(std::vector<double>{piece.place_m, piece.extent_m});
  }
  return all;
}

Scenario by_mass() {
  Scenario scenario = small_box();
  LatticeParameters& product = lattice_of(scenario);
  product.shape = Shape::cylinder;
  product.size_m = {0.02, 0.024, 0.022};
  product.cell_size_m = 0.008;
  product.density_kg_m3.reset();
  product.mass_kg = 0.01;
  product.yield_stress_Pa = 1e3;
  product.tangent_modulus_Pa = 1e4;
  scenario.strategy.waypoint.push_back({.place_m = std::array<double, 3>{0.0, 0.05, 0.2}});
  return scenario;
}

Scenario by_loss() {
  Scenario scenario = by_mass();
  LatticeParameters& product = lattice_of(scenario);
  product.mass_kg.reset();
  product.density_kg_m3 = 900.0;
  product.relaxation_time_s.reset();
  product.loss_ratio = 0.2;
  product.at_frequency_Hz = 50.0;
  product.prony_modulus = {0.2, 0.3};
  product.prony_time_s = {0.5, 20.0};
  return scenario;
}

Scenario by_profile() {
  Scenario scenario = by_mass();
  LatticeParameters& product = lattice_of(scenario);
  product.shape = Shape::revolution;
  product.size_m = {0.024, 0.024, 0.024};
  product.profile_height = {0.0, 1.0, 2.5, 3.0};
  product.profile_radius = {0.0, 1.0, 1.1, 0.0};
  return scenario;
}

Scenario by_exponents() {
  Scenario scenario = by_mass();
  lattice_of(scenario).shape = Shape::superellipsoid;
  lattice_of(scenario).exponents = {2.5, 3.0};
  return scenario;
}

Scenario by_modes() {
  Scenario scenario = by_mass();
  scenario.simulation.body = ProductBody::modes;
  return scenario;
}

Scenario network() {
  Scenario scenario = oscillator(1.0, 100.0, 1e-3, 10);
  NetworkParameters& network = network_of(scenario);
  NetworkParticle third;
  third.position_m = {1.0, 1.0, 0.5};
  third.mass_kg = 0.5;
  third.contact_stiffness_N_m = 50.0;
  network.particle.push_back(third);
  NetworkSpring spring;
  spring.between = {1, 2};
  spring.stiffness_N_m = 70.0;
  spring.damping_N_s_m = 0.1;
  spring.rest_length_m = 1.0;
  spring.yield_force_N = 5.0;
  spring.hardening_ratio = 0.1;
  spring.burgers_flow_N_s_m = 700.0;
  spring.burgers_recovery_N_m = 100.0;
  spring.burgers_recovery_N_s_m = 50.0;
  network.spring.push_back(spring);
  network.load.push_back({1, {0.0}, {{1.0, 0.0, 0.0}}});
  return scenario;
}

Scenario by_mesh() {
  Scenario scenario = by_mass();
  LatticeParameters& product = lattice_of(scenario);
  product.shape = Shape::mesh;
  product.mesh = mesh_product(icosphere(1), {}, (std::uint64_t{7} << 40) + 3).mesh;
  return scenario;
}

class FactorKeys : public ::testing::TestWithParam<Scenario (*)()> {};

TEST_P(FactorKeys, ChangeExactlyWithTheFieldsThatDecideTheModel) {
  const Scenario base = GetParam()();
  std::string error;
  const auto model = Model::build(base, error);
  ASSERT_NE(model, nullptr) << error;
  const std::vector<double> numbers = numbers_of(*model);
  for (int field = 0;; ++field) {
    Scenario changed = base;
    Perturbation perturbation(field);
    visit_parameters(changed,
                     [&](std::string_view, int, auto& parameters) { visit_fields(parameters, perturbation); });
    if (!perturbation.happened()) break;
    const bool key_changed = factor_key(changed) != factor_key(base);
    // A rotation of the gripper that becomes one lets the product turn, a height to fall from lets it roll; the
    // faces of shaped pads are met at places; modes move instead of particles.
    const bool decides =
        perturbation.decides() == Decides::model || product_frame(changed) != product_frame(base) ||
        contact_set(changed) != contact_set(base) || has_shaped_pads(changed) != has_shaped_pads(base) ||
        has_lattice_pads(changed) != has_lattice_pads(base) || mode_count(changed) != mode_count(base) ||
        stands_on_its_bottom(changed) != stands_on_its_bottom(base);
    EXPECT_EQ(key_changed, decides) << perturbation.name();
    // A second mass beside the density and the like: no model.
    const auto other = Model::build(changed, error);
    if (other == nullptr) continue;
    // Exact: whoever shares a model has to share its bits.
    if (numbers_of(*other) != numbers) {
      EXPECT_TRUE(key_changed) << perturbation.name() << " changes the model, not the key";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Products, FactorKeys,
                         ::testing::Values(by_mass, by_loss, by_profile, by_exponents, by_mesh, by_modes,
                                           network));

TEST(FactorKey, TellsProductsOfDifferentKindsApart) {
  EXPECT_NE(factor_key(by_mass()), factor_key(network()));
  Scenario smaller = network();
  network_of(smaller).particle.pop_back();
  network_of(smaller).spring.pop_back();
  EXPECT_NE(factor_key(smaller), factor_key(network()));
}

TEST(FactorKey, LeavesOutWhatLanesMayDifferIn) {
  Scenario other = by_mass();
  jaw_of(other).pad_modulus_Pa *= 2.0;
  other.cell.gravity_m_s2[2] *= 0.5;
  other.strategy.grip_force_N *= 2.0;
  other.limits.slip_m *= 2.0;
  EXPECT_EQ(factor_key(other), factor_key(by_mass()));
}

TEST(FactorKey, HoldsAllThatMakesPadsWhichAreBodies) {
  Scenario base = small_box();
  jaw_of(base).pad.kind = PadKind::lattice;
  jaw_of(base).pad.cell_size_m = 0.0015;
  EXPECT_NE(factor_key(base), factor_key(small_box()));
  const std::vector<void (*)(Scenario&)> changes = {
      [](Scenario& s) { jaw_of(s).pad_size_m[1] *= 1.01; },
      [](Scenario& s) { jaw_of(s).pad_thickness_m *= 1.01; },
      [](Scenario& s) { jaw_of(s).pad_modulus_Pa *= 1.01; },
      [](Scenario& s) { jaw_of(s).pad_poisson_ratio = 0.3; },
      [](Scenario& s) { jaw_of(s).pad_relaxation_time_s = 1e-3; },
      [](Scenario& s) { jaw_of(s).pad.cell_size_m = 0.00151; },
      [](Scenario& s) { jaw_of(s).pad.density_kg_m3 *= 1.01; },
      [](Scenario& s) { s.cell.grip_height_m += 1e-3; },
      [](Scenario& s) { s.cell.grip_offset_m += 1e-3; },
  };
  for (std::size_t i = 0; i < changes.size(); ++i) {
    Scenario changed = base;
    changes[i](changed);
    EXPECT_NE(factor_key(changed), factor_key(base)) << "change " << i;
  }
  Scenario other = base;
  jaw_of(other).finger_mass_kg *= 2.0;
  jaw_of(other).pad_edge_radius_m = 1e-3;
  EXPECT_EQ(factor_key(other), factor_key(base));
}

}  // namespace
}  // namespace unbruised

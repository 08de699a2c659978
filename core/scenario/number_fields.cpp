#include "core/scenario/number_fields.hpp"

#include <algorithm>
#include <array>
#include <type_traits>

namespace unbruised {
namespace {

constexpr Range kIndex{.min = 0.0, .max = 2147483647.0};
constexpr Range kPoissonRatio{.min = 0.0, .max = 0.5, .max_open = true};
/// Below (1 + sqrt 3) / 2 Wilson's method is not unconditionally stable; above 3 it damps what is looked for.
constexpr Range kTheta{.min = 1.37, .max = 3.0};
constexpr Range kAccuracy{.min = 0.0, .max = 1.0, .max_open = true};

template <typename T>
void visit_numbers(T& member, NumberPlace place, const NumberVisit& visit) {
  if constexpr (std::is_same_v<T, double> || std::is_same_v<T, int> || std::is_same_v<T, std::optional<double>>) {
    visit(place, NumberSlot(&member));
  } else {
    for (std::size_t i = 0; i < member.size(); ++i) {
      NumberPlace at = place;
      (place.element < 0 ? at.element : at.component) = static_cast<int>(i);
      visit_numbers(member[i], at, visit);
    }
  }
}

template <auto member>
void lattice(Scenario& scenario, const NumberVisit& visit) {
  if (auto* p = std::get_if<LatticeParameters>(&scenario.product)) visit_numbers(p->*member, {}, visit);
}
template <auto list, auto member>
void listed(Scenario& scenario, const NumberVisit& visit) {
  auto* network = std::get_if<NetworkParameters>(&scenario.product);
  if (network == nullptr) return;
  auto& items = network->*list;
  for (std::size_t i = 0; i < items.size(); ++i) {
    visit_numbers(items[i].*member, {.index = static_cast<int>(i)}, visit);
  }
}
template <auto member>
void particle(Scenario& scenario, const NumberVisit& visit) {
  listed<&NetworkParameters::particle, member>(scenario, visit);
}
template <auto member>
void spring(Scenario& scenario, const NumberVisit& visit) {
  listed<&NetworkParameters::spring, member>(scenario, visit);
}
template <auto member>
void load(Scenario& scenario, const NumberVisit& visit) {
  listed<&NetworkParameters::load, member>(scenario, visit);
}
void friction(Scenario& scenario, const NumberVisit& visit) {
  std::visit([&](auto& product) { visit_numbers(product.friction, {}, visit); }, scenario.product);
}
template <auto member>
void gripper(Scenario& scenario, const NumberVisit& visit) {
  if (scenario.gripper) visit_numbers((*scenario.gripper).*member, {}, visit);
}
template <auto part, auto member>
void part_of(Scenario& scenario, const NumberVisit& visit) {
  visit_numbers(scenario.*part.*member, {}, visit);
}

using Fields = std::vector<NumberField>;

Fields product_fields() {
  using L = LatticeParameters;
  using P = NetworkParticle;
  using S = NetworkSpring;
  using F = NetworkLoad;
  return {
      {"product.size_m", kPositive, lattice<&L::size_m>},
      {"product.cell_size_m", kPositive, lattice<&L::cell_size_m>},
      {"product.mass_kg", kPositive, lattice<&L::mass_kg>},
      {"product.density_kg_m3", kPositive, lattice<&L::density_kg_m3>},
      {"product.youngs_modulus_Pa", kPositive, lattice<&L::youngs_modulus_Pa>},
      {"product.poisson_ratio", kPoissonRatio, lattice<&L::poisson_ratio>},
      {"product.yield_stress_Pa", kPositive, lattice<&L::yield_stress_Pa>},
      {"product.tangent_modulus_Pa", kPositive, lattice<&L::tangent_modulus_Pa>},
      {"product.relaxation_time_s", kNotNegative, lattice<&L::relaxation_time_s>},
      {"product.loss_ratio", kNotNegative, lattice<&L::loss_ratio>},
      {"product.at_frequency_Hz", kPositive, lattice<&L::at_frequency_Hz>},
      {"product.friction", kNotNegative, friction},
      {"product.initial_velocity_m_s", kAnyNumber, lattice<&L::initial_velocity_m_s>},
      {"product.particle[].position_m", kAnyNumber, particle<&P::position_m>},
      {"product.particle[].mass_kg", kNotNegative, particle<&P::mass_kg>},
      {"product.particle[].initial_displacement_m", kAnyNumber, particle<&P::initial_displacement_m>},
      {"product.particle[].initial_velocity_m_s", kAnyNumber, particle<&P::initial_velocity_m_s>},
      {"product.particle[].contact_stiffness_N_m", kNotNegative, particle<&P::contact_stiffness_N_m>},
      {"product.spring[].between", kIndex, spring<&S::between>},
      {"product.spring[].stiffness_N_m", kNotNegative, spring<&S::stiffness_N_m>},
      {"product.spring[].damping_N_s_m", kNotNegative, spring<&S::damping_N_s_m>},
      {"product.spring[].rest_length_m", kPositive, spring<&S::rest_length_m>},
      {"product.spring[].yield_force_N", kPositive, spring<&S::yield_force_N>},
      {"product.spring[].hardening_ratio", kNotNegative, spring<&S::hardening_ratio>},
      {"product.load[].particle", kIndex, load<&F::particle>},
      {"product.load[].time_s", kAnyNumber, load<&F::time_s>},
      {"product.load[].force_N", kAnyNumber, load<&F::force_N>},
  };
}

Fields gripper_fields() {
  using G = GripperParameters;
  return {
      {"gripper.finger_mass_kg", kPositive, gripper<&G::finger_mass_kg>},
      {"gripper.stroke_m", kPositive, gripper<&G::stroke_m>},
      {"gripper.pad_size_m", kPositive, gripper<&G::pad_size_m>},
      {"gripper.pad_thickness_m", kPositive, gripper<&G::pad_thickness_m>},
      {"gripper.pad_modulus_Pa", kPositive, gripper<&G::pad_modulus_Pa>},
      {"gripper.pad_relaxation_time_s", kNotNegative, gripper<&G::pad_relaxation_time_s>},
      {"gripper.drive_gain_N_s_m", kPositive, gripper<&G::drive_gain_N_s_m>},
      {"gripper.drive_viscous_N_s_m", kNotNegative, gripper<&G::drive_viscous_N_s_m>},
      {"gripper.max_force_N", kPositive, gripper<&G::max_force_N>},
      {"gripper.max_speed_m_s", kPositive, gripper<&G::max_speed_m_s>},
      {"gripper.min_force_N", kNotNegative, gripper<&G::min_force_N>},
      {"gripper.force_accuracy", kAccuracy, gripper<&G::force_accuracy>},
      {"gripper.force_step_N", kNotNegative, gripper<&G::force_step_N>},
      {"gripper.opening_m", kPositive, gripper<&G::opening_m>},
  };
}

template <auto member>
NumberField cell_field(std::string_view path, const Range& range) {
  return {path, range, part_of<&Scenario::cell, member>};
}
Fields cell_fields() {
  using C = CellParameters;
  return {
      cell_field<&C::gravity_m_s2>("cell.gravity_m_s2", kAnyNumber),
      cell_field<&C::support_friction>("cell.support_friction", kNotNegative),
      cell_field<&C::support_modulus_Pa>("cell.support_modulus_Pa", kPositive),
      cell_field<&C::support_thickness_m>("cell.support_thickness_m", kPositive),
      cell_field<&C::support_relaxation_time_s>("cell.support_relaxation_time_s", kNotNegative),
      cell_field<&C::approach_gap_m>("cell.approach_gap_m", kPositive),
      cell_field<&C::grip_height_m>("cell.grip_height_m", kAnyNumber),
      cell_field<&C::grip_offset_m>("cell.grip_offset_m", kAnyNumber),
      cell_field<&C::lift_height_m>("cell.lift_height_m", kNotNegative),
      cell_field<&C::transfer_m>("cell.transfer_m", kAnyNumber),
      cell_field<&C::place_height_m>("cell.place_height_m", kAnyNumber),
  };
}

template <auto member>
NumberField strategy_field(std::string_view path, const Range& range) {
  return {path, range, part_of<&Scenario::strategy, member>};
}
Fields strategy_fields() {
  using S = StrategyParameters;
  return {
      strategy_field<&S::approach_speed_m_s>("strategy.approach_speed_m_s", kPositive),
      strategy_field<&S::grip_force_N>("strategy.grip_force_N", kPositive),
      strategy_field<&S::contact_force_N>("strategy.contact_force_N", kNotNegative),
      strategy_field<&S::grip_ramp_s>("strategy.grip_ramp_s", kNotNegative),
      strategy_field<&S::settle_s>("strategy.settle_s", kNotNegative),
      strategy_field<&S::lift_acceleration_m_s2>("strategy.lift_acceleration_m_s2", kPositive),
      strategy_field<&S::transfer_acceleration_m_s2>("strategy.transfer_acceleration_m_s2", kPositive),
      strategy_field<&S::lower_acceleration_m_s2>("strategy.lower_acceleration_m_s2", kPositive),
      strategy_field<&S::speed_m_s>("strategy.speed_m_s", kPositive),
      strategy_field<&S::hold_s>("strategy.hold_s", kNotNegative),
      strategy_field<&S::release_height_m>("strategy.release_height_m", kNotNegative),
      strategy_field<&S::place_settle_s>("strategy.place_settle_s", kNotNegative),
      strategy_field<&S::release_speed_m_s>("strategy.release_speed_m_s", kPositive),
      strategy_field<&S::recover_s>("strategy.recover_s", kNotNegative),
  };
}

template <auto member>
NumberField limit_field(std::string_view path, const Range& range) {
  return {path, range, part_of<&Scenario::limits, member>};
}
Fields limit_fields() {
  using M = LimitParameters;
  return {
      limit_field<&M::permanent_set_m>("limits.permanent_set_m", kNotNegative),
      limit_field<&M::plastic_strain>("limits.plastic_strain", kNotNegative),
      limit_field<&M::bruised_volume_m3>("limits.bruised_volume_m3", kNotNegative),
      limit_field<&M::peak_pressure_Pa>("limits.peak_pressure_Pa", kNotNegative),
      limit_field<&M::absorbed_energy_J>("limits.absorbed_energy_J", kNotNegative),
      limit_field<&M::finger_force_N>("limits.finger_force_N", kNotNegative),
      limit_field<&M::contact_yield_ratio>("limits.contact_yield_ratio", kNotNegative),
      limit_field<&M::slip_m>("limits.slip_m", kPositive),
  };
}

template <auto member>
NumberField simulation_field(std::string_view path, const Range& range) {
  return {path, range, part_of<&Scenario::simulation, member>};
}
Fields simulation_fields() {
  using S = SimulationParameters;
  return {
      simulation_field<&S::time_step_s>("simulation.time_step_s", kPositive),
      simulation_field<&S::theta>("simulation.theta", kTheta),
      simulation_field<&S::duration_s>("simulation.duration_s", kPositive),
      simulation_field<&S::trace_interval_s>("simulation.trace_interval_s", kPositive),
      simulation_field<&S::pressure_patch_m>("simulation.pressure_patch_m", kPositive),
      simulation_field<&S::max_strain>("simulation.max_strain", kPositive),
      simulation_field<&S::max_rotation_rad>("simulation.max_rotation_rad", kPositive),
  };
}

std::optional<double> value_of(NumberSlot slot) {
  if (auto* const* number = std::get_if<double*>(&slot)) return **number;
  if (auto* const* integer = std::get_if<int*>(&slot)) return **integer;
  return *std::get<std::optional<double>*>(slot);
}

}  // namespace

const std::vector<NumberField>& number_fields() {
  static const Fields table = [] {
    Fields all;
    for (const Fields& part : {product_fields(), gripper_fields(), cell_fields(), strategy_fields(),
                               limit_fields(), simulation_fields()}) {
      all.insert(all.end(), part.begin(), part.end());
    }
    return all;
  }();
  return table;
}

const NumberField* find_number_field(std::string_view path) {
  const Fields& all = number_fields();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const NumberField& field) { return field.path == path; });
  return found == all.end() ? nullptr : &*found;
}

std::string path_of(std::string_view pattern, const NumberPlace& place) {
  std::string path(pattern);
  const auto brackets = [](int number) { return "[" + std::to_string(number) + "]"; };
  if (const std::size_t at = path.find("[]"); at != std::string::npos && place.index >= 0) {
    path.replace(at, 2, brackets(place.index));
  }
  if (place.element >= 0) path += brackets(place.element);
  if (place.component >= 0) path += brackets(place.component);
  return path;
}

void for_each_number(const NumberField& field, const Scenario& scenario,
                     const std::function<void(const NumberPlace&, double)>& visit) {
  // The table hands out places to write to; here they are only read.
  field.each(const_cast<Scenario&>(scenario), [&](const NumberPlace& place, NumberSlot slot) {
    if (const auto value = value_of(slot)) visit(place, *value);
  });
}

std::optional<double> number_of(const NumberField& field, const Scenario& scenario) {
  std::optional<double> first;
  for_each_number(field, scenario, [&](const NumberPlace& /*place*/, double value) {
    if (!first) first = value;
  });
  return first;
}

}  // namespace unbruised

#include <algorithm>
#include <cmath>

#include "core/product/lattice_stiffness.hpp"
#include "core/simulation/simulation.hpp"

namespace unbruised {
namespace {

/// Collects broken rules, one line per rule.
class Checker {
 public:
  void require(bool holds, const char* field, const char* rule) {
    if (!holds) violations_.push_back({field, rule});
  }
  void positive(double value, const char* field) {
    require(std::isfinite(value) && value > 0.0, field, "must be > 0");
  }
  void not_negative(double value, const char* field) {
    require(std::isfinite(value) && value >= 0.0, field, "must be >= 0");
  }
  void finite(double value, const char* field) { require(std::isfinite(value), field, "must be finite"); }
  template <std::size_t N>
  void finite(const std::array<double, N>& values, const char* field) {
    require(std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); }), field,
            "must be finite");
  }
  void finite(const std::optional<double>& value, const char* field) {
    if (value) finite(*value, field);
  }
  [[nodiscard]] std::vector<Violation> take() { return std::move(violations_); }

 private:
  std::vector<Violation> violations_;
};

void check_lattice(const LatticeParameters& p, Checker& check) {
  bool sizes = true;
  for (double size : p.size_m) sizes = sizes && std::isfinite(size) && size > 0.0;
  check.require(sizes, "product.size_m", "must be three numbers > 0");
  check.positive(p.cell_size_m, "product.cell_size_m");
  check.positive(p.youngs_modulus_Pa, "product.youngs_modulus_Pa");
  check.require(p.poisson_ratio >= 0.0 && p.poisson_ratio < 0.5, "product.poisson_ratio",
                "must be >= 0 and < 0.5");
  check.require(p.mass_kg.has_value() != p.density_kg_m3.has_value(), "product.mass_kg",
                "give exactly one of mass_kg and density_kg_m3");
  if (p.mass_kg) check.positive(*p.mass_kg, "product.mass_kg");
  if (p.density_kg_m3) check.positive(*p.density_kg_m3, "product.density_kg_m3");
  check.not_negative(p.friction, "product.friction");
  check.finite(p.initial_velocity_m_s, "product.initial_velocity_m_s");
  check.require(p.yield_stress_Pa.has_value() == p.tangent_modulus_Pa.has_value(), "product.tangent_modulus_Pa",
                "yield_stress_Pa and tangent_modulus_Pa come together");
  if (p.yield_stress_Pa) check.positive(*p.yield_stress_Pa, "product.yield_stress_Pa");
  if (p.tangent_modulus_Pa) {
    check.require(*p.tangent_modulus_Pa > 0.0 && *p.tangent_modulus_Pa < p.youngs_modulus_Pa,
                  "product.tangent_modulus_Pa", "must be > 0 and < youngs_modulus_Pa");
  }
  check.require(!(p.relaxation_time_s && p.loss_ratio), "product.relaxation_time_s",
                "give relaxation_time_s or loss_ratio with at_frequency_Hz, not both");
  check.require(p.loss_ratio.has_value() == p.at_frequency_Hz.has_value(), "product.loss_ratio",
                "loss_ratio and at_frequency_Hz come together");
  if (p.relaxation_time_s) check.not_negative(*p.relaxation_time_s, "product.relaxation_time_s");
  if (p.loss_ratio) check.not_negative(*p.loss_ratio, "product.loss_ratio");
  if (p.at_frequency_Hz) check.positive(*p.at_frequency_Hz, "product.at_frequency_Hz");
  if (!sizes || !(p.cell_size_m > 0.0)) return;
  double cells = 1.0;
  for (double size : p.size_m) {
    check.require(p.cell_size_m <= size / 2.0 * (1.0 + 1e-12), "product.cell_size_m",
                  "must be at most half the smallest extent");
    cells *= size / p.cell_size_m;
  }
  check.require(cells <= 2e6, "product.cell_size_m", "gives more than 2,000,000 cells");
  if (cells <= 2e6) {
    check.require(lattice_is_admissible(lattice_cell_extent_m(p)), "product.cell_size_m",
                  "gives cells whose sides differ by more than 20 %; choose one that divides the extents better");
  }
}

void check_network(const NetworkParameters& p, Checker& check) {
  check.require(!p.particle.empty(), "product.particle", "a network needs at least one particle");
  const int count = static_cast<int>(p.particle.size());
  for (const NetworkParticle& particle : p.particle) {
    const bool wall = particle.fixed[0] && particle.fixed[1] && particle.fixed[2];
    check.require(particle.mass_kg > 0.0 || (wall && particle.mass_kg == 0.0), "product.particle.mass_kg",
                  "must be > 0 unless all three freedoms are fixed");
    check.finite(particle.mass_kg, "product.particle.mass_kg");
    check.finite(particle.position_m, "product.particle.position_m");
    check.finite(particle.initial_displacement_m, "product.particle.initial_displacement_m");
    check.finite(particle.initial_velocity_m_s, "product.particle.initial_velocity_m_s");
    check.not_negative(particle.contact_stiffness_N_m, "product.particle.contact_stiffness_N_m");
  }
  for (const NetworkSpring& spring : p.spring) {
    const auto [a, b] = spring.between;
    const bool exist = a >= 0 && a < count && b >= 0 && b < count && a != b;
    check.require(exist, "product.spring.between", "must be two different particles of the network");
    if (exist) {
      double distance2 = 0.0;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double d = p.particle[a].position_m[axis] - p.particle[b].position_m[axis];
        distance2 += d * d;
      }
      check.require(distance2 > 0.0, "product.spring.between", "joins two particles at the same place");
    }
    check.not_negative(spring.stiffness_N_m, "product.spring.stiffness_N_m");
    check.not_negative(spring.damping_N_s_m, "product.spring.damping_N_s_m");
    if (spring.rest_length_m) check.positive(*spring.rest_length_m, "product.spring.rest_length_m");
    if (spring.yield_force_N) check.positive(*spring.yield_force_N, "product.spring.yield_force_N");
    check.not_negative(spring.hardening_ratio, "product.spring.hardening_ratio");
  }
  for (const NetworkLoad& load : p.load) {
    check.require(load.particle >= 0 && load.particle < count, "product.load.particle",
                  "must be a particle of the network");
    check.require(!load.time_s.empty() && load.time_s.size() == load.force_N.size(), "product.load.force_N",
                  "must have as many entries as time_s, at least one");
    for (const double time : load.time_s) check.finite(time, "product.load.time_s");
    check.require(std::is_sorted(load.time_s.begin(), load.time_s.end()), "product.load.time_s",
                  "must not decrease");
    for (const auto& force : load.force_N) check.finite(force, "product.load.force_N");
  }
}

void check_gripper(const GripperParameters& p, Checker& check) {
  check.positive(p.finger_mass_kg, "gripper.finger_mass_kg");
  check.positive(p.stroke_m, "gripper.stroke_m");
  check.require(p.pad_size_m[0] > 0.0 && p.pad_size_m[1] > 0.0, "gripper.pad_size_m", "must be two numbers > 0");
  check.finite(p.pad_size_m, "gripper.pad_size_m");
  check.positive(p.pad_thickness_m, "gripper.pad_thickness_m");
  check.positive(p.pad_modulus_Pa, "gripper.pad_modulus_Pa");
  check.not_negative(p.pad_relaxation_time_s, "gripper.pad_relaxation_time_s");
  check.positive(p.drive_gain_N_s_m, "gripper.drive_gain_N_s_m");
  check.not_negative(p.drive_viscous_N_s_m, "gripper.drive_viscous_N_s_m");
  check.positive(p.max_force_N, "gripper.max_force_N");
  check.positive(p.max_speed_m_s, "gripper.max_speed_m_s");
  check.require(p.min_force_N >= 0.0 && p.min_force_N <= p.max_force_N, "gripper.min_force_N",
                "must be >= 0 and at most max_force_N");
  check.require(p.force_accuracy >= 0.0 && p.force_accuracy < 1.0, "gripper.force_accuracy",
                "must be >= 0 and < 1");
  check.not_negative(p.force_step_N, "gripper.force_step_N");
  if (p.opening_m) check.positive(*p.opening_m, "gripper.opening_m");
}

void check_strategy(const Scenario& scenario, Checker& check) {
  const StrategyParameters& s = scenario.strategy;
  const CellParameters& cell = scenario.cell;
  check.positive(s.approach_speed_m_s, "strategy.approach_speed_m_s");
  check.require(s.approach_speed_m_s <= scenario.gripper->max_speed_m_s, "strategy.approach_speed_m_s",
                "must be at most gripper.max_speed_m_s");
  check.positive(s.grip_force_N, "strategy.grip_force_N");
  check.require(s.grip_force_N <= scenario.gripper->max_force_N, "strategy.grip_force_N",
                "must be at most gripper.max_force_N");
  check.require(s.contact_force_N >= 0.0 && s.contact_force_N <= s.grip_force_N, "strategy.contact_force_N",
                "must be >= 0 and <= grip_force_N");
  check.not_negative(s.grip_ramp_s, "strategy.grip_ramp_s");
  check.not_negative(s.settle_s, "strategy.settle_s");
  check.positive(s.lift_acceleration_m_s2, "strategy.lift_acceleration_m_s2");
  if (s.transfer_acceleration_m_s2)
    check.positive(*s.transfer_acceleration_m_s2, "strategy.transfer_acceleration_m_s2");
  if (s.lower_acceleration_m_s2) check.positive(*s.lower_acceleration_m_s2, "strategy.lower_acceleration_m_s2");
  check.positive(s.speed_m_s, "strategy.speed_m_s");
  check.not_negative(s.hold_s, "strategy.hold_s");
  check.not_negative(s.release_height_m, "strategy.release_height_m");
  check.not_negative(s.place_settle_s, "strategy.place_settle_s");
  check.positive(s.release_speed_m_s, "strategy.release_speed_m_s");
  check.not_negative(s.recover_s, "strategy.recover_s");
  check.positive(cell.approach_gap_m, "cell.approach_gap_m");
  check.not_negative(cell.lift_height_m, "cell.lift_height_m");
  check.finite(cell.grip_height_m, "cell.grip_height_m");
  check.finite(cell.grip_offset_m, "cell.grip_offset_m");
  check.finite(cell.transfer_m, "cell.transfer_m");
  check.finite(cell.place_height_m, "cell.place_height_m");
  check.require(cell.place_height_m + s.release_height_m <= cell.lift_height_m, "cell.place_height_m",
                "place_height_m + strategy.release_height_m must be at most lift_height_m");
}

void check_limits(const LimitParameters& limits, Checker& check) {
  check.finite(limits.permanent_set_m, "limits.permanent_set_m");
  check.finite(limits.plastic_strain, "limits.plastic_strain");
  check.finite(limits.bruised_volume_m3, "limits.bruised_volume_m3");
  check.finite(limits.peak_pressure_Pa, "limits.peak_pressure_Pa");
  check.finite(limits.absorbed_energy_J, "limits.absorbed_energy_J");
  check.finite(limits.finger_force_N, "limits.finger_force_N");
  check.finite(limits.contact_yield_ratio, "limits.contact_yield_ratio");
  check.positive(limits.slip_m, "limits.slip_m");
}

}  // namespace

std::vector<Violation> validate(const Scenario& scenario) {
  Checker check;
  const auto* lattice = std::get_if<LatticeParameters>(&scenario.product);
  if (lattice != nullptr) {
    check_lattice(*lattice, check);
  } else {
    check_network(std::get<NetworkParameters>(scenario.product), check);
    check.require(!scenario.gripper, "gripper", "a network cannot be gripped in this version");
  }
  if (scenario.gripper) {
    check_gripper(*scenario.gripper, check);
    check_strategy(scenario, check);
  } else {
    check.require(scenario.simulation.duration_s.has_value(), "simulation.duration_s",
                  "is required without a gripper");
  }
  if (scenario.simulation.duration_s) check.positive(*scenario.simulation.duration_s, "simulation.duration_s");
  check.not_negative(scenario.cell.support_friction, "cell.support_friction");
  check.positive(scenario.cell.support_modulus_Pa, "cell.support_modulus_Pa");
  check.positive(scenario.cell.support_thickness_m, "cell.support_thickness_m");
  check.not_negative(scenario.cell.support_relaxation_time_s, "cell.support_relaxation_time_s");
  check.finite(scenario.cell.gravity_m_s2, "cell.gravity_m_s2");
  check_limits(scenario.limits, check);
  check.positive(scenario.simulation.time_step_s, "simulation.time_step_s");
  check.require(scenario.simulation.theta >= 1.37 && scenario.simulation.theta <= 3.0, "simulation.theta",
                "must be >= 1.37 and <= 3: below (1 + sqrt 3) / 2 Wilson's method is not unconditionally stable");
  if (scenario.simulation.trace_interval_s) {
    check.positive(*scenario.simulation.trace_interval_s, "simulation.trace_interval_s");
  }
  check.positive(scenario.simulation.pressure_patch_m, "simulation.pressure_patch_m");
  check.positive(scenario.simulation.max_strain, "simulation.max_strain");
  check.positive(scenario.simulation.max_rotation_rad, "simulation.max_rotation_rad");
  return check.take();
}

}  // namespace unbruised

#pragma once

/// @file
/// What a material adds to the elastic product: a load on the right-hand side that follows the displacement, and
/// the account of what it takes. The factor never changes.

#include <memory>
#include <optional>
#include <vector>

#include "core/body/body_model.hpp"
#include "core/integration/wilson_theta.hpp"
#include "core/lanes/lane.hpp"
#include "core/lanes/lane_archive.hpp"
#include "core/scenario/product_frame.hpp"

namespace unbruised {

/// The shape which the body's statics give under a load, and a displacement beside it.
struct LastingShape {
  std::vector<double> load_N;          ///< [3n]
  std::vector<double> displacement_m;  ///< [3n], or empty
};

/// All lanes of one material; energies in J since load.
class Material {
 public:
  virtual ~Material() = default;

  virtual void load(int lane, const Scenario& scenario) = 0;
  /// All that a lane keeps from step to step, but for what `load` sets.
  virtual void archive(LaneArchive& lane) {
    lane(largest_strain_, largest_cell_rotation_, largest_plastic_, plastic_work_, hardening_energy_);
  }

  /// Opens the accounts of energy of a lane anew; what the material is stays.
  void open_accounts(int lane) {
    plastic_work_.set(lane, 0.0);
    hardening_energy_.set(lane, 0.0);
  }

  /// The load that holds at t + theta dt so far, rows 3 x particle + axis; null: there never is one.
  [[nodiscard]] virtual const LaneArray* load_theta() const = 0;
  /// Follows `load`, once the displacement of the lane is there too.
  virtual void settle(int /*lane*/, const LaneArray& /*u*/) {}
  /// Starts a step from the state at t; before the body begins it.
  virtual void begin_step(const LaneArray& u) = 0;
  /// What a lattice remembers, as the displacement whose stiffness is that force at t + theta dt; null: nothing.
  [[nodiscard]] virtual const LaneArray* remembered() const { return nullptr; }
  /// Books the power of what fades, after the body has begun the step.
  /// Takes the velocity of the deformation, K times it, and the lanes that run.
  virtual void book_power(const LaneArray& /*rate*/, const LaneArray& /*stiffness_rate*/,
                          const Mask& /*running*/) {}
  /// Follows the displacement at t + theta dt in the lanes of `active`.
  /// @return the lanes whose load still moved by more than the tolerance: they must be solved again
  virtual Mask update(const LaneArray& u_theta, const Mask& active) = 0;
  /// Moves the state to t + dt in the lanes of `running`. @param u the displacement there
  virtual void end_step(const LaneArray& u, const WilsonTheta& wilson, const Mask& running) = 0;

  /// Largest strain, sqrt(e:e), at the last update; 0 where it is not measured.
  [[nodiscard]] const Lane& largest_strain() const { return largest_strain_; }
  /// Largest rotation of a cell against the body's frame at the last update [rad]; 0 where it is not measured.
  [[nodiscard]] const Lane& largest_cell_rotation() const { return largest_cell_rotation_; }
  /// Largest accumulated plastic strain.
  [[nodiscard]] const Lane& largest_plastic_strain() const { return largest_plastic_; }
  /// Plastic work, and the part of it that hardening stores.
  [[nodiscard]] const Lane& plastic_work() const { return plastic_work_; }
  [[nodiscard]] const Lane& hardening_energy() const { return hardening_energy_; }
  /// Energy of the plastic strains themselves, and what has faded: with it the elastic energy is
  /// 1/2 u K u - u f_p + this.
  [[nodiscard]] virtual double self_energy(int lane, const LaneArray& u) const = 0;
  /// What fading stiffness has turned into heat.
  [[nodiscard]] virtual double relaxed_J(int /*lane*/, const LaneArray& /*u*/) const { return 0.0; }
  /// The load of the present plastic strain of one lane, [3n].
  [[nodiscard]] virtual std::vector<double> plastic_load_N(int lane) const = 0;
  /// Does it flow under every force?
  [[nodiscard]] virtual bool flows() const { return false; }
  /// What stays once the body is let go of and has recovered.
  [[nodiscard]] virtual LastingShape lasting(int lane, const LaneArray& /*u*/) const {
    return {plastic_load_N(lane), {}};
  }
  /// Volume with more accumulated plastic strain than `threshold`; none: the material has no volume.
  [[nodiscard]] virtual std::optional<double> volume_above_m3(int lane, double threshold) const = 0;
  /// Of the cells of one lane, for those who record it: plastic strain, 6 each (Voigt xx yy zz yz xz xy, tensor
  /// shears), and what has accumulated, 1 each. Empty: there are no cells that flow.
  [[nodiscard]] virtual std::vector<double> cell_strain(int /*lane*/) const { return {}; }
  [[nodiscard]] virtual std::vector<double> accumulated_cell_strain(int /*lane*/) const { return {}; }

 protected:
  /// Moves a row that is linear in time to t + dt in the lanes of `running`. @return the row there
  static Lane take_over(const WilsonTheta& wilson, const Mask& running, std::size_t row, LaneArray& now,
                        LaneArray& theta) {
    const Lane before = now.get(row);
    const Lane after = select(running, wilson.at_end(before, theta.get(row)), before);
    now.put(row, after);
    theta.put(row, after);
    return after;
  }
  static std::vector<double> of_lane(const LaneArray& rows, int lane) {
    std::vector<double> values(rows.rows());
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = rows.at(i, lane);
    return values;
  }
  void clear_account(int lane) {
    for (Lane* value :
         {&largest_strain_, &largest_cell_rotation_, &largest_plastic_, &plastic_work_, &hardening_energy_}) {
      value->set(lane, 0.0);
    }
  }
  Lane largest_strain_{0.0}, largest_cell_rotation_{0.0}, largest_plastic_{0.0}, plastic_work_{0.0},
      hardening_energy_{0.0};
};

/// The material of a body: plasticity and relaxation at cells or springs, or none.
/// @param body has to outlive the material
/// @param wilson with whose step it moves
/// @param frame of the body; in a floating one the rotations of cells are measured
std::unique_ptr<Material> make_material(const BodyModel& body, const WilsonTheta& wilson,
                                        ProductFrame frame = ProductFrame::upright);

/// What somebody else measures of a solid, and where it is found; both outlive its material.
struct MeasuredElsewhere {
  const Lane& largest_strain;
  const Lane& largest_cell_rotation;
};

/// One that adds nothing. @param measured none: it is no solid
std::unique_ptr<Material> make_elastic_material(std::size_t particle_count,
                                                std::optional<MeasuredElsewhere> measured = std::nullopt);

}  // namespace unbruised

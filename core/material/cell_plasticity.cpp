#include "core/material/cell_plasticity.hpp"

#include <algorithm>
#include <limits>
#include <span>

#include "core/door/require.hpp"
#include "core/scenario/product.hpp"

namespace unbruised {
namespace {

/// Plastic strain that a further solve would still move by less than this counts as converged: a millionth of the
/// strain (1 %) at which limits are usually set.
constexpr double kTolerance = 1e-8;
/// Above every yield stress [Pa].
constexpr double kNeverYields = 1e200;

}  // namespace

CellPlasticity::CellPlasticity(const BodyModel& body, const WilsonTheta& wilson, ProductFrame frame)
    : body_(body),
      lattice_(*body.lattice),
      time_step_s_(wilson.dt),
      volume_m3_(body.cell.front().volume_m3),
      measures_rotation_(frame == ProductFrame::floating) {
  for (std::size_t axis = 0; axis < 3; ++axis) gradient_[axis] = 1.0 / (4.0 * lattice_.cell_extent_m[axis]);
  for (const CellStiffness& cell : body.cell) material_.push_back({.shear_modulus = Lane(cell.D[21])});  // D_44
  const std::size_t cells = lattice_.cell.size();
  touched_.assign(cells, 0);
  strain_ = LaneArray(6 * cells);
  strain_theta_ = LaneArray(6 * cells);
  accumulated_ = LaneArray(cells);
  accumulated_theta_ = LaneArray(cells);
  load_ = LaneArray(3 * lattice_.position_m.size());
  load_theta_ = LaneArray(3 * lattice_.position_m.size());
  if (body.relaxation.branch.empty()) return;
  relaxation_.emplace(body.relaxation, 3 * body.particle_count);
  share_ = body.relaxation.stiffness_theta;
  branch_strain_.assign(body.relaxation.branch.size(), LaneArray(6 * cells));
  past_strain_ = LaneArray(6 * cells);
}

void CellPlasticity::load(int lane, const Scenario& scenario) {
  require(is_lane(lane), "CellPlasticity::load: there is no such lane");
  constexpr YieldLaw kElastic{std::numeric_limits<double>::infinity(), 0.0, 0.0};
  for (std::size_t m = 0; m < material_.size(); ++m) {
    const YieldLaw law = yield_law(scenario.product, m).value_or(kElastic);
    material_[m].yield_stress.set(lane, law.yield_stress_Pa);
    material_[m].hardening.set(lane, law.hardening_modulus_Pa);
  }
  for (std::size_t cell = 0; cell < touched_.size(); ++cell) {
    if (touched_[cell] == 0) continue;
    for (std::size_t i = 0; i < 6; ++i)
      strain_.at(6 * cell + i, lane) = strain_theta_.at(6 * cell + i, lane) = 0.0;
    for (LaneArray& strain : branch_strain_) {
      for (std::size_t i = 0; i < 6; ++i) strain.at(6 * cell + i, lane) = 0.0;
    }
    accumulated_.at(cell, lane) = accumulated_theta_.at(cell, lane) = 0.0;
  }
  load_.clear_lane(lane);
  load_theta_.clear_lane(lane);
  clear_account(lane);
  if (relaxation_) relaxation_->load(lane);
  deformed_.load(lane);
}

void CellPlasticity::archive(LaneArchive& lane) {
  Material::archive(lane);
  if (relaxation_) {
    relaxation_->archive(lane);
    deformed_.archive(lane);
    for (LaneArray& strain : branch_strain_) lane(strain);
    lane(start_energy_J_[static_cast<std::size_t>(lane.lane())]);
  }
  double flown = 0.0;
  for (std::size_t cell = 0; cell < touched_.size(); ++cell) flown += accumulated_.at(cell, lane.lane());
  lane(flown);
  if (!(flown > 0.0)) return;
  lane(strain_, strain_theta_, accumulated_, accumulated_theta_, load_, load_theta_);
  for (std::size_t cell = 0; lane.arrives() && cell < touched_.size(); ++cell) {
    if (accumulated_.at(cell, lane.lane()) > 0.0) touched_[cell] = 1;
  }
}

void CellPlasticity::settle(int lane, const LaneArray& u) {
  if (!relaxation_) return;
  relaxation_->settle(lane, u);
  start_energy_J_[static_cast<std::size_t>(lane)] = elastic_energy(lane, u, strain_) + faded_energy(lane, u);
}

void CellPlasticity::begin_step(const LaneArray& u) {
  flowing_ = false;
  if (!relaxation_) return;
  may_yield_ = std::ranges::any_of(
      material_, [](const CellMaterial& each) { return any(each.yield_stress < Lane(kNeverYields)); });
  relaxation_->begin_step(u);
  has_load_ = std::ranges::any_of(touched_, [](unsigned char touched) { return touched != 0; });
  if (!has_load_) return;
  load_.fill(0.0);
  load_theta_.fill(0.0);
  for (std::size_t cell = 0; cell < touched_.size(); ++cell) {
    if (touched_[cell] != 0) remember(cell);
  }
}

/// The loads of a cell at t and, with what it remembers and no further flow, at t + theta dt.
void CellPlasticity::remember(std::size_t cell) {
  const RelaxationStep& step = relaxation_->step();
  const Lane shear_modulus = material_of(cell).shear_modulus, twice_shear = shear_modulus + shear_modulus;
  Lane now[6], later[6];
  for (std::size_t i = 0; i < 6; ++i) {
    const std::size_t row = 6 * cell + i;
    const Lane plastic = strain_.get(row);
    Lane past(0.0), present = Lane(step.long_term) * plastic;
    for (std::size_t k = 0; k < branch_strain_.size(); ++k) {
      const BranchStep& b = step.branch[k];
      const Lane q = branch_strain_[k].get(row);
      past += Lane(b.share) * (Lane(b.keep_theta) * q - Lane(b.gain_theta) * plastic);
      present += Lane(b.share) * q;
    }
    past_strain_.put(row, past);
    now[i] = twice_shear * present;
    later[i] = twice_shear * (Lane(share_) * plastic + past);
  }
  add_load(cell, now, load_);
  add_load(cell, later, load_theta_);
}

void CellPlasticity::book_power(const LaneArray& rate, const LaneArray& stiffness_rate, const Mask& running) {
  if (!relaxation_) return;
  Lane power(0.0);
  for (std::size_t i = 0; i < rate.rows(); ++i) {
    const Lane of_strain = relaxation_->stressed().get(i) * stiffness_rate.get(i);
    power += has_load_ ? of_strain - load_.get(i) * rate.get(i) : of_strain;
  }
  deformed_.book(time_step_s_, power, running);
}

void CellPlasticity::add_load(std::size_t cell, const Lane (&stress)[6], LaneArray& load) const {
  const Lane volume(volume_m3_);
  const Lane g[3] = {Lane(gradient_[0]) * volume, Lane(gradient_[1]) * volume, Lane(gradient_[2]) * volume};
  // Traction-like parts: row i of the stress times the gradient along each axis.
  constexpr int kVoigt[3][3] = {{0, 5, 4}, {5, 1, 3}, {4, 3, 2}};
  Lane part[3][3];
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) part[i][j] = stress[kVoigt[i][j]] * g[j];
  }
  for (int corner = 0; corner < 8; ++corner) {
    const std::size_t row = row_of(cell, corner);
    for (int i = 0; i < 3; ++i) {
      Lane force = load.get(row + i);
      for (int j = 0; j < 3; ++j) force = ((corner >> j) & 1) != 0 ? force + part[i][j] : force - part[i][j];
      load.put(row + i, force);
    }
  }
}

/// Mean gradient of one displacement over a cell from its values at the corners: differences of opposite faces,
/// du_i/dx_j = (sum_+ u_i - sum_- u_i) / (4 h_j).
[[gnu::always_inline]] inline void CellPlasticity::mean_gradient(const Lane (&u)[8], Lane (&gradient)[3]) const {
  const Lane d01 = u[1] - u[0], d23 = u[3] - u[2], d45 = u[5] - u[4], d67 = u[7] - u[6];
  const Lane s01 = u[1] + u[0], s23 = u[3] + u[2], s45 = u[5] + u[4], s67 = u[7] + u[6];
  gradient[0] = Lane(gradient_[0]) * ((d01 + d23) + (d45 + d67));
  gradient[1] = Lane(gradient_[1]) * ((s23 - s01) + (s67 - s45));
  gradient[2] = Lane(gradient_[2]) * ((s45 + s67) - (s01 + s23));
}

/// Its symmetric part.
[[gnu::always_inline]] static inline void mean_strain(const Lane (&gradient)[3][3], Lane (&e)[6]) {
  const Lane half(0.5);
  for (int i = 0; i < 3; ++i) e[i] = gradient[i][i];
  e[3] = half * (gradient[1][2] + gradient[2][1]);
  e[4] = half * (gradient[0][2] + gradient[2][0]);
  e[5] = half * (gradient[0][1] + gradient[1][0]);
}

/// Square of the angle by which its other part turns.
[[gnu::always_inline]] static inline Lane mean_rotation2(const Lane (&gradient)[3][3]) {
  const Lane x = gradient[2][1] - gradient[1][2], y = gradient[0][2] - gradient[2][0],
             z = gradient[1][0] - gradient[0][1];
  return Lane(0.25) * (x * x + y * y + z * z);
}

void CellPlasticity::map_cell(std::size_t cell, const LaneArray& u_theta, const Mask& active, Largest& largest) {
  Lane gradient[3][3], left[3][3], e[6];
  const bool relaxes = relaxation_.has_value() && may_yield_;
  for (int i = 0; i < 3; ++i) {
    Lane u[8];
    for (int corner = 0; corner < 8; ++corner) u[corner] = u_theta.get(row_of(cell, corner) + i);
    mean_gradient(u, gradient[i]);
    if (!relaxes) continue;
    for (int corner = 0; corner < 8; ++corner) {
      u[corner] = Lane(share_) * u[corner] + relaxation_->remembered().get(row_of(cell, corner) + i);
    }
    mean_gradient(u, left[i]);
  }
  mean_strain(gradient, e);
  if (measures_rotation_) largest.rotation2 = max(largest.rotation2, mean_rotation2(gradient));
  const Lane shear2 = e[3] * e[3] + e[4] * e[4] + e[5] * e[5];
  largest.strain2 = max(largest.strain2, e[0] * e[0] + e[1] * e[1] + e[2] * e[2] + shear2 + shear2);
  if (relaxation_) {
    if (!may_yield_) return;
    // The strain whose instantaneous stress is the one that is left.
    mean_strain(left, e);
  }
  const Lane mean = (e[0] + e[1] + e[2]) * Lane(1.0 / 3.0);
  for (int i = 0; i < 3; ++i) e[i] -= mean;
  const bool touched = touched_[cell] != 0;
  Lane accumulated(0.0);
  Lane old[6] = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
  if (touched) {
    accumulated = accumulated_.get(cell);
    for (std::size_t i = 0; i < 6; ++i) {
      old[i] = strain_.get(6 * cell + i);
      e[i] -= Lane(share_) * old[i];
      if (relaxation_) e[i] -= past_strain_.get(6 * cell + i);
    }
  }
  const CellMaterial& material = material_of(cell);
  const Lane shear_modulus = material.shear_modulus, twice_shear = shear_modulus + shear_modulus;
  const Lane norm2 =
      e[0] * e[0] + e[1] * e[1] + e[2] * e[2] + Lane(2.0) * (e[3] * e[3] + e[4] * e[4] + e[5] * e[5]);
  const Lane equivalent = twice_shear * sqrt(Lane(1.5) * norm2);
  const Lane excess = equivalent - (material.yield_stress + material.hardening * accumulated);
  const Mask yielding = active & (excess > Lane(0.0));
  if (!touched && none(yielding)) return;
  touched_[cell] = 1;
  const Lane flow =
      select(yielding, excess / (Lane(3.0 * share_) * shear_modulus + material.hardening), Lane(0.0));
  const Lane scale = Lane(1.5) * flow * twice_shear / max(equivalent, Lane(1e-300));
  Lane stress[6];
  for (std::size_t i = 0; i < 6; ++i) {
    const Lane before = strain_theta_.get(6 * cell + i);
    const Lane after = select(active, old[i] + scale * e[i], before);
    stress[i] = twice_shear * Lane(share_) * (after - before);
    strain_theta_.put(6 * cell + i, after);
  }
  const Lane before = accumulated_theta_.get(cell);
  const Lane after = select(active, accumulated + flow, before);
  accumulated_theta_.put(cell, after);
  const Lane moved = abs(after - before);
  largest.flow = max(largest.flow, moved);
  Mask any_stress = Mask(false);
  for (const Lane& s : stress) any_stress = any_stress | (abs(s) > Lane(0.0));
  if (any(any_stress)) {
    flowing_ = true;
    add_load(cell, stress, load_theta_);
  }
}

Mask CellPlasticity::update(const LaneArray& u_theta, const Mask& active) {
  require(u_theta.rows() == load_.rows(), "CellPlasticity::update: displacements of another body");
  Largest largest;
  for (std::size_t cell = 0; cell < touched_.size(); ++cell) map_cell(cell, u_theta, active, largest);
  largest_strain_ = select(active, sqrt(largest.strain2), largest_strain_);
  largest_cell_rotation_ = select(active, sqrt(largest.rotation2), largest_cell_rotation_);
  return active & (largest.flow > Lane(kTolerance));
}

void CellPlasticity::end_step(const LaneArray& u, const WilsonTheta& w, const Mask& running) {
  if (relaxation_) relaxation_->end_step(u, running);
  if (!flowing_ && !relaxation_) return;
  const Lane volume(volume_m3_);
  for (std::size_t cell = 0; cell < touched_.size(); ++cell) {
    if (touched_[cell] == 0) continue;
    for (std::size_t i = 6 * cell; i < 6 * cell + 6; ++i) {
      const Lane before = strain_.get(i);
      const Lane change = take_over(w, running, i, strain_, strain_theta_) - before;
      for (std::size_t k = 0; k < branch_strain_.size(); ++k) {
        const BranchStep& b = relaxation_->step().branch[k];
        const Lane q = branch_strain_[k].get(i);
        branch_strain_[k].put(i, select(running, Lane(b.keep) * q + Lane(b.gain) * change, q));
      }
    }
    const CellMaterial& material = material_of(cell);
    const Lane before = accumulated_.get(cell);
    const Lane after = take_over(w, running, cell, accumulated_, accumulated_theta_);
    const Lane flow = after - before;
    const Lane stored = Lane(0.5) * material.hardening * (after + before) * flow * volume;
    plastic_work_ += select(flow > Lane(0.0), stored + material.yield_stress * flow * volume, Lane(0.0));
    hardening_energy_ += stored;
    largest_plastic_ = max(largest_plastic_, after);
  }
  if (relaxation_) return;
  for (std::size_t i = 0; i < load_.rows(); ++i) take_over(w, running, i, load_, load_theta_);
}

/// 1/2 V e D e.
double CellPlasticity::strain_energy(int lane, const LaneArray& strain) const {
  double energy = 0.0;
  for (std::size_t cell = 0; cell < touched_.size(); ++cell) {
    if (touched_[cell] == 0) continue;
    double norm2 = 0.0;
    for (std::size_t i = 0; i < 6; ++i) {
      const double e = strain.at(6 * cell + i, lane);
      norm2 += (i < 3 ? 1.0 : 2.0) * e * e;
    }
    energy += volume_m3_ * material_of(cell).shear_modulus[lane] * norm2;
  }
  return energy;
}

/// Of the instantaneous stiffness, without a plastic strain.
double CellPlasticity::elastic_energy(int lane, const LaneArray& u, const LaneArray& strain) const {
  const std::vector<double> at = of_lane(u, lane), load = load_of(lane, strain);
  std::vector<double> force(at.size());
  multiply(body_.K, std::span<const double>(at), std::span<double>(force));
  double energy = strain_energy(lane, strain);
  for (std::size_t i = 0; i < at.size(); ++i) energy += at[i] * (0.5 * force[i] - load[i]);
  return energy;
}

/// The elastic energy less what it would be, had nothing faded.
double CellPlasticity::faded_energy(int lane, const LaneArray& u) const {
  const RelaxationStep& step = relaxation_->step();
  double energy = (step.long_term - 1.0) * elastic_energy(lane, u, strain_);
  for (std::size_t k = 0; k < branch_strain_.size(); ++k) {
    energy += step.branch[k].share * elastic_energy(lane, relaxation_->branch(k), branch_strain_[k]);
  }
  return energy;
}

double CellPlasticity::self_energy(int lane, const LaneArray& u) const {
  const double energy = strain_energy(lane, strain_);
  return relaxation_ ? energy + faded_energy(lane, u) : energy;
}

/// What the deformation did, and is neither stored nor went into plastic flow.
double CellPlasticity::relaxed_J(int lane, const LaneArray& u) const {
  if (!relaxation_) return 0.0;
  const double stored = elastic_energy(lane, u, strain_) + faded_energy(lane, u);
  return deformed_.work_J(lane) - plastic_work_[lane] - (stored - start_energy_J_[static_cast<std::size_t>(lane)]);
}

std::optional<double> CellPlasticity::volume_above_m3(int lane, double threshold) const {
  double volume = 0.0;
  for (std::size_t cell = 0; cell < touched_.size(); ++cell) {
    if (touched_[cell] != 0 && accumulated_.at(cell, lane) > threshold) volume += volume_m3_;
  }
  return volume;
}

std::vector<double> CellPlasticity::plastic_load_N(int lane) const {
  return relaxation_ ? load_of(lane, strain_) : of_lane(load_, lane);
}

/// V B^T D e of one lane.
std::vector<double> CellPlasticity::load_of(int lane, const LaneArray& strain) const {
  std::vector<double> load(load_.rows(), 0.0);
  constexpr std::size_t kVoigt[3][3] = {{0, 5, 4}, {5, 1, 3}, {4, 3, 2}};
  for (std::size_t cell = 0; cell < touched_.size(); ++cell) {
    if (touched_[cell] == 0) continue;
    for (std::size_t corner = 0; corner < 8; ++corner) {
      const auto row = 3 * static_cast<std::size_t>(lattice_.cell[cell][corner]);
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
          const double part = 2.0 * material_of(cell).shear_modulus[lane] *
                              strain.at(6 * cell + kVoigt[i][j], lane) * gradient_[j] * volume_m3_;
          load[row + i] += ((corner >> j) & 1) != 0 ? part : -part;
        }
      }
    }
  }
  return load;
}

LastingShape CellPlasticity::lasting(int lane, const LaneArray& u) const {
  LastingShape shape{plastic_load_N(lane), {}};
  if (!relaxation_) return shape;
  const RelaxationStep& step = relaxation_->step();
  if (step.flows()) {
    shape.displacement_m = relaxation_->flowed_m(lane, u);
    std::ranges::fill(shape.load_N, 0.0);
    for (std::size_t k = 0; k < branch_strain_.size(); ++k) {
      const BranchStep& b = step.branch[k];
      const std::vector<double> load = load_of(lane, branch_strain_[k]);
      for (std::size_t i = 0; i < load.size(); ++i) {
        shape.load_N[i] += b.share * b.time_s / step.flow_time_s() * load[i];
      }
    }
  }
  for (double& force : shape.load_N) force *= step.rest_share();
  return shape;
}

}  // namespace unbruised

#include "core/body/modal_lanes.hpp"

#include <cmath>
#include <numeric>

#include "core/door/require.hpp"

namespace unbruised {
namespace {

/// Strains are measured anew once the contact forces have grown by this factor: half a percent is nothing beside
/// what bounds the strain (simulation.max_strain, 30 %).
constexpr double kForceStep = 1.02;

}  // namespace

ModalLanes::ModalLanes(const BodyModel& body, const ModalBasis& basis, const WilsonTheta& wilson)
    : BodyMotion(3 * body.particle_count),
      body_(body),
      basis_(basis),
      w_(wilson),
      relaxation_s_(body.relaxation_time_s),
      viscous_(viscous_share(body, wilson)),
      inverse_effective_(effective_square_1_s2(basis, body, wilson)),
      root_mass_(std::sqrt(body.total_mass_kg)),
      every_mode_(basis.modes.count()),
      every_row_(basis.node_freedoms()),
      mode_(basis.modes.count(), body.relaxation),
      rest_(basis.node_freedoms(), body.relaxation),
      force_(basis.node_freedoms(), body.relaxation),
      base_(basis.modes.count()),
      rest_base_(basis.node_freedoms()),
      pushed_(basis.modes.count()),
      yielded_(basis.node_freedoms()),
      by_modes_(basis.node_freedoms()),
      strain_(basis.strain_of_modes.rows()),
      strain_of_rest_(basis.strain_of_modes.rows()) {
  for (double& square : inverse_effective_) square = 1.0 / square;
  for (std::vector<int>* every : {&every_mode_, &every_row_}) std::iota(every->begin(), every->end(), 0);
  if (!basis.turning) return;
  frame_.emplace(body.position_m, body.mass_kg, wilson);
  turning_.emplace(*basis.turning, wilson);
  for (LaneArray* array : {&deforming_viscous_, &deforming_rate_}) *array = LaneArray(basis.modes.count());
}

void ModalLanes::load(int lane, const BodyState& state, const std::array<double, 3>& gravity_m_s2) {
  const std::size_t freedoms = 3 * body_.particle_count;
  require(is_lane(lane), "ModalLanes::load: there is no such lane");
  require(state.displacement_m.size() == freedoms && state.velocity_m_s.size() == freedoms &&
              state.acceleration_m_s2.size() == freedoms,
          "ModalLanes::load: the state of another body");
  for (LaneArray* rows : {&u_, &v_, &a_, &u_theta_}) rows->clear_lane(lane);
  for (Motion* motion : {&mode_, &rest_, &force_}) motion->clear(lane);
  if (frame_) {
    const InFrame placed = place_in_frame(lane, state, gravity_m_s2);
    load_modes(lane, placed.state, placed.gravity_m_s2);
  } else {
    load_modes(lane, state, gravity_m_s2);
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    gravity_[axis].set(lane, gravity_m_s2[axis]);
    if (frame_) continue;
    mass_u_[axis].set(lane, root_mass_ * mode_.now.at(axis, lane));
    mass_a_[axis].set(lane, root_mass_ * mode_.second.at(axis, lane));
  }
  if (frame_) {
    Mask fresh(false);
    fresh.set(lane, true);
    turning_->give_momentum(frame_->to_frame(frame_->angular_momentum_kg_m2_s()), modal_motion(), fresh);
    const LaneVector mass_u = Lane(body_.total_mass_kg) * frame_->center_motion_m();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      mass_u_[axis] = select(fresh, mass_u[axis], mass_u_[axis]);
      mass_a_[axis] = select(fresh, frame_->mass_acceleration_N()[axis], mass_a_[axis]);
    }
  }
  for (Lane* value : {&force_sum_, &strained_by_, &largest_strain_, &largest_cell_rotation_})
    value->set(lane, 0.0);
  damped_.load(lane);
  deformed_.load(lane);
  start_energy_J_[static_cast<std::size_t>(lane)] = elastic_J(lane);
}

/// Fits the frame of a lane. @return what is loaded in its axes
ModalLanes::InFrame ModalLanes::place_in_frame(int lane, const BodyState& state,
                                               const std::array<double, 3>& gravity_m_s2) {
  const std::array<const std::vector<double>*, 3> from = {&state.displacement_m, &state.velocity_m_s,
                                                          &state.acceleration_m_s2};
  const std::array<LaneArray*, 3> rows = {&u_, &v_, &a_};
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t i = 0; i < from[k]->size(); ++i) rows[k]->at(i, lane) = (*from[k])[i];
  }
  frame_->load(lane, motion(), state.rotation_rad, gravity_m_s2);
  InFrame placed{state, of_lane(frame_->to_frame(to_lanes(gravity_m_s2)), lane)};
  const std::array<std::vector<double>*, 3> to = {&placed.state.displacement_m, &placed.state.velocity_m_s,
                                                  &placed.state.acceleration_m_s2};
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t i = 0; i < to[k]->size(); ++i) (*to[k])[i] = rows[k]->at(i, lane);
    rows[k]->clear_lane(lane);
  }
  return placed;
}

void ModalLanes::load_modes(int lane, const BodyState& state, const std::array<double, 3>& gravity_m_s2) {
  const std::size_t freedoms = 3 * body_.particle_count;
  const std::array<const std::vector<double>*, 3> from = {&state.displacement_m, &state.velocity_m_s,
                                                          &state.acceleration_m_s2};
  const std::array<LaneArray*, 3> to = {&mode_.now, &mode_.rate, &mode_.second};
  for (std::size_t mode = 0; mode < basis_.modes.count(); ++mode) {
    const double* shape = basis_.modes.of(mode);
    for (std::size_t k = 0; k < 3; ++k) {
      double sum = 0.0;
      for (std::size_t i = 0; i < freedoms; ++i) sum += shape[i] * body_.mass_kg[i / 3] * (*from[k])[i];
      to[k]->at(mode, lane) = sum;
    }
  }
  // The body begins in balance, but for what accelerates all of it: contact forces are what is left of K u. One
  // whose stiffness fades has stood for long.
  std::vector<double> elastic(freedoms);
  multiply(body_.K, std::span<const double>(state.displacement_m), std::span<double>(elastic));
  for (std::size_t row = 0; row < basis_.node_freedoms(); ++row) {
    const std::size_t i = freedom_of(row);
    force_.now.at(row, lane) = elastic[i] + body_.mass_kg[i / 3] *
                                                (state.acceleration_m_s2[i] - gravity_m_s2[i % 3]) /
                                                body_.relaxation.rest_share();
    u_.at(i, lane) = state.displacement_m[i];
    v_.at(i, lane) = state.velocity_m_s[i];
    a_.at(i, lane) = state.acceleration_m_s2[i];
  }
  for (std::size_t row = 0; row < basis_.node_freedoms(); ++row) {
    double sum = 0.0;
    for (std::size_t k = 0; k < basis_.node_freedoms(); ++k) {
      sum += basis_.rest.at(row, k) * force_.now.at(k, lane);
    }
    rest_.now.at(row, lane) = sum;
  }
}

void ModalLanes::archive(LaneArchive& lane) {
  for (Motion* motion : {&mode_, &rest_, &force_}) motion->archive(lane);
  for (std::size_t row = 0; row < basis_.node_freedoms(); ++row) {
    const std::size_t i = freedom_of(row);
    lane(u_.at(i, lane.lane()), v_.at(i, lane.lane()), a_.at(i, lane.lane()));
  }
  damped_.archive(lane);
  deformed_.archive(lane);
  lane(start_energy_J_[static_cast<std::size_t>(lane.lane())]);
  lane(gravity_, mass_u_, mass_a_, strained_by_, largest_strain_, largest_cell_rotation_);
  if (frame_) frame_->archive(lane);
}

void ModalLanes::begin_step(const Mask& running, const LaneArray* remembered) {
  require(remembered == nullptr, "ModalLanes: modes remember by themselves");
  running_ = running;
  columns_.clear();
  force_sum_ = Lane(0.0);
  for (Motion* motion : {&mode_, &rest_, &force_}) {
    if (motion->memory) motion->memory->begin_step(motion->now);
  }
  if (frame_) {
    const FramePrediction prediction = frame_->predict(running);
    turning_->predict(prediction, modal_motion(), deforming_viscous_, deforming_rate_, running);
    frame_->apply({.shift = prediction.way, .turn = transposed(prediction.back), .spin = {}, .momentum = {}},
                  basis_.node, motion(), running);
  }
  const LaneVector gravity = frame_ ? frame_->to_frame({gravity_}) : LaneVector{gravity_};
  const LaneVector turned = frame_ ? turning_->to_rotating(frame_->rigid_load_rad_s2()) : LaneVector{};
  const NarrowPacks busy(running);
  std::array<NarrowPack, kNarrowPacks> power_of;
  power_of.fill(NarrowPack(0.0));
  const NarrowPack share(1.0 / viscous_);
  for (std::size_t mode = 0; mode < basis_.modes.count(); ++mode) {
    const double square = basis_.modes.square_1_s2[mode];
    const NarrowPack inverse(inverse_effective_[mode]), stiff(square);
    busy.each([&](int first) {
      const NarrowPack y = get_pack(mode_.now, mode, first), v = get_pack(mode_.rate, mode, first),
                       second = get_pack(mode_.second, mode, first);
      const NarrowPack carried =
          frame_ ? mode_.carried(get_pack(deforming_viscous_, mode, first), relaxation_s_, mode, first)
                 : mode_.carried(w_, relaxation_s_, mode, first);
      NarrowPack load = w_.inertial(y, v, second) + stiff * carried;
      if (mode < 3) load += NarrowPack(root_mass_) * narrow(gravity[mode], first);
      if (frame_ && mode >= 3 && mode < kRigidModes) load += narrow(turned[mode - 3], first);
      put_pack(base_, mode, inverse * load, first);
      const NarrowPack rate = get_pack(deforming_rate(), mode, first);
      power_of[pack_at(first)] += stiff * rate * rate;
    });
  }
  for (std::size_t row = 0; row < basis_.node_freedoms(); ++row) {
    busy.each([&](int first) {
      put_pack(rest_base_, row, share * rest_.carried(w_, relaxation_s_, row, first), first);
      put_pack(force_.theta, row, share * force_.carried(w_, relaxation_s_, row, first), first);
      power_of[pack_at(first)] += get_pack(force_.rate, row, first) * get_pack(rest_.rate, row, first);
    });
  }
  Lane power(0.0);
  busy.each([&](int first) { widen(power, NarrowPack(relaxation_s_) * power_of[pack_at(first)], first); });
  damped_.book(w_.dt, power, running);
  if (mode_.memory) book_fading(running);
}

/// The power that the deformation has on what has not faded.
void ModalLanes::book_fading(const Mask& running) {
  Lane power(0.0);
  for (std::size_t mode = kRigidModes; mode < basis_.modes.count(); ++mode) {
    power +=
        Lane(basis_.modes.square_1_s2[mode]) * mode_.memory->stressed().get(mode) * deforming_rate().get(mode);
  }
  for (std::size_t row = 0; row < basis_.node_freedoms(); ++row) {
    power += force_.memory->stressed().get(row) * rest_.rate.get(row);
  }
  deformed_.book(w_.dt, power, running);
}

void ModalLanes::add_forces(int, std::span<const double>) {
  require(false, "ModalLanes: nothing but contact acts on a lattice");
}

void ModalLanes::start_solve(const LaneArray* load, LaneVector* moment) {
  require(load == nullptr, "ModalLanes: nothing flows within");
  require(moment == nullptr || frame_, "ModalLanes: only a body in a floating frame is asked for moments");
  if (moment == nullptr) return;
  LaneVector on_rotating;
  for (std::size_t k = 0; k < 3; ++k) on_rotating[k] = Lane(w_.a0) * base_.get(3 + k);
  *moment = turning_->moment(on_rotating);
}

void ModalLanes::solve_without_contact(const Touchable& touchable, LaneArray& base) {
  require(std::ranges::equal(touchable.particle, basis_.node),
          "ModalLanes: other particles than those of the basis");
  multiply(basis_.at_nodes, every_mode_, base_, BusyPacks(running_), by_modes_);
  const NarrowPacks busy(running_);
  for (std::size_t row = 0; row < basis_.node_freedoms(); ++row) {
    busy.each([&](int first) {
      put_pack(base, row, get_pack(by_modes_, row, first) + get_pack(rest_base_, row, first), first);
    });
  }
}

void ModalLanes::add_contact(std::span<const int>, std::span<const int> active, const LaneArray& force) {
  columns_.clear();
  if (active.empty()) return;
  for (const int index : active) {
    for (int axis = 0; axis < 3; ++axis) columns_.push_back(3 * index + axis);
  }
  const BusyPacks busy(running_);
  multiply(basis_.from_nodes, columns_, force, busy, pushed_);
  multiply(basis_.rest, columns_, force, busy, yielded_);
  const double share = 1.0 / viscous_;
  Lane sum(0.0);
  for (const int column : columns_) {
    const auto row = static_cast<std::size_t>(column);
    busy.narrow.each([&](int first) {
      const NarrowPack acting = get_pack(force, row, first);
      put_pack(force_.theta, row, get_pack(force_.theta, row, first) + NarrowPack(share) * acting, first);
      widen(sum, narrow(sum, first) + abs(acting), first);
    });
  }
  force_sum_ = sum;
}

void ModalLanes::finish_solve(const Mask& lanes, const LaneVector* turn_rad) {
  require(turn_rad == nullptr || frame_, "ModalLanes: a body that stays upright was turned");
  const BusyPacks busy(running_);
  const bool touched = !columns_.empty();
  const LaneVector turned = turn_rad != nullptr ? turning_->to_rotating(*turn_rad) : LaneVector{};
  for (std::size_t mode = 0; mode < basis_.modes.count(); ++mode) {
    busy.narrow.each([&](int first) {
      NarrowPack y = get_pack(base_, mode, first);
      if (touched) y += NarrowPack(inverse_effective_[mode]) * get_pack(pushed_, mode, first);
      if (turn_rad != nullptr && mode >= 3 && mode < kRigidModes) y += narrow(turned[mode - 3], first);
      put_pack(mode_.theta, mode, y, first);
    });
  }
  if (touched || turn_rad != nullptr) multiply(basis_.at_nodes, every_mode_, mode_.theta, busy, by_modes_);
  const double share = 1.0 / viscous_;
  for (std::size_t row = 0; row < basis_.node_freedoms(); ++row) {
    const std::size_t i = freedom_of(row);
    busy.narrow.each([&](int first) {
      NarrowPack rest = get_pack(rest_base_, row, first);
      if (touched) rest += NarrowPack(share) * get_pack(yielded_, row, first);
      put_pack(rest_.theta, row, rest, first);
      put_pack(u_theta_, i, get_pack(by_modes_, row, first) + rest, first);
    });
  }
  measure_strain(lanes);
}

/// Of lanes whose contact forces have grown.
void ModalLanes::measure_strain(const Mask& lanes) {
  const Mask due = lanes & (force_sum_ > Lane(kForceStep) * strained_by_);
  if (none(due)) return;
  const BusyPacks busy(due);
  multiply(basis_.strain_of_modes, every_mode_, mode_.theta, busy, strain_);
  multiply(basis_.strain_of_rest, every_row_, force_.theta, busy, strain_of_rest_);
  Lane strain(0.0), rotation(0.0);
  for (std::size_t row = 0; row < strain_.rows(); row += kStrainRows) {
    Lane strain2(0.0), rotation2(0.0);
    for (std::size_t i = 0; i < kStrainRows; ++i) {
      const Lane e = strain_.get(row + i) + strain_of_rest_.get(row + i);
      if (i < 6) {
        strain2 += (i < 3 ? Lane(1.0) : Lane(2.0)) * e * e;
      } else {
        rotation2 += e * e;
      }
    }
    strain = max(strain, strain2);
    rotation = max(rotation, rotation2);
  }
  largest_strain_ = select(due, sqrt(strain), largest_strain_);
  if (frame_) largest_cell_rotation_ = select(due, sqrt(rotation), largest_cell_rotation_);
  strained_by_ = select(due, force_sum_, strained_by_);
}

void ModalLanes::advance(const Mask& running, const OuterForces& outer) {
  std::optional<BalanceSums> balance;
  if (frame_) balance = turning_->balance(modal_motion(), mode_.theta, running);
  const NarrowPacks busy(running);
  const auto advance_row = [&](std::size_t row, const LaneArray& theta, LaneArray& u, LaneArray& v, LaneArray& a) {
    busy.each([&](int first) {
      const PackMask moves = narrow(running, first);
      const NarrowPack old_u = get_pack(u, row, first), old_v = get_pack(v, row, first),
                       old_a = get_pack(a, row, first);
      NarrowPack new_u = old_u, new_v = old_v, new_a = old_a;
      w_.advance(get_pack(theta, row, first), new_u, new_v, new_a);
      put_pack(u, row, select(moves, new_u, old_u), first);
      put_pack(v, row, select(moves, new_v, old_v), first);
      put_pack(a, row, select(moves, new_a, old_a), first);
    });
  };
  for (Motion* motion : {&mode_, &rest_, &force_}) {
    for (std::size_t row = 0; row < motion->now.rows(); ++row) {
      advance_row(row, motion->theta, motion->now, motion->rate, motion->second);
    }
  }
  for (std::size_t row = 0; row < basis_.node_freedoms(); ++row) {
    advance_row(freedom_of(row), u_theta_, u_, v_, a_);
  }
  if (frame_) fit_frame(*balance, outer, running);
  for (Motion* motion : {&mode_, &rest_, &force_}) {
    if (motion->memory) motion->memory->end_step(motion->now, running);
  }
  if (frame_) return take_sums_of(*frame_, body_.total_mass_kg);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    mass_u_[axis] = Lane(root_mass_) * mode_.now.get(axis);
    mass_a_[axis] = Lane(root_mass_) * mode_.second.get(axis);
  }
}

void ModalLanes::fit_frame(const BalanceSums& balance, const OuterForces& outer, const Mask& running) {
  const StateSums sums = turning_->sums(modal_motion(), running);
  const FrameCorrection correction = frame_->fit_step(sums, balance, outer, running);
  turning_->apply(correction, modal_motion(), running);
  frame_->apply(correction, basis_.node, motion(), running);
}

BodyState ModalLanes::state(int lane) const {
  const std::size_t freedoms = 3 * body_.particle_count;
  BodyState state;
  const std::array<std::vector<double>*, 3> to = {&state.displacement_m, &state.velocity_m_s,
                                                  &state.acceleration_m_s2};
  const std::array<std::array<const LaneArray*, 2>, 3> from = {
      {{&mode_.now, &force_.now}, {&mode_.rate, &force_.rate}, {&mode_.second, &force_.second}}};
  std::vector<std::vector<double>> force(3, std::vector<double>(basis_.node_freedoms()));
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t row = 0; row < force[k].size(); ++row) force[k][row] = from[k][1]->at(row, lane);
  }
  std::vector<std::vector<double>> shapes = rest_shapes(basis_, body_, force);
  for (std::size_t k = 0; k < 3; ++k) {
    *to[k] = std::move(shapes[k]);
    for (std::size_t mode = 0; mode < basis_.modes.count(); ++mode) {
      const double* shape = basis_.modes.of(mode);
      const double amount = from[k][0]->at(mode, lane);
      for (std::size_t i = 0; i < freedoms; ++i) (*to[k])[i] += shape[i] * amount;
    }
  }
  if (frame_) turn_to_world(*frame_, lane, state);
  return state;
}

std::optional<BodyEnergy> ModalLanes::energy(int lane) const {
  return BodyEnergy{kinetic_energy_J(lane), elastic_J(lane)};
}

double ModalLanes::elastic_J(int lane) const {
  const auto stored = [&](const LaneArray& y, const LaneArray& f, const LaneArray& r) {
    double energy = 0.0;
    for (std::size_t mode = 0; mode < basis_.modes.count(); ++mode) {
      energy += 0.5 * basis_.modes.square_1_s2[mode] * y.at(mode, lane) * y.at(mode, lane);
    }
    for (std::size_t row = 0; row < basis_.node_freedoms(); ++row)
      energy += 0.5 * f.at(row, lane) * r.at(row, lane);
    return energy;
  };
  const RelaxationStep& step = body_.relaxation;
  double energy = step.long_term * stored(mode_.now, force_.now, rest_.now);
  for (std::size_t k = 0; k < step.branch.size(); ++k) {
    energy +=
        step.branch[k].share * stored(mode_.memory->branch(k), force_.memory->branch(k), rest_.memory->branch(k));
  }
  return energy;
}

double ModalLanes::damped_J(int lane) const {
  const double damped = damped_.work_J(lane);
  if (!mode_.memory) return damped;
  return damped + deformed_.work_J(lane) - (elastic_J(lane) - start_energy_J_[static_cast<std::size_t>(lane)]);
}

double ModalLanes::rotation_rad(int lane) const {
  if (frame_) return frame_->angle_rad(lane);
  double square = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double angle = 0.0;
    for (std::size_t k = 0; k < 3; ++k) angle += basis_.modes.turn[k][axis] * mode_.now.at(3 + k, lane);
    square += angle * angle;
  }
  return std::sqrt(square);
}

std::array<double, 3> ModalLanes::momentum(int lane) const {
  if (frame_) return of_lane(frame_->momentum_kg_m_s(), lane);
  std::array<double, 3> sum{};
  for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] = root_mass_ * mode_.rate.at(axis, lane);
  return sum;
}

double ModalLanes::kinetic_energy_J(int lane) const {
  double energy = 0.0;
  for (std::size_t mode = 0; mode < basis_.modes.count(); ++mode) {
    energy += 0.5 * mode_.rate.at(mode, lane) * mode_.rate.at(mode, lane);
  }
  return energy;
}

}  // namespace unbruised

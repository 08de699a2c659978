#include "core/body/body_lanes.hpp"

#include <algorithm>
#include <cmath>

#include "core/algebra/lane_matrix.hpp"
#include "core/door/require.hpp"

namespace unbruised {

BodyLanes::BodyLanes(const BodyModel& body, const WilsonTheta& wilson, ProductFrame frame,
                     const Touchable& touchable)
    : BodyMotion(3 * body.particle_count), body_(body), w_(wilson) {
  const std::size_t freedoms = 3 * body.particle_count;
  require(body.factor.size > 0 && body.slot.size() == freedoms, "BodyLanes: the body is not factored");
  for (LaneArray* array : {&viscous_, &c_viscous_}) *array = LaneArray(freedoms);
  rhs_ = LaneArray(static_cast<std::size_t>(body.factor.size));
  if (body.factor.single_value.empty()) {
    solve_.emplace(body);
  } else {
    correction_.emplace(body, wilson, touchable);
  }
  if (frame == ProductFrame::upright) return;
  require(!body.is_anchored(), "BodyLanes: a body that is held has no floating frame");
  frame_.emplace(body.position_m, body.mass_kg, wilson);
  rate_ = LaneArray(freedoms);
}

void BodyLanes::load(int lane, const BodyState& state, const std::array<double, 3>& gravity_m_s2) {
  const std::size_t freedoms = 3 * body_.particle_count;
  require(is_lane(lane), "BodyLanes::load: there is no such lane");
  require(state.displacement_m.size() == freedoms && state.velocity_m_s.size() == freedoms &&
              state.acceleration_m_s2.size() == freedoms,
          "BodyLanes::load: the state of another body");
  u_theta_.clear_lane(lane);
  for (std::size_t i = 0; i < freedoms; ++i) {
    u_.at(i, lane) = state.displacement_m[i];
    v_.at(i, lane) = state.velocity_m_s[i];
    a_.at(i, lane) = state.acceleration_m_s2[i];
  }
  for (std::size_t i = 0; i < 3; ++i) {
    gravity_[i].set(lane, gravity_m_s2[i]);
    double sum_u = 0.0, sum_a = 0.0;
    for (std::size_t p = 0; p < body_.particle_count; ++p) {
      sum_u += body_.mass_kg[p] * u_.at(3 * p + i, lane);
      sum_a += body_.mass_kg[p] * a_.at(3 * p + i, lane);
    }
    mass_u_[i].set(lane, sum_u);
    mass_a_[i].set(lane, sum_a);
  }
  if (frame_) frame_->load(lane, motion(), state.rotation_rad, gravity_m_s2);
  if (correction_) correction_->load(lane);
  damped_.load(lane);
}

void BodyLanes::archive(LaneArchive& lane) {
  lane(u_, v_, a_, gravity_, mass_u_, mass_a_, turn_);
  if (correction_) correction_->archive(lane);
  damped_.archive(lane);
  if (frame_) frame_->archive(lane);
}

void BodyLanes::begin_step(const Mask& running, const LaneArray* remembered) {
  running_ = running;
  // What is remembered is multiplied by K together with what is damped.
  const Lane factor(damping_factor());
  if (frame_) {
    frame_->predict(motion(), viscous_, rate_, running);
    if (correction_) predict(remembered);
    for (std::size_t i = 0; !correction_ && remembered != nullptr && i < viscous_.rows(); ++i) {
      viscous_.put(i, factor * viscous_.get(i) - remembered->get(i));
    }
    const LaneVector gravity = frame_->to_frame({gravity_}), turned = frame_->rigid_load_rad_s2();
    const auto outer_m_s2 = [&](std::size_t p, int first) {
      return narrow(gravity, first) + cross(narrow(turned, first), to_lanes<NarrowPack>(frame_->rest_place_m(p)));
    };
    put_right_hand_side(rate_, remembered, outer_m_s2, running);
  } else {
    if (correction_) predict(remembered);
    for (std::size_t i = 0; !correction_ && i < 3 * body_.particle_count; ++i) {
      const Lane viscous = w_.viscous(u_.get(i), v_.get(i), a_.get(i));
      viscous_.put(i, remembered != nullptr ? factor * viscous - remembered->get(i) : viscous);
    }
    const LaneVector gravity{gravity_};
    put_right_hand_side(
        v_, remembered, [&](std::size_t, int first) { return narrow(gravity, first); }, running);
  }
  for (std::size_t i = 0; i < body_.rest_force_N.size(); ++i) {
    if (body_.slot[i] < 0) continue;
    const auto at = static_cast<std::size_t>(body_.slot[i]);
    rhs_.put(at, rhs_.get(at) + Lane(body_.rest_force_N[i]));
  }
}

void BodyLanes::predict(const LaneArray* remembered) {
  const double h = w_.theta * w_.dt, factor = damping_factor(), share = body_.relaxation.stiffness_theta;
  const NarrowPacks busy(running_);
  for (std::size_t i = 0; i < 3 * body_.particle_count; ++i) {
    busy.each([&](int first) {
      const auto get = [&](const LaneArray& rows) { return get_pack(rows, i, first); };
      const NarrowPack v = get(v_), a = get(a_);
      const NarrowPack predicted = get(u_) + NarrowPack(h) * v + NarrowPack(0.5 * h * h) * a;
      put_pack(correction_->predicted(), i, predicted, first);
      NarrowPack left;
      if (frame_) {
        left = NarrowPack(factor) * get(viscous_) - NarrowPack(share + factor * w_.a1) * predicted;
      } else {
        left = NarrowPack(-factor) * (v + NarrowPack(h) * a) - NarrowPack(share) * predicted;
      }
      put_pack(viscous_, i, remembered != nullptr ? left - get(*remembered) : left, first);
    });
  }
}

template <class Acceleration>
[[gnu::always_inline]] inline void BodyLanes::put_right_hand_side(const LaneArray& rate,
                                                                  const LaneArray* remembered,
                                                                  const Acceleration& outer_m_s2,
                                                                  const Mask& running) {
  const double factor = damping_factor();
  const bool is_predicted = correction_.has_value();
  const double of_both = remembered != nullptr || is_predicted ? 1.0 : factor;
  const BlockMatrix& matrix = is_damped_as_it_is_stiff() ? body_.K : body_.C;
  const NarrowPacks busy(running);
  Lane power(0.0);
  if (is_predicted && remembered == nullptr) {
    multiply_and_form(matrix, viscous_, rate, c_viscous_, power, running);
    power *= Lane(factor);
  } else {
    if (c_v_.rows() == 0) c_v_ = LaneArray(rate.rows());
    multiply_two(matrix, viscous_, rate, c_viscous_, c_v_, running);
    power = power_of(rate, busy);
  }
  const NarrowPack pack_of_both = of_both;
  for (std::size_t p = 0; p < body_.particle_count; ++p) {
    const NarrowPack mass(body_.mass_kg[p]);
    busy.each([&](int first) {
      const PackVector outer = outer_m_s2(p, first);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t i = 3 * p + axis;
        const int slot = body_.slot[i];
        if (slot < 0) continue;
        const auto get = [&](const LaneArray& rows) { return get_pack(rows, i, first); };
        const NarrowPack inertial = is_predicted ? -get(a_) : w_.inertial(get(u_), get(v_), get(a_));
        put_pack(rhs_, static_cast<std::size_t>(slot),
                 mass * (inertial + outer[axis]) + pack_of_both * get(c_viscous_), first);
      }
    });
  }
  damped_.book(w_.dt, power, running);
}

/// rate' C rate, by what of the body is free.
Lane BodyLanes::power_of(const LaneArray& rate, const NarrowPacks& busy) const {
  const NarrowPack factor(damping_factor());
  std::array<NarrowPack, kNarrowPacks> sum;
  sum.fill(NarrowPack(0.0));
  for (std::size_t i = 0; i < rate.rows(); ++i) {
    if (body_.slot[i] < 0) continue;
    busy.each(
        [&](int first) { sum[pack_at(first)] += factor * get_pack(rate, i, first) * get_pack(c_v_, i, first); });
  }
  Lane power(0.0);
  busy.each([&](int first) { widen(power, sum[pack_at(first)], first); });
  return power;
}

void BodyLanes::add_forces(int lane, std::span<const double> force_N) {
  require(is_lane(lane), "BodyLanes::add_forces: there is no such lane");
  require(force_N.size() == body_.slot.size(), "BodyLanes::add_forces: forces on another body");
  for (std::size_t i = 0; i < force_N.size(); ++i) {
    const int slot = body_.slot[i];
    if (slot >= 0) rhs_.at(static_cast<std::size_t>(slot), lane) += force_N[i];
  }
}

void BodyLanes::start_solve(const LaneArray* load, LaneVector* moment) {
  require(load == nullptr || load->rows() == body_.slot.size(), "BodyLanes::start_solve: a load on another body");
  if (moment != nullptr) *moment = moment_of_load(load);
  if (correction_) return correction_->start(rhs_, load, running_);
  for (std::size_t i = 0; i < 3 * body_.particle_count; ++i) {
    if (body_.slot[i] < 0) continue;
    const auto at = static_cast<std::size_t>(body_.slot[i]);
    solve_->rows().put(at, load != nullptr ? rhs_.get(at) + load->get(i) : rhs_.get(at));
  }
  solve_->forward(running_);
}

/// Of the right-hand side: the stiffness of what is predicted turns nothing, its inertia does.
LaneVector BodyLanes::moment_of_load(const LaneArray* load) const {
  require(frame_.has_value(), "BodyLanes: only a body in a floating frame is asked for moments");
  std::array<PackVector, kNarrowPacks> moment_of;
  const NarrowPacks busy(running_);
  for (std::size_t p = 0; p < body_.particle_count; ++p) {
    const PackVector X = to_lanes<NarrowPack>(frame_->rest_place_m(p));
    const NarrowPack inertia(w_.a0 * body_.mass_kg[p]);
    busy.each([&](int first) {
      PackVector force;
      for (std::size_t i = 0; i < 3; ++i) {
        force[i] = get_pack(rhs_, static_cast<std::size_t>(body_.slot[3 * p + i]), first);
        if (load != nullptr) force[i] += get_pack(*load, 3 * p + i, first);
        if (correction_) force[i] += inertia * get_pack(correction_->predicted(), 3 * p + i, first);
      }
      moment_of[pack_at(first)] += cross(X, force);
    });
  }
  LaneVector moment;
  busy.each([&](int first) { widen(moment, moment_of[pack_at(first)], first); });
  return moment;
}

void BodyLanes::solve_without_contact(const Touchable& touchable, LaneArray& base) {
  require(base.rows() == 3 * touchable.particle.size(),
          "BodyLanes::solve_without_contact: a row for each freedom");
  if (correction_) return correction_->look_without_contact(touchable, base);
  const LaneArray& solution = solve_->look(touchable.reach, running_);
  for (std::size_t i = 0; i < base.rows(); ++i) {
    const int slot = body_.slot[3 * static_cast<std::size_t>(touchable.particle[i / 3]) + i % 3];
    base.put(i, slot >= 0 ? solution.get(static_cast<std::size_t>(slot)) : Lane(0.0));
  }
}

HeldForces BodyLanes::solve_under_held(const Touchable& touchable, LaneArray& base) {
  // In a floating frame contact forces turn the body as well, all of them.
  if (!correction_ || frame_) return BodyMotion::solve_under_held(touchable, base);
  correction_->look_under_held(touchable, base);
  return correction_->held();
}

void BodyLanes::add_contact(std::span<const int> particles, std::span<const int> active, const LaneArray& force) {
  require(force.rows() == 3 * particles.size(), "BodyLanes::add_contact: a force for each freedom");
  if (correction_) return correction_->take_contact(particles, active, force);
  if (!active.empty()) solve_->join(particles, active, force, running_);
}

void BodyLanes::finish_solve(const Mask& lanes, const LaneVector* turn_rad) {
  correction_ ? correction_->finish() : solve_->backward(running_);
  const NarrowPacks busy(lanes);
  for (std::size_t p = 0; p < body_.particle_count; ++p) {
    busy.each([&](int first) {
      const PackVector before = get_vector(u_theta_, p, first);
      PackVector u = before;
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t freedom = 3 * p + i;
        if (body_.slot[freedom] < 0) continue;
        u[i] = correction_ ? correction_->displacement_m(freedom, first)
                           : get_pack(solve_->rows(), static_cast<std::size_t>(body_.slot[freedom]), first);
      }
      if (turn_rad != nullptr) {
        u += cross(narrow(*turn_rad, first), to_lanes<NarrowPack>(frame_->rest_place_m(p)));
      }
      put_vector(u_theta_, p, select(narrow(lanes, first), u, before), first);
    });
  }
}

Lane BodyLanes::weighted_load(std::span<const double> shape) const {
  require(!correction_ && shape.size() == body_.slot.size(),
          "BodyLanes::weighted_load: the shape of another body");
  Lane sum(0.0);
  for (std::size_t i = 0; i < shape.size(); ++i) {
    if (body_.slot[i] >= 0) sum += Lane(shape[i]) * rhs_.get(static_cast<std::size_t>(body_.slot[i]));
  }
  return sum;
}

Lane BodyLanes::inertial_sum(std::size_t axis) const {
  Lane sum(0.0);
  for (std::size_t p = 0; p < body_.particle_count; ++p) {
    const std::size_t i = 3 * p + axis;
    sum += Lane(body_.mass_kg[p]) * w_.inertial(u_.get(i), v_.get(i), a_.get(i));
  }
  return sum;
}

void BodyLanes::add_motion(std::span<const double> shape, const Lane& factor, const Mask& lanes) {
  require(shape.size() == body_.slot.size(), "BodyLanes::add_motion: the shape of another body");
  for (std::size_t i = 0; i < shape.size(); ++i) {
    const Lane before = u_theta_.get(i);
    u_theta_.put(i, select(lanes, before + Lane(shape[i]) * factor, before));
  }
}

void BodyLanes::advance(const Mask& running, const OuterForces& outer) {
  if (frame_) {
    frame_->advance(motion(), u_theta_, outer, running);
    take_sums_of(*frame_, body_.total_mass_kg);
  } else {
    advance_upright(running);
  }
}

void BodyLanes::advance_upright(const Mask& running) {
  struct Sums {
    PackVector mass_u, mass_a, turn;
  };
  std::array<Sums, kNarrowPacks> sums_of;
  const NarrowPacks busy(running);
  for (std::size_t p = 0; p < body_.particle_count; ++p) {
    const NarrowPack mass(body_.mass_kg[p]);
    std::array<double, 3> X = body_.position_m[p];
    for (std::size_t i = 0; i < 3; ++i) X[i] -= body_.center_of_mass_m[i];
    busy.each([&](int first) {
      Sums& sums = sums_of[pack_at(first)];
      const PackMask moves = narrow(running, first);
      const PackVector old_u = get_vector(u_, p, first), old_v = get_vector(v_, p, first),
                       old_a = get_vector(a_, p, first), u_theta = get_vector(u_theta_, p, first);
      PackVector u = old_u, v = old_v, a = old_a;
      for (std::size_t i = 0; i < 3; ++i) w_.advance(u_theta[i], u[i], v[i], a[i]);
      u = select(moves, u, old_u);
      v = select(moves, v, old_v);
      a = select(moves, a, old_a);
      for (std::size_t i = 0; i < 3; ++i) {
        if (body_.slot[3 * p + i] < 0) u[i] = v[i] = a[i] = NarrowPack(0.0);
      }
      put_vector(u_, p, u, first);
      put_vector(v_, p, v, first);
      put_vector(a_, p, a, first);
      const PackVector moved = mass * u;
      sums.mass_u += moved;
      sums.mass_a += mass * a;
      sums.turn += cross(to_lanes<NarrowPack>(X), moved);
    });
  }
  LaneVector mass_u, mass_a, turn;
  busy.each([&](int first) {
    const Sums& sums = sums_of[pack_at(first)];
    widen(mass_u, sums.mass_u, first);
    widen(mass_a, sums.mass_a, first);
    widen(turn, sums.turn, first);
  });
  mass_u_ = mass_u.at;
  mass_a_ = mass_a.at;
  turn_ = turn.at;
}

double BodyLanes::rotation_rad(int lane) const {
  if (frame_) return frame_->angle_rad(lane);
  double square = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    double angle = 0.0;
    for (std::size_t j = 0; j < 3; ++j) angle += body_.inverse_inertia[3 * i + j] * turn_[j][lane];
    square += angle * angle;
  }
  return std::sqrt(square);
}

BodyState BodyLanes::state(int lane) const {
  const std::size_t freedoms = 3 * body_.particle_count;
  BodyState state{std::vector<double>(freedoms), std::vector<double>(freedoms), std::vector<double>(freedoms), {}};
  for (std::size_t i = 0; i < freedoms; ++i) {
    state.displacement_m[i] = u_.at(i, lane);
    state.velocity_m_s[i] = v_.at(i, lane);
    state.acceleration_m_s2[i] = a_.at(i, lane);
  }
  if (frame_) turn_to_world(*frame_, lane, state);
  return state;
}

std::array<double, 3> BodyLanes::momentum(int lane) const {
  if (frame_) return of_lane(frame_->momentum_kg_m_s(), lane);
  std::array<double, 3> sum{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t p = 0; p < body_.particle_count; ++p) sum[i] += body_.mass_kg[p] * v_.at(3 * p + i, lane);
  }
  return sum;
}

double BodyLanes::kinetic_energy_J(int lane) const {
  double energy = 0.0;
  for (std::size_t i = 0; i < 3 * body_.particle_count; ++i) {
    energy += 0.5 * body_.mass_kg[i / 3] * v_.at(i, lane) * v_.at(i, lane);
  }
  return energy;
}

}  // namespace unbruised

#include "core/frame/frame_lanes.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/door/eigen.hpp"
#include "core/door/require.hpp"

namespace unbruised {
namespace {

/// Of the moment that is left in a step beta takes this share in the next one; all of it rings where contacts are
/// hard and steps long.
constexpr double kRelaxation = 0.5;
/// Giving angular momentum back is stable as long as dt^2 sum |f| |y| is below this share of the smallest inertia:
/// flights, and grips that are not both hard and long of step.
constexpr double kMostLeverage = 0.3;

// Passes over all particles go pack by pack of lanes: what a particle needs then stays in registers.

/// What the prediction of a particle is made with.
struct Predicted {
  PackVector v_c, a_c, way, omega, alpha;
  PackMatrix back;

  Predicted() = default;
  Predicted(const FramePrediction& f, int first)
      : v_c(narrow(f.v_c, first)),
        a_c(narrow(f.a_c, first)),
        way(narrow(f.way, first)),
        omega(narrow(f.omega, first)),
        alpha(narrow(f.alpha, first)),
        back(narrow(f.back, first)) {}
};

/// What takes a particle into the frame that fits.
struct Fitted {
  PackVector shift, spin;
  PackMatrix back;
  PackMask lanes{false};
};

}  // namespace

FrameLanes::FrameLanes(std::span<const std::array<double, 3>> position_m, std::span<const double> mass_kg,
                       const WilsonTheta& wilson)
    : w_(wilson),
      X_(position_m.begin(), position_m.end()),
      mass_kg_(mass_kg.begin(), mass_kg.end()),
      every_particle_(position_m.size()) {
  require(X_.size() == mass_kg_.size() && X_.size() > 2, "FrameLanes: a mass for each of three places or more");
  std::iota(every_particle_.begin(), every_particle_.end(), 0);
  std::array<double, 3> moment{};
  double total = 0.0;
  for (std::size_t p = 0; p < X_.size(); ++p) {
    total += mass_kg_[p];
    for (std::size_t i = 0; i < 3; ++i) moment[i] += mass_kg_[p] * X_[p][i];
  }
  total_mass_ = Lane(total);
  Eigen::Matrix3d J = Eigen::Matrix3d::Zero();
  for (std::size_t p = 0; p < X_.size(); ++p) {
    for (std::size_t i = 0; i < 3; ++i) X_[p][i] -= moment[i] / total;
    const Eigen::Map<const Eigen::Vector3d> X(X_[p].data());
    J += mass_kg_[p] * (X.squaredNorm() * Eigen::Matrix3d::Identity() - X * X.transpose());
  }
  least_inertia_ = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(J).eigenvalues()[0];
  R_ = attitude_.matrix();
}

void FrameLanes::load(int lane, const LaneMotion& motion, const std::array<double, 3>& rotation_rad,
                      const std::array<double, 3>& gravity_m_s2) {
  require(is_lane(lane), "FrameLanes::load: there is no such lane");
  require(motion.u.rows() == 3 * X_.size(), "FrameLanes::load: the state of another body");
  Mask fresh(false);
  fresh.set(lane, true);
  attitude_ = select(fresh, rotation_by(to_lanes(rotation_rad)), attitude_);
  R_ = attitude_.matrix();
  if (rotation_rad != std::array<double, 3>{})
    apply({.shift = {}, .turn = R_, .spin = {}, .momentum = {}}, every_particle_, motion, fresh);
  for (LaneVector* vector : {&center_, &beta_, &angular_momentum_}) {
    *vector = select(fresh, LaneVector{}, *vector);
  }
  StateSums sums;
  for (std::size_t p = 0; p < X_.size(); ++p) {
    sums.add(Lane(mass_kg_[p]), X_[p], to_lanes(X_[p]) + get_vector(motion.u, p), get_vector(motion.v, p),
             get_vector(motion.a, p));
  }
  StateSums about_center = sums;
  about_center.center(total_mass_);
  angular_momentum_ = select(fresh, to_world(about_center.y_v), angular_momentum_);
  outer_force_ = select(fresh, to_world(sums.a) - total_mass_ * to_lanes(gravity_m_s2), outer_force_);
  outer_moment_ = select(fresh, to_world(about_center.y_a), outer_moment_);
  corrected_ = select(fresh, Lane(0.0), corrected_);
  apply(fit(sums, fresh, fresh), every_particle_, motion, fresh);
}

void FrameLanes::archive(LaneArchive& lane) {
  lane.members(attitude_);
  lane.members(R_);
  for (LaneVector* vector : {&center_, &beta_, &angular_momentum_, &outer_force_, &outer_moment_, &mass_v_,
                             &mass_a_, &omega_, &alpha_}) {
    lane(vector->at);
  }
  lane(corrected_);
}

/// Lanes that do not take part keep every bit: composing rounds even with no turn.
void FrameLanes::turn_frame(const LaneRotation& by, const Mask& running) {
  attitude_ = select(running, attitude_ * by, attitude_);
  R_ = attitude_.matrix();
}

FramePrediction FrameLanes::predict(const Mask& running) {
  const Lane h(w_.theta * w_.dt), half_square(0.5 * w_.theta * w_.dt * w_.theta * w_.dt);
  const LaneVector v_c = Lane(1.0) / total_mass_ * mass_v_, a_c = Lane(1.0) / total_mass_ * mass_a_;
  const LaneVector phi = select(running, h * omega_ + half_square * alpha_, LaneVector{});
  const LaneVector way = select(running, h * v_c + half_square * a_c, LaneVector{});
  const LaneRotation turn = rotation_by(phi);
  back_ = transposed(turn.matrix());
  center_ += R_ * way;
  turn_frame(turn, running);
  return {v_c, a_c, way, omega_, alpha_, back_};
}

void FrameLanes::predict(const LaneMotion& motion, LaneArray& viscous, LaneArray& rate, const Mask& running) {
  const FramePrediction prediction = predict(running);
  std::array<Predicted, kNarrowPacks> packs;
  const NarrowPacks busy(running);
  busy.each([&](int first) { packs[pack_at(first)] = Predicted(prediction, first); });
  for (std::size_t p = 0; p < X_.size(); ++p) {
    const PackVector X = to_lanes<NarrowPack>(X_[p]);
    busy.each([&](int first) {
      const Predicted& f = packs[pack_at(first)];
      const PackVector u = get_vector(motion.u, p, first), v = get_vector(motion.v, p, first),
                       a = get_vector(motion.a, p, first), y = X + u;
      const PackVector spun = cross(f.omega, y);
      const PackVector s = v - f.v_c - spun;
      const PackVector q = a - f.a_c - cross(f.alpha, y) - cross(f.omega, spun + NarrowPack(2.0) * s);
      PackVector damped;
      for (std::size_t i = 0; i < 3; ++i) damped[i] = w_.viscous(u[i], s[i], q[i]);
      put_vector(viscous, p, damped, first);
      put_vector(rate, p, s, first);
      put_vector(motion.u, p, f.back * (y - f.way) - X, first);
      put_vector(motion.v, p, f.back * v, first);
      put_vector(motion.a, p, f.back * a, first);
    });
  }
}

void FrameLanes::advance(const LaneMotion& motion, const LaneArray& u_theta, const OuterForces& outer,
                         const Mask& running) {
  std::array<StateSumsOf<NarrowPack>, kNarrowPacks> sums_of;
  std::array<BalanceSumsOf<NarrowPack>, kNarrowPacks> balance_of;
  const NarrowPacks busy(running);
  for (std::size_t p = 0; p < X_.size(); ++p) {
    const NarrowPack mass(mass_kg_[p]);
    const PackVector X = to_lanes<NarrowPack>(X_[p]);
    busy.each([&](int first) {
      const PackVector u_then = get_vector(u_theta, p, first);
      const PackVector old_u = get_vector(motion.u, p, first), old_v = get_vector(motion.v, p, first),
                       old_a = get_vector(motion.a, p, first);
      const PackVector a_then =
          NarrowPack(w_.a0) * (u_then - old_u) - NarrowPack(w_.a2) * old_v - NarrowPack(2.0) * old_a;
      balance_of[pack_at(first)].add(mass, X_[p], X + u_then, a_then);
      PackVector u = old_u, v = old_v, a = old_a;
      for (std::size_t i = 0; i < 3; ++i) w_.advance(u_then[i], u[i], v[i], a[i]);
      const auto moves = narrow(running, first);
      u = select(moves, u, old_u);
      v = select(moves, v, old_v);
      a = select(moves, a, old_a);
      put_vector(motion.u, p, u, first);
      put_vector(motion.v, p, v, first);
      put_vector(motion.a, p, a, first);
      sums_of[pack_at(first)].add(mass, X_[p], X + u, v, a);
    });
  }
  StateSums sums;
  BalanceSums balance;
  busy.each([&](int first) {
    sums.widen(sums_of[pack_at(first)], first);
    balance.widen(balance_of[pack_at(first)], first);
  });
  apply(fit_step(sums, balance, outer, running), every_particle_, motion, running);
}

FrameCorrection FrameLanes::fit_step(const StateSums& sums, const BalanceSums& balance, const OuterForces& outer,
                                     const Mask& running) {
  const LaneVector y_c = Lane(1.0) / total_mass_ * balance.y;
  const LaneVector moment = outer.moment - cross(y_c, outer.force);
  balance_moments(balance, y_c, moment, running);
  book_outer(outer, moment, running);
  const Mask may_correct =
      running & (Lane(w_.dt * w_.dt) * outer.leverage <= Lane(kMostLeverage * least_inertia_));
  return fit(sums, may_correct, running);
}

/// r = T - sum m (y - y_c) x a is the moment of the internal forces, which linear kinematics let act.
void FrameLanes::balance_moments(const BalanceSums& sums, const LaneVector& y_c, const LaneVector& moment,
                                 const Mask& running) {
  const LaneVector left = moment + cross(y_c, sums.a) - sums.y_a;
  const LaneVector change = solve(trace_minus(sums.X_y), left);
  beta_ += select(running, Lane(kRelaxation) * change, LaneVector{});
}

/// Forces are linear over a step along x, y, z, as the accelerations are: so the impulses close.
void FrameLanes::book_outer(const OuterForces& outer, const LaneVector& moment, const Mask& running) {
  const LaneVector old_moment = outer_moment_;
  const LaneVector force_then = to_world(outer.force), moment_then = to_world(moment);
  for (std::size_t i = 0; i < 3; ++i) {
    outer_force_[i] = select(running, w_.at_end(outer_force_[i], force_then[i]), outer_force_[i]);
    outer_moment_[i] = select(running, w_.at_end(outer_moment_[i], moment_then[i]), outer_moment_[i]);
  }
  angular_momentum_ += select(running, Lane(0.5 * w_.dt) * (old_moment + outer_moment_), LaneVector{});
}

/// Moves centre and attitude to where sum m y = 0 and sum m X x u = 0, and finds the spin that is missing of the
/// angular momentum; where it may not be given back, the body's own counts from here on.
FrameCorrection FrameLanes::fit(StateSums sums, const Mask& may_correct, const Mask& running) {
  FrameCorrection correction;
  correction.shift = select(running, Lane(1.0) / total_mass_ * sums.y, LaneVector{});
  center_ += R_ * correction.shift;
  sums.center(total_mass_);
  const LaneRotation turn = select(running, polar_rotation(sums.y_X), LaneRotation{});
  turn_frame(turn, running);
  correction.turn = turn.matrix();
  sums.turn(correction.turn);
  const LaneVector momentum = to_frame(angular_momentum_);
  const LaneMatrix J = trace_minus(sums.y_y);
  const LaneVector missing = momentum - sums.y_v;
  correction.spin = select(may_correct, solve(J, missing), LaneVector{});
  correction.momentum = momentum;
  correction.is_spun = may_correct;
  corrected_ += select(running, sqrt(dot(missing, missing)), Lane(0.0));
  const LaneVector kept = select(may_correct, momentum, sums.y_v);
  angular_momentum_ = select(running & !may_correct, to_world(sums.y_v), angular_momentum_);
  const LaneVector omega = solve(J, kept);
  omega_ = select(running, omega, omega_);
  alpha_ = select(running, solve(J, sums.y_a - cross(omega, kept)), alpha_);
  mass_v_ = select(running, sums.v, mass_v_);
  mass_a_ = select(running, sums.a, mass_a_);
  return correction;
}

double FrameLanes::angle_rad(int lane) const {
  double square = 0.0;
  for (const Lane& component : attitude_.axis.at) square += component[lane] * component[lane];
  return 2.0 * std::asin(std::min(1.0, std::sqrt(square)));
}

void FrameLanes::apply(const FrameCorrection& correction, std::span<const int> particles, const LaneMotion& motion,
                       const Mask& lanes) const {
  const LaneMatrix back = transposed(correction.turn);
  std::array<Fitted, kNarrowPacks> packs;
  const NarrowPacks busy(lanes);
  busy.each([&](int first) {
    packs[pack_at(first)] = {narrow(correction.shift, first), narrow(correction.spin, first), narrow(back, first),
                             narrow(lanes, first)};
  });
  for (const int particle : particles) {
    const auto p = static_cast<std::size_t>(particle);
    const PackVector X = to_lanes<NarrowPack>(X_[p]);
    busy.each([&](int first) {
      const Fitted& f = packs[pack_at(first)];
      const PackVector u = get_vector(motion.u, p, first), v = get_vector(motion.v, p, first),
                       a = get_vector(motion.a, p, first);
      const PackVector y = f.back * (X + u - f.shift);
      put_vector(motion.u, p, select(f.lanes, y - X, u), first);
      put_vector(motion.v, p, select(f.lanes, f.back * v + cross(f.spin, y), v), first);
      put_vector(motion.a, p, select(f.lanes, f.back * a, a), first);
    });
  }
}

}  // namespace unbruised

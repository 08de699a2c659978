#include "core/frame/frame_lanes.hpp"

#include "core/door/require.hpp"

namespace unbruised {
namespace {

/// Newton steps of the fit: from a turn of 0.1 rad three of them are right to rounding.
constexpr int kFitSteps = 3;
/// Of the moment that is left in a step beta takes this share in the next one; all of it rings where contacts are
/// hard and steps long.
constexpr double kRelaxation = 0.5;

/// The rotation Q of A = Q P with a symmetric P, by Newton's method from Q = 1.
LaneRotation polar_rotation(const LaneMatrix& A) {
  LaneRotation Q;
  for (int step = 0; step < kFitSteps; ++step) {
    const LaneMatrix B = transposed(Q.matrix()) * A;
    const LaneVector skew{{B(2, 1) - B(1, 2), B(0, 2) - B(2, 0), B(1, 0) - B(0, 1)}};
    LaneMatrix symmetric = B;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) symmetric(i, j) = Lane(0.5) * (B(i, j) + B(j, i));
    }
    Q = Q * rotation_by(solve(trace_minus(symmetric), skew));
  }
  return Q;
}

}  // namespace

FrameLanes::FrameLanes(std::span<const std::array<double, 3>> position_m, std::span<const double> mass_kg,
                       const WilsonTheta& wilson)
    : w_(wilson), X_(position_m.begin(), position_m.end()), mass_kg_(mass_kg.begin(), mass_kg.end()) {
  require(X_.size() == mass_kg_.size() && X_.size() > 2, "FrameLanes: a mass for each of three places or more");
  std::array<double, 3> moment{};
  double total = 0.0;
  for (std::size_t p = 0; p < X_.size(); ++p) {
    total += mass_kg_[p];
    for (std::size_t i = 0; i < 3; ++i) moment[i] += mass_kg_[p] * X_[p][i];
  }
  total_mass_ = Lane(total);
  for (auto& X : X_) {
    for (std::size_t i = 0; i < 3; ++i) X[i] -= moment[i] / total;
  }
  R_ = attitude_.matrix();
}

void FrameLanes::load(int lane, const LaneMotion& motion) {
  require(is_lane(lane), "FrameLanes::load: there is no such lane");
  require(motion.u.rows() == 3 * X_.size(), "FrameLanes::load: the state of another body");
  Mask fresh(false);
  fresh.set(lane, true);
  attitude_ = select(fresh, LaneRotation{}, attitude_);
  R_ = attitude_.matrix();
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
  angular_momentum_ = select(fresh, about_center.y_v, angular_momentum_);
  corrected_ = select(fresh, Lane(0.0), corrected_);
  apply(fit(sums, fresh), motion, fresh);
}

/// Lanes that do not take part keep every bit: composing rounds even with no turn.
void FrameLanes::turn_frame(const LaneRotation& by, const Mask& running) {
  attitude_ = select(running, attitude_ * by, attitude_);
  R_ = attitude_.matrix();
}

void FrameLanes::predict(const LaneMotion& motion, LaneArray& viscous, LaneArray& rate, const Mask& running) {
  const Lane h(w_.theta * w_.dt), half_square(0.5 * w_.theta * w_.dt * w_.theta * w_.dt);
  const LaneVector v_c = Lane(1.0) / total_mass_ * mass_v_, a_c = Lane(1.0) / total_mass_ * mass_a_;
  const LaneVector phi = select(running, h * omega_ + half_square * alpha_, LaneVector{});
  const LaneVector way = select(running, h * v_c + half_square * a_c, LaneVector{});
  const LaneRotation turn = rotation_by(phi);
  const LaneMatrix back = transposed(turn.matrix());
  center_ += R_ * way;
  turn_frame(turn, running);
  for (std::size_t p = 0; p < X_.size(); ++p) {
    const LaneVector X = to_lanes(X_[p]), u = get_vector(motion.u, p), v = get_vector(motion.v, p),
                     a = get_vector(motion.a, p), y = X + u;
    const LaneVector spun = cross(omega_, y);
    const LaneVector s = v - v_c - spun;
    const LaneVector q = a - a_c - cross(alpha_, y) - cross(omega_, spun + Lane(2.0) * s);
    for (std::size_t i = 0; i < 3; ++i) viscous.put(3 * p + i, w_.viscous(u[i], s[i], q[i]));
    put_vector(rate, p, s);
    put_vector(motion.u, p, back * (y - way) - X);
    put_vector(motion.v, p, back * v);
    put_vector(motion.a, p, back * a);
  }
}

void FrameLanes::advance(const LaneMotion& motion, const LaneArray& u_theta, const Mask& running) {
  StateSums sums;
  BalanceSums balance;
  for (std::size_t p = 0; p < X_.size(); ++p) {
    const Lane mass(mass_kg_[p]);
    const LaneVector X = to_lanes(X_[p]), u_then = get_vector(u_theta, p);
    LaneVector u = get_vector(motion.u, p), v = get_vector(motion.v, p), a = get_vector(motion.a, p);
    const LaneVector old_u = u, old_v = v, old_a = a;
    const LaneVector a_then = Lane(w_.a0) * (u_then - u) - Lane(w_.a2) * v - Lane(2.0) * a;
    balance.add(mass, X_[p], X + u_then, a_then);
    for (std::size_t i = 0; i < 3; ++i) w_.advance(u_then[i], u[i], v[i], a[i]);
    u = select(running, u, old_u);
    v = select(running, v, old_v);
    a = select(running, a, old_a);
    put_vector(motion.u, p, u);
    put_vector(motion.v, p, v);
    put_vector(motion.a, p, a);
    sums.add(mass, X_[p], X + u, v, a);
  }
  balance_moments(balance, running);
  apply(fit(sums, running), motion, running);
}

/// r = T - sum m (y - y_c) x a is the moment of the internal forces, which linear kinematics let act.
void FrameLanes::balance_moments(const BalanceSums& sums, const Mask& running) {
  const LaneVector y_c = Lane(1.0) / total_mass_ * sums.y;
  const LaneVector left = cross(y_c, sums.a) - sums.y_a;
  const LaneVector change = solve(trace_minus(sums.X_y), left);
  beta_ += select(running, Lane(kRelaxation) * change, LaneVector{});
}

/// Moves centre and attitude to where sum m y = 0 and sum m X x u = 0, and finds the spin that keeps the angular
/// momentum.
FrameLanes::Correction FrameLanes::fit(StateSums sums, const Mask& running) {
  Correction correction;
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
  correction.spin = solve(J, missing);
  corrected_ += select(running, sqrt(dot(missing, missing)), Lane(0.0));
  const LaneVector omega = solve(J, momentum);
  omega_ = select(running, omega, omega_);
  alpha_ = select(running, solve(J, sums.y_a - cross(omega, momentum)), alpha_);
  mass_v_ = select(running, sums.v, mass_v_);
  mass_a_ = select(running, sums.a, mass_a_);
  return correction;
}

void FrameLanes::apply(const Correction& correction, const LaneMotion& motion, const Mask& lanes) const {
  const LaneMatrix back = transposed(correction.turn);
  for (std::size_t p = 0; p < X_.size(); ++p) {
    const LaneVector X = to_lanes(X_[p]), u = get_vector(motion.u, p), v = get_vector(motion.v, p),
                     a = get_vector(motion.a, p);
    const LaneVector y = back * (X + u - correction.shift);
    put_vector(motion.u, p, select(lanes, y - X, u));
    put_vector(motion.v, p, select(lanes, back * v + cross(correction.spin, y), v));
    put_vector(motion.a, p, select(lanes, back * a, a));
  }
}

}  // namespace unbruised

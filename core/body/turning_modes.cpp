#include "core/body/turning_modes.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/door/eigen.hpp"

namespace unbruised {
namespace {

/// w -> v x w.
LaneMatrix cross_matrix(const LaneVector& v) {
  const Lane zero(0.0);
  return {{zero, zero - v[2], v[1], v[2], zero, zero - v[0], zero - v[1], v[0], zero}};
}

LaneMatrix less_one(LaneMatrix A) {
  for (std::size_t i = 0; i < 3; ++i) A(i, i) -= Lane(1.0);
  return A;
}

DenseMatrix stacked(const std::vector<Eigen::MatrixXd>& blocks) {
  const auto rows = static_cast<std::size_t>(blocks.front().rows());
  return {rows * blocks.size(), static_cast<std::size_t>(blocks.front().cols()),
          [&](std::size_t i, std::size_t j) {
            return blocks[i / rows](static_cast<Eigen::Index>(i % rows), static_cast<Eigen::Index>(j));
          }};
}

}  // namespace

TurningBasis turning_basis(const BodyModel& body, const ModeShapes& modes) {
  using Matrix = Eigen::MatrixXd;
  const auto particles = static_cast<Eigen::Index>(body.particle_count),
             count = static_cast<Eigen::Index>(modes.count());
  const std::array<double, 3>& center = body.center_of_mass_m;
  Eigen::VectorXd mass(particles);
  Matrix X(particles, 3);
  std::array<Matrix, 3> S;
  S.fill(Matrix(particles, count));
  for (Eigen::Index p = 0; p < particles; ++p) {
    const auto particle = static_cast<std::size_t>(p);
    mass[p] = body.mass_kg[particle];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      X(p, static_cast<Eigen::Index>(axis)) = body.position_m[particle][axis] - center[axis];
      for (Eigen::Index k = 0; k < count; ++k) {
        S[axis](p, k) = modes.of(static_cast<std::size_t>(k))[3 * particle + axis];
      }
    }
  }
  TurningBasis basis;
  basis.root_mass = std::sqrt(body.total_mass_kg);
  basis.of_X.resize(9 * modes.count());
  std::array<std::array<Matrix, 3>, 3> T;
  for (std::size_t a = 0; a < 3; ++a) {
    const Matrix weighed = mass.asDiagonal() * S[a];
    for (std::size_t b = 0; b < 3; ++b) {
      const auto axis = static_cast<Eigen::Index>(b);
      T[a][b] = weighed.transpose() * S[b];
      const Eigen::VectorXd of_X = weighed.transpose() * X.col(axis);
      std::copy_n(of_X.data(), modes.count(), basis.of_X.data() + (3 * a + b) * modes.count());
      basis.X_X[3 * a + b] = X.col(static_cast<Eigen::Index>(a)).dot(mass.cwiseProduct(X.col(axis)));
    }
  }
  basis.crossing = stacked({T[2][1] - T[1][2], T[0][2] - T[2][0], T[1][0] - T[0][1]});
  basis.stretching = stacked({T[0][0], T[1][1], T[1][2] + T[2][1], T[2][0] + T[0][2], T[0][1] + T[1][0]});
  Eigen::Matrix3d turn;
  for (int k = 0; k < 3; ++k) {
    for (int axis = 0; axis < 3; ++axis) {
      turn(axis, k) = modes.turn[static_cast<std::size_t>(k)][static_cast<std::size_t>(axis)];
    }
  }
  const Eigen::Matrix3d to_rotating = turn.inverse();
  for (int i = 0; i < 9; ++i) basis.to_rotating[static_cast<std::size_t>(i)] = to_rotating(i / 3, i % 3);
  return basis;
}

/// B = one + xx e_x e_x' + yy e_y e_y' + shears + [axial x]: S' M S = 1 takes T_zz's part.
struct TurningModes::Turn {
  NarrowPack one, xx, yy;
  PackVector shear, axial;

  Turn(const LaneMatrix& B, int first) {
    const PackMatrix b = narrow(B, first);
    const NarrowPack half(0.5);
    one = b(2, 2);
    xx = b(0, 0) - b(2, 2);
    yy = b(1, 1) - b(2, 2);
    shear = {{half * (b(1, 2) + b(2, 1)), half * (b(2, 0) + b(0, 2)), half * (b(0, 1) + b(1, 0))}};
    axial = {{half * (b(2, 1) - b(1, 2)), half * (b(0, 2) - b(2, 0)), half * (b(1, 0) - b(0, 1))}};
  }
};

TurningModes::TurningModes(const TurningBasis& basis, const WilsonTheta& wilson)
    : basis_(basis),
      w_(wilson),
      count_(basis.crossing.columns()),
      every_mode_(count_),
      crossing_(3 * count_),
      acceleration_(count_) {
  std::iota(every_mode_.begin(), every_mode_.end(), 0);
  for (Components* of : {&now_, &rate_, &second_}) {
    of->crossing = LaneArray(3 * count_);
    of->stretching = LaneArray(5 * count_);
  }
  for (std::size_t i = 0; i < 9; ++i) to_rotating_.at[i] = Lane(basis.to_rotating[i]);
}

void TurningModes::cross(const LaneArray& amounts, const BusyPacks& lanes, LaneArray& crossing) const {
  multiply(basis_.crossing, every_mode_, amounts, lanes, crossing);
}

void TurningModes::look(const LaneArray& amounts, const BusyPacks& lanes, Components& components) const {
  cross(amounts, lanes, components.crossing);
  multiply(basis_.stretching, every_mode_, amounts, lanes, components.stretching);
}

/// sum m (S z).
LaneVector TurningModes::root_mass_times(const LaneArray& amounts) const {
  return Lane(basis_.root_mass) * LaneVector{{amounts.get(0), amounts.get(1), amounts.get(2)}};
}

/// A mode's amount of B S z.
[[gnu::always_inline]] inline NarrowPack TurningModes::turned(const Turn& by, const LaneArray& amounts,
                                                              const Components& components, std::size_t mode,
                                                              int first) const {
  const auto crossed = [&](std::size_t c) { return get_pack(components.crossing, c * count_ + mode, first); };
  const auto stretched = [&](std::size_t c) { return get_pack(components.stretching, c * count_ + mode, first); };
  NarrowPack sum = by.one * get_pack(amounts, mode, first) + by.xx * stretched(0) + by.yy * stretched(1);
  for (std::size_t c = 0; c < 3; ++c) sum += by.shear[c] * stretched(2 + c) + by.axial[c] * crossed(c);
  return sum;
}

/// Of B X.
[[gnu::always_inline]] inline NarrowPack TurningModes::turned_X(const PackMatrix& by, std::size_t mode) const {
  NarrowPack sum(0.0);
  for (std::size_t i = 0; i < 9; ++i) sum += by.at[i] * NarrowPack(basis_.of_X[i * count_ + mode]);
  return sum;
}

/// A mode's amount of e_c x y: its part of what acts on it is a moment.
[[gnu::always_inline]] inline PackVector TurningModes::levers(const LaneArray& crossing, std::size_t mode,
                                                              int first) const {
  const auto of_X = [&](std::size_t a, std::size_t b) {
    return NarrowPack(basis_.of_X[(3 * a + b) * count_ + mode]);
  };
  PackVector lever{{of_X(2, 1) - of_X(1, 2), of_X(0, 2) - of_X(2, 0), of_X(1, 0) - of_X(0, 1)}};
  for (std::size_t c = 0; c < 3; ++c) lever[c] += get_pack(crossing, c * count_ + mode, first);
  return lever;
}

void TurningModes::predict(const FramePrediction& prediction, const ModalMotion& motion, LaneArray& viscous,
                           LaneArray& rate, const Mask& running) {
  const BusyPacks busy(running);
  look(motion.now, busy, now_);
  look(motion.rate, busy, rate_);
  look(motion.second, busy, second_);
  // s = v - v_c - omega x y and q = a - a_c - alpha x y - omega x (omega x y) - 2 omega x s, in which what is the
  // same for all particles deforms nothing.
  const LaneMatrix spin = cross_matrix(prediction.omega), spin2 = spin * spin,
                   angular = cross_matrix(prediction.alpha), back_less_one = less_one(prediction.back);
  LaneMatrix of_place;
  for (std::size_t i = 0; i < 9; ++i) of_place.at[i] = spin2.at[i] - angular.at[i];
  const LaneVector moved = Lane(0.0 - basis_.root_mass) * (prediction.back * prediction.way);
  busy.narrow.each([&](int first) {
    const PackMask turns = narrow(running, first);
    const Turn back(prediction.back, first), place(of_place, first);
    const PackMatrix spin_X = narrow(spin, first), place_X = narrow(of_place, first),
                     back_X = narrow(back_less_one, first);
    const PackVector omega = narrow(prediction.omega, first);
    for (std::size_t mode = 0; mode < count_; ++mode) {
      const NarrowPack y = get_pack(motion.now, mode, first), v = get_pack(motion.rate, mode, first),
                       a = get_pack(motion.second, mode, first);
      NarrowPack s = v - turned_X(spin_X, mode);
      NarrowPack q = a + turned_X(place_X, mode) + turned(place, motion.now, now_, mode, first);
      for (std::size_t c = 0; c < 3; ++c) {
        s -= omega[c] * get_pack(now_.crossing, c * count_ + mode, first);
        q -= NarrowPack(2.0) * omega[c] * get_pack(rate_.crossing, c * count_ + mode, first);
      }
      put_pack(viscous, mode, w_.viscous(y, s, q), first);
      put_pack(rate, mode, s, first);
      NarrowPack place_now = turned_X(back_X, mode) + turned(back, motion.now, now_, mode, first);
      if (mode < 3) place_now += narrow(moved[mode], first);
      const NarrowPack rate_now = turned(back, motion.rate, rate_, mode, first),
                       second_now = turned(back, motion.second, second_, mode, first);
      put_pack(motion.now, mode, select(turns, place_now, y), first);
      put_pack(motion.rate, mode, select(turns, rate_now, v), first);
      put_pack(motion.second, mode, select(turns, second_now, a), first);
    }
  });
}

BalanceSums TurningModes::balance(const ModalMotion& start, const LaneArray& theta, const Mask& running) {
  const BusyPacks busy(running);
  for (std::size_t mode = 0; mode < count_; ++mode) {
    busy.narrow.each([&](int first) {
      const auto get = [&](const LaneArray& amounts) { return get_pack(amounts, mode, first); };
      put_pack(acceleration_, mode,
               NarrowPack(w_.a0) * (get(theta) - get(start.now)) - NarrowPack(w_.a2) * get(start.rate) -
                   NarrowPack(2.0) * get(start.second),
               first);
    });
  }
  cross(theta, busy, crossing_);
  BalanceSums sums;
  sums.y = root_mass_times(theta);
  sums.a = root_mass_times(acceleration_);
  busy.narrow.each([&](int first) {
    PackVector y_a;
    PackMatrix X_y;
    for (std::size_t i = 0; i < 9; ++i) X_y.at[i] = NarrowPack(basis_.X_X[i]);
    for (std::size_t mode = 0; mode < count_; ++mode) {
      const NarrowPack y = get_pack(theta, mode, first);
      y_a += get_pack(acceleration_, mode, first) * levers(crossing_, mode, first);
      for (std::size_t a = 0; a < 3; ++a) {
        for (std::size_t b = 0; b < 3; ++b) {
          X_y(a, b) += NarrowPack(basis_.of_X[(3 * b + a) * count_ + mode]) * y;
        }
      }
    }
    widen(sums.y_a, y_a, first);
    widen(sums.X_y, X_y, first);
  });
  return sums;
}

StateSums TurningModes::sums(const ModalMotion& motion, const Mask& running) {
  const BusyPacks busy(running);
  look(motion.now, busy, now_);
  look(motion.rate, busy, rate_);
  look(motion.second, busy, second_);
  StateSums sums;
  sums.y = root_mass_times(motion.now);
  sums.v = root_mass_times(motion.rate);
  sums.a = root_mass_times(motion.second);
  busy.narrow.each([&](int first) {
    PackVector y_v, y_a;
    PackMatrix J, y_X;
    for (std::size_t i = 0; i < 9; ++i) y_X.at[i] = NarrowPack(basis_.X_X[i]);
    for (std::size_t mode = 0; mode < count_; ++mode) {
      const PackVector lever = levers(now_.crossing, mode, first);
      const NarrowPack y = get_pack(motion.now, mode, first);
      y_v += get_pack(motion.rate, mode, first) * lever;
      y_a += get_pack(motion.second, mode, first) * lever;
      for (std::size_t i = 0; i < 9; ++i) {
        J.at[i] += lever[i / 3] * lever[i % 3];
        y_X.at[i] += NarrowPack(basis_.of_X[i * count_ + mode]) * y;
      }
    }
    // sum m y y' of the inertia.
    const NarrowPack half_trace = NarrowPack(0.5) * (J(0, 0) + J(1, 1) + J(2, 2));
    PackMatrix y_y;
    for (std::size_t i = 0; i < 9; ++i) y_y.at[i] = (i % 4 == 0 ? half_trace : NarrowPack(0.0)) - J.at[i];
    widen(sums.y_v, y_v, first);
    widen(sums.y_a, y_a, first);
    widen(sums.y_y, y_y, first);
    widen(sums.y_X, y_X, first);
  });
  return sums;
}

void TurningModes::apply(const FrameCorrection& correction, const ModalMotion& motion, const Mask& running) {
  const LaneMatrix back = transposed(correction.turn), back_less_one = less_one(back);
  const LaneVector moved = Lane(0.0 - basis_.root_mass) * (back * correction.shift);
  NarrowPacks(running).each([&](int first) {
    const PackMask turns = narrow(running, first);
    const Turn turn(back, first);
    const PackMatrix turn_X = narrow(back_less_one, first);
    for (std::size_t mode = 0; mode < count_; ++mode) {
      const auto put = [&](LaneArray& amounts, const NarrowPack& value) {
        put_pack(amounts, mode, select(turns, value, get_pack(amounts, mode, first)), first);
      };
      NarrowPack y = turned_X(turn_X, mode) + turned(turn, motion.now, now_, mode, first);
      if (mode < 3) y += narrow(moved[mode], first);
      put(motion.now, y);
      put(motion.rate, turned(turn, motion.rate, rate_, mode, first));
      put(motion.second, turned(turn, motion.second, second_, mode, first));
    }
  });
  give_momentum(correction.momentum, motion, correction.is_spun);
}

void TurningModes::give_momentum(const LaneVector& momentum_kg_m2_s, const ModalMotion& motion,
                                 const Mask& lanes) {
  if (none(lanes)) return;
  const BusyPacks busy(lanes);
  cross(motion.now, busy, now_.crossing);
  LaneVector momentum;
  LaneMatrix inertia = identity_lanes();
  busy.narrow.each([&](int first) {
    PackVector sum;
    PackMatrix J;
    for (std::size_t mode = 0; mode < count_; ++mode) {
      const PackVector lever = levers(now_.crossing, mode, first);
      sum += get_pack(motion.rate, mode, first) * lever;
      for (std::size_t i = 0; i < 9; ++i) J.at[i] += lever[i / 3] * lever[i % 3];
    }
    widen(momentum, sum, first);
    widen(inertia, J, first);
  });
  const LaneVector spin = select(lanes, solve(inertia, momentum_kg_m2_s - momentum), LaneVector{});
  busy.narrow.each([&](int first) {
    const PackVector added = narrow(spin, first);
    for (std::size_t mode = 0; mode < count_; ++mode) {
      put_pack(motion.rate, mode,
               get_pack(motion.rate, mode, first) + dot(added, levers(now_.crossing, mode, first)), first);
    }
  });
}

}  // namespace unbruised

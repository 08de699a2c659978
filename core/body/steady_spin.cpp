#include "core/body/steady_spin.hpp"

#include "core/door/eigen.hpp"
#include "core/door/require.hpp"

namespace unbruised {
namespace {

/// The load follows the shape: each round shrinks the error by the strain at least.
constexpr int kRounds = 12;

using Vectors = Eigen::Matrix3Xd;
using Eigen::Matrix3d;
using Eigen::Vector3d;

/// sum m |y|^2 1 - y y'.
Matrix3d inertia(const std::vector<double>& mass_kg, const Vectors& y) {
  Matrix3d J = Matrix3d::Zero();
  for (Eigen::Index p = 0; p < y.cols(); ++p) {
    const Vector3d at = y.col(p);
    J += mass_kg[static_cast<std::size_t>(p)] * (at.squaredNorm() * Matrix3d::Identity() - at * at.transpose());
  }
  return J;
}

/// Acceleration of each particle of a body that turns freely by omega without changing its shape.
Vectors acceleration(const std::vector<double>& mass_kg, const Vectors& y, const Vector3d& omega) {
  const Matrix3d J = inertia(mass_kg, y);
  const Vector3d alpha = J.ldlt().solve(-omega.cross(J * omega));
  Vectors a(3, y.cols());
  for (Eigen::Index p = 0; p < y.cols(); ++p) {
    const Vector3d at = y.col(p);
    a.col(p) = alpha.cross(at) + omega.cross(omega.cross(at));
  }
  return a;
}

/// Takes the rigid motion out of u: sum m u = 0 and sum m X x u = 0.
void remove_rigid(const std::vector<double>& mass_kg, const Vectors& X, Vectors& u) {
  Vector3d mean = Vector3d::Zero(), moment = Vector3d::Zero();
  double total = 0.0;
  for (Eigen::Index p = 0; p < u.cols(); ++p) {
    const double m = mass_kg[static_cast<std::size_t>(p)];
    const Vector3d at = X.col(p), moved = u.col(p);
    total += m;
    mean += m * moved;
    moment += m * at.cross(moved);
  }
  const Vector3d turn = inertia(mass_kg, X).ldlt().solve(moment);
  for (Eigen::Index p = 0; p < u.cols(); ++p) u.col(p) -= mean / total + turn.cross(Vector3d(X.col(p)));
}

}  // namespace

void add_steady_spin(const BodyModel& body, const std::array<double, 3>& spin_rad_s, BodyState& state) {
  const Vector3d omega(spin_rad_s[0], spin_rad_s[1], spin_rad_s[2]);
  if (omega.isZero(0.0)) return;
  require(body.statics != nullptr && !body.is_anchored(),
          "add_steady_spin: only a solid that nothing holds spins");
  const auto n = static_cast<Eigen::Index>(body.particle_count);
  Vectors X(3, n), u = Vectors::Zero(3, n);
  for (Eigen::Index p = 0; p < n; ++p) {
    for (Eigen::Index i = 0; i < 3; ++i) {
      X(i, p) = body.position_m[static_cast<std::size_t>(p)][static_cast<std::size_t>(i)] -
                body.center_of_mass_m[static_cast<std::size_t>(i)];
    }
  }
  for (int round = 0; round < kRounds; ++round) {
    const Vectors a = acceleration(body.mass_kg, X + u, omega);
    std::vector<double> load(static_cast<std::size_t>(3 * n));
    for (std::size_t i = 0; i < load.size(); ++i) load[i] = -body.mass_kg[i / 3] * a.data()[i];
    const std::vector<double> shape = body.statics->free_shape(load);
    std::copy(shape.begin(), shape.end(), u.data());
    remove_rigid(body.mass_kg, X, u);
  }
  const Vectors a = acceleration(body.mass_kg, X + u, omega);
  for (std::size_t i = 0; i < state.displacement_m.size(); ++i) {
    const auto p = static_cast<Eigen::Index>(i / 3), axis = static_cast<Eigen::Index>(i % 3);
    state.displacement_m[i] += u(axis, p);
    state.velocity_m_s[i] += omega.cross(Vector3d(X.col(p) + u.col(p)))[axis];
    state.acceleration_m_s2[i] += a(axis, p);
  }
}

}  // namespace unbruised

#include "core/body/rigid_motion.hpp"

#include <stdexcept>

#include "core/door/eigen.hpp"

namespace unbruised {
namespace {

using Positions = std::span<const std::array<double, 3>>;

/// Relative to the largest moment, below which a rotation moves no point. Moments of collinear points are
/// zero up to the rounding of their sums, about n x 1e-16; a body as thin as 1e-4 of its length is still above.
constexpr double kDegenerateMoment = 1e-10;

Eigen::Vector3d at(const std::array<double, 3>& x) { return {x[0], x[1], x[2]}; }

Eigen::Vector3d centroid(Positions position) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const auto& x : position) sum += at(x);
  return sum / static_cast<double>(position.size());
}

Eigen::Vector3d displacement_of(std::span<const double> u, std::size_t i) {
  return {u[3 * i], u[3 * i + 1], u[3 * i + 2]};
}

/// w of J w = L, in the subspace where J is not degenerate.
Eigen::Vector3d solve_moments(const Eigen::Matrix3d& J, const Eigen::Vector3d& L) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(J);
  Eigen::Vector3d w = Eigen::Vector3d::Zero();
  const double largest = eigen.eigenvalues()[2];
  for (int k = 0; k < 3; ++k) {
    const double moment = eigen.eigenvalues()[k];
    if (moment <= kDegenerateMoment * largest || moment <= 0.0) continue;
    const Eigen::Vector3d direction = eigen.eigenvectors().col(k);
    w += direction * (direction.dot(L) / moment);
  }
  return w;
}

void require_fit(Positions position, std::size_t freedoms) {
  if (freedoms != 3 * position.size()) throw std::invalid_argument("rigid motion: three displacements per place");
}

}  // namespace

RigidMotion best_fit_rigid_motion(Positions position_m, std::span<const double> displacement_m) {
  require_fit(position_m, displacement_m.size());
  if (position_m.empty()) return {};
  const Eigen::Vector3d center = centroid(position_m);
  Eigen::Vector3d t = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < position_m.size(); ++i) t += displacement_of(displacement_m, i);
  t /= static_cast<double>(position_m.size());

  // Normal equations: sum (|r|^2 I - r r^T) w = sum r x (u - t).
  Eigen::Matrix3d J = Eigen::Matrix3d::Zero();
  Eigen::Vector3d L = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < position_m.size(); ++i) {
    const Eigen::Vector3d r = at(position_m[i]) - center;
    const Eigen::Vector3d u = displacement_of(displacement_m, i) - t;
    J += r.squaredNorm() * Eigen::Matrix3d::Identity() - r * r.transpose();
    L += r.cross(u);
  }
  const Eigen::Vector3d w = solve_moments(J, L);
  return {{t[0], t[1], t[2]}, {w[0], w[1], w[2]}};
}

void remove_rigid_motion(Positions position_m, std::span<double> displacement_m) {
  const RigidMotion motion = best_fit_rigid_motion(position_m, displacement_m);
  if (position_m.empty()) return;
  const Eigen::Vector3d center = centroid(position_m);
  const Eigen::Vector3d t = at(motion.translation);
  const Eigen::Vector3d w = at(motion.rotation);
  for (std::size_t i = 0; i < position_m.size(); ++i) {
    const Eigen::Vector3d rigid = t + w.cross(at(position_m[i]) - center);
    for (int k = 0; k < 3; ++k) displacement_m[3 * i + static_cast<std::size_t>(k)] -= rigid[k];
  }
}

}  // namespace unbruised

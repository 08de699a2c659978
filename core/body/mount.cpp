#include "core/body/mount.hpp"

#include <algorithm>

#include "core/door/eigen.hpp"
#include "core/scenario/vectors.hpp"

namespace unbruised {
namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6, Eigen::RowMajor>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

Eigen::Map<const Matrix6> view(const SixBySix& A) { return Eigen::Map<const Matrix6>(A.data()); }

SixBySix stored(const Matrix6& A) {
  SixBySix out{};
  std::copy_n(A.data(), 36, out.begin());
  return out;
}

/// C that gives each mode of M and K the same part of its critical damping: M Phi diag(2 zeta omega) Phi' M.
SixBySix modal_damping(const SixBySix& mass, const SixBySix& stiffness, double ratio) {
  const Matrix6 M = view(mass), K = view(stiffness);
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> modes(K, M);
  const Vector6 omega = modes.eigenvalues().cwiseMax(0.0).cwiseSqrt();
  const Eigen::Matrix<double, 6, 6> shapes = M * modes.eigenvectors();
  return stored(shapes * (2.0 * ratio * omega).asDiagonal() * shapes.transpose());
}

}  // namespace

std::optional<Mount> sensor_mount(const Scenario& scenario, const std::array<double, 3>& grip_m,
                                  const std::array<double, 3>& foot_m) {
  const SixAxisSensorParameters& sensor = scenario.sensor;
  if (!has_sensor(scenario)) return std::nullopt;
  Mount mount;
  mount.mass = carried_mass(sensor);
  mount.stiffness = sensor_stiffness(sensor);
  mount.damping = modal_damping(mount.mass, mount.stiffness, sensor.damping_ratio);
  mount.carries_pads = sensor.at == SensorMount::wrist;
  mount.carries_support = sensor.at == SensorMount::support;
  const std::array<double, 3> given = sensor.position_m.value_or(std::array<double, 3>{});
  for (std::size_t i = 0; i < 3; ++i) mount.origin_m[i] = (mount.carries_pads ? grip_m : foot_m)[i] + given[i];
  return mount;
}

Six multiply(const SixBySix& A, const Six& x) {
  Six y{};
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t j = 0; j < 6; ++j) y[i] += A[6 * i + j] * x[j];
  }
  return y;
}

Six solve(const SixBySix& A, const Six& b) {
  const Vector6 x = view(A).llt().solve(Eigen::Map<const Vector6>(b.data()));
  Six out{};
  std::copy_n(x.data(), 6, out.begin());
  return out;
}

SixBySix inverse(const SixBySix& A) {
  const Matrix6 inverted = view(A).llt().solve(Matrix6::Identity());
  return stored(0.5 * (inverted + inverted.transpose()));
}

Six moved(const Six& wrench, const std::array<double, 3>& to) {
  const std::array<double, 3> by = cross(to, std::array<double, 3>{wrench[0], wrench[1], wrench[2]});
  Six out = wrench;
  for (std::size_t i = 0; i < 3; ++i) out[3 + i] -= by[i];
  return out;
}

Six wrench_of(const std::array<double, 3>& force_N, const std::array<double, 3>& place_m) {
  const std::array<double, 3> moment = cross(place_m, force_N);
  return {force_N[0], force_N[1], force_N[2], moment[0], moment[1], moment[2]};
}

Six add(const Six& b, double factor, const Six& a) {
  Six sum = b;
  for (std::size_t i = 0; i < 6; ++i) sum[i] += factor * a[i];
  return sum;
}

}  // namespace unbruised

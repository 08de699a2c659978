#include "core/robot/arm_sway.hpp"

#include <cmath>
#include <numbers>
#include <optional>

#include "core/door/eigen.hpp"
#include "core/door/require.hpp"

namespace unbruised {
namespace {

using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;

/// A posture changes little in so many steps.
constexpr int kModesEvery = 4;
/// Radians in a step that a mode rings through at most: it is sampled at least four times a period.
constexpr double kFastest_rad = 0.5 * std::numbers::pi;

double mass_kg(const std::vector<PointLoad>& loads) {
  double all = 0.0;
  for (const PointLoad& load : loads) all += load.mass_kg;
  return all;
}

std::optional<double> time_constant_s(const RobotParameters& robot, std::size_t joint) {
  const auto bandwidth_Hz = of_joint(robot.bandwidth_Hz, joint);
  if (!bandwidth_Hz) return std::nullopt;
  return 1.0 / (2.0 * std::numbers::pi * *bandwidth_Hz);
}

Vector vector_of(const Joints& joints) {
  return Eigen::Map<const Vector>(joints.data(), static_cast<Eigen::Index>(joints.size()));
}

/// f
Vector forces(const Arm& arm, const ArmMotion& motors, const std::vector<PointLoad>& loads) {
  return vector_of(joint_torques(arm, motors, loads, {}));
}

}  // namespace

struct ArmSway::Springs {
  const Arm& arm;
  double step_s;
  Vector stiffness;        ///< K
  Vector e, rate, change;  ///< e, e', e''
  Vector force;            ///< f
  Matrix shape;            ///< S: e = S x with mu x'' + 2 zeta sqrt(mu) x' + x = -S' f, and S' K S = 1
  Vector mu;               ///< 1 / omega^2
  double loads_kg = -1.0;  ///< with which the modes were found
  int modes_age = 0;       ///< steps since then

  /// Hanging back evenly.
  Springs(const Arm& of, double step, const ArmMotion& motors, const std::vector<PointLoad>& loads)
      : arm(of), step_s(step), force(forces(of, motors, loads)) {
    const auto n = static_cast<Eigen::Index>(arm.joint_count());
    stiffness.resize(n);
    for (Eigen::Index j = 0; j < n; ++j)
      stiffness[j] = *of_joint(arm.robot().stiffness_N_m_rad, static_cast<std::size_t>(j));
    e = -stiffness.cwiseInverse().cwiseProduct(force);
    rate = change = Vector::Zero(n);
    find_modes(motors, loads);
  }

  /// Is a mode followed as it rings?
  [[nodiscard]] bool rings(Eigen::Index i) const { return step_s < kFastest_rad * std::sqrt(mu[i]); }

  void find_modes(const ArmMotion& motors, const std::vector<PointLoad>& loads) {
    modes_age = 0;
    loads_kg = mass_kg(loads);
    const std::size_t n = arm.joint_count();
    ArmMotion unit{motors.angle_rad, Joints(n, 0.0), Joints(n, 0.0)};
    Matrix M(n, n);
    for (std::size_t j = 0; j < n; ++j) {
      unit.acceleration_rad_s2[j] = 1.0;
      M.col(static_cast<Eigen::Index>(j)) = forces(arm, unit, loads);
      unit.acceleration_rad_s2[j] = 0.0;
    }
    const Vector soft = stiffness.cwiseSqrt().cwiseInverse();
    const Matrix scaled = soft.asDiagonal() * (0.5 * (M + M.transpose())) * soft.asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Matrix> solver(scaled);
    shape = soft.asDiagonal() * solver.eigenvectors();
    mu = solver.eigenvalues().cwiseMax(0.0);
  }

  void follow(const ArmMotion& motors, const std::vector<PointLoad>& loads) {
    const Vector before = force;
    force = forces(arm, motors, loads);
    if (++modes_age >= kModesEvery || mass_kg(loads) != loads_kg) find_modes(motors, loads);
    const Vector g0 = -shape.transpose() * before, g1 = -shape.transpose() * force;
    Vector x = shape.transpose() * stiffness.asDiagonal() * e;
    Vector x_rate = shape.transpose() * stiffness.asDiagonal() * rate, x_change = Vector::Zero(mu.size());
    for (Eigen::Index i = 0; i < mu.size(); ++i) {
      const double slope = (g1[i] - g0[i]) / step_s;
      if (rings(i)) {
        step_mode(i, g0[i], slope, x[i], x_rate[i]);
        x_change[i] = (g1[i] - x[i]) / mu[i] - 2.0 * arm.robot().damping_ratio * x_rate[i] / std::sqrt(mu[i]);
      } else {
        x[i] = g1[i];
        x_rate[i] = slope;
      }
    }
    e = shape * x;
    rate = shape * x_rate;
    change = shape * x_change;
  }

  /// mu x'' + 2 zeta sqrt(mu) x' + x = g + slope t over a step.
  void step_mode(Eigen::Index i, double g, double slope, double& x, double& x_rate) const {
    const double zeta = arm.robot().damping_ratio, omega = 1.0 / std::sqrt(mu[i]), decay = zeta * omega,
                 ring = omega * std::sqrt(1.0 - zeta * zeta), late = 2.0 * zeta * slope / omega;
    const double A = x - g + late, B = (x_rate - slope + decay * A) / ring;
    const double left = std::exp(-decay * step_s), c = std::cos(ring * step_s), s = std::sin(ring * step_s);
    x = g + slope * step_s - late + left * (A * c + B * s);
    x_rate = slope + left * ((ring * B - decay * A) * c - (decay * B + ring * A) * s);
  }
};

ArmSway::ArmSway(const Arm& arm, double step_s, const ArmMotion& told, const std::vector<PointLoad>& loads)
    : arm_(arm), step_s_(step_s), told_speed_rad_s_(told.speed_rad_s), motors_(told) {
  require(step_s > 0.0, "ArmSway: a step takes time");
  const std::size_t n = arm.joint_count();
  lag_rad_.assign(n, 0.0);
  for (std::size_t j = 0; j < n; ++j) {
    const auto tau = time_constant_s(arm.robot(), j);
    if (!tau) continue;
    lag_rad_[j] = *tau * (told.speed_rad_s[j] - *tau * told.acceleration_rad_s2[j]);
    motors_.angle_rad[j] -= lag_rad_[j];
    motors_.speed_rad_s[j] = lag_rad_[j] / *tau;
  }
  links_ = motors_;
  if (arm.robot().stiffness_N_m_rad.empty()) return;
  springs_ = std::make_unique<Springs>(arm, step_s, motors_, loads);
  for (std::size_t j = 0; j < n; ++j) links_.angle_rad[j] += springs_->e[static_cast<Eigen::Index>(j)];
}

ArmSway::~ArmSway() = default;

ArmMotion ArmSway::follow(const ArmMotion& told, const std::vector<PointLoad>& loads) {
  follow_motors(told);
  links_ = motors_;
  if (!springs_) return links_;
  springs_->follow(motors_, loads);
  for (std::size_t j = 0; j < arm_.joint_count(); ++j) {
    const auto at = static_cast<Eigen::Index>(j);
    links_.angle_rad[j] += springs_->e[at];
    links_.speed_rad_s[j] += springs_->rate[at];
    links_.acceleration_rad_s2[j] += springs_->change[at];
  }
  return links_;
}

void ArmSway::follow_motors(const ArmMotion& told) {
  for (std::size_t j = 0; j < arm_.joint_count(); ++j) {
    const auto tau = time_constant_s(arm_.robot(), j);
    if (!tau) {
      motors_.angle_rad[j] = told.angle_rad[j];
      motors_.speed_rad_s[j] = told.speed_rad_s[j];
      motors_.acceleration_rad_s2[j] = told.acceleration_rad_s2[j];
      continue;
    }
    // lag' = q' - lag / tau, for a q' that changes evenly over the step.
    const double from = told_speed_rad_s_[j], to = told.speed_rad_s[j], change = (to - from) / step_s_;
    const double left = std::exp(-step_s_ / *tau);
    lag_rad_[j] = *tau * (to - *tau * change) + (lag_rad_[j] - *tau * (from - *tau * change)) * left;
    motors_.angle_rad[j] = told.angle_rad[j] - lag_rad_[j];
    motors_.speed_rad_s[j] = lag_rad_[j] / *tau;
    motors_.acceleration_rad_s2[j] = (to - motors_.speed_rad_s[j]) / *tau;
  }
  told_speed_rad_s_ = told.speed_rad_s;
}

}  // namespace unbruised

#include <algorithm>
#include <cmath>

#include "core/door/eigen.hpp"
#include "core/robot/arm.hpp"

namespace unbruised {
namespace {

/// No memory is asked for: an arm has kMostArmJoints at most.
using Matrix = Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::ColMajor, 6, static_cast<int>(kMostArmJoints)>;
using Rates = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, static_cast<int>(kMostArmJoints), 1>;
using Gram = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 6, 6>;
using Square = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

constexpr double kAgreement = 1e-10;  // m and rad
constexpr int kMostSteps = 200;
constexpr double kLargestStep_rad = 0.5;
constexpr double kLeastDamping = 1e-14;
constexpr double kMostDamping = 1e4;

Vector6 vector_of(const Twist& twist) {
  Vector6 out;
  for (int d = 0; d < 3; ++d) {
    out[d] = twist.linear[static_cast<std::size_t>(d)];
    out[d + 3] = twist.angular[static_cast<std::size_t>(d)];
  }
  return out;
}

Matrix matrix_of(const std::vector<Twist>& jacobian) {
  Matrix out(6, static_cast<Eigen::Index>(jacobian.size()));
  for (std::size_t i = 0; i < jacobian.size(); ++i) out.col(static_cast<Eigen::Index>(i)) = vector_of(jacobian[i]);
  return out;
}

/// What is left to go: the way, and the turn about the vector by its length.
Vector6 error_between(const Pose& wanted, const Pose& now) {
  Twist error;
  for (std::size_t d = 0; d < 3; ++d) error.linear[d] = wanted.place_m[d] - now.place_m[d];
  error.angular = rotation_to(wanted.attitude * inverse(now.attitude));
  return vector_of(error);
}

void keep_within(const Arm& arm, Joints& angle) {
  for (std::size_t i = 0; i < angle.size(); ++i) {
    const ArmJointParameters& joint = arm.robot().joint[i];
    angle[i] = std::max(angle[i], joint.lower_rad.value_or(angle[i]));
    angle[i] = std::min(angle[i], joint.upper_rad.value_or(angle[i]));
  }
}

}  // namespace

std::optional<Joints> posture_for(const Arm& arm, const Pose& palm, Joints from, bool keep_limits) {
  double damping = 1e-6;
  Vector6 error = error_between(palm, arm.palm(from));
  for (int step = 0; step < kMostSteps && damping < kMostDamping; ++step) {
    if (error.head<3>().norm() < kAgreement && error.tail<3>().norm() < kAgreement) return from;
    const Matrix J = matrix_of(arm.jacobian(from));
    Square damped = J * J.transpose();
    damped.diagonal().array() += damping;
    Rates way = J.transpose() * damped.ldlt().solve(error);
    const double size = way.norm();
    if (size > kLargestStep_rad) way *= kLargestStep_rad / size;
    Joints next = from;
    for (std::size_t i = 0; i < next.size(); ++i) next[i] += way[static_cast<Eigen::Index>(i)];
    if (keep_limits) keep_within(arm, next);
    const Vector6 left = error_between(palm, arm.palm(next));
    const bool helps = left.norm() < error.norm();
    damping = helps ? std::max(kLeastDamping, 0.1 * damping) : 10.0 * damping;
    if (!helps) continue;
    from = std::move(next);
    error = left;
  }
  return std::nullopt;
}

JointRates rates_for(const std::vector<Twist>& jacobian, const Twist& twist) {
  const Matrix J = matrix_of(jacobian);
  const Vector6 wanted = vector_of(twist);
  Rates rate;
  if (J.cols() == 6) {
    const Square all = J;
    rate = all.partialPivLu().solve(wanted);
  } else {
    rate = J.completeOrthogonalDecomposition().solve(wanted);
  }
  JointRates out;
  out.rate.assign(rate.data(), rate.data() + rate.size());
  const double size = wanted.norm();
  if (size > 0.0) out.residual = (J * rate - wanted).norm() / size;
  return out;
}

double manipulability(const std::vector<Twist>& jacobian) {
  const Matrix J = matrix_of(jacobian);
  // Squares of the singular values are right to rounding of the largest: quick, and enough where none is small.
  constexpr double kSmall = 0.01;
  const Gram squares = J.cols() < 6 ? Gram(J.transpose() * J) : Gram(J * J.transpose());
  const Eigen::SelfAdjointEigenSolver<Gram> solver(squares, Eigen::EigenvaluesOnly);
  const auto& square = solver.eigenvalues();
  const double ratio = std::sqrt(std::max(0.0, square[0] / square[square.size() - 1]));
  if (ratio > kSmall) return ratio;
  const Eigen::JacobiSVD<Matrix> svd(J);
  const auto& values = svd.singularValues();
  return values[0] > 0.0 ? values[values.size() - 1] / values[0] : 0.0;
}

}  // namespace unbruised

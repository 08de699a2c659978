// A stiff body that tumbles about its intermediate axis, against Euler's equations of a rigid one.

#include "tests/core/frame/spin_scenes.hpp"

namespace unbruised {
namespace {

using namespace testing;

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

struct RigidState {
  Vector3d omega;     ///< along the axes of the body
  Eigen::Vector4d q;  ///< w, x, y, z
};

RigidState rate(const Matrix3d& J, const RigidState& at) {
  const Vector3d domega = J.ldlt().solve(-at.omega.cross(J * at.omega));
  const Quaterniond q(at.q[0], at.q[1], at.q[2], at.q[3]);
  const Quaterniond dq = q * Quaterniond(0.0, at.omega.x(), at.omega.y(), at.omega.z());
  return {domega, 0.5 * Eigen::Vector4d(dq.w(), dq.x(), dq.y(), dq.z())};
}

RigidState moved(const RigidState& from, const RigidState& along, double by) {
  return {from.omega + by * along.omega, from.q + by * along.q};
}

/// The attitude of a rigid body by the classical Runge-Kutta method; 4000 steps of a twelve-radian tumble are
/// right to 1e-10.
Quaterniond rigid_attitude(const Matrix3d& J, const Vector3d& omega, double duration_s) {
  constexpr int kSteps = 4000;
  const double h = duration_s / kSteps;
  RigidState s{omega, {1.0, 0.0, 0.0, 0.0}};
  for (int k = 0; k < kSteps; ++k) {
    const RigidState k1 = rate(J, s), k2 = rate(J, moved(s, k1, 0.5 * h)), k3 = rate(J, moved(s, k2, 0.5 * h)),
                     k4 = rate(J, moved(s, k3, h));
    s.omega += h / 6.0 * (k1.omega + 2.0 * k2.omega + 2.0 * k3.omega + k4.omega);
    s.q += h / 6.0 * (k1.q + 2.0 * k2.q + 2.0 * k3.q + k4.q);
    s.q.normalize();
  }
  return {s.q[0], s.q[1], s.q[2], s.q[3]};
}

Matrix3d inertia_of(const Points& points) {
  Matrix3d J = Matrix3d::Zero();
  for (std::size_t p = 0; p < points.X.size(); ++p) {
    const Vector3d& X = points.X[p];
    J += points.mass_kg[p] * (X.squaredNorm() * Matrix3d::Identity() - X * X.transpose());
  }
  return J;
}

struct TumbleCase {
  double time_step_s, largest_angle, largest_energy_change;
};

TEST(Tumbling, FollowsTheRigidBodyAtSecondOrder) {
  const Vector3d omega = 10.0 * Vector3d(0.02, 1.0, 0.03);
  // Of a prototype: 1.8e-5, 6.6e-5, 4.7e-4 and 4.1e-7, 3.3e-6, 2.6e-5; 1.2e-5 of the angle is the body's
  // flexibility.
  for (const TumbleCase& at : {TumbleCase{2e-3, 4e-5, 1e-6}, {4e-3, 1.3e-4, 7e-6}, {8e-3, 1e-3, 6e-5}}) {
    Scenario scenario = spinning_box({omega.x(), omega.y(), omega.z()}, at.time_step_s, 1.2, 2e7);
    lattice_of(scenario).relaxation_time_s = 1e-4;
    Trace trace;
    EXPECT_EQ(run(scenario, &trace).cause, "");
    const Points points = points_of(scenario);
    const SpinRow start = spin_row(trace, points, 0), end = last_row(trace, points);
    const double angle =
        angle_between(end.attitude, rigid_attitude(inertia_of(points), omega, trace.time_s.back()));
    EXPECT_LT(angle, at.largest_angle) << at.time_step_s;
    EXPECT_LT((end.momentum_kg_m2_s - start.momentum_kg_m2_s).norm(), 1e-12 * start.momentum_kg_m2_s.norm());
    const std::vector<double> energy = column(trace, "stored_energy_J");
    EXPECT_LT(std::abs(energy.back() / energy.front() - 1.0), at.largest_energy_change) << at.time_step_s;
  }
}

/// Attitude and shape of a soft body after 0.256 s.
SpinRow soft_tumble(double time_step_s) {
  Scenario scenario = spinning_box({0.4, 20.0, 0.6}, time_step_s, 0.256, 5e4);
  lattice_of(scenario).relaxation_time_s = 1e-3;
  Trace trace;
  EXPECT_EQ(run(scenario, &trace).cause, "");
  return last_row(trace, points_of(scenario));
}

TEST(Tumbling, OfASoftBodyIsOfSecondOrderInTheTimeStep) {
  const SpinRow reference = soft_tumble(2.5e-4);
  std::vector<double> angle, shape;
  for (const double dt : {1e-3, 2e-3, 4e-3}) {
    const SpinRow row = soft_tumble(dt);
    angle.push_back(angle_between(row.attitude, reference.attitude));
    shape.push_back((row.u - reference.u).cwiseAbs().maxCoeff());
  }
  // A reference of a quarter of the finest step takes 1/16 of its error: factors of 4 become 4.2 and 4.05.
  for (const auto* error : {&angle, &shape}) {
    EXPECT_GT((*error)[1] / (*error)[0], 3.5);
    EXPECT_GT((*error)[2] / (*error)[1], 3.5);
  }
}

TEST(Tumbling, LeavesAPlasticBodyAsItIs) {
  // Squeezed is not what a free body is; stretched by its spin it is. Once it has flowed and turns on, nothing
  // more flows.
  Scenario scenario = spinning_box({0.0, 0.0, 30.0}, 1e-3, 0.5, 4e4);
  lattice_of(scenario).yield_stress_Pa = 150.0;
  lattice_of(scenario).tangent_modulus_Pa = 1e4;
  Trace trace;
  EXPECT_EQ(run(scenario, &trace).cause, "");
  const std::vector<double> strain = column(trace, "plastic_strain_max");
  EXPECT_GT(strain.back(), 1e-4);
  EXPECT_NEAR(strain.back(), strain[strain.size() / 2], 1e-12);
}

}  // namespace
}  // namespace unbruised

// Wilson-theta through the whole simulator: networks against published tables and exact solutions.

#include <cmath>
#include <complex>
#include <numbers>

#include <gtest/gtest.h>

#include "core/door/eigen.hpp"
#include "tests/core/simulation/scenes.hpp"
#include "tests/reference_data.hpp"

namespace unbruised {
namespace {

using namespace testing;
using std::numbers::pi;

/// Bathe's example as masses 2 and 1 on springs of 4, 2 and 2 between two walls: K = [[6, -2], [-2, 4]].
Scenario bathe() {
  Scenario scenario = oscillator(2.0, 4.0, 0.28, 12);
  NetworkParameters& network = network_of(scenario);
  NetworkParticle second = network.particle[1];
  second.position_m = {2.0, 0.0, 0.0};
  second.mass_kg = 1.0;
  NetworkParticle wall = network.particle[0];
  wall.position_m = {3.0, 0.0, 0.0};
  network.particle.push_back(second);
  network.particle.push_back(wall);
  for (const std::array<int, 2>& between : {std::array{1, 2}, std::array{2, 3}}) {
    NetworkSpring& spring = network.spring.emplace_back();
    spring.between = between;
    spring.stiffness_N_m = 2.0;
  }
  network.load.push_back({2, {0.0}, {{10.0, 0.0, 0.0}}});
  return scenario;
}

TEST(WilsonTheta, ReproducesBathesTwoFreedomTable) {
  const std::array<std::array<double, 2>, 12> printed = {{{0.00605, 0.366},
                                                          {0.0525, 1.34},
                                                          {0.196, 2.64},
                                                          {0.490, 3.92},
                                                          {0.952, 4.88},
                                                          {1.54, 5.31},
                                                          {2.16, 5.18},
                                                          {2.67, 4.61},
                                                          {2.92, 3.82},
                                                          {2.82, 3.06},
                                                          {2.33, 2.52},
                                                          {1.54, 2.29}}};
  Trace trace;
  run(bathe(), &trace);
  const auto table = read_table("wilson_bathe_2dof.csv");
  ASSERT_EQ(trace.time_s.size(), 13u);
  ASSERT_EQ(table.size(), 13u);
  for (std::size_t k = 0; k < 13; ++k) {
    for (std::size_t i = 0; i < 2; ++i) {
      const std::size_t at = 12 * k + 3 * (i + 1);
      const std::string name = std::to_string(i + 1);
      // The file has 15 digits of numbers up to 10.
      EXPECT_NEAR(trace.displacement_m[at], number(table[k], "u" + name), 1e-12) << "step " << k;
      EXPECT_NEAR(trace.velocity_m_s[at], number(table[k], "v" + name), 1e-12) << "step " << k;
      EXPECT_NEAR(trace.acceleration_m_s2[at], number(table[k], "a" + name), 1e-12) << "step " << k;
      if (k == 0) continue;
      const double value = printed[k - 1][i];
      const double last_digit = std::pow(10.0, std::floor(std::log10(value)) - 2.0);
      EXPECT_NEAR(trace.displacement_m[at], value, last_digit) << "step " << k;
    }
  }
}

/// Exact motion of q'' + 2 zeta omega q' + omega^2 q = f(t) for a piecewise linear f, at multiples of `dt`.
std::vector<double> exact_mode(double omega, double zeta, const std::vector<double>& time,
                               const std::vector<double>& force, double dt, int steps) {
  const double damped = omega * std::sqrt(1.0 - zeta * zeta);
  double q = 0.0, rate = 0.0, t = 0.0;
  std::vector<double> result = {0.0};
  // March over the pieces between kinks and sample times: within one, the motion is a closed form.
  for (int k = 1; k <= steps; ++k) {
    const double target = k * dt;
    while (t < target - 1e-13) {
      double end = target;
      for (double kink : time) {
        if (kink > t + 1e-13 && kink < end) end = kink;
      }
      const auto value = [&](double at) {
        std::size_t i = 0;
        while (i + 2 < time.size() && at >= time[i + 1]) ++i;
        if (at >= time.back()) return force.back();
        return force[i] + (force[i + 1] - force[i]) * (at - time[i]) / (time[i + 1] - time[i]);
      };
      const double h = end - t, middle = 0.5 * (t + end);
      const double slope = (value(middle + 0.25 * h) - value(middle - 0.25 * h)) / (0.5 * h);
      const double start = value(middle) - 0.5 * h * slope;
      const double w2 = omega * omega;
      const double p0 = (start - 2.0 * zeta * slope / omega) / w2, p1 = slope / w2;
      const double A = q - p0, B = (rate - p1 + zeta * omega * A) / damped;
      const double decay = std::exp(-zeta * omega * h), c = std::cos(damped * h), s = std::sin(damped * h);
      q = decay * (A * c + B * s) + p0 + p1 * h;
      rate = decay * ((-zeta * omega * A + damped * B) * c + (-zeta * omega * B - damped * A) * s) + p1;
      t = end;
    }
    result.push_back(q);
  }
  return result;
}

/// A chain of four masses between a wall and a free end, loaded by a force that rises, falls and rests.
class LoadedChain {
 public:
  static constexpr double kEnd = 4.0;
  std::vector<double> time = {0.0, 0.5, 1.0, 2.0};
  std::vector<double> force = {0.0, 3.0, -2.0, 1.0};
  std::array<double, 4> mass = {1.0, 1.5, 0.7, 2.0}, stiffness = {40.0, 25.0, 30.0, 20.0};

  explicit LoadedChain(double damping_time) : damping_time_(damping_time) {}

  [[nodiscard]] Scenario scenario(double dt) const {
    Scenario scenario = oscillator(1.0, 1.0, dt, static_cast<int>(std::lround(kEnd / dt)));
    NetworkParameters network;
    NetworkParticle wall;
    wall.fixed = {true, true, true};
    network.particle = {wall};
    for (std::size_t i = 0; i < 4; ++i) {
      NetworkParticle particle;
      particle.position_m = {1.0 + static_cast<double>(i), 0.0, 0.0};
      particle.mass_kg = mass[i];
      particle.fixed = {false, true, true};
      network.particle.push_back(particle);
      const int j = static_cast<int>(i);
      NetworkSpring& spring = network.spring.emplace_back();
      spring.between = {j, j + 1};
      spring.stiffness_N_m = stiffness[i];
      spring.damping_N_s_m = damping_time_ * stiffness[i];
    }
    NetworkLoad load;
    load.particle = 3;
    load.time_s = time;
    for (double f : force) load.force_N.push_back({f, 0.0, 0.0});
    network.load = {load};
    scenario.product = network;
    return scenario;
  }

  /// Exact displacement of the masses at multiples of `dt`, [4, steps + 1].
  [[nodiscard]] Eigen::MatrixXd exact(double dt) const {
    Eigen::MatrixXd K = Eigen::MatrixXd::Zero(4, 4), M = Eigen::MatrixXd::Zero(4, 4);
    for (int i = 0; i < 4; ++i) {
      M(i, i) = mass[static_cast<std::size_t>(i)];
      const double k = stiffness[static_cast<std::size_t>(i)];
      K(i, i) += k;
      if (i > 0) {
        K(i - 1, i - 1) += k;
        K(i, i - 1) -= k;
        K(i - 1, i) -= k;
      }
    }
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> eigen(K, M);
    const int steps = static_cast<int>(std::lround(kEnd / dt));
    Eigen::MatrixXd u = Eigen::MatrixXd::Zero(4, steps + 1);
    for (int m = 0; m < 4; ++m) {
      const double omega = std::sqrt(eigen.eigenvalues()[m]);
      const Eigen::VectorXd shape = eigen.eigenvectors().col(m);
      std::vector<double> modal = force;
      for (double& f : modal) f *= shape[2];
      const auto q = exact_mode(omega, 0.5 * damping_time_ * omega, time, modal, dt, steps);
      for (int k = 0; k <= steps; ++k) u.col(k) += q[static_cast<std::size_t>(k)] * shape;
    }
    return u;
  }

  /// Largest error over time of all masses.
  [[nodiscard]] double error(double dt) const {
    Trace trace;
    run(scenario(dt), &trace);
    const Eigen::MatrixXd wanted = exact(dt);
    EXPECT_EQ(static_cast<Eigen::Index>(trace.time_s.size()), wanted.cols());
    double worst = 0.0;
    for (Eigen::Index k = 0; k < wanted.cols(); ++k) {
      for (Eigen::Index i = 0; i < 4; ++i) {
        const auto at = static_cast<std::size_t>(15 * k + 3 * (i + 1));
        worst = std::max(worst, std::abs(trace.displacement_m[at] - wanted(i, k)));
      }
    }
    return worst;
  }

 private:
  double damping_time_;
};

TEST(WilsonTheta, ConvergesWithOrderTwoUnderALoadThatChanges) {
  for (double damping_time : {0.0, 0.02}) {
    const LoadedChain chain(damping_time);
    std::vector<double> error;
    for (double dt : {0.02, 0.01, 0.005, 0.0025}) error.push_back(chain.error(dt));
    for (std::size_t i = 1; i < error.size(); ++i) {
      const double ratio = error[i - 1] / error[i];
      EXPECT_GT(ratio, 3.6) << "damping time " << damping_time << ", errors " << error[i - 1] << ", " << error[i];
      EXPECT_LT(ratio, 4.4) << "damping time " << damping_time << ", errors " << error[i - 1] << ", " << error[i];
    }
    EXPECT_LT(error.back(), 1e-3);
    std::cout << "[ measured ] damping time " << damping_time << ": errors " << error[0] << " " << error[1] << " "
              << error[2] << " " << error[3] << "\n";
  }
}

TEST(WilsonTheta, FreeFallIsExact) {
  Scenario scenario = small_box();
  scenario.gripper = NoGripper{};
  scenario.cell.support = false;
  scenario.cell.gravity_m_s2 = {0.0, 1.5, -kGravity};
  lattice_of(scenario).initial_velocity_m_s = {0.3, 0.0, 0.7};
  scenario.simulation.duration_s = 0.5;
  Trace trace;
  const ScenarioResult result = run(scenario, &trace);
  for (std::size_t k = 0; k < trace.time_s.size(); ++k) {
    const double t = trace.time_s[k];
    const std::array<double, 3> wanted = {0.3 * t, 0.75 * t * t, 0.7 * t - 0.5 * kGravity * t * t};
    for (std::size_t i = 0; i < 3 * static_cast<std::size_t>(trace.particle_count); ++i) {
      // 500 steps that each round 1 m at 1e-16; the errors of the accelerations add up twice, so with steps^2.
      ASSERT_NEAR(trace.displacement_m[3 * static_cast<std::size_t>(trace.particle_count) * k + i], wanted[i % 3],
                  1e-10)
          << "t = " << t;
    }
  }
  EXPECT_LT(result.metrics[Metric::impulse_balance_error], 1e-9);
  EXPECT_LT(std::abs(result.metrics[Metric::energy_balance_error]), 1e-9);
}

/// One step of the undamped oscillator of omega = 1 from a state; acceleration only zero or consistent.
Eigen::Vector3d one_step(double dt, double theta, double u, double v, InitialAcceleration start) {
  Scenario scenario = oscillator(1.0, 1.0, dt, 1);
  scenario.simulation.theta = theta;
  scenario.simulation.initial_acceleration = start;
  network_of(scenario).particle[1].initial_displacement_m = {u, 0.0, 0.0};
  network_of(scenario).particle[1].initial_velocity_m_s = {v, 0.0, 0.0};
  Trace trace;
  run(scenario, &trace);
  return {trace.displacement_m[9], trace.velocity_m_s[9], trace.acceleration_m_s2[9]};
}

/// Eigenvalues of the step's 3 x 3 amplification matrix, from three steps of the simulator.
Eigen::Vector3cd amplification(double dt, double theta) {
  Eigen::Matrix3d A;
  A.col(0) = one_step(dt, theta, 1.0, 0.0, InitialAcceleration::zero);
  A.col(1) = one_step(dt, theta, 0.0, 1.0, InitialAcceleration::zero);
  A.col(2) = A.col(0) - one_step(dt, theta, 1.0, 0.0, InitialAcceleration::consistent);  // a0 = -1
  return Eigen::EigenSolver<Eigen::Matrix3d>(A).eigenvalues();
}

TEST(WilsonTheta, HasTheSpectralRadiusOfItsTheory) {
  for (const TableRow& row : read_table("spectral_radius.csv")) {
    for (const auto& [theta, name] :
         {std::pair(1.4, "wilson1.4"), std::pair(1.37, "wilson1.37"), std::pair(1.420815, "wilson1.420815")}) {
      const double radius = amplification(number(row, "Omega"), theta).cwiseAbs().maxCoeff();
      // The file has 12 decimals; near dt / T = 100 the columns of the matrix differ by 1e5 in size.
      EXPECT_NEAR(radius, number(row, name), 1e-9) << name << " at dt/T = " << row.at("dt_over_T");
      EXPECT_LE(radius, 1.0);
    }
  }
}

/// The root that carries the motion: of the complex pair, the one of positive argument.
std::complex<double> principal_root(double Omega) {
  std::complex<double> principal = 0.0;
  const Eigen::Vector3cd roots = amplification(Omega, 1.4);
  for (const auto& root : roots) {
    if (root.imag() > 1e-9) principal = root;
  }
  return principal;
}

TEST(WilsonTheta, LengthensThePeriodAndDampsAsTheTableSays) {
  int rows = 0;
  for (const TableRow& row : read_table("period_elongation_decay.csv")) {
    if (row.at("method") != "wilson1.4") continue;
    const double Omega = 2.0 * pi * number(row, "dt_over_T");
    const std::complex<double> root = principal_root(Omega);
    if (std::arg(root) == 0.0) continue;
    ++rows;
    const double elongation = Omega / std::arg(root) - 1.0;
    const double damping = -std::log(std::abs(root)) / std::arg(root);
    EXPECT_NEAR(elongation, number(row, "period_elongation"), 1e-8) << row.at("dt_over_T");
    EXPECT_NEAR(damping, number(row, "algorithmic_damping_ratio"), 1e-8) << row.at("dt_over_T");
    EXPECT_NEAR(std::abs(root), number(row, "abs_principal_root"), 1e-9) << row.at("dt_over_T");
    if (Omega > 0.13) continue;
    // Leading terms; the next ones are Omega^2 smaller with factors of order one.
    EXPECT_NEAR(elongation / (Omega * Omega), 1.0 / 24.0 + 1.4 * 0.4 / 4.0, 0.5 * Omega * Omega);
    EXPECT_NEAR(damping / std::pow(Omega, 3), 1.4 * 0.4 * 1.8 / 12.0, 0.5 * Omega * Omega + 1e-5);
  }
  EXPECT_GE(rows, 8);
}

struct Vibration {
  std::vector<double> u, v;
};

/// A load of a constant size from the start, or one that rises from zero over the first step.
enum class Rise { at_once, over_first_step };

Vibration vibrate(double dt_over_T, double load, double u0, Rise rise, int steps) {
  const double omega = 2.0 * pi;  // T = 1 s
  Scenario scenario = oscillator(1.0, omega * omega, dt_over_T, steps);
  network_of(scenario).particle[1].initial_displacement_m = {u0, 0.0, 0.0};
  const std::array<double, 3> full = {load * omega * omega, 0.0, 0.0};
  if (rise == Rise::at_once) {
    network_of(scenario).load = {{1, {0.0}, {full}}};
  } else {
    network_of(scenario).load = {{1, {0.0, dt_over_T}, {{0.0, 0.0, 0.0}, full}}};
  }
  Trace trace;
  run(scenario, &trace);
  return {freedom(trace, trace.displacement_m, 3), freedom(trace, trace.velocity_m_s, 3)};
}

double largest_size(const std::vector<double>& values) {
  double result = 0.0;
  for (double value : values) result = std::max(result, std::abs(value));
  return result;
}

TEST(WilsonTheta, OvershootsAsKnown) {
  // The first displacement at dt = T, so that a quietly "repaired" scheme is noticed.
  EXPECT_NEAR(vibrate(1.0, 0.0, 1.0, Rise::at_once, 1).u[1], -5.65439308828, 1e-11);
  int rows = 0;
  for (const TableRow& row : read_table("overshoot_u0_1_v0_0.csv")) {
    if (row.at("method") != "wilson1.4") continue;
    ++rows;
    const Vibration free = vibrate(number(row, "dt_over_T"), 0.0, 1.0, Rise::at_once, 40);
    const double first = number(row, "u_after_step1");
    EXPECT_NEAR(free.u[1], first, 1e-10 * std::max(1.0, std::abs(first))) << row.at("dt_over_T");
    const std::vector<double> later(free.u.begin() + 1, free.u.end());
    const std::vector<double> speed(free.v.begin() + 1, free.v.end());
    const double most = number(row, "max_abs_u_40steps"), fastest = number(row, "max_abs_v_over_omega");
    EXPECT_NEAR(largest_size(later), most, 1e-9 * std::max(1.0, most)) << row.at("dt_over_T");
    EXPECT_NEAR(largest_size(speed) / (2.0 * pi), fastest, 1e-9 * std::max(1.0, fastest)) << row.at("dt_over_T");
  }
  EXPECT_GE(rows, 8);
}

TEST(WilsonTheta, OvershootsUnderAStepLoadButNotUnderARamp) {
  for (const TableRow& row : read_table("step_load_overshoot_wilson14.csv")) {
    const double ratio = number(row, "dt_over_T");
    const int steps = 400;
    const Vibration jump = vibrate(ratio, 1.0, 0.0, Rise::at_once, steps);
    const double first = number(row, "u1_over_us"), most = number(row, "max_u_over_us");
    EXPECT_NEAR(jump.u[1], first, 1e-7 * std::max(1.0, first)) << ratio;
    EXPECT_NEAR(largest(jump.u), most, 1e-6 * std::max(1.0, most)) << ratio;
    const Vibration ramp = vibrate(ratio, 1.0, 0.0, Rise::over_first_step, steps);
    EXPECT_NEAR(ramp.u[1], number(row, "u1_over_us_if_a0_zero"), 1e-7) << ratio;
    EXPECT_NEAR(largest(ramp.u), number(row, "max_if_a0_zero"), 1e-6) << ratio;
    EXPECT_LE(largest(ramp.u), 2.0) << ratio;  // the exact maximum under a step load
  }
}

TEST(WilsonTheta, KeepsANetworkWithoutForcesAtRestToTheLastBit) {
  Scenario scenario = bathe();
  network_of(scenario).load.clear();
  Trace trace;
  run(scenario, &trace);
  for (double u : trace.displacement_m) EXPECT_EQ(u, 0.0);
}

}  // namespace
}  // namespace unbruised

// Bounces on a plate on a six-axis sensor, against closed forms: restitution of a dashpot, the series of a ball's
// impacts, Hertz's impact of a sphere, and steps so long that they follow nothing.

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/core/simulation/scenes.hpp"
#include "tests/reference_data.hpp"

namespace unbruised {
namespace {

using namespace testing;

constexpr double kBall_kg = 0.05, kFoot_kg = 5e-5, kSpring_N_m = 5000.0;

void put_on_sensor(Scenario& scenario) {
  scenario.cell.support = true;
  scenario.cell.support_relaxation_time_s = 0.0;
  scenario.sensor.at = SensorMount::support;
  scenario.sensor.position_m = {0.0, 0.0, 0.0};
  scenario.sensor.element_stiffness_N_m = 2.5e6;
  scenario.sensor.mass_kg = 0.005;
  scenario.sensor.inertia_kg_m2 = {1e-6, 1e-6, 1e-6};
}

/// A ball on a spring and a dashpot with a light foot, which touches a plate that hardly gives way.
Scenario dashpot_ball(double zeta, double height_m, double speed_m_s) {
  Scenario scenario;
  NetworkParameters network;
  NetworkParticle foot, ball;
  foot.mass_kg = kFoot_kg;
  foot.contact_stiffness_N_m = 1000.0 * kSpring_N_m;
  ball.mass_kg = kBall_kg - kFoot_kg;
  foot.position_m = {0.0, 0.0, height_m};
  ball.position_m = {0.0, 0.0, height_m + 0.02};
  for (NetworkParticle* particle : {&foot, &ball}) {
    particle->initial_velocity_m_s = {0.0, 0.0, -speed_m_s};
    particle->fixed = {true, true, false};
  }
  NetworkSpring spring;
  spring.between = {0, 1};
  spring.stiffness_N_m = kSpring_N_m;
  spring.damping_N_s_m = 2.0 * zeta * std::sqrt(kSpring_N_m * kBall_kg);
  network.particle = {foot, ball};
  network.spring = {spring};
  scenario.product = network;
  put_on_sensor(scenario);
  scenario.simulation.time_step_s = 5e-5;
  return scenario;
}

/// Velocity of the centre of mass in each row.
std::vector<double> center_speeds(const Trace& trace) {
  const std::vector<double> foot = freedom(trace, trace.velocity_m_s, 2),
                            ball = freedom(trace, trace.velocity_m_s, 5);
  std::vector<double> speeds(foot.size());
  for (std::size_t i = 0; i < foot.size(); ++i) {
    speeds[i] = (kFoot_kg * foot[i] + (kBall_kg - kFoot_kg) * ball[i]) / kBall_kg;
  }
  return speeds;
}

TEST(Bounce, OfADashpotHasItsClosedRestitution) {
  for (const TableRow& row : read_table("restitution_linear_dashpot.csv")) {
    const double zeta = number(row, "zeta");
    if (zeta > 0.3) continue;
    Scenario scenario = dashpot_ball(zeta, 1e-4, 1.0);
    scenario.cell.gravity_m_s2 = {0.0, 0.0, 0.0};
    scenario.simulation.duration_s = 0.02;
    Trace trace;
    run(scenario, &trace);
    // 1/1000 of the spring is the contact's, 1/2000 the sensor's.
    EXPECT_NEAR(center_speeds(trace).back(), number(row, "e_no_tension"), 0.01) << zeta;
  }
}

/// Of the dashpot without tension: e = exp(-zeta t), t = (pi - atan(2 zeta s / (s^2 - zeta^2))) / s.
double restitution(double zeta) {
  const double s = std::sqrt(1.0 - zeta * zeta);
  return std::exp(-zeta * (M_PI - std::atan2(2.0 * zeta * s, s * s - zeta * zeta)) / s);
}

TEST(Bounce, FollowsTheSeriesOfItsRestitution) {
  double low = 0.01, high = 0.3;
  for (int i = 0; i < 60; ++i) (restitution(0.5 * (low + high)) > 0.7 ? low : high) = 0.5 * (low + high);
  Scenario scenario = dashpot_ball(0.5 * (low + high), 0.1, 0.0);
  scenario.cell.gravity_m_s2 = {0.0, 0.0, -9.81};
  scenario.simulation.duration_s = 0.65;
  Trace trace;
  run(scenario, &trace);
  const std::vector<double> speeds = center_speeds(trace), force_N = column(trace, "sensor_wrench", 2);
  std::vector<double> impacts, times;
  for (std::size_t i = 1; i < speeds.size(); ++i) {
    const bool touches = force_N[i] > 0.5 && speeds[i] < 0.0;
    if (!touches || (!times.empty() && trace.time_s[i] - times.back() < 0.05)) continue;
    impacts.push_back(
        -*std::min_element(speeds.begin() + static_cast<long>(i) - 20, speeds.begin() + static_cast<long>(i) + 1));
    times.push_back(trace.time_s[i]);
  }
  ASSERT_GE(impacts.size(), 3U);
  std::size_t n = 0;
  for (const TableRow& row : read_table("bounce_heights.csv")) {
    if (number(row, "e") != 0.7 || n >= 3) continue;
    // While the dashpot lets go the ball still lies by a millimetre below where it touched: gravity takes up to 2
    // % of the speed from bounce to bounce, and never gives.
    const double expected = number(row, "impact_speed_m_s");
    EXPECT_NEAR(impacts[n], expected, (0.002 + 0.02 * static_cast<double>(n)) * expected) << n;
    EXPECT_LE(impacts[n], 1.001 * expected) << n;
    if (n > 0) {
      const double flight_s = 2.0 * impacts[n] / 9.81;
      const double contact_s = times[n] - times[n - 1] - flight_s;
      EXPECT_NEAR(contact_s, M_PI * std::sqrt(kBall_kg / kSpring_N_m), 0.15 * 0.01) << n;
    }
    ++n;
  }
}

/// A soft ball that meets the plate at 0.5 m/s.
Scenario soft_ball(const TableRow& row, double cell_size_m) {
  Scenario scenario;
  LatticeParameters ball;
  ball.shape = Shape::sphere;
  ball.size_m = {0.06, 0.06, 0.06};
  ball.cell_size_m = cell_size_m;
  ball.mass_kg = number(row, "m_kg");
  ball.youngs_modulus_Pa = number(row, "E_Pa");
  ball.poisson_ratio = number(row, "nu");
  ball.relaxation_time_s = 0.0;
  ball.initial_velocity_m_s = {0.0, 0.0, -0.5};
  scenario.product = ball;
  put_on_sensor(scenario);
  scenario.cell.gravity_m_s2 = {0.0, 0.0, 0.0};
  scenario.cell.support_modulus_Pa = 1e9;  // 2 mm of hard plastic
  scenario.cell.support_thickness_m = 0.002;
  scenario.simulation.time_step_s = 1e-4;
  scenario.simulation.duration_s = 0.015;
  return scenario;
}

// Hertz's impact, read through the sensor: a lattice is stiffer than the sphere by its cells over the patch, whose
// radius is 7.4 mm here, and comes nearer with them.
TEST(Bounce, OfASphereComesToHertzs) {
  for (const TableRow& row : read_table("hertz_impact.csv")) {
    if (!row.at("case").starts_with("soft ball") || number(row, "v_m_s") != 0.5) continue;
    std::vector<double> error;
    for (const double cell_size_m : {0.0075, 0.004}) {
      Trace trace;
      const ScenarioResult result = run(soft_ball(row, cell_size_m), &trace);
      EXPECT_EQ(result.outcome, Outcome::held) << result.cause;
      error.push_back(result.metrics[Metric::peak_sensor_force_N] / number(row, "F_max_N") - 1.0);
      const std::vector<double> force_N = column(trace, "sensor_wrench", 2);
      const auto pressed =
          std::count_if(force_N.begin(), force_N.end(), [](double force) { return force > 0.05; });
      EXPECT_NEAR(1e-4 * static_cast<double>(pressed), number(row, "contact_time_s"),
                  0.12 * number(row, "contact_time_s"));
    }
    EXPECT_LT(error[0], 0.18);
    EXPECT_LT(error[1], 0.10);
    EXPECT_GT(error[1], 0.0);
  }
}

/// Largest speed after a point mass of 1 m/s has met a plate; ten phases of the impact within a step.
double largest_rebound_m_s(double steps_per_contact, bool on_sensor) {
  const double contact_s = M_PI * std::sqrt(kBall_kg / kSpring_N_m);
  double most = 0.0;
  for (int phase = 0; phase < 10; ++phase) {
    Scenario scenario;
    NetworkParameters network;
    NetworkParticle particle;
    particle.mass_kg = kBall_kg;
    particle.contact_stiffness_N_m = kSpring_N_m;
    scenario.simulation.time_step_s = contact_s / steps_per_contact;
    particle.position_m = {0.0, 0.0, (1.0 + 0.1 * phase) * scenario.simulation.time_step_s};
    particle.initial_velocity_m_s = {0.0, 0.0, -1.0};
    network.particle = {particle};
    scenario.product = network;
    put_on_sensor(scenario);
    scenario.cell.gravity_m_s2 = {0.0, 0.0, 0.0};
    scenario.sensor.at = on_sensor ? SensorMount::support : SensorMount::none;
    scenario.sensor.mass_kg = 1.0;
    scenario.sensor.element_stiffness_N_m = 2.5e5;
    scenario.sensor.inertia_kg_m2 = {1e-3, 1e-3, 1e-3};
    scenario.simulation.duration_s = 10.0 * contact_s;
    Trace trace;
    run(scenario, &trace);
    most = std::max(most, largest(freedom(trace, trace.velocity_m_s, 2)));
  }
  return most;
}

// A plate of 1 kg on 1e6 N/m, at steps from a contact's fiftieth to its whole length: the mount adds nothing to
// what collocated contact gains where a step does not resolve it.
TEST(Bounce, AMountGainsNoEnergyAtAnyStep) {
  for (const double steps : {50.0, 12.0, 6.0, 3.0, 1.0}) {
    EXPECT_LE(largest_rebound_m_s(steps, true), largest_rebound_m_s(steps, false) + 1e-3) << steps;
  }
  EXPECT_LE(largest_rebound_m_s(12.0, true), 1.001);
}

}  // namespace
}  // namespace unbruised

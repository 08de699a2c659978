#include "core/body/network.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/core/algebra/dense.hpp"

namespace unbruised {
namespace {

NetworkParticle particle_at(double x, double y = 0.0, double z = 0.0) {
  NetworkParticle particle;
  particle.position_m = {x, y, z};
  particle.mass_kg = 1.0;
  return particle;
}

NetworkSpring spring_between(int a, int b, double stiffness, double damping = 0.0) {
  NetworkSpring spring;
  spring.between = {a, b};
  spring.stiffness_N_m = stiffness;
  spring.damping_N_s_m = damping;
  return spring;
}

/// Bathe's two-freedom example along x: wall -4- mass 2 -2- mass 1 -2- wall, M = diag(2, 1), K = [6 -2; -2 4].
NetworkParameters bathe() {
  NetworkParameters network;
  network.particle = {particle_at(0), particle_at(1), particle_at(2), particle_at(3)};
  network.particle[0].fixed = network.particle[3].fixed = {true, true, true};
  network.particle[1].fixed = network.particle[2].fixed = {false, true, true};
  network.particle[1].mass_kg = 2.0;
  network.spring = {spring_between(0, 1, 4.0), spring_between(1, 2, 2.0, 0.5), spring_between(3, 2, 2.0)};
  return network;
}

TEST(Network, AssemblesBathesTwoFreedomExample) {
  const NetworkSystem system = build_network(bathe());
  const Eigen::MatrixXd K = testing::dense(system.K);
  const std::vector<int> free{3, 6};
  Eigen::Matrix2d expected;
  expected << 6, -2, -2, 4;
  EXPECT_EQ(K(free, free), expected);
  EXPECT_EQ(system.mass_kg[1], 2.0);
  EXPECT_EQ(system.mass_kg[2], 1.0);
  EXPECT_EQ(system.fixed[1], (std::array<bool, 3>{false, true, true}));
  EXPECT_EQ(K(3, 0), -4.0);
  Eigen::Matrix2d damping;
  damping << 0.5, -0.5, -0.5, 0.5;
  EXPECT_EQ(testing::dense(system.C)(free, free), damping);
}

TEST(Network, StiffnessAndDampingShareOnePattern) {
  const NetworkSystem system = build_network(bathe());
  EXPECT_EQ(system.K.row_start, system.C.row_start);
  EXPECT_EQ(system.K.column, system.C.column);
  EXPECT_EQ(system.K.column, (std::vector<int>{0, 1, 0, 1, 2, 1, 2, 3, 2, 3}));
}

TEST(Network, ASlantedSpringActsAlongItsLine) {
  NetworkParameters network;
  network.particle = {particle_at(1, 1, 1), particle_at(2, 3, 3)};
  network.spring = {spring_between(0, 1, 9.0)};
  const NetworkSystem system = build_network(network);
  Eigen::Matrix3d expected;  // k n n^T with n = (1, 2, 2) / 3
  expected << 1, 2, 2, 2, 4, 4, 2, 4, 4;
  const Eigen::MatrixXd K = testing::dense(system.K);
  EXPECT_LT((K.topLeftCorner<3, 3>() - expected).norm(), 1e-14);
  EXPECT_LT((K.topRightCorner<3, 3>() + expected).norm(), 1e-14);
  EXPECT_TRUE(testing::is_symmetric_to_the_bit(K));
  EXPECT_DOUBLE_EQ(system.springs[0].rest_length, 3.0);
  EXPECT_EQ(system.springs[0].yield_force, std::numeric_limits<double>::infinity());
  EXPECT_EQ(system.rest_force_N, std::vector<double>(6, 0.0));
}

TEST(Network, ASpringShorterThanItsPlacePullsItsEndsTogether) {
  NetworkParameters network;
  network.particle = {particle_at(0), particle_at(0, 0, 0.5)};
  network.spring = {spring_between(0, 1, 100.0)};
  network.spring[0].rest_length_m = 0.4;
  network.spring[0].yield_force_N = 3.0;
  network.spring[0].hardening_ratio = 0.2;
  const NetworkSystem system = build_network(network);
  const std::vector<double> expected{0, 0, 10, 0, 0, -10};
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(system.rest_force_N[i], expected[i], 1e-13);
  EXPECT_EQ(system.springs[0].rest_length, 0.4);
  EXPECT_EQ(system.springs[0].yield_force, 3.0);
  EXPECT_EQ(system.springs[0].hardening_ratio, 0.2);
  EXPECT_EQ(system.springs[0].direction, (std::array<double, 3>{0, 0, 1}));
}

TEST(Network, ParallelSpringsAdd) {
  NetworkParameters network;
  network.particle = {particle_at(0), particle_at(1)};
  network.spring = {spring_between(0, 1, 3.0), spring_between(1, 0, 4.0)};
  EXPECT_EQ(testing::dense(build_network(network).K)(0, 0), 7.0);
}

TEST(Network, RefusesSpringsWithoutLengthOrEnds) {
  NetworkParameters network;
  network.particle = {particle_at(0), particle_at(0)};
  network.spring = {spring_between(0, 1, 1.0)};
  EXPECT_THROW(build_network(network), std::invalid_argument);
  network.spring = {spring_between(0, 0, 1.0)};
  EXPECT_THROW(build_network(network), std::invalid_argument);
  network.spring = {spring_between(0, 2, 1.0)};
  EXPECT_THROW(build_network(network), std::invalid_argument);
}

double load_x(const NetworkLoad& load, double time, JumpSide side = JumpSide::right) {
  NetworkParameters network = bathe();
  network.load = {load};
  return network_load_N(network, time, side)[3 * static_cast<std::size_t>(load.particle)];
}

TEST(NetworkLoad, IsLinearBetweenPointsAndConstantOutside) {
  const NetworkLoad load{1, {1.0, 3.0, 4.0}, {{10, 0, 0}, {20, 0, 0}, {0, 0, 0}}};
  EXPECT_EQ(load_x(load, -5.0), 10.0);
  EXPECT_EQ(load_x(load, 1.0), 10.0);
  EXPECT_DOUBLE_EQ(load_x(load, 1.5), 12.5);
  EXPECT_EQ(load_x(load, 3.0), 20.0);
  EXPECT_EQ(load_x(load, 3.0, JumpSide::left), 20.0);
  EXPECT_DOUBLE_EQ(load_x(load, 3.75), 5.0);
  EXPECT_EQ(load_x(load, 4.0), 0.0);
  EXPECT_EQ(load_x(load, 9.0), 0.0);
}

TEST(NetworkLoad, JumpsWhereATimeIsRepeated) {
  const NetworkLoad load{2, {0.0, 1.0, 1.0, 2.0}, {{0, 0, 0}, {5, 0, 0}, {-7, 0, 0}, {-7, 0, 0}}};
  EXPECT_EQ(load_x(load, 1.0), -7.0);
  EXPECT_EQ(load_x(load, 1.0, JumpSide::left), 5.0);
  EXPECT_NEAR(load_x(load, std::nextafter(1.0, 0.0)), 5.0, 1e-14);
  EXPECT_EQ(load_x(load, std::nextafter(1.0, 2.0)), -7.0);
}

TEST(NetworkLoad, JumpsAtItsFirstAndLastPoint) {
  const NetworkLoad load{1, {0.0, 0.0, 1.0, 1.0}, {{1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}}};
  EXPECT_EQ(load_x(load, 0.0, JumpSide::left), 1.0);
  EXPECT_EQ(load_x(load, 0.0), 2.0);
  EXPECT_EQ(load_x(load, 1.0, JumpSide::left), 3.0);
  EXPECT_EQ(load_x(load, 1.0), 4.0);
  EXPECT_EQ(load_x(load, -1.0), 1.0);
}

TEST(NetworkLoad, OfAThriceRepeatedTimeTheMiddleValueNeverActs) {
  const NetworkLoad load{1, {0.0, 1.0, 1.0, 1.0, 2.0}, {{1, 0, 0}, {1, 0, 0}, {99, 0, 0}, {2, 0, 0}, {2, 0, 0}}};
  EXPECT_EQ(load_x(load, 1.0, JumpSide::left), 1.0);
  EXPECT_EQ(load_x(load, 1.0), 2.0);
}

TEST(NetworkLoad, LoadsOnOneParticleAdd) {
  NetworkParameters network = bathe();
  network.load = {{1, {0.0}, {{1, 2, 3}}}, {1, {0.0}, {{10, 20, 30}}}, {2, {0.0}, {{0, 0, 7}}}};
  EXPECT_EQ(network_load_N(network, 4.0), (std::vector<double>{0, 0, 0, 11, 22, 33, 0, 0, 7, 0, 0, 0}));
}

TEST(NetworkLoad, RefusesLoadsThatActOnNothing) {
  NetworkParameters network = bathe();
  network.load = {{4, {0.0}, {{1, 0, 0}}}};
  EXPECT_THROW(network_load_N(network, 0.0), std::invalid_argument);
  network.load = {{1, {}, {}}};
  EXPECT_THROW(network_load_N(network, 0.0), std::invalid_argument);
}

}  // namespace
}  // namespace unbruised

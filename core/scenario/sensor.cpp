#include "core/scenario/sensor.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/scenario/vectors.hpp"

namespace unbruised {
namespace {

/// Of a pivot against the largest diagonal entry, below which a matrix counts as singular.
constexpr double kLeastPivot = 1e-12;

/// Adds what a spring along `axis` at `place` holds against: k g g', g the axis and its moment about the origin.
void add_spring(const std::array<double, 3>& place, const std::array<double, 3>& axis, double k, SixBySix& sum) {
  const std::array<double, 3> moment = cross(place, axis);
  std::array<double, 6> g{};
  for (std::size_t i = 0; i < 3; ++i) {
    g[i] = axis[i];
    g[3 + i] = moment[i];
  }
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t j = 0; j < 6; ++j) sum[6 * i + j] += k * g[i] * g[j];
  }
}

/// Elements on a circle, from the x axis on. @param k radially, tangentially, along z
SixBySix ring(int count, double radius_m, const std::array<double, 3>& k) {
  SixBySix sum{};
  for (int element = 0; element < count; ++element) {
    const double angle = 2.0 * std::numbers::pi * element / count;
    const double c = std::cos(angle), s = std::sin(angle);
    const std::array<double, 3> place = {radius_m * c, radius_m * s, 0.0};
    add_spring(place, {c, s, 0.0}, k[0], sum);
    add_spring(place, {-s, c, 0.0}, k[1], sum);
    add_spring(place, {0.0, 0.0, 1.0}, k[2], sum);
  }
  // What cancels around the circle does so to rounding only.
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t j = 0; j < 6; ++j) {
      double& entry = sum[6 * i + j];
      if (i != j && entry * entry < 1e-24 * sum[7 * i] * sum[7 * j]) entry = 0.0;
    }
  }
  return sum;
}

}  // namespace

SixBySix sensor_stiffness(const SixAxisSensorParameters& sensor) {
  constexpr std::array<double, 3> kNone{};
  const double K = sensor.element_stiffness_N_m;
  switch (sensor.model) {
    case SensorModel::li_1998:
      return ring(4, sensor.element_radius_m, {0.0, K, K});
    case SensorModel::ring:
      return ring(sensor.element_count, sensor.element_radius_m, sensor.ring_stiffness_N_m.value_or(kNone));
    case SensorModel::matrix:
      return sensor.stiffness_matrix.value_or(SixBySix{});
    case SensorModel::datasheet:
      break;
  }
  SixBySix diagonal{};
  for (std::size_t i = 0; i < 3; ++i) {
    diagonal[7 * i] = sensor.stiffness_N_m.value_or(kNone)[i];
    diagonal[7 * (3 + i)] = sensor.stiffness_N_m_rad.value_or(kNone)[i];
  }
  return diagonal;
}

SixBySix carried_mass(const SixAxisSensorParameters& sensor) {
  SixBySix mass{};
  const std::array<double, 3>& c = sensor.center_of_mass_m;
  const double m = sensor.mass_kg;
  const double square = dot(c, c);
  for (std::size_t i = 0; i < 3; ++i) {
    mass[7 * i] = m;
    for (std::size_t j = 0; j < 3; ++j) {
      const double own = i == j ? sensor.inertia_kg_m2[i] + m * square : 0.0;
      mass[6 * (3 + i) + 3 + j] = own - m * c[i] * c[j];
    }
    // m (phi x c): the force along i by a rotation about j.
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    mass[6 * i + 3 + j] = mass[6 * (3 + j) + i] = m * c[k];
    mass[6 * i + 3 + k] = mass[6 * (3 + k) + i] = -m * c[j];
  }
  return mass;
}

bool is_positive_definite(const SixBySix& matrix) {
  // Scaled to a diagonal of ones: N/m and N m/rad are of different sizes.
  std::array<double, 6> scale{};
  for (std::size_t i = 0; i < 6; ++i) {
    if (!(matrix[7 * i] > 0.0)) return false;
    scale[i] = 1.0 / std::sqrt(matrix[7 * i]);
  }
  SixBySix L{};
  for (std::size_t j = 0; j < 6; ++j) {
    for (std::size_t i = j; i < 6; ++i) {
      double sum = matrix[6 * i + j] * scale[i] * scale[j];
      for (std::size_t k = 0; k < j; ++k) sum -= L[6 * i + k] * L[6 * j + k];
      if (i == j && !(sum > kLeastPivot)) return false;
      L[6 * i + j] = i == j ? std::sqrt(sum) : sum / L[7 * j];
    }
  }
  return true;
}

}  // namespace unbruised

#pragma once

/// @file
/// A six-axis force/torque sensor: the spring between what it is fixed to and what it carries, and how its
/// deformation is read (docs/instruments.md). Plain data in SI. A wrench is Fx, Fy, Fz, Mx, My, Mz, a twist the
/// displacements along x, y, z and the rotations about them, in the axes of the palm (wrist) or the cell
/// (support).

#include <array>
#include <optional>

namespace unbruised {

/// What a sensor carries.
enum class SensorMount {
  none,     ///< there is no sensor
  wrist,    ///< the gripper, at the end of the arm
  support,  ///< the plate on which the product stands or falls
};

/// How its stiffness is given.
enum class SensorModel {
  li_1998,    ///< a cross of four elements (Li, Wang & Ho 1998, Fig. 2): 2K, 2K, 4K, 2Ka2, 2Ka2, 4Ka2
  ring,       ///< equal elements on a circle, each with three stiffnesses
  datasheet,  ///< six stiffnesses without coupling
  matrix,     ///< a full 6x6 matrix
};

/// What is taken from a raw reading.
enum class SensorTare {
  none,
  own_weight,  ///< the weight of what it carries itself, as it hangs or lies at the start
  start,       ///< what it reads at the start, a product on its plate included
};

struct SixAxisSensorParameters {
  SensorMount at = SensorMount::none;
  SensorModel model = SensorModel::li_1998;
  /// > 0; K of each element of the cross
  double element_stiffness_N_m = 1e6;
  /// > 0; of the circle on which the elements stand, a
  double element_radius_m = 0.03;
  /// >= 3; of a ring
  int element_count = 4;
  /// >= 0; of each element of a ring: radially, tangentially and along z
  std::optional<std::array<double, 3>> ring_stiffness_N_m;
  /// > 0; of a datasheet, along x, y, z
  std::optional<std::array<double, 3>> stiffness_N_m;
  /// > 0; of a datasheet, about x, y, z
  std::optional<std::array<double, 3>> stiffness_N_m_rad;
  /// Symmetric and positive definite; rows of forces, then of torques, per displacement, then per rotation
  std::optional<std::array<double, 36>> stiffness_matrix;
  /// >= 0, < 1; of each of its six modes
  double damping_ratio = 0.02;
  /// > 0; of all that it carries itself, fingers included
  double mass_kg = 0.5;
  /// Of that mass, from the sensor's origin.
  std::array<double, 3> center_of_mass_m{0.0, 0.0, 0.0};
  /// > 0; of that mass about its centre
  std::array<double, 3> inertia_kg_m2{1e-3, 1e-3, 1e-3};
  /// The sensor's origin: from the centre of the pads (wrist), from where the support's plane lies under the
  /// product's middle at the start (support). Required where there is a sensor.
  std::optional<std::array<double, 3>> position_m;
  /// Point about which torques are read, from the sensor's origin.
  std::array<double, 3> report_at_m{0.0, 0.0, 0.0};
  SensorTare tare = SensorTare::own_weight;
  /// > 0; of a first-order low pass. None: no filter.
  std::optional<double> bandwidth_Hz;
  /// > 0, <= 1 / time_step_s; a reading is held until the next. None: it is read at all times.
  std::optional<double> rate_Hz;
  /// >= 0; readings are multiples of it; 0: any reading
  double resolution_N = 0.0;
  double resolution_N_m = 0.0;
  /// > 0; beyond it a component reads its end. None: it has no end.
  std::optional<double> range_N;
  std::optional<double> range_N_m;
  /// >= 0; standard deviation of a normal error of each sample, with `noise_seed`
  double noise_N = 0.0;
  double noise_N_m = 0.0;
  /// >= 0; of the noise
  int noise_seed = 1;
  /// Reads between steps from the motion that is predicted within them; else at the ends of steps, from the forces
  /// that the contact register holds there.
  bool motion_prediction = true;
};

/// 6x6, row-major.
using SixBySix = std::array<double, 36>;

/// Stiffness of the sensor's spring about its origin [N/m, N/rad, N m/m, N m/rad].
/// Source of li_1998: Li, Wang & Ho 1998, Eqs 3-1 to 3-6.
SixBySix sensor_stiffness(const SixAxisSensorParameters& sensor);
/// Mass matrix about its origin of what the sensor carries.
SixBySix carried_mass(const SixAxisSensorParameters& sensor);
/// Is a symmetric matrix positive definite?
bool is_positive_definite(const SixBySix& matrix);

}  // namespace unbruised

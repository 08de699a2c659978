#pragma once

/// @file
/// The parameters of products. Plain data in SI; the inequality a value takes part in stands above it.

#include <array>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

namespace unbruised {

class ProductMesh;

enum class Shape { box, sphere, ellipsoid, cylinder, revolution, superellipsoid, mesh };
/// Of superellipsoids: below, edges are sharp; above, sides are as good as flat.
inline constexpr double kLeastExponent = 2.0, kLargestExponent = 4.0;
enum class Axis { x = 0, y = 1, z = 2 };
/// Which of its moduli the stiffness of a relaxing material is written with.
enum class PronyFrom { instantaneous, long_term };

/// What lies deeper in a lattice product: flesh under a rind, a core, a stone. By depth or by place.
struct ProductLayer {
  /// > 0, more than those of the layers before; below the true surface. It reaches to the next one, or to the
  /// middle.
  std::optional<double> from_depth_m;
  /// > 0; in place of a depth, extents of an ellipsoid along the product's axes, within its bounding box
  std::optional<std::array<double, 3>> size_m;
  /// Of that ellipsoid, from the middle of the bounding box; none: there
  std::optional<std::array<double, 3>> center_m;
  /// > 0; what youngs_modulus_Pa of the product is of it, instantaneous or long-term, this is
  double youngs_modulus_Pa = 1e6;
  /// 0 <= poisson_ratio < 0.5; none: that of the product
  std::optional<double> poisson_ratio;
  /// > 0; none: it stays elastic
  std::optional<double> yield_stress_Pa;
  /// 0 < tangent_modulus_Pa < youngs_modulus_Pa; required with yield_stress_Pa
  std::optional<double> tangent_modulus_Pa;
};

/// A solid product as a lattice of particles, springs and dampers (docs/theory.md, "Lattice").
/// It stands centred on x = y = 0 with the lowest point of its true shape on z = 0.
struct LatticeParameters {
  Shape shape = Shape::box;
  /// > 0 each; full extents. A sphere has three equal ones, a solid of revolution two across its axis.
  std::array<double, 3> size_m{0.05, 0.05, 0.05};
  /// Axis of a cylinder or a solid of revolution.
  Axis axis = Axis::z;
  /// Of a solid of revolution: 4 to 1000 points from its low end to its high one, as many radii as heights; the
  /// curve through them is stretched to size_m. Radii begin and end at 0, heights rise; a flat end has its middle
  /// and its rim at one height.
  std::vector<double> profile_height;
  /// >= 0
  std::vector<double> profile_radius;
  /// >= 2, <= 4; of a superellipsoid: across z, and between z and the outline across it. 2: an ellipse.
  std::array<double, 2> exponents{2.0, 2.0};
  /// The surface of shape = mesh, stretched to size_m; shared by all scenarios that have it.
  std::shared_ptr<const ProductMesh> mesh;
  /// > 0, <= half the smallest extent. Extents are divided into round(size / cell_size) cells, at least two, whose
  /// sides may differ by 22 %.
  double cell_size_m = 0.005;
  /// > 0. Exactly one of mass_kg and density_kg_m3 is given.
  std::optional<double> mass_kg;
  /// > 0; times the volume of the true shape.
  std::optional<double> density_kg_m3;
  /// > 0
  double youngs_modulus_Pa = 1e6;
  /// 0 <= poisson_ratio < 0.5
  double poisson_ratio = 0.25;
  /// > 0; none: the product stays elastic.
  std::optional<double> yield_stress_Pa;
  /// 0 < tangent_modulus_Pa < youngs_modulus_Pa; required with yield_stress_Pa.
  std::optional<double> tangent_modulus_Pa;
  /// >= 0. Damping is stiffness-proportional, C = relaxation_time K. Either relaxation_time_s, or
  /// loss_ratio with at_frequency_Hz: relaxation_time = loss_ratio / (2 pi frequency).
  std::optional<double> relaxation_time_s;
  std::optional<double> loss_ratio;
  std::optional<double> at_frequency_Hz;
  /// > 0 each, sum <= 1, up to six; shares of the instantaneous modulus that fade with prony_time_s.
  std::vector<double> prony_modulus;
  /// > 0 each, as many as prony_modulus.
  std::vector<double> prony_time_s;
  /// Which modulus youngs_modulus_Pa is; long_term needs a sum of prony_modulus < 1.
  PronyFrom prony_from = PronyFrom::instantaneous;
  /// > 0. A Burgers model in place of prony_modulus, all three or none: c1 / k1, k2 / k1 and c2 / k2 of a spring
  /// k1 in series with a dashpot c1 and with a spring k2 beside a dashpot c2.
  std::optional<double> burgers_flow_time_s;
  std::optional<double> burgers_recovery_modulus;
  std::optional<double> burgers_recovery_time_s;
  /// > 0, < cell_size_m; of a skin that gives way only with the surface, as a membrane. None: there is no skin.
  std::optional<double> skin_thickness_m;
  /// > 0; required with skin_thickness_m
  std::optional<double> skin_modulus_Pa;
  /// 0 <= skin_poisson_ratio < 0.5; none: poisson_ratio
  std::optional<double> skin_poisson_ratio;
  /// >= 0; Coulomb coefficient against the pads.
  double friction = 0.5;
  std::array<double, 3> initial_velocity_m_s{0.0, 0.0, 0.0};
  /// Angular velocity at the start, deformed as it is by that; all zero with a gripper.
  std::array<double, 3> initial_spin_rad_s{0.0, 0.0, 0.0};
  /// Attitude at the start, about this vector by its length, up to half a turn; all zero with a gripper.
  std::array<double, 3> initial_rotation_rad{0.0, 0.0, 0.0};
  /// >= 0; of its lowest place above the support's plane at the start; 0 with a gripper.
  double initial_height_m = 0.0;
  /// At most 8; a cell is of the last that holds its middle, of none: what the product's own keys say. All moduli
  /// fade alike.
  std::vector<ProductLayer> layer;
};

struct NetworkParticle {
  std::array<double, 3> position_m{0.0, 0.0, 0.0};
  /// > 0 unless all three freedoms are fixed
  double mass_kg = 0.0;
  std::array<bool, 3> fixed{false, false, false};
  std::array<double, 3> initial_displacement_m{0.0, 0.0, 0.0};
  std::array<double, 3> initial_velocity_m_s{0.0, 0.0, 0.0};
  /// >= 0; > 0: the particle touches the support plane through a layer of this stiffness.
  double contact_stiffness_N_m = 0.0;
};

struct NetworkSpring {
  std::array<int, 2> between{0, 0};
  /// >= 0
  double stiffness_N_m = 0.0;
  /// >= 0
  double damping_N_s_m = 0.0;
  /// > 0; default: the distance of the particles, so that the spring starts without force.
  std::optional<double> rest_length_m;
  /// > 0, needs stiffness_N_m > 0; |force| at first yield. None: the spring stays elastic.
  std::optional<double> yield_force_N;
  /// >= 0; yield force grows by hardening_ratio x stiffness x plastic elongation.
  double hardening_ratio = 0.0;
  /// As of a lattice, of its stiffness.
  std::vector<double> prony_modulus;
  std::vector<double> prony_time_s;
  PronyFrom prony_from = PronyFrom::instantaneous;
  /// > 0, all three or none: c1, k2 and c2 of a Burgers model whose k1 is stiffness_N_m.
  std::optional<double> burgers_flow_N_s_m;
  std::optional<double> burgers_recovery_N_m;
  std::optional<double> burgers_recovery_N_s_m;
};

struct NetworkLoad {
  int particle = 0;
  /// not decreasing, as long as force_N; linear between points, constant outside; a repeated time is a jump.
  std::vector<double> time_s;
  std::vector<std::array<double, 3>> force_N;
};

/// Particles, springs, dampers, masses and loads written out one by one.
struct NetworkParameters {
  std::vector<NetworkParticle> particle;
  std::vector<NetworkSpring> spring;
  std::vector<NetworkLoad> load;
  /// >= 0; Coulomb coefficient against pads (unused while only the support is touched).
  double friction = 0.5;
};

using ProductParameters = std::variant<LatticeParameters, NetworkParameters>;

}  // namespace unbruised

#include "core/contact/layered_face.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

#include "core/scenario/finger_axes.hpp"
#include "core/scenario/lattice_cells.hpp"
#include "core/scenario/relaxation.hpp"
#include "core/scenario/true_shape.hpp"

namespace unbruised {
namespace {

double series(double a, double b) { return a > 0.0 && b > 0.0 ? a * b / (a + b) : 0.0; }

/// Length of the overlap of a pad and a face, whose middles lie this far apart.
double covered_m(double offset_m, double pad_m, double face_m) {
  const double high = std::min(offset_m + 0.5 * pad_m, 0.5 * face_m);
  const double low = std::max(offset_m - 0.5 * pad_m, -0.5 * face_m);
  return std::max(0.0, high - low);
}

/// The side -z, on which a product stands.
constexpr std::size_t kUnderside = 4;

/// Of a side, about as it curves: half its extents, but of the pole where a solid has one that curves.
double mean_radius_m(const LatticeParameters& product, std::size_t side) {
  const auto [first, second] = face_tangents(side / 2);
  const TrueShape shape(product);
  if (shape.solid() != nullptr && shape.curvatures(side) == 2) {
    return std::sqrt(shape.pole_radius_m(side, first) * shape.pole_radius_m(side, second));
  }
  return 0.25 * (product.size_m[first] + product.size_m[second]);
}

/// Springs ask for no patch.
FaceLayer face_layer(const LayerParameters& layer, const LatticeParameters& product, std::size_t side,
                     const std::array<double, 2>& covered) {
  if (layer.is_springs()) return {layer, {}, covered};
  return {layer, patch_area(product, side, face_tangents(side / 2)), covered};
}

/// Across which axis the face of the product lies that the pads meet; of listed fingers the first one.
std::size_t axis_at_pad(const ParallelJawParameters& gripper) {
  return gripper.finger.empty() ? 0 : faced_axis(finger_axes(gripper.finger.front())[2]);
}

std::array<double, 2> under_pad_m(const LatticeParameters& product, const ParallelJawParameters& gripper,
                                  const CellParameters& cell) {
  const std::array<double, 3> middle_m = {0.0, cell.grip_offset_m, cell.grip_height_m};
  const auto [first, second] = face_tangents(axis_at_pad(gripper));
  return {covered_m(middle_m[first], gripper.pad_size_m[0], product.size_m[first]),
          covered_m(middle_m[second], gripper.pad_size_m[1], product.size_m[second])};
}

FaceLayer pad_under(const LatticeParameters& product, const ParallelJawParameters& jaw,
                    const CellParameters& cell) {
  if (is_shaped(jaw.pad)) {
    return {pad_layer(jaw), pad_patch_area(product, PadFace(jaw)), under_pad_m(product, jaw, cell)};
  }
  return face_layer(pad_layer(jaw), product, 2 * axis_at_pad(jaw), under_pad_m(product, jaw, cell));
}
FaceLayer support_under(const LatticeParameters& product, const CellParameters& cell) {
  return face_layer(support_layer(cell), product, kUnderside, TrueShape(product).face_extents_m(kUnderside));
}

}  // namespace

double LayeredFace::plane_strain_modulus_Pa() const {
  return youngs_modulus_Pa / (1.0 - poisson_ratio * poisson_ratio);
}

double LayeredFace::hertz_depth_m(double force_N) const {
  return std::pow(0.75 * force_N / (plane_strain_modulus_Pa() * std::sqrt(radius_m)), 2.0 / 3.0);
}

double LayeredFace::patch_m2(double force_N) const {
  if (is_flat) return flat_area_m2;
  return std::min(std::numbers::pi * radius_m * hertz_depth_m(force_N), largest_patch_m2);
}

double LayeredFace::stiffness_N_m(double force_N) const {
  const double of_layer = layer_N_m(force_N);
  if (is_flat) return series(of_layer, youngs_modulus_Pa * flat_area_m2 / half_depth_m);
  return series(of_layer, 2.0 * plane_strain_modulus_Pa() * std::sqrt(radius_m * hertz_depth_m(force_N)));
}

LayeredFace side_at_pad(const LatticeParameters& product, const ParallelJawParameters& gripper,
                        const CellParameters& cell) {
  const std::array<double, 2> covered = under_pad_m(product, gripper, cell);
  const std::size_t axis = axis_at_pad(gripper);
  double radius_m = mean_radius_m(product, 2 * axis);
  bool is_flat = TrueShape(product).curvatures(2 * axis) == 0;
  if (is_shaped(gripper.pad)) {
    const std::array<double, 2> curvature = relative_curvature_1_m(product, PadFace(gripper));
    is_flat = curvature[0] + curvature[1] == 0.0;
    if (!is_flat) radius_m = 2.0 / (curvature[0] + curvature[1]);
  }
  return {.youngs_modulus_Pa = instantaneous_modulus_Pa(product),
          .poisson_ratio = product.poisson_ratio,
          .half_depth_m = 0.5 * product.size_m[axis],
          .is_flat = is_flat,
          .flat_area_m2 = covered[0] * covered[1],
          .radius_m = radius_m,
          .largest_patch_m2 = gripper.pad_size_m[0] * gripper.pad_size_m[1],
          .layer = pad_under(product, gripper, cell)};
}

LayeredFace side_at_support(const LatticeParameters& product, const CellParameters& cell) {
  const std::array<double, 2> base_m = TrueShape(product).face_extents_m(kUnderside);
  const double base_m2 = base_m[0] * base_m[1];
  return {.youngs_modulus_Pa = instantaneous_modulus_Pa(product),
          .poisson_ratio = product.poisson_ratio,
          .half_depth_m = 0.5 * product.size_m[2],
          .is_flat = TrueShape(product).curvatures(kUnderside) == 0,
          .flat_area_m2 = base_m2,
          .radius_m = mean_radius_m(product, kUnderside),
          .largest_patch_m2 = base_m2,
          .layer = support_under(product, cell)};
}

namespace {

/// Its particles have layers of their own.
FaceLayer pad_under(const NetworkParameters&, const ParallelJawParameters& jaw, const CellParameters&) {
  return {pad_layer(jaw), {}, {}};
}

FaceLayer support_under(const NetworkParameters&, const CellParameters& cell) {
  return {support_layer(cell), {}, {}};
}

double weight_N(const LatticeParameters& product, const CellParameters& cell) {
  return lattice_mass_kg(product) * std::abs(cell.gravity_m_s2[2]);
}
double weight_N(const NetworkParameters&, const CellParameters&) { return 0.0; }

}  // namespace

FaceLayer layer_at_pad(const Scenario& scenario) {
  const auto* jaw = parallel_jaw(scenario);
  if (jaw == nullptr) return {};
  return std::visit([&](const auto& kind) { return pad_under(kind, *jaw, scenario.cell); }, scenario.product);
}

FaceLayer layer_at_support(const Scenario& scenario) {
  return std::visit([&](const auto& kind) { return support_under(kind, scenario.cell); }, scenario.product);
}

double pad_layer_N_m3(const Scenario& scenario, const FaceLayer& layer) {
  // A measured layer is simulated with its whole law.
  return layer.layer.law ? layer.layer.springs_N_m3() : layer.stiffness_N_m3(scenario.strategy.grip_force_N);
}

double support_layer_N_m3(const Scenario& scenario, const FaceLayer& layer) {
  return layer.stiffness_N_m3(
      std::visit([&](const auto& kind) { return weight_N(kind, scenario.cell); }, scenario.product));
}

}  // namespace unbruised

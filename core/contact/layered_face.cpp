#include "core/contact/layered_face.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

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
  const double of_layer = layer_per_area_Pa_m * patch_m2(force_N);
  if (is_flat) return series(of_layer, youngs_modulus_Pa * flat_area_m2 / half_depth_m);
  return series(of_layer, 2.0 * plane_strain_modulus_Pa() * std::sqrt(radius_m * hertz_depth_m(force_N)));
}

LayeredFace side_at_pad(const LatticeParameters& product, const ParallelJawParameters& gripper,
                        const CellParameters& cell) {
  return {.youngs_modulus_Pa = product.youngs_modulus_Pa,
          .poisson_ratio = product.poisson_ratio,
          .half_depth_m = 0.5 * product.size_m[0],
          .is_flat = TrueShape(product).curvatures(0) == 0,
          .flat_area_m2 = covered_m(cell.grip_offset_m, gripper.pad_size_m[0], product.size_m[1]) *
                          covered_m(cell.grip_height_m, gripper.pad_size_m[1], product.size_m[2]),
          .radius_m = 0.25 * (product.size_m[1] + product.size_m[2]),
          .largest_patch_m2 = gripper.pad_size_m[0] * gripper.pad_size_m[1],
          .layer_per_area_Pa_m = gripper.pad_modulus_Pa / gripper.pad_thickness_m};
}

LayeredFace side_at_support(const LatticeParameters& product, const CellParameters& cell) {
  const double base_m2 = product.size_m[0] * product.size_m[1];
  return {.youngs_modulus_Pa = product.youngs_modulus_Pa,
          .poisson_ratio = product.poisson_ratio,
          .half_depth_m = 0.5 * product.size_m[2],
          .is_flat = TrueShape(product).curvatures(2) == 0,
          .flat_area_m2 = base_m2,
          .radius_m = 0.25 * (product.size_m[0] + product.size_m[1]),
          .largest_patch_m2 = base_m2,
          .layer_per_area_Pa_m = cell.support_modulus_Pa / cell.support_thickness_m};
}

}  // namespace unbruised

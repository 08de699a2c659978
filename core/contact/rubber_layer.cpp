#include "core/contact/rubber_layer.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

namespace unbruised {
namespace {

/// Waves over the half width that the energies are summed over: 1e-3 is left beyond.
constexpr int kWaves = 1200;
constexpr double kWaveStep = 0.05;
/// Of slenderness: from here on, 3 steps to each doubling.
constexpr double kLeastSlenderness = 0.25, kStepsPerDoubling = 3.0;
/// Beyond it a layer is a half-space to 1e-30.
constexpr double kDeep = 35.0;

double confined_over_free(double nu) { return nu < 0.5 ? (1.0 - nu) / ((1.0 + nu) * (1.0 - 2.0 * nu)) : 1e9; }

/// Squares of the spectra of Hertz's pressure, at the middles of the wave steps: of a circle (sin x - x cos x) /
/// x^3, of a strip J1(x) / x.
std::array<double, kWaves> squared_spectrum(PatchKind kind) {
  std::array<double, kWaves> squares{};
  for (int i = 0; i < kWaves; ++i) {
    const double x = (i + 0.5) * kWaveStep;
    const double wave =
        kind == PatchKind::strip ? std::cyl_bessel_j(1.0, x) / x : (std::sin(x) - x * std::cos(x)) / (x * x * x);
    squares[static_cast<std::size_t>(i)] = wave * wave;
  }
  return squares;
}

/// Stiffness over E / t by the energy that a patch of this slenderness stores: of pressures p, int p^2 / int p u.
double energy_factor(PatchKind kind, double slenderness, double nu, PadBulge bulge) {
  static const std::array<double, kWaves> strip = squared_spectrum(PatchKind::strip);
  static const std::array<double, kWaves> circle = squared_spectrum(PatchKind::ellipse);
  const bool is_strip = kind == PatchKind::strip;
  const auto& square = is_strip ? strip : circle;
  double pressure = 0.0, work = 0.0;
  for (int i = 0; i < kWaves; ++i) {
    const double x = (i + 0.5) * kWaveStep, weight = square[static_cast<std::size_t>(i)] * (is_strip ? 1.0 : x);
    pressure += weight;
    work += weight * 2.0 * (1.0 - nu * nu) * layer_response(x / slenderness, nu, bulge) / x;
  }
  return pressure / (work * slenderness);
}

}  // namespace

double layer_response(double x, double poisson_ratio, PadBulge bulge) {
  const double kappa = 3.0 - 4.0 * poisson_ratio;
  const double at = std::min(x, kDeep), s = std::sinh(at), c = std::cosh(at);
  if (bulge == PadBulge::free) {
    const double twice = 2.0 * at;
    return (2.0 * kappa * std::sinh(twice) - 2.0 * twice) /
           (2.0 * kappa * std::cosh(twice) + twice * twice + 1.0 + kappa * kappa);
  }
  // The face keeps its place along itself. Of the two solutions of even and odd order that vanish at the back, p
  // is to q as the held face needs.
  const double p = -at * s / (kappa * s + at * c);
  const double way = kappa * s - at * (p * s + c);
  const double stress = (kappa + 1.0) * c - (kappa - 1.0) * p * s - 2.0 * at * (p * c + s);
  return 4.0 / (kappa + 1.0) * way / stress;
}

RubberFactor::RubberFactor(PatchKind kind, double poisson_ratio, PadBulge bulge) : springs_(false) {
  std::array<double, kSteps> energy{};
  for (std::size_t i = 0; i < kSteps; ++i) {
    const double slenderness = kLeastSlenderness * std::exp2(static_cast<double>(i) / kStepsPerDoubling);
    energy[i] = std::log(energy_factor(kind, slenderness, poisson_ratio, bulge));
  }
  // Of a force F the springs' energy goes with 1 / (a^2 k) for a circle and 1 / (b k) for a strip.
  const double share = kind == PatchKind::strip ? 1.0 : 0.5;
  for (std::size_t i = 0; i < kSteps; ++i) {
    const std::size_t low = i == 0 ? 0 : i - 1, high = std::min(i + 1, kSteps - 1);
    const double growth =
        (energy[high] - energy[low]) * kStepsPerDoubling / (static_cast<double>(high - low) * std::numbers::ln2);
    log_[i] = energy[i] - std::log1p(share * growth);
  }
}

double RubberFactor::at(double slenderness) const {
  if (springs_) return 1.0;
  const double place = kStepsPerDoubling * std::log2(std::max(slenderness, kLeastSlenderness) / kLeastSlenderness);
  const double clamped = std::min(place, static_cast<double>(kSteps - 1));
  const auto low = std::min(static_cast<std::size_t>(clamped), kSteps - 2);
  return std::exp(log_[low] + (clamped - static_cast<double>(low)) * (log_[low + 1] - log_[low]));
}

double whole_pad_factor(const std::array<double, 2>& side_m, double thickness_m, double poisson_ratio,
                        PadBulge bulge) {
  // Pressed area over what is free to bulge. A face along which the rubber slides is the middle of a pad twice as
  // thick that is bonded on both sides.
  const double bonded_m = bulge == PadBulge::held ? thickness_m : 2.0 * thickness_m;
  const double shape = side_m[0] * side_m[1] / (2.0 * (side_m[0] + side_m[1]) * bonded_m);
  const double confined = 1.0 / confined_over_free(poisson_ratio);
  return 1.0 / (confined + (1.0 - confined) / (1.0 + 2.0 * shape * shape));
}

LayerParameters pad_layer(const ParallelJawParameters& gripper) {
  return {gripper.pad_modulus_Pa,    gripper.pad_thickness_m, gripper.pad_poisson_ratio,
          gripper.pad_bulge,         pad_law(gripper.pad),    gripper.pad_size_m[0] * gripper.pad_size_m[1],
          reference_depth_m(gripper)};
}

LayerParameters support_layer(const CellParameters& cell) {
  return {cell.support_modulus_Pa, cell.support_thickness_m, cell.support_poisson_ratio, PadBulge::free};
}

namespace {

/// The thread's last table again where it serves: scenarios of a study seldom differ in it, and it costs as much
/// as many steps.
const RubberFactor& rubber_factor(PatchKind kind, double poisson_ratio, PadBulge bulge) {
  using Key = std::tuple<PatchKind, double, PadBulge>;
  thread_local Key last_key;
  thread_local RubberFactor last;
  const Key key{kind, poisson_ratio, bulge};
  if (last.is_springs() || key != last_key) {
    last = RubberFactor(kind, poisson_ratio, bulge);
    last_key = key;
  }
  return last;
}

}  // namespace

FaceLayer::FaceLayer(const LayerParameters& parameters, const PatchArea& patch,
                     const std::array<double, 2>& covered)
    : layer(parameters), area(patch), covered_m(covered) {
  if (layer.is_springs() || layer.law || area.kind == PatchKind::flat) return;
  rubber = rubber_factor(area.kind, layer.poisson_ratio, layer.bulge);
}

double FaceLayer::patch_half_width_m(double force_N, double layer_N_m3) const {
  if (area.kind == PatchKind::strip) {
    return area.half_width_m(force_N / std::max(covered_m[area.straight], 1e-9), layer_N_m3);
  }
  return std::sqrt(area.ellipse_m2(force_N, layer_N_m3) / std::numbers::pi);
}

/// Of springs that are as deep as the law's layer under the mean pressure of their patch.
double FaceLayer::law_stiffness_N_m3(double force_N) const {
  double stiffness = layer.springs_N_m3();
  if (!(force_N > 0.0)) return stiffness;
  const double covered_m2 = covered_m[0] * covered_m[1];
  constexpr int kIterations = 8;
  for (int i = 0; i < kIterations; ++i) {
    double touched_m2 = covered_m2;
    if (area.kind == PatchKind::strip) {
      touched_m2 = std::min(touched_m2, 2.0 * patch_half_width_m(force_N, stiffness) * covered_m[area.straight]);
    } else if (area.kind == PatchKind::ellipse) {
      touched_m2 = std::min(touched_m2, area.ellipse_m2(force_N, stiffness));
    }
    const double pressure = force_N / touched_m2;
    stiffness = pressure / layer.law->depth_m(pressure * layer.law_area_m2);
  }
  return stiffness;
}

double FaceLayer::stiffness_N_m3(double force_N) const {
  const double springs = layer.springs_N_m3();
  if (layer.law && covered_m[0] > 0.0 && covered_m[1] > 0.0) return law_stiffness_N_m3(force_N);
  if (layer.is_springs() || !(covered_m[0] > 0.0) || !(covered_m[1] > 0.0)) return springs;
  if (area.kind == PatchKind::flat) {
    return springs * whole_pad_factor(covered_m, layer.thickness_m, layer.poisson_ratio, layer.bulge);
  }
  const double widest_m = 0.5 * std::min(covered_m[0], covered_m[1]);
  double stiffness = springs;
  constexpr int kIterations = 4;  // area and stiffness settle to 1e-3
  for (int i = 0; i < kIterations; ++i) {
    stiffness =
        springs * rubber.at(std::min(patch_half_width_m(force_N, stiffness), widest_m) / layer.thickness_m);
  }
  return stiffness;
}

}  // namespace unbruised

#include "core/scenario/pad_face.hpp"

#include <algorithm>
#include <cmath>

namespace unbruised {
namespace {

/// Part of a profile's half width, to both sides of its middle, whose curvature is that of its patch.
constexpr double kCurvedPart = 0.5;
/// Places at which a parabola is fitted, and a height looked for.
constexpr int kFitPlaces = 64;

}  // namespace

PadFace::PadFace(const ParallelJawParameters& jaw)
    : shape_(jaw.pad.shape),
      across_(jaw.pad.along == PadAlong::z ? 0 : 1),
      radius_m_(jaw.pad.radius_m.value_or(1.0)),
      half_m_{0.5 * jaw.pad_size_m[0], 0.5 * jaw.pad_size_m[1]} {
  if (shape_ == PadShape::v_groove) cotangent_ = 1.0 / std::tan(jaw.pad.half_angle_rad.value_or(1.0));
  if (shape_ != PadShape::profile) return;
  place_m_ = jaw.pad.profile_place_m;
  profile_m_ = jaw.pad.profile_height_m;
}

/// Of a circle or sphere, from its pole.
double PadFace::round_m(double square_m2) const {
  const double radius2 = radius_m_ * radius_m_;
  // |R| - sqrt(R^2 - s^2) in the form that keeps its digits.
  const double root = std::sqrt(std::max(0.0, radius2 - square_m2));
  return std::copysign(std::min(square_m2, radius2) / (std::abs(radius_m_) + root), -radius_m_);
}

double PadFace::profile_m(double across_m) const {
  if (place_m_.empty()) return 0.0;
  const auto above = std::upper_bound(place_m_.begin(), place_m_.end(), across_m);
  if (above == place_m_.begin()) return profile_m_.front();
  if (above == place_m_.end()) return profile_m_.back();
  const auto i = static_cast<std::size_t>(above - place_m_.begin());
  const double share = (across_m - place_m_[i - 1]) / (place_m_[i] - place_m_[i - 1]);
  return profile_m_[i - 1] + share * (profile_m_[i] - profile_m_[i - 1]);
}

double PadFace::height_m(const std::array<double, 2>& place_m) const {
  std::array<double, 2> on{};
  for (std::size_t t = 0; t < 2; ++t) on[t] = std::clamp(place_m[t], -half_m_[t], half_m_[t]);
  const double s = on[across_];
  switch (shape_) {
    case PadShape::flat:
      break;
    case PadShape::cylinder:
      return round_m(s * s);
    case PadShape::sphere:
      return round_m(on[0] * on[0] + on[1] * on[1]);
    case PadShape::v_groove:
      return std::abs(s) * cotangent_;
    case PadShape::profile:
      return profile_m(s);
  }
  return 0.0;
}

double PadFace::slope(const std::array<double, 2>& place_m, std::size_t t, double length_m) const {
  std::array<double, 2> low = place_m, high = place_m;
  low[t] = std::clamp(place_m[t] - 0.5 * length_m, -half_m_[t], half_m_[t]);
  high[t] = std::clamp(place_m[t] + 0.5 * length_m, -half_m_[t], half_m_[t]);
  return high[t] > low[t] ? (height_m(high) - height_m(low)) / (high[t] - low[t]) : 0.0;
}

/// Least squares: h = c0 + c1 s - s^2 curvature / 2.
double PadFace::profile_curvature_1_m() const {
  const double reach_m = kCurvedPart * half_m_[across_];
  double square = 0.0, fourth = 0.0, height = 0.0, height_square = 0.0;
  for (int i = 0; i < kFitPlaces; ++i) {
    const double s = (2.0 * (i + 0.5) / kFitPlaces - 1.0) * reach_m, h = profile_m(s);
    square += s * s;
    fourth += s * s * s * s;
    height += h;
    height_square += h * s * s;
  }
  const double second = (height_square - height * square / kFitPlaces) / (fourth - square * square / kFitPlaces);
  return -2.0 * second;
}

std::array<double, 2> PadFace::curvature_1_m() const {
  std::array<double, 2> curvature{0.0, 0.0};
  if (shape_ == PadShape::cylinder) curvature[across_] = 1.0 / radius_m_;
  if (shape_ == PadShape::sphere) curvature.fill(1.0 / radius_m_);
  if (shape_ == PadShape::profile) curvature[across_] = profile_curvature_1_m();
  return curvature;
}

double PadFace::groove_cosine() const { return 1.0 / std::sqrt(1.0 + cotangent_ * cotangent_); }

std::array<double, 2> PadFace::range_m() const {
  if (shape_ != PadShape::profile) {
    const double corner = height_m(half_m_);
    return {std::min(0.0, corner), std::max(0.0, corner)};
  }
  // Linear between its places.
  std::array<double, 2> range{profile_m(-half_m_[across_]), profile_m(-half_m_[across_])};
  const auto look = [&range](double h) { range = {std::min(range[0], h), std::max(range[1], h)}; };
  look(profile_m(half_m_[across_]));
  for (std::size_t i = 0; i < place_m_.size(); ++i) {
    if (std::abs(place_m_[i]) < half_m_[across_]) look(profile_m_[i]);
  }
  return range;
}

}  // namespace unbruised

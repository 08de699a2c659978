#include "core/contact/shaped_pads.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace unbruised {
namespace {

/// Of a cell: within it a face is as straight as it was taken for.
constexpr double kMoved = 1e-3;
constexpr double kNever_m = 1e6;

}  // namespace

ShapedPads::ShapedPads(const ContactModel& model, const SurfaceLanes& surfaces, ContactRegister& contacts)
    : model_(model),
      surfaces_(surfaces),
      contacts_(contacts),
      turn_(9 * model.candidate.size()),
      offset_(model.candidate.size()) {
  for (LaneArray& rows : looked_) {
    rows = LaneArray(model.candidate.size());
    rows.fill(kNever_m);
  }
  for (std::size_t c = 0; c < model.candidate.size(); ++c) {
    for (std::size_t i = 0; i < 3; ++i) turn_.put(9 * c + 4 * i, Lane(1.0));
  }
}

void ShapedPads::load(int lane) {
  for (LaneArray& rows : looked_) {
    for (std::size_t c = 0; c < rows.rows(); ++c) rows.at(c, lane) = kNever_m;
  }
}

LaneMatrix ShapedPads::axes(std::size_t c) const {
  LaneMatrix T;
  for (std::size_t i = 0; i < 9; ++i) T.at[i] = turn_.get(9 * c + i);
  return T;
}

Mask ShapedPads::look(std::size_t c, const std::array<Lane, 2>& place_m, const Mask& may) {
  const auto& tributary = model_.candidate[c].tributary;
  const Lane least(kMoved * std::min(tributary[0].extent_m, tributary[1].extent_m));
  const Mask moved = (abs(place_m[0] - looked_[0].get(c)) > least) | (abs(place_m[1] - looked_[1].get(c)) > least);
  const Mask looks = may & moved;
  if (none(looks)) return looks;
  for (std::size_t t = 0; t < 2; ++t) looked_[t].put(c, select(looks, place_m[t], looked_[t].get(c)));
  for (int lane = 0; lane < kLanes; ++lane) {
    if (looks[lane]) look_in_lane(c, {place_m[0][lane], place_m[1][lane]}, lane);
  }
  return looks;
}

/// The face h over the pad's plane is taken for its mean slope g over the cell: its normal is (1, -g) / sqrt(1 +
/// g^2) in the closing direction and the pad's tangents.
void ShapedPads::look_in_lane(std::size_t c, const std::array<double, 2>& place_m, int lane) {
  const ContactCandidate& candidate = model_.candidate[c];
  const PadFace& face = surfaces_.face(lane);
  const double sign = normal_sign(candidate.surface);
  std::array<double, 2> on_pad{}, slope{};
  for (std::size_t t = 0; t < 2; ++t) {
    on_pad[t] = candidate.tributary[t].place_m + place_m[t] - surfaces_[candidate.surface].center_m[t][lane];
  }
  for (std::size_t t = 0; t < 2; ++t) slope[t] = face.slope(on_pad, t, candidate.tributary[t].extent_m);
  const double cosine = 1.0 / std::sqrt(1.0 + slope[0] * slope[0] + slope[1] * slope[1]);
  // The shortest turn from the pad's normal axis x to this normal.
  const double y = -sign * slope[0] * cosine, z = -sign * slope[1] * cosine, over = 1.0 / (1.0 + cosine);
  const std::array<double, 9> turn = {
      cosine, y, z, -y, 1.0 - y * y * over, -y * z * over, -z, -y * z * over, 1.0 - z * z * over};
  for (std::size_t i = 0; i < 9; ++i) turn_.at(9 * c + i, lane) = turn[i];
  const double height = face.height_m(on_pad);
  offset_.at(c, lane) = cosine * (height - slope[0] * place_m[0] - slope[1] * place_m[1]);
  double foremost = std::numeric_limits<double>::infinity();
  for (int q = 0; q < kReliefPlaces; ++q) {
    const auto offset = place_offset_m(candidate, q);
    const std::array<double, 2> there = {on_pad[0] + offset[0], on_pad[1] + offset[1]};
    const double relief =
        cosine * (candidate.relief_m[static_cast<std::size_t>(q)] - (face.height_m(there) - height));
    contacts_.relief.at(c * kReliefPlaces + static_cast<std::size_t>(q), lane) = relief;
    foremost = std::min(foremost, relief);
  }
  contacts_.foremost.at(c, lane) = foremost;
}

}  // namespace unbruised

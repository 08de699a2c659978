#include "core/contact/window_pressure.hpp"

#include <algorithm>
#include <cmath>

namespace unbruised {
namespace {

/// Steps of the windows per side of a window.
constexpr double kStepsPerSide = 4.0;
/// A rounding error must not add a step.
constexpr double kRounding = 1e-9;
/// Windows are laid again where the surface has moved this share of their side over the face.
constexpr double kLeastMove = 1e-3;

/// Windows along a stretch of each length, an odd number: one stands in the middle.
Lane window_count(const Lane& length_m, double side_m) {
  Lane count(1.0);
  for (int lane = 0; lane < kLanes; ++lane) {
    const double free = std::max(0.0, length_m[lane] - side_m);
    count.set(lane, 1.0 + 2.0 * std::ceil(0.5 * kStepsPerSide * free / side_m - kRounding));
  }
  return count;
}

double largest_of(const Lane& value) {
  double largest = value[0];
  for (int lane = 1; lane < kLanes; ++lane) largest = std::max(largest, value[lane]);
  return largest;
}

}  // namespace

WindowPressure::WindowPressure(const FaceGrid& grid, double side_m)
    : grid_(grid), side_m_(side_m), row_N_(grid.piece[0].size()) {}

void WindowPressure::clear(int lane) {
  for (Axis& axis : axis_) {
    axis.reach.low.set(lane, 0.0);  // no surface has this reach
    axis.reach.high.set(lane, 0.0);
  }
}

void WindowPressure::archive(LaneArchive& lane) {
  for (Axis& axis : axis_) {
    lane(axis.reach.low, axis.reach.high);
    if (lane.arrives()) axis.laid = false;
  }
}

void WindowPressure::lay_windows(std::size_t t) {
  const auto& pieces = grid_.piece[t];
  Axis& axis = axis_[t];
  const Stretch& reach = axis.reach;
  const Stretch covered{max(reach.low, Lane(grid_.low_m[t])), min(reach.high, Lane(grid_.high_m[t]))};
  const Lane length = max0(covered.high - covered.low), half(0.5 * side_m_);
  const Lane count = window_count(length, side_m_);
  const Lane step = max0(length - Lane(side_m_)) / max(count - Lane(1.0), Lane(1.0));
  const Lane first = select(length > Lane(side_m_), covered.low + half, Lane(0.5) * (covered.low + covered.high));
  axis.windows = static_cast<std::size_t>(largest_of(count));
  if (axis.share.rows() < axis.windows * pieces.size()) axis.share = LaneArray(axis.windows * pieces.size());
  axis.piece.assign(axis.windows, {pieces.size(), 0});
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Lane whole = pieces[i].weight_m(covered, Lane(0.0));
    const Lane inverse = select(whole > Lane(0.0), Lane(1.0) / max(whole, Lane(1e-300)), Lane(0.0));
    for (std::size_t k = 0; k < axis.windows; ++k) {
      // A lane with fewer windows has its last one again.
      const Lane middle = first + step * min(Lane(static_cast<double>(k)), count - Lane(1.0));
      const Stretch window{max(middle - half, covered.low), min(middle + half, covered.high)};
      const Lane share = pieces[i].weight_m(window, Lane(0.0)) * inverse;
      axis.share.put(k * pieces.size() + i, share);
      if (none(share > Lane(0.0))) continue;
      axis.piece[k] = {std::min(axis.piece[k][0], i), i + 1};
    }
  }
}

Lane WindowPressure::largest_Pa(const LaneArray& normal_N, const std::array<Stretch, 2>& reach,
                                const Mask& lanes) {
  const Lane least(kLeastMove * side_m_);
  for (std::size_t t = 0; t < 2; ++t) {
    Stretch& laid = axis_[t].reach;
    const Mask moved = lanes & ((abs(reach[t].low - laid.low) > least) | (abs(reach[t].high - laid.high) > least));
    if (none(moved) && axis_[t].laid) continue;
    laid = {select(moved, reach[t].low, laid.low), select(moved, reach[t].high, laid.high)};
    lay_windows(t);
    axis_[t].laid = true;
  }
  const std::size_t rows = grid_.piece[0].size(), columns = grid_.piece[1].size();
  Lane largest(0.0);
  for (std::size_t l = 0; l < axis_[1].windows; ++l) {
    for (std::size_t i = 0; i < rows; ++i) {
      Lane force(0.0);
      for (std::size_t j = axis_[1].piece[l][0]; j < axis_[1].piece[l][1]; ++j) {
        const int c = grid_.candidate[i * columns + j];
        if (c >= 0) force += axis_[1].share.get(l * columns + j) * normal_N.get(static_cast<std::size_t>(c));
      }
      row_N_.put(i, force);
    }
    for (std::size_t k = 0; k < axis_[0].windows; ++k) {
      Lane force(0.0);
      for (std::size_t i = axis_[0].piece[k][0]; i < axis_[0].piece[k][1]; ++i) {
        force += axis_[0].share.get(k * rows + i) * row_N_.get(i);
      }
      largest = max(largest, force);
    }
  }
  return largest * Lane(1.0 / (side_m_ * side_m_));
}

}  // namespace unbruised

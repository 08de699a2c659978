#include "core/gripper/force_curve_lanes.hpp"

namespace unbruised {

void ForceCurveLanes::load(int lane, std::span<const double> speed_m_s, std::span<const double> force_N) {
  const std::size_t count = force_N.size();
  given_.set(lane, count > 0);
  any_given_ = any(given_);
  if (piece_.size() < count) piece_.resize(count, piece_.back());
  for (std::size_t i = 0; i < piece_.size(); ++i) {
    const std::size_t at = i < count ? i : count - 1;  // where there is one
    const bool slopes = i + 1 < count;
    piece_[i].speed_m_s.set(lane, count > 0 ? speed_m_s[at] : 0.0);
    piece_[i].force_N.set(lane, count > 0 ? force_N[at] : kUnlimited);
    piece_[i].slope_N_s_m.set(lane,
                              slopes ? (force_N[i + 1] - force_N[i]) / (speed_m_s[i + 1] - speed_m_s[i]) : 0.0);
  }
}

Lane ForceCurveLanes::force_N(const Lane& speed_m_s) const {
  Lane force = piece_.front().force_N;
  for (const Piece& piece : piece_) {
    const Lane beyond = speed_m_s - piece.speed_m_s;
    force = select(beyond > Lane(0.0), piece.force_N + piece.slope_N_s_m * beyond, force);
  }
  return force;
}

}  // namespace unbruised

#include "core/contact/place_windows.hpp"

namespace unbruised {

Lane PlaceWindows::largest_Pa() const {
  // Half a window to each side: one around the place that carries most is hardly worse than the best.
  const Lane half(0.5 * side_m_);
  Lane largest(0.0);
  for (const Place& middle : place_) {
    Lane force(0.0);
    for (const Place& other : place_) {
      const Mask within = (abs(other.at[0] - middle.at[0]) <= half) & (abs(other.at[1] - middle.at[1]) <= half);
      force += select(within, other.force_N, Lane(0.0));
    }
    largest = max(largest, force);
  }
  return largest * Lane(1.0 / (side_m_ * side_m_));
}

}  // namespace unbruised

#include "core/contact/pad_slip.hpp"

#include <cstddef>

namespace unbruised {

void PadSlip::forget(int lane) {
  for (Lane* value : {&way_[0], &way_[1], &angle_}) value->set(lane, 0.0);
}

void PadSlip::begin_step() {
  for (Lane* sum : {&force_, &square_, &turn_, &moved_[0], &moved_[1], &place_[0], &place_[1], &open_way_[0],
                    &open_way_[1], &open_count_}) {
    *sum = Lane(0.0);
  }
}

void PadSlip::add_closed(const std::array<Lane, 2>& place_m, const Lane& force_N,
                         const std::array<Lane, 2>& moved_m) {
  force_ += force_N;
  for (std::size_t t = 0; t < 2; ++t) {
    moved_[t] += force_N * moved_m[t];
    place_[t] += force_N * place_m[t];
  }
  square_ += force_N * (place_m[0] * place_m[0] + place_m[1] * place_m[1]);
  turn_ += force_N * (place_m[0] * moved_m[1] - place_m[1] * moved_m[0]);
}

void PadSlip::add_open(const std::array<Lane, 2>& way_m, const Mask& open) {
  for (std::size_t t = 0; t < 2; ++t) open_way_[t] += select(open, way_m[t], Lane(0.0));
  open_count_ += select(open, Lane(1.0), Lane(0.0));
}

void PadSlip::end_step(double least_radius_m, const Mask& running) {
  const Lane tiny(1e-300);
  const Mask touches = force_ > Lane(0.0);
  const Lane force = max(force_, tiny);
  for (std::size_t t = 0; t < 2; ++t) {
    const Lane open_way = open_way_[t] / max(open_count_, Lane(1.0));
    way_[t] += select(running, select(touches, moved_[t] / force, open_way), Lane(0.0));
  }
  // Least squares about the centre of force.
  const Lane spread = square_ - (place_[0] * place_[0] + place_[1] * place_[1]) / force;
  const Lane turn = turn_ - (place_[0] * moved_[1] - place_[1] * moved_[0]) / force;
  const Mask turns = running & touches & (spread > force * Lane(least_radius_m * least_radius_m));
  angle_ += select(turns, turn / max(spread, tiny), Lane(0.0));
}

}  // namespace unbruised

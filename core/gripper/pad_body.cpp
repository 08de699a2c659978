#include "core/gripper/pad_body.hpp"

#include "core/algebra/lane_solve.hpp"
#include "core/scenario/pad_lattice.hpp"

namespace unbruised {
namespace {

/// Fills `lag` and `felt_mass_kg`.
void let_back_accelerate(const WilsonTheta& wilson, PadBody& pad) {
  const BodyModel& body = pad.body;
  LaneArray x(static_cast<std::size_t>(body.factor.size));
  x.fill(0.0);
  for (std::size_t p = 0; p < body.particle_count; ++p) {
    const int slot = body.slot[3 * p];
    if (slot >= 0) x.at(static_cast<std::size_t>(slot), 0) = body.mass_kg[p];
  }
  solve_forward(body.factor, x.data());
  solve_backward(body.factor, x.data());
  pad.lag.assign(3 * body.particle_count, 0.0);
  pad.felt_mass_kg = body.total_mass_kg;
  for (std::size_t i = 0; i < pad.lag.size(); ++i) {
    if (body.slot[i] < 0) continue;
    pad.lag[i] = x.at(static_cast<std::size_t>(body.slot[i]), 0);
    if (i % 3 == 0) pad.felt_mass_kg -= wilson.a0 * body.mass_kg[i / 3] * pad.lag[i];
  }
}

}  // namespace

std::optional<PadBody> build_pad(const ParallelJawParameters& jaw, const WilsonTheta& wilson, std::string& error) {
  std::optional<BodyModel> body = build_held_body(pad_lattice(jaw), wilson, error);
  if (!body) return std::nullopt;
  PadBody pad{.body = std::move(*body), .face = {}, .place_m = {}, .compliance = {}, .lag = {}};
  const Lattice& lattice = *pad.body.lattice;
  for (const SurfacePoint& point : lattice.side[1]) {
    pad.face.push_back(point.node);
    const auto& place = pad.body.position_m[static_cast<std::size_t>(point.node)];
    const double y = place[1], z = place[2] - lattice.center_m[2];
    if (pad.place_m[1].empty() || pad.place_m[1].back() != z) pad.place_m[1].push_back(z);
    if (pad.place_m[1].size() == 1) pad.place_m[0].push_back(y);
  }
  pad.compliance = node_compliance(pad.body.factor, pad.body.slot, pad.face);
  let_back_accelerate(wilson, pad);
  return pad;
}

}  // namespace unbruised

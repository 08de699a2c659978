#include "core/simulation/replay_surfaces.hpp"

#include "core/scenario/finger_axes.hpp"
#include "core/scenario/opening.hpp"
#include "core/scenario/pad_face.hpp"
#include "core/surface/surfaces.hpp"

namespace unbruised {
namespace {

void put_face(const PadFace& face, ReplaySurface& surface) {
  const auto place_m = [&](int at, std::size_t along) {
    return (static_cast<double>(at) / (kReplayFaceSide - 1) - 0.5) * surface.size_m[along];
  };
  for (int i = 0; i < kReplayFaceSide; ++i) {
    for (int j = 0; j < kReplayFaceSide; ++j)
      surface.height_m.push_back(face.height_m({place_m(i, 0), place_m(j, 1)}));
  }
}

ReplaySurface pad_of(const Scenario& scenario, const ParallelJawParameters& jaw, int number) {
  ReplaySurface pad;
  pad.kind = ReplaySurface::Kind::pad;
  pad.finger = static_cast<int>(finger_of(number));
  pad.size_m = jaw.pad_size_m;
  pad.thickness_m = jaw.pad_thickness_m;
  if (is_listed_pad(number)) {
    const FingerParameters& finger = jaw.finger[finger_of(number)];
    pad.axes = finger_axes(finger);
    pad.origin_m = finger.offset_m;
  } else {
    pad.axes = {{{0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}, {normal_sign(number), 0.0, 0.0}}};
  }
  for (std::size_t i = 0; i < 3; ++i) pad.origin_m[i] -= opened_half_m(scenario) * pad.axes[2][i];
  if (is_shaped(jaw.pad)) put_face(PadFace(jaw), pad);
  return pad;
}

}  // namespace

std::vector<ReplaySurface> replay_surfaces(const Scenario& scenario) {
  std::vector<ReplaySurface> all;
  const auto* jaw = parallel_jaw(scenario);
  for (const int number : surfaces_of(scenario)) {
    ReplaySurface surface;
    if (is_pad(number)) {
      surface.kind = ReplaySurface::Kind::absent;
      if (jaw != nullptr) surface = pad_of(scenario, *jaw, number);
    } else if (is_of_cell_list(number)) {
      const CellSurfaceParameters& listed =
          scenario.cell.surface[static_cast<std::size_t>(number - kFirstCellSurface)];
      surface.kind = ReplaySurface::Kind::listed;
      surface.origin_m = listed.center_m;
      surface.axes = surface_axes(listed);
      surface.size_m = listed.size_m.value_or(std::array{0.0, 0.0});
      surface.thickness_m = listed.thickness_m;
    } else {
      surface.axes = {{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};
      surface.thickness_m = scenario.cell.support_thickness_m;
    }
    surface.name = surface_name(number);
    all.push_back(std::move(surface));
  }
  return all;
}

}  // namespace unbruised
